"""Port numbers: the doors of a room have numbers that stay; the rooms have none.

The robot knows how many rooms there are.  It tries every sequence of so many doors, and comes back.

Source: M. Yamashita, T. Kameda, Computing on anonymous networks: Part I, IEEE Transactions on
Parallel and Distributed Systems 7(1), 69-89 (1996), for the model.

    $ allworlds check ports.py:all_doors --lighthouse compass+told:n --task home --step-budget 10000 --edges 3
    HOLDS
    $ allworlds check ports.py:one_less --lighthouse compass+told:n --task home --step-budget 10000 --edges 3
    REFUTED
"""

from allworlds import Move


def within(percept, depth):
    """Walk along all ways of that depth, and come back to this room."""
    for port in range(percept.degree if depth else 0):
        there = yield Move(percept.bearing + port)
        came = -there.bearing  # the port of arrival, modulo the degree
        there = yield from within(there, depth - 1)
        percept = yield Move(there.bearing + came)
    return percept


def all_doors(first, *, told):
    """Look as far as a room can be."""
    yield from within(first, told["n"] - 1)


def one_less(first, *, told):
    """Look less far."""
    yield from within(first, max(told["n"] - 2, 0))
