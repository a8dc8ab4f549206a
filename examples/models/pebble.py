"""One pebble: without one no robot can tell how large a ring is.

The robot leaves the pebble, and goes round until it finds it again.

Source: G. Dudek, M. Jenkin, E. Milios, D. Wilkes, Robotic exploration as graph construction, IEEE
Transactions on Robotics and Automation 7(6), 859-865 (1991).

    $ allworlds check pebble.py:leaves --lighthouse movable --task count:n --where pebble.py:ring --edges 5
    HOLDS
    $ allworlds check pebble.py:guesses --lighthouse movable --task count:n --where pebble.py:ring --edges 5
    REFUTED
"""

from allworlds import Drop, Move


def ring(map_):
    """Whether every room has two doors."""
    return {*map_.degree_at} == {2}


def leaves(first):
    """Count the steps back to the pebble."""
    yield Drop()
    steps = 1
    while not (yield Move(1)).marks:
        steps += 1
    return steps


def guesses(first):
    """Walk three steps, and say 3."""
    for _ in range(3):
        yield Move(1)
    return 3
