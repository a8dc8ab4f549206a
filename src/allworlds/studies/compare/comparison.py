"""Result of a comparison: rows, the world in which explorers differ most, findings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from statistics import geometric_mean
from typing import Annotated

from msgspec import Struct
from typing_extensions import override

from allworlds.document.struct import (
    Aside,
    Document,
    Edges,
    Figure,
    Natural,
    Positive,
    Vertices,
    about,
)
from allworlds.engines.single import SingleRun, single_run
from allworlds.inputs.checks import InputError
from allworlds.studies.compare.contest_report import ContestReport
from allworlds.studies.compare.contestants import InWorld
from allworlds.studies.compare.growing_families import Member
from allworlds.world.world import World


class InMap(Struct, frozen=True):
    """An explorer's cost in one rooted map, over the places of its lighthouse."""

    runs: int
    total: int
    worst: int

    @property
    def mean(self) -> Fraction:
        """Mean number of traversals per run."""
        return Fraction(self.total, self.runs)


class ComparedRow(Document):
    """Costs in the worlds of one size. The first explorer is compared with each other one."""

    edges: Edges
    vertices: Vertices
    worlds: Annotated[
        Positive, about("rooted maps in which every explorer's lighthouse has a place")
    ]
    runs: Annotated[Positive, about("judged in them, of all explorers together")]
    mean: Annotated[
        dict[str, Figure],
        about("for each explorer the mean over these maps of its mean over the places"),
    ]
    worst: Annotated[dict[str, Natural], about("for each explorer the largest cost of a run")]
    ratio: Annotated[
        dict[str, Figure | None],
        about(
            "for each explorer its mean in a map divided by that of the first there: the geometric "
            "mean over these maps; null where one is 0"
        ),
    ]
    less: Annotated[
        dict[str, Natural], about("in how many maps the first one's mean is less than this one's")
    ]
    equal: Annotated[dict[str, Natural], about("in how many it is equal")]
    more: Annotated[dict[str, Natural], about("in how many it is more")]


class DifferMost(Document):
    """The smallest of the worlds in which the first explorer differs most from another."""

    world: Annotated[World, about("the rooted map, with the first one's lighthouse")]
    costs: Annotated[dict[str, Figure], about("for each explorer its mean over the places")]


class Comparison(ContestReport):
    """Report of 'compare'.

    Explorers side by side in the same worlds.

    ``member`` is the one world, if they were run in one of a family; ``all_counted`` tells that an
    independent source counts the worlds that were enumerated; ``in_worlds`` holds the runs in each
    world if rows are wanted by them.
    """

    rows: Annotated[
        tuple[ComparedRow, ...], about("one for each (edges, vertices) of the finished levels")
    ]
    differ_most: Annotated[
        DifferMost | None, about("null: nothing was compared, or nothing differs")
    ]
    member: Aside[Member | None]
    all_counted: Aside[bool]
    in_worlds: Aside[tuple[InWorld, ...]] = ()

    @property
    @override
    def agrees(self) -> bool:
        return self.all_counted

    @property
    def worlds_kept(self) -> tuple[InWorld, ...]:
        """The runs in each world.

        Raises:
            InputError: if they were not kept.
        """
        if self.rows and not self.in_worlds:
            raise InputError(f"by {self.by}: these rows are kept if compare has this option")
        return self.in_worlds

    def walks(self) -> Iterator[SingleRun]:
        """A run of each explorer in the world that differs most, at the first place."""
        if self.differ_most is None:
            return
        for contestant in self.contestants:
            world = contestant.first_world(self.differ_most.world.map)
            yield single_run(contestant.subject, world, contestant.rules, (), self.request.limits)


def rounded(value: Fraction) -> float:
    """The number rounded to six decimal places, as documents have it."""
    return round(float(value), 6)


def row_of(edges: int, vertices: int, maps: Sequence[Mapping[str, InMap]]) -> ComparedRow:
    """The row of one size, from what each explorer costs in each rooted map."""
    first, *others = maps[0]

    def times(holds: Callable[[Fraction, Fraction], bool]) -> dict[str, int]:
        return {
            name: sum(holds(costs[first].mean, costs[name].mean) for costs in maps)
            for name in others
        }

    def ratio(name: str) -> float | None:
        means = [(costs[name].mean, costs[first].mean) for costs in maps]
        if not all(mine and beside for mine, beside in means):
            return None
        return round(geometric_mean(float(mine / beside) for mine, beside in means), 6)

    mean = {n: sum((costs[n].mean for costs in maps), Fraction(0)) / len(maps) for n in maps[0]}
    return ComparedRow(
        edges=edges,
        vertices=vertices,
        worlds=len(maps),
        runs=sum(cost.runs for costs in maps for cost in costs.values()),
        mean={name: rounded(cost) for name, cost in mean.items()},
        worst={n: max(costs[n].worst for costs in maps) for n in maps[0]},
        ratio={name: ratio(name) for name in maps[0]},
        less=times(lambda a, b: a < b),
        equal=times(lambda a, b: a == b),
        more=times(lambda a, b: a > b),
    )
