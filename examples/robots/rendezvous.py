"""Two robots that shall meet, in ``meeting``.

``mommy``, with ``labels=true``: robot 0 waits for mommy, robot 1 looks for it.
``walk``, ``zigzag`` and ``tree`` are anonymous, and start at the same time: they never meet where
symmetry keeps them apart.

``to_the_other`` is oblivious: on one edge each of two goes to the other one.  They meet in central,
and go past each other for ever in fsync and async.
"""

from allworlds import Automaton, Move, Watch


def tree(first):
    """Go along every walk of length 1, 2, 3, ... and back: each vertex is visited some day."""

    def behind(seen, depth):
        for _ in range(seen.degree - 1 if depth else 0):
            yield from behind((yield Move(1)), depth - 1)
        yield Move(1 if depth else 0)

    depth, turn = 0, 0
    while True:
        for _ in range(first.degree):
            yield from behind((yield Move(turn)), depth)
            turn = 1
        depth += 1


def mommy(first, *, told):
    """Robot 0 waits, robot 1 looks for it."""
    if told:
        yield from tree(first)
    while True:
        yield Watch()


def walk(first):
    """Walk on round a face, for ever."""
    while True:
        yield Move(1)


def zigzag(first):
    """Turn by what was sensed, and by the number of steps."""
    seen, steps = first, 0
    while True:
        steps += 1
        seen = yield Move(steps * steps + seen.degree)


def go(memory, percept):
    """Go along the edge."""
    return memory, Move(0)


to_the_other = Automaton(None, go)
