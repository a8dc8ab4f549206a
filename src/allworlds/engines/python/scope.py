"""The scope of a check: every option that the counts and the verdict depend on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

from allworlds.engines.python.runs_of_unit import LevelRuns
from allworlds.engines.units.levels import units_of_level
from allworlds.engines.units.shards import WHOLE, Shard, Whole
from allworlds.inputs import InputError, an_integer, at_most, show
from allworlds.judging import Rules
from allworlds.maps import Extent
from allworlds.protocol import Choices, Schedule, Schedules

MOST_RUNS = 10**12


@dataclass(frozen=True, slots=True)
class Sample:
    """A number of random worlds, drawn from a seed, each with a least number of edges.

    Raises:
        InputError: for numbers out of range.
    """

    runs: int
    seed: int = 0
    min_edges: int = 1

    def __post_init__(self) -> None:
        for name in ("runs", "seed", "min_edges"):
            object.__setattr__(self, name, an_integer(name, getattr(self, name)))
        at_most("runs", self.runs, MOST_RUNS)
        if self.seed < 0:
            raise InputError(f"seed = {show(self.seed)}, but seeds are 0, 1, 2, ...")
        if self.runs < 1:
            raise InputError(f"runs = {self.runs} is not positive")
        if self.min_edges < 1:
            raise InputError(f"min-edges = {show(self.min_edges)} is not positive")


Coverage: TypeAlias = Whole | Shard | Sample
"""The part of the worlds of an extent that is tried."""


@dataclass(frozen=True)
class Scope:
    """A class of worlds with its bounds, and the rules.

    Attributes:
        extent: class and bounds.
        rules: how each run is played and judged.
        schedules: ``one`` (the policy's) or ``all`` (every sequence of choices).
        coverage: which of these worlds.
    """

    extent: Extent
    rules: Rules
    schedules: Schedule = "one"
    coverage: Coverage = WHOLE

    @property
    def whole(self) -> bool:
        """Every world of the extent is tried, so that they can be counted."""
        return isinstance(self.coverage, Whole)

    def units(self, edges: int) -> Iterator[LevelRuns]:
        """The units of a level; the same for any number of workers."""
        portion = WHOLE if isinstance(self.coverage, Sample) else self.coverage
        for unit in units_of_level(self.extent, edges, portion):
            yield LevelRuns(unit.edges, unit.prefix)

    def schedule(self, name: str) -> Iterator[Choices]:
        """Choices for each schedule of the run of that name."""
        if self.schedules == "one":
            yield self.rules.choices(name)
        else:
            yield from Schedules()
