"""What comparisons report: what all have in common, and that in the same worlds."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Annotated, Any

from msgspec import Struct
from typing_extensions import override

from allworlds.document import (
    EXIT_CODE,
    Aside,
    Document,
    Edges,
    Figure,
    Natural,
    Positive,
    Some,
    Text,
    Vertices,
    WhichShard,
    about,
    computed,
    replace,
)
from allworlds.engines import (
    By,
    SingleRun,
    SweptExit,
    SweptReport,
    TriedPlaces,
    by_named,
    single_run,
    told_scope,
    tried_places,
)
from allworlds.inputs import InputError
from allworlds.judging import AskedRules, Finding
from allworlds.outcome import Verdict
from allworlds.studies.check import SharedFile
from allworlds.studies.compare.contestants import Contestant, InWorld
from allworlds.studies.compare.growth import Member
from allworlds.studies.compare.intervals import geometric_mean
from allworlds.studies.compare.requests import AskedContestWorlds
from allworlds.world import AskedLighthouse, World


class ComparedName(Document):
    """An explorer by its name."""

    name: Annotated[Text, about("the explorer's")]


class Compared(ComparedName, of=(AskedLighthouse, AskedRules)):
    """An explorer of a comparison, with the rules of its runs."""

    places: TriedPlaces
    shared_file: SharedFile


class ContestScope(Document, of=AskedContestWorlds):
    """The worlds of a comparison."""

    shard: WhichShard


class ContestReport(SweptReport):
    """The report of explorers that were run in the same worlds.

    ``contestants`` were run; rows for programs are wanted ``by`` world or run.
    """

    verdict: Annotated[Verdict, about("whether a run of any explorer broke a law")] = computed(
        lambda report: report.judged
    )
    exit_code: SweptExit = EXIT_CODE
    explorers: Annotated[Some[Compared], about("in the order in which they were named")] = computed(
        lambda report: tuple(report.compared_one(one) for one in report.contestants)
    )
    scope: Annotated[ContestScope, about("the worlds in which they were run")] = computed(
        lambda report: told_scope(ContestScope, report.request, shard=str(report.portion))
    )
    findings: Annotated[
        tuple[Finding, ...], about("the smallest of each explorer that broke a law")
    ] = ()
    contestants: Aside[tuple[Contestant, ...]]
    by: Aside[By | None] = None

    @property
    def judged(self) -> Verdict:
        """The verdict of these facts."""
        return self.facts.verdict

    @property
    @override
    def refuted(self) -> bool:
        return bool(self.findings)

    @property
    def names(self) -> list[str]:
        """The names of the explorers."""
        return [one.name for one in self.contestants]

    @override
    def records(self, by: str | None = None) -> list[dict[str, Any]]:
        """The rows of ``--csv``, by the names of their columns: ``pandas.DataFrame`` takes them.

        Args:
            by: ``size``, ``world`` or ``run``, as in the request; by default as was asked for.

        Raises:
            InputError: for another word, or for rows that were not kept.
        """
        found = self if by is None else replace(self, by=by_named(by))
        return super(ContestReport, found).records()

    def compared_one(self, one: Contestant) -> Compared:
        """The part of the document that tells of an explorer."""
        return Compared(
            name=one.name,
            **one.rules.told,
            places=tried_places(one.rules.lighthouse, self.extent),
            shared_file=one.rules.shared_file,
        )


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
        found = geometric_mean([float(mine / beside) for mine, beside in means])
        return found and round(found[0], 6)

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
