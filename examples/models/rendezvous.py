"""Rendezvous: one robot waits, the other one looks for it, on ever longer ways.

Source: S. Alpern, S. Gal, The Theory of Search Games and Rendezvous, Kluwer (2003), 'wait for
mommy'.

    $ allworlds team rendezvous.py:wait rendezvous.py:search --model meeting:apart=false --scheduler async --edges 2
    HOLDS
    $ allworlds team rendezvous.py:wait --model meeting --edges 2
    REFUTED
"""

from allworlds import Move, Watch


def wait(first):
    """Wait until somebody comes."""
    while True:
        yield Watch()


def search(first):
    """Walk along every way of 0, 1, 2, ... further doors, and back."""

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
