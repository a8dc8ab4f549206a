"""What is to be checked: every option that the counts and the verdict depend on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias, cast, get_args

from allworlds.findings import Rules
from allworlds.inputs import InputError, an_integer, at_most, show
from allworlds.maps.classes import Extent
from allworlds.protocol import Choices, Schedules
from allworlds.runs.units import Unit
from allworlds.work import units_of_level

Schedule: TypeAlias = Literal["one", "all"]

DEFAULT_EDGES = 5
MOST_RUNS = 10**12


@dataclass(frozen=True, slots=True)
class Whole:
    """Every world of the extent."""


@dataclass(frozen=True, slots=True)
class Shard:
    """Every ``count``-th unit of work, beginning with the one of number ``index``.

    Raises:
        InputError: naming what is out of range.
    """

    index: int
    count: int

    def __post_init__(self) -> None:
        for name, number in (("K", self.index), ("N", self.count)):
            an_integer(f"shard {name}", number)
        if self.count < 1 or not 0 <= self.index < self.count:
            raise InputError(f"shard {self} is out of range; K/N needs 0 <= K < N, counted from 0")

    def __str__(self) -> str:
        return f"{self.index}/{self.count}"


@dataclass(frozen=True, slots=True)
class Sample:
    """So many random worlds, drawn from a seed.

    Raises:
        InputError: for numbers out of range.
    """

    runs: int
    seed: int = 0

    def __post_init__(self) -> None:
        for name in ("runs", "seed"):
            object.__setattr__(self, name, an_integer(name, getattr(self, name)))
        at_most("runs", self.runs, MOST_RUNS)
        if self.seed < 0:
            raise InputError(f"seed = {show(self.seed)}, but seeds are 0, 1, 2, ...")
        if self.runs < 1:
            raise InputError(f"runs = {self.runs} is not positive")


Coverage: TypeAlias = Whole | Shard | Sample
"""Which of the worlds of an extent are tried."""


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
    coverage: Coverage = Whole()

    @property
    def whole(self) -> bool:
        """Every world of the extent is tried, so that they can be counted."""
        return isinstance(self.coverage, Whole)

    def units(self, edges: int) -> Iterator[Unit]:
        """The pieces of a level that one worker does at a time; the same for any workers."""
        index, count = 0, 1
        if isinstance(self.coverage, Shard):
            index, count = self.coverage.index, self.coverage.count
        for i, unit in enumerate(units_of_level(self.extent, edges)):
            if i % count == index:
                yield Unit(unit.edges, unit.prefix)

    def schedule(self, name: str) -> Iterator[Choices]:
        """Choices for each schedule of the run of that name."""
        if self.schedules == "one":
            yield self.rules.choices(name)
        else:
            yield from Schedules()


def a_schedule(text: object) -> Schedule:
    """``one`` or ``all``.

    Raises:
        InputError: for anything else.
    """
    if text not in get_args(Schedule):
        raise InputError(f"schedules {show(text)} is none of {', '.join(get_args(Schedule))}")
    return cast("Schedule", text)


def a_shard(pair: object) -> Coverage:
    """The shard of ``(K, N)``; of one shard, and of None, the whole.

    Raises:
        InputError: for anything else.
    """
    if pair is None:
        return Whole()
    if not isinstance(pair, tuple | list) or len(pair) != 2:
        raise InputError(f"shard = {show(pair)} is not a pair (K, N)")
    shard = Shard(an_integer("shard K", pair[0]), an_integer("shard N", pair[1]))
    return Whole() if shard.count == 1 else shard
