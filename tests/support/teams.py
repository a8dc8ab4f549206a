"""Programs of several robots for tests, right ones and slips."""

import os
import random
import sys
import time

from allworlds import Automaton, Do, Move, Wait, Watch


def waits(first):
    """Waits until somebody comes."""
    while True:
        yield Watch()


def polls(first):
    """Waits a turn at a time."""
    while True:
        yield Wait()


def searches(first):
    """Walks along every walk of 1, 2, 3, ... edges, and back."""

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


def by_label(first, *, told):
    """Robot 0 waits, robot 1 searches."""
    yield from searches(first) if told else waits(first)


def walks(first):
    """Walks on round a face."""
    while True:
        yield Move(1)


other_end = Automaton(None, lambda memory, percept: (None, Move(0)))
"""Goes to and fro."""


def hangs(first):
    """Is silent for ever where the degree is 3."""
    seen = first
    while seen.degree != 3:
        seen = yield Move(1)
    time.sleep(1000)


def exits(first):
    """Ends its process where the degree is 3."""
    seen = first
    while seen.degree != 3:
        seen = yield Move(1)
    os._exit(3)


def raises(first):
    """Raises where the degree is 3."""
    seen = first
    while seen.degree != 3:
        seen = yield Move(1)
    raise ValueError("three")


def floods(first):
    """Prints very much."""
    while True:
        sys.stdout.write("x" * 100_000)
        yield Move(1)


def changes_its_mind(first):
    """Walks at random."""
    for _ in range(3):
        yield Move(random.randrange(2))
    yield from waits(first)


STATE = []


def remembers(first):
    """Does in its second run something else than in its first one."""
    STATE.append(first.degree)
    for _ in range(3):
        yield Move(len(STATE) % 2)
    yield from waits(first)


counts_calls = []


def _impure(memory, percept):
    counts_calls.append(percept)
    return memory, Move(len(counts_calls) % 2)


forgetful = Automaton(0, _impure)
"""An automaton whose step depends on how often it was called."""


def changes_at_ends(first):
    """Goes on, once it has moved, by the seed of its process where the degree is 1."""
    seen = yield Move(0)
    while True:
        seen = yield Move(hash("where") % 997 if seen.degree == 1 else 0)


no_pair = Automaton(None, lambda memory, percept: Move(0))
"""Says an action without a memory."""


def says_a_number(first):
    """Says what is no action."""
    yield 5


def does(first):
    """Says what no built-in meeting understands."""
    yield Do("colour")
