"""Places as tables of numbers, for the compiled search."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from allworlds.engines import FAR, PlaceTable
from allworlds.protocol import Percept
from allworlds.studies.optimum.knowledge import Places

ToldApart: TypeAlias = Callable[[Percept, int], int]
"""The largest number of places that can be told apart after a percept, by the traversals left."""


def place_table(
    places: Places, told_apart: ToldApart | None, tick: Callable[[], None]
) -> PlaceTable:
    """The table of these places, all that motions lead to, and the mirror images of all.

    Args:
        places: get the numbers of the table.
        told_apart: where it is known.
        tick: called for each place; it may raise.
    """
    codes: dict[Percept, int] = {}
    after: list[list[int]] = []
    code: list[list[int]] = []
    mirror: list[int] = []
    while len(after) < len(places.places):
        tick()
        number = len(after)
        parts = [places.moved((number,), k)[0] for k in range(places.degree((number,)))]
        after.append([part.known[0] for part in parts])
        code.append([codes.setdefault(part.percept, len(codes)) for part in parts])
        mirror.append(places.mirrored(number))
    own = [codes.setdefault(places.percept(number), len(codes)) for number in range(len(after))]
    limits = (
        [[told_apart(percept, left) for left in range(FAR + 1)] for percept in codes]
        if told_apart
        else []
    )
    return PlaceTable(after, code, own, places.answer, mirror, limits)
