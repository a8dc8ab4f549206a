"""Explorers of the reports in ``whole.py``, which has them in a file ``mine.py``."""

from allworlds import CombinatorialMap, Estimate, Move

EDGE = CombinatorialMap([0, 1], [1, 0])


def walking(*actions, answer=None, then=None):
    """An explorer that does this, whatever it senses, and then that for ever."""

    def explore(_):
        yield from (action for action in actions)  # a tuple takes no percepts
        while then is not None:
            yield then
        return answer

    return explore


def stays(first):
    return Estimate(EDGE, 0)
    yield


def first_edge(first):
    yield Move(0)
    return Estimate(EDGE, 1)


def crashes(first):
    yield Move(0)
    raise ValueError("this edge is too much")


def goes_round(first):
    while True:
        yield Move(0)
        yield Move(1)
        yield Move(0)
        yield Move(1)
        yield Move(0)
        yield Move(1)
        yield Move(0)
        yield Move(1)
        yield Move(2)
        yield Move(2)
