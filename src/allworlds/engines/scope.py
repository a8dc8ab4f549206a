"""The scope of a check: every option that the counts and the verdict depend on, and its units."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Protocol, TypeAlias

from msgspec import Struct
from msgspec.structs import force_setattr

from allworlds.engines.units import (
    WHOLE,
    LevelUnit,
    Placed,
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

PIECE = 50
"""The given worlds that one worker does at a time."""


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


class Given(Struct, frozen=True):
    """Worlds that the user has chosen, with the numbers of their places; ascending by edges."""

    worlds: tuple[tuple[World, int], ...]

    @property
    def sizes(self) -> list[int]:
        """Their numbers of edges, each once, ascending."""
        return sorted({world.map.edge_count for world, _ in self.worlds})

    def level(self, edges: int) -> SweptLevel:
        """Those with that many edges."""
        here = [each for each in self.worlds if each[0].map.edge_count == edges]
        pieces = (here[i : i + PIECE] for i in range(0, len(here), PIECE))
        units = [GivenWorlds(tuple(piece), f"{edges}/{i}") for i, piece in enumerate(pieces)]
        return SweptLevel(edges, len(here), units)


Coverage: TypeAlias = Whole | Shard | Sample | Given
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
        """Whether every world of the extent is tried, so that they can be counted."""
        return isinstance(self.coverage, Whole)

    @property
    def given(self) -> Sequence[World]:
        """The worlds that the user has chosen; none where they are those of an extent."""
        if not isinstance(self.coverage, Given):
            return ()
        return [world for world, _ in self.coverage.worlds]

    @property
    def portion(self) -> Portion:
        """The whole, or a shard of it."""
        match self.coverage:
            case Sample(portion=portion):
                return portion
            case Given():
                return WHOLE
        return self.coverage

    @property
    def sizes(self) -> Sequence[int]:
        """The numbers of edges of its levels."""
        return self.coverage.sizes if isinstance(self.coverage, Given) else self.extent.levels

    def units(self, edges: int) -> Iterator[LevelUnit]:
        """The units of a level; they do not depend on the number of workers."""
        return units_of_level(self.extent, edges, self.portion)

    @property
    def levels(self) -> Iterator[SweptLevel]:
        """The levels of the scope, with their units."""
        if isinstance(self.coverage, Given):
            yield from map(self.coverage.level, self.coverage.sizes)
            return
        for edges in self.extent.levels:
            yield SweptLevel(edges, level_size(self.extent, edges), self.units(edges))
