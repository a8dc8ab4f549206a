"""The report of ``team``: counts by size, findings, and a run that the budget cuts off.

The *budget* is the largest number of activations of each robot in a run.
"""

from __future__ import annotations

from typing import Annotated

from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.robots.team import TeamRow, TeamScope, TeamTally
from allworlds.robots.team_finding import TeamFinding
from allworlds.studies.scopes import FileDigests, GivenCount, as_scope
from allworlds.studies.swept import PortionReport
from allworlds.studies.team.request import TeamRequest
from allworlds.studies.user_corpus import CorpusReport, UserCorpus


class TeamCell(doc.Document):
    """One comparison of the count gate: of the maps with these numbers of edges and vertices."""

    edges: doc.Edges
    vertices: doc.Vertices
    enumerated: Annotated[doc.Natural, doc.about("rooted maps that were visited")]
    counted: Annotated[doc.Natural, doc.about("the number by an independent source")]
    source: Annotated[doc.Text, doc.about("says who")]

    @property
    def agrees(self) -> bool:
        """Whether the enumeration and the source give the same count."""
        return self.counted == self.enumerated


class TeamCounts(doc.Document):
    """Counts of the worlds of one size, and of what the searches in these worlds have met."""

    edges: doc.Edges
    vertices: doc.Vertices
    maps: Annotated[doc.Natural, doc.about("rooted maps")]
    worlds: Annotated[doc.Natural, doc.about("maps with starts of all robots")]
    configurations: Annotated[doc.Natural, doc.about("states of a world with all minds")]
    most: Annotated[doc.Natural, doc.about("the most configurations of one world")]
    ends: Annotated[doc.Natural, doc.about("configurations in which a run ends")]
    cut_off: Annotated[doc.Natural, doc.about("configurations in which the budget cuts a run off")]
    full: Annotated[doc.Natural, doc.about("worlds with more configurations than are allowed")]
    longest: Annotated[doc.Natural, doc.about("the most activations of a robot in a run that ends")]
    schedules: Annotated[
        doc.Natural | None,
        doc.about("the number of maximal runs; null: infinitely many, or not known"),
    ]


@doc.with_options(TeamRequest)
class TeamScopeDocument(doc.Document):
    """The scope of a search: every option that its counts and its verdict depend on."""

    shard: doc.WhichShard
    given: GivenCount
    sha256: FileDigests
    gate: Annotated[
        tuple[TeamCell, ...],
        doc.about(
            "the count gate: one comparison for each size; none of a shard, or of given maps"
        ),
    ]
    complete: Annotated[bool, doc.about("whether every world of the scope was searched")]
    stopped: Annotated[str | None, doc.about("why the search is not complete; null: it is")]


class TeamReport(PortionReport, kw_only=True):
    """Report of 'team'.

    The counts and findings of the searches in all worlds, and the verdict that follows from them.

    ``asked`` is the scope that was to be searched, ``tally`` holds the counts of the finished
    levels and the smallest findings, ``cells`` are the comparisons of the count gate, ``seconds``
    the durations of the levels, ``levels`` the finished numbers of edges, and ``past`` is the
    user's corpus.
    """

    explorers: Annotated[doc.Some[doc.Text], doc.about("the program of each robot")]
    asked: doc.NotInDocument[TeamScope]
    tally: doc.NotInDocument[TeamTally]
    cells: doc.NotInDocument[tuple[TeamCell, ...]] = ()
    seconds: doc.NotInDocument[tuple[float, ...]] = ()
    levels: doc.NotInDocument[tuple[int, ...]] = ()
    past: doc.NotInDocument[UserCorpus[TeamFinding] | None] = None

    @doc.computed
    def verdict(self) -> outcome.Verdict:
        """The verdict, which is about this scope alone.

        The scope is the value of :attr:`scope`.
        """
        return self.facts.verdict

    @doc.computed
    def scope(self) -> TeamScopeDocument:
        """A description of all that was searched."""
        return as_scope(
            TeamScopeDocument,
            self.request,
            edges=self.extent.edges,
            scheduler=self.asked.timing.scheduler,
            robots=len(self.asked.team.program_of),
            gate=self.cells,
            complete=isinstance(self.ending, outcome.Completed),
            stopped=self.ending.reason or None,
        )

    @doc.computed
    def rows(self) -> tuple[TeamCounts, ...]:
        """A row for each (edges, vertices), ascending: the counts of the worlds of this size."""
        names = TeamRow.__slots__
        return tuple(
            TeamCounts(edges=m, vertices=n, **{name: getattr(row, name) for name in names})
            for (m, n), row in sorted(self.tally.rows.items())
        )

    @doc.computed
    def remarks(self) -> tuple[doc.Text, ...]:
        """Remarks about processes, which refute nothing; a repeated remark is listed once."""
        return tuple(sorted(self.tally.remarks))

    @doc.computed
    def corpus(self) -> doc.IfAny[CorpusReport | None]:
        """The files of the user's corpus after the search; null without ``--corpus``."""
        return self.past.report if self.past else None

    @doc.computed
    def findings(self) -> tuple[TeamFinding, ...]:
        """The smallest findings, ascending by (edges, vertices, canonical code, starts)."""
        return tuple(self.tally.findings)

    @doc.computed
    def unfinished(self) -> TeamFinding | None:
        """A run that the budget cuts off, with the fewest events; null: no run is cut off.

        The run is in the smallest world in which a run is cut off; of the cut-off runs in this
        world, it has the fewest events.  An event is here a step of one robot, or of several robots
        at once.  A cut-off run leaves the verdict open.  Only under the option ``within`` does it
        break a law; then it is also a finding.
        """
        return next(iter(self.tally.unfinished), None)

    @property
    @override
    def seconds_by_part(self) -> dict[str, list[float]]:
        return {"level_seconds": [*self.seconds]}

    @property
    def explorer(self) -> str:
        """The name of the program of the first robot."""
        return self.explorers[0]

    @property
    def total(self) -> TeamRow:
        """The counts of all sizes together."""
        total = TeamRow()
        for row in self.tally.rows.values():
            total.add(row)
        return total

    @property
    @override
    def agrees(self) -> bool:
        return all(cell.agrees for cell in self.cells)

    @property
    @override
    def refuted(self) -> bool:
        return bool(self.tally.findings)

    @property
    @override
    def undecided(self) -> bool:
        return super().undecided or bool(self.total.cut_off or self.total.full)

    @property
    @override
    def empty(self) -> bool:
        return not self.total.configurations
