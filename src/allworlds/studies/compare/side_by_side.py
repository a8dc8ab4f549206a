"""Units of several explorers: each contestant has a number, an engine and a place.

A unit of a comparison is a unit of runs with the number of the contestant that plays it. Its result
holds the costs of one contestant, and a level adds up those of all.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field as entry
from itertools import groupby
from typing import Any, Self, TypeAlias

from msgspec import Struct, field

from allworlds.engines import (
    GivenWorlds,
    Outcome,
    PartialResult,
    RunCounter,
    Tally,
    Transport,
    UnitOfRuns,
)
from allworlds.judging import Rules
from allworlds.maps import CombinatorialMap
from allworlds.world import World

MapKey: TypeAlias = tuple[int, int, tuple[int, ...], tuple[int, ...]]
"""Numbers of edges and vertices, sigma and alpha: sorts rooted maps from small to large."""


@dataclass(slots=True)
class CostTally(Tally):
    """A tally that knows every run.

    Attributes:
        costs: by the rooted map, and the number of the lighthouse's place in it.
    """

    costs: dict[tuple[MapKey, int], int] = entry(default_factory=dict)

    def add(self, other: Tally) -> None:
        """Take in another part's tally; no run is in two of them."""
        # Zero-argument super() does not know a class with slots.
        Tally.add(self, other)
        if isinstance(other, CostTally):
            self.costs.update(other.costs)


class CostEngine(RunCounter, frozen=True):
    """The counter that returns the cost of every run, too."""

    def tally(self) -> CostTally:
        """An empty tally."""
        return CostTally(self.keep)

    def count_outcome(self, world: World, place: int, outcome: Outcome, tally: Tally) -> None:
        """Add a run, which has one episode, to the tally, and its cost."""
        super().count_outcome(world, place, outcome, tally)
        assert isinstance(tally, CostTally)
        tally.costs[key_of(world.map), place] = outcome.cost


def key_of(map_: CombinatorialMap) -> MapKey:
    """The key of a map that is rooted at its dart 0."""
    return map_.edge_count, map_.vertex_count, tuple(map_.sigma), tuple(map_.alpha)


class UnitOfOne(Struct, frozen=True):
    """A unit of runs that one contestant plays."""

    number: int
    unit: UnitOfRuns

    @property
    def key(self) -> str:
        """Key of the unit in a run directory: ``NUMBER/KEY``."""
        return f"{self.number}/{self.unit.key}"

    @property
    def runs(self) -> int:
        """The number of its runs, if they are those of given worlds."""
        return len(self.unit.worlds) if isinstance(self.unit, GivenWorlds) else 0


class CostsOfAll(Struct):
    """Costs of the runs of each contestant, which add up in any order.

    Attributes:
        of: by the number of the contestant.
    """

    of: dict[int, CostTally] = field(default_factory=dict)

    @property
    def worlds(self) -> int:
        """The number of rooted maps, counted once for each contestant."""
        return sum(tally.worlds for tally in self.of.values())

    @property
    def findings(self) -> list[Any]:
        """The smallest finding of each contestant."""
        return [found for tally in self.of.values() for found in tally.findings]

    def one(self, number: int) -> CostTally:
        """The costs of a single contestant."""
        return self.of.setdefault(number, CostTally(keep=1))

    def add(self, other: CostsOfAll) -> None:
        """Add the costs of another part."""
        for number, tally in other.of.items():
            self.one(number).add(tally)

    def under(self, rules: Sequence[Rules]) -> Self:
        """Return the costs under the rules of each contestant."""
        for number, tally in self.of.items():
            tally.under(rules[number])
        return self


class SideBySide:
    """The transports of all contestants as one; each contestant uses its own.

    Args:
        transports: by the number of the contestant; contexts as long as this one is.
    """

    def __init__(self, transports: Sequence[Transport[Any]]) -> None:
        self._transports, self._stack = transports, ExitStack()

    def __enter__(self) -> Self:
        with ExitStack() as stack:
            for transport in self._transports:
                stack.enter_context(transport)
            self._stack = stack.pop_all()
        return self

    def __exit__(self, *error: object) -> None:
        raised: Any = error
        self._stack.__exit__(*raised)

    def map(
        self, engine: Sequence[CostEngine], units: Iterable[UnitOfOne]
    ) -> Iterator[PartialResult[UnitOfOne, CostsOfAll]]:
        """Yield the parts of all units as they come. The units of a contestant stand together."""
        for number, own in groupby(units, key=lambda unit: unit.number):
            transport = self._transports[number]
            for part in transport.map(engine[number], (each.unit for each in own)):
                result = CostsOfAll({number: part.result})
                yield PartialResult(UnitOfOne(number, part.unit), result, part.last)
