"""Two robots that shall meet, in ``meeting``.

With ``labels=true``: ``mommy``: robot 0 waits for mommy, robot 1 looks for it.  ``impatient`` waits
one turn at a time: others may be too slow for any number of turns, so it is unfinished in async
where ``mommy`` holds.  Anonymous robots, which start at the same time: ``walk``, ``zigzag`` and
``tree`` never meet where symmetry keeps them apart.

``to_the_other`` is oblivious: on one edge each of two goes to the other one.  They meet in central,
and go past each other for ever in fsync and async.
"""

from allworlds import Automaton, Move, Wait, Watch


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


def impatient(first, *, told):
    """The same; robot 0 counts the turns that it waits."""
    if told:
        yield from tree(first)
    while True:
        yield Wait()


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


to_the_other = Automaton(None, lambda memory, percept: (memory, Move(0)))
