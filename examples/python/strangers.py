"""Explorers that map no world by themselves. A shield makes each of them right.

allworlds check shield:examples/python/strangers.py:ahead --edges 4
"""

from __future__ import annotations

from collections.abc import Generator

from allworlds import Move, Percept

Walk = Generator[Move, Percept, None]


def lazy(_first: Percept) -> Walk:
    """Answer at once, and say nothing."""
    return
    yield Move(0)


def ahead(_first: Percept) -> Walk:
    """Leave by the next dart, for ever."""
    while True:
        yield Move(1)


def zigzag(_first: Percept) -> Walk:
    """Leave by the darts 1, 4, 9, 16, ... modulo 7, for ever."""
    k = 0
    while True:
        k += 1
        yield Move(k * k % 7)
