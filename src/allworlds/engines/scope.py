"""The scope of a check: every option that the counts and the verdict depend on, and its units."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Protocol, TypeAlias

from msgspec import Struct
from msgspec.structs import force_setattr

from allworlds.engines.units import (
    WHOLE,
    GivenUnit,
    LevelUnit,
    Portion,
    Shard,
    SweptLevel,
    Whole,
    level_size,
    units_of_level,
)
from allworlds.inputs.checks import InputError, an_integer, at_most, show
from allworlds.judging.findings.rules import Rules
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.notations.given import Placed
from allworlds.protocol.choices import Schedule
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.world import World


class UnitOfRuns(Protocol):
    """A unit that one worker does at a time."""

    @property
    def key(self) -> str:
        """Its name among the units of a check."""

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """Every map with its places, in a fixed order."""


class GivenWorlds(Struct, frozen=True):
    """Chosen worlds, each with its own place; their start is dart 0."""

    worlds: tuple[tuple[World, int], ...]
    key: str = ""

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:  # noqa: ARG002  # they are all there
        """The worlds as they are."""
        for world, place in self.worlds:
            yield world.map, [(place, world.lighthouse)]


class NumberedRun(Struct, frozen=True):
    """A run of a unit: its number there, and where it takes place.

    Attributes:
        number: from 0 on; a world without a place counts as one.
        map: rooted at dart 0.
        place: the number of the lighthouse's place.
        lighthouse: None if the world has no place for it.
        first: whether it is the first of its world.
    """

    number: int
    map: CombinatorialMap
    place: int
    lighthouse: Lighthouse | None
    first: bool


def numbered_runs(
    worlds: UnitOfRuns, extent: Extent, kind: type[Lighthouse]
) -> Iterator[NumberedRun]:
    """Every run of a unit, in its order, by which parent and worker speak of it."""
    number = 0
    for map_, places in worlds.placed(extent, kind):
        for i, (place, lighthouse) in enumerate(places or [(0, None)]):
            yield NumberedRun(number, map_, place, lighthouse, i == 0)
            number += 1


MOST_RUNS = 10**12


class Sample(Struct, frozen=True):
    """A number of random worlds, drawn from a seed, each with a least number of edges.

    A shard of it is a range of these worlds.

    Raises:
        InputError: for numbers out of range.
    """

    runs: int
    seed: int = 0
    min_edges: int = 1
    portion: Portion = WHOLE

    def __post_init__(self) -> None:
        for name in ("runs", "seed", "min_edges"):
            force_setattr(self, name, an_integer(name, getattr(self, name)))
        at_most("runs", self.runs, MOST_RUNS)
        if self.seed < 0:
            raise InputError(f"seed = {show(self.seed)}, but seeds are 0, 1, 2, ...")
        if self.runs < 1:
            raise InputError(f"runs = {self.runs} is not positive")
        if self.min_edges < 1:
            raise InputError(f"min-edges = {show(self.min_edges)} is not positive")


Coverage: TypeAlias = Whole | Shard | Sample
"""The part of the worlds of an extent that is tried."""


class Scope(Struct, frozen=True):
    """A class of worlds with its bounds, and the rules.

    Attributes:
        extent: class and bounds.
        rules: the rules by which each run is played and judged.
        schedules: ``one`` (the policy's) or ``all`` (every sequence of choices).
        coverage: the part of these worlds that is tried.
    """

    extent: Extent
    rules: Rules
    schedules: Schedule = "one"
    coverage: Coverage = WHOLE

    @property
    def whole(self) -> bool:
        """Whether every world of a class is tried, so that they can be counted."""
        return isinstance(self.coverage, Whole) and self.extent.given is None

    def like(self, world: World) -> Iterable[World]:
        """The given worlds that are this one in another numbering; none where none are given."""
        return () if self.extent.given is None else self.extent.given.like(world)

    @property
    def portion(self) -> Portion:
        """The whole, or a shard of it."""
        return self.coverage.portion if isinstance(self.coverage, Sample) else self.coverage

    def units(self, edges: int) -> Iterator[LevelUnit | GivenUnit]:
        """The units of a level; they do not depend on the number of workers."""
        return units_of_level(self.extent, edges, self.portion)

    @property
    def levels(self) -> Iterator[SweptLevel]:
        """The levels of the scope, with their units."""
        for edges in self.extent.levels:
            yield SweptLevel(edges, level_size(self.extent, edges), self.units(edges))
