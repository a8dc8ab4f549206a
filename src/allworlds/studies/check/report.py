"""The request and the report of a check.

A request can name files with an explorer and with code that judges.  *Rules* say how runs are
played and judged: the lighthouse, the task, the laws, the bound, the policy of choices, the step
budget.  *Limits* are those of time, memory and workers.  The report has the verdict with its scope,
the count gate, the witnesses, and the most expensive runs.
"""

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, Literal, TypeAlias, get_args

from typing_extensions import override

from allworlds.documents import document as doc
from allworlds.engines import engine_table, hash_seeds, single
from allworlds.engines.limits import Limits, positive
from allworlds.engines.tally import Row, Tally
from allworlds.engines.units import WHOLE, Sample, Scope, ShardOptions, cells_of_level
from allworlds.explorers import loading, sources
from allworlds.inputs import checks, requests
from allworlds.judging.findings.finding import Finding, labelled
from allworlds.judging.laws.law_table import checked_laws
from allworlds.judging.rules import Among, RuleOptions, Rules
from allworlds.judging.tasks import Task
from allworlds.maps import classes, combinatorial, count_source
from allworlds.maps.build import named_map
from allworlds.maps.classes import DEFAULT_EDGES, ClassOptions, Condition, Extent, ExtentOptions
from allworlds.notations.given import GivenOptions
from allworlds.outcome import Completed, Verdict
from allworlds.protocol.choices import Schedule
from allworlds.studies.check.covered import CoveredRow, covered_rows
from allworlds.studies.options import ClusterOptions, ListenerOptions, RunDirectoryOptions
from allworlds.studies.scopes import FileDigests, GivenCount, TriedPlaces, as_scope, tried_places
from allworlds.studies.swept import PortionReport
from allworlds.studies.user_corpus import CorpusOptions, CorpusReport, UserCorpus
from allworlds.world import named, selection
from allworlds.world.world import World

SharedFile: TypeAlias = Annotated[
    doc.IfAny[str],
    doc.about("the explorer's file, if it also holds code that judges: see trust"),
]
"""The type of the key ``shared_file``, which the scope of every verb that judges runs has."""


def shared_file(explorer: str, rules: Rules, where: Condition | None) -> str:
    """The name of the explorer's file if this file also has code that judges the explorer.

    ``explorer`` is the explorer's name; ``rules`` and the condition ``where`` may need code of the
    user.  The result is empty if none of this code is in the explorer's file.  Otherwise the
    judge's process must load the explorer's file, whose code could change a verdict.
    """
    files = (*rules.files, *selection.files_of_condition(where))
    if not files:
        return ""
    theirs = {file.resolve() for file in sources.files_of_explorer(explorer)}
    return next((file.name for file in files if file in theirs), "")


class ManyWorlds(ListenerOptions, Limits, RuleOptions, selection.LighthouseOptions, ClassOptions):
    """The part of a request that names a class of maps, a lighthouse, the rules and the limits."""

    def rules(self, subject: loading.Subject) -> Rules:
        """The rules by which the explorer's runs are played and judged.

        The lighthouse is that of given worlds, or the one that the request names; if there is
        neither, it is the explorer's default lighthouse.

        Raises:
            InputError: naming the offending option and what would be legal.
        """
        fixed = isinstance(self, GivenOptions) and self.lighthouse_of_given(self.lighthouse)
        lighthouse = fixed or self.lighthouse or subject.lighthouse
        where = self.where if isinstance(self, selection.WhereOptions) else None
        rules = self.rules_of(
            subject, lighthouse, promised=self.map_class.planar, among=Among.of(where)
        )
        return doc.replace(rules, shared_file=shared_file(subject.name, rules, where))


class CheckRequest(
    CorpusOptions,
    RunDirectoryOptions,
    ClusterOptions,
    ManyWorlds,
    sources.ExplorerOptions,
    ShardOptions,
    selection.WhereOptions,
    GivenOptions,
    ExtentOptions,
):
    """Request of ``check``: an explorer, worlds, the rules of the runs, and limits of the job."""

    edges: Annotated[
        int | None,
        requests.Option(
            requests.SCOPE,
            "M",
            f"At most M edges (default, unless --vertices is given: {DEFAULT_EDGES}).",
            parse=checks.integer_of,
            document_type=doc.Bounded,
        ),
    ] = None
    schedules: Annotated[
        requests.Converted[str, Schedule],
        requests.Option(
            requests.RARE_RULES,
            "one|all",
            "all: every sequence of choices, for an explorer that takes choices.",
            document_type=Annotated[
                Schedule, doc.about("`one`: the policy chooses; `all`: every sequence of choices")
            ],
        ),
    ] = requests.Converted(checks.a_word("schedules", get_args(Schedule)), "one")
    engine: Annotated[
        str,
        requests.Option(
            requests.RARE_EFFORT,
            "auto|python|kernel",
            "python judges in Python, kernel in compiled code; auto: the faster one of those able.",
        ),
    ] = "auto"

    max_findings: Annotated[
        requests.Converted[int, int],
        requests.Option(
            requests.RARE_EFFORT,
            "K",
            "Stop after the level with the K-th finding; of each law and map one finding counts.",
            parse=checks.integer_of,
        ),
    ] = requests.Converted(positive("max-findings"), 1)

    @property
    def extent(self) -> Extent:
        """The class of maps with its bounds, or the given maps.

        If neither a bound nor maps are given, the number of edges is at most ``DEFAULT_EDGES``;
        then a check takes some seconds.

        Raises:
            InputError: naming the offending bound and what would be legal.
        """
        unbounded = self.edges is None and self.vertices is None and self.given is None
        edges = DEFAULT_EDGES if unbounded else self.edges
        return Extent(self.map_class, edges, self.vertices, self.where, self.given)


class GateCell(doc.Document):
    """One comparison of the count gate, for the maps with these numbers of edges and vertices."""

    edges: doc.Edges
    vertices: doc.Vertices
    enumerated: Annotated[doc.Natural, doc.about("rooted maps that were visited")]
    counted: Annotated[doc.Natural, doc.about("the number by an independent source")]
    source: Annotated[doc.Text, doc.about("the name of this source")]
    fingerprint: Annotated[doc.IfAny[str], doc.about("of the visited rooted maps")] = ""
    listed: Annotated[doc.IfAny[str], doc.about("the fingerprint of a second enumeration")] = ""

    @property
    def agrees(self) -> bool:
        """Whether the maps are as many as the source counts, and have the fingerprint ``listed``.

        If ``listed`` is empty, fingerprints are not compared.
        """
        return self.counted == self.enumerated and self.listed in ("", self.fingerprint)


LISTED_EDGES = 5
"""The largest number of edges for which each check lists all maps a second time, by other code.

Then the fingerprints of both lists are compared.
"""


def known_fingerprints(extent: classes.Extent, edges: int) -> dict[int, str]:
    """The known fingerprints of the maps with ``edges`` edges, by number of vertices.

    A fingerprint is a number made from a map, here in hexadecimal; the fingerprint of several maps
    is the sum of theirs.

    Up to :data:`LISTED_EDGES` edges the fingerprints are computed here, also under a condition.
    For this purpose the maps are enumerated once more, by other code than that of the check.

    For more edges the fingerprints are read from a file of the package.  The file has fingerprints
    for each class of maps, but not for conditions, and not for every number of edges.  If the file
    lacks the fingerprints, the result is empty.
    """
    if edges <= LISTED_EDGES:
        return {n: f"{each:x}" for n, each in count_source.listed(extent, edges).items()}
    corpus, name = named.own_corpus(), f"counts-{extent.map_class}"
    kept = [corpus.document(e) for e in corpus.of_kind("counts") if e.name == name]
    levels: Any = kept[0].get("fingerprints", {}) if kept and extent.where is None else {}
    return dict(enumerate(levels.get(str(edges), ()), 1))


def count_gate(extent: classes.Extent, edges: int, tally: Tally) -> list[GateCell]:
    """Compare the number of a level's maps with that of an independent source.

    ``edges`` is the number of edges of these maps; ``tally`` has their counts.  There is a
    comparison for each number of vertices.  There is none if no source counts the maps, for example
    under some conditions.  The fingerprints of the maps are compared, too, if they are known.
    """
    source = count_source.source_of(extent)
    if source is None:
        return []
    known, cells = known_fingerprints(extent, edges), list[GateCell]()
    for vertices, counted in cells_of_level(extent, edges).items():
        row = tally.rows.get((edges, vertices), Row())
        cell = GateCell(
            edges=edges,
            vertices=vertices,
            enumerated=row.worlds,
            counted=counted,
            source=source.name,
            fingerprint=f"{row.fingerprint:x}" if row.fingerprint else "",
            listed=known.get(vertices, ""),
        )
        if cell.enumerated or cell.counted:
            cells.append(cell)
    return cells


SMALLEST = {"loop-edge": "loop", "parallel-edge": "dipole-2"}
"""For each event that does not depend on the explorer, the smallest map in which it occurs."""


def missing_witnesses(
    extent: classes.Extent, subject: loading.Subject, task: Task, seen: Mapping[str, int]
) -> tuple[str, ...]:
    """The events that must occur in a check of the whole extent, but are not in ``seen``.

    Two events do not depend on the explorer: that a map has a loop, and that it has parallel edges.
    Such an event is required if the extent includes the smallest map in which it occurs
    (:data:`SMALLEST`).

    A built-in explorer reports further events, for example the cases of Algorithm 1.  For each of
    them it is known which size the smallest world has in which the event occurs.  The event is
    required if the extent has worlds of this size, and two conditions hold.  First: the task is to
    draw the map; a run with another task may end before the event.  Second: the extent has no
    condition; otherwise the smallest world may be left out of the extent.
    """
    simple, last = extent.map_class.simple, extent.levels[-1]
    required = {event for event, least in SMALLEST.items() if extent.include(named_map(least))}
    own = subject.own if task.is_map and extent.where is None else None
    for event, least in own.witnesses.items() if own else ():
        match least[simple]:
            case (edges, vertices) if edges <= last and vertices <= extent.vertex_limit(last):
                required.add(event)
    return tuple(sorted(event for event in required if not seen.get(event)))


class SampleReport(doc.Document):
    """The options by which the random worlds of a sample were drawn."""

    edges: Annotated[doc.Positive, doc.about("the most edges of a world")]
    min_edges: Annotated[doc.Positive, doc.about("the least edges of a world")]
    runs: Annotated[doc.Positive, doc.about("how many worlds were drawn")]
    seed: Annotated[doc.Natural, doc.about("the seed of the draws")]
    mix: Annotated[doc.Different[doc.Text], doc.about("the distributions that come in turn")]


Gated: TypeAlias = tuple[GateCell, ...] | Literal["absent", "deferred to the merge of all shards"]
"""The comparisons of the count gate, or the reason why there are none."""


@doc.with_options(CheckRequest)
class CheckedScope(doc.Document):
    """The scope of a check: every option that its counts and its verdict depend on."""

    places: TriedPlaces
    shared_file: SharedFile
    shard: doc.WhichShard
    sample: Annotated[SampleReport | None, doc.about("how `fuzz` drew the worlds; else null")]
    given: GivenCount
    sha256: FileDigests
    symmetry: Annotated[str | None, doc.about("why one run stands for several; null: none does")]
    gate: Annotated[
        Gated,
        doc.about(
            "the count gate: one comparison for each (edges, vertices) of the finished levels"
        ),
    ]
    complete: Annotated[bool, doc.about("whether every world of the scope was tried")]
    finished_levels: Annotated[
        doc.Different[doc.Positive], doc.about("the finished numbers of edges")
    ]
    stopped: Annotated[str | None, doc.about("why the job ended early; null: it did not end early")]


class CheckRow(doc.Document):
    """Counts and costs of the runs in the worlds of one size."""

    edges: doc.Edges
    vertices: doc.Vertices
    worlds: Annotated[doc.Natural, doc.about("rooted maps")]
    runs: Annotated[doc.Natural, doc.about("worlds x places of the lighthouse")]
    episodes: Annotated[doc.Natural, doc.about("runs x schedules")]
    traversals: Annotated[doc.Natural, doc.about("summed over the episodes")]
    traversals_rooted: Annotated[
        doc.Natural, doc.about("summed over the runs at the first place of each rooted map alone")
    ]
    max_cost: Annotated[doc.Natural, doc.about("the largest cost of an episode")]
    best_cost: Annotated[
        doc.IfAny[doc.Natural | None],
        doc.about(
            "each run has a cheapest schedule; this is the largest cost of these; absent: only one "
            "schedule of each run was tried"
        ),
    ]
    bound: Annotated[int | None, doc.about("the largest bound of a run; null without a bound")]


class CheckReport(PortionReport):
    """Report of 'check' and of 'fuzz'.

    The counts and findings of a check, and the verdict that follows from them.

    ``asked`` is the scope as it was asked for; the key ``scope`` says in addition how much of it
    was finished.  ``tally`` holds the counts and the smallest findings.  ``levels`` are the numbers
    of edges of the finished levels, ``seconds`` the durations of the levels, and ``cells`` the
    comparisons of the count gate.  ``past`` is the user's corpus, which knows for each of its
    earlier findings whether the check has reproduced it.  ``offspring`` is the number of worlds
    that ``fuzz`` has bred.  Such a world is a drawn world after small changes; worlds are bred so
    that the explorer also runs lines of its code that run in few worlds.
    """

    explorer: Annotated[doc.Text, doc.about("the name of the explorer")]
    engine: Annotated[engine_table.EngineName, doc.about("the engine that ran")]
    asked: doc.NotInDocument[Scope]
    tally: doc.NotInDocument[Tally]
    levels: doc.NotInDocument[tuple[int, ...]]
    cells: doc.NotInDocument[tuple[GateCell, ...]] = ()
    past: doc.NotInDocument[UserCorpus[Finding] | None] = None
    symmetry: doc.NotInDocument[str] = ""
    seconds: doc.NotInDocument[tuple[float, ...]] = ()
    offspring: doc.NotInDocument[int] = 0

    @doc.computed
    def verdict(self) -> Verdict:
        """The verdict, which is about the scope of this report alone."""
        return self.judged

    @doc.computed
    def scope(self) -> CheckedScope:
        """A description of all that was checked."""
        extent, rules, coverage = self.asked.extent, self.asked.rules, self.asked.coverage
        gate: Gated = self.cells
        if count_source.source_of(extent) is None or coverage.drawn:
            gate = "absent"
        elif coverage != WHOLE:
            gate = "deferred to the merge of all shards"
        return as_scope(
            CheckedScope,
            self.request,
            rules,
            edges=extent.edges,
            places=tried_places(rules.lighthouse, extent),
            shared_file=rules.shared_file,
            sample=as_scope(SampleReport, self.request, mix=coverage.mix)
            if isinstance(coverage, Sample)
            else None,
            symmetry=self.symmetry or None,
            gate=gate,
            complete=self.complete,
            finished_levels=self.levels,
            stopped=self.ending.reason or None,
        )

    @doc.computed
    def worlds(self) -> doc.Natural:
        """The number of rooted maps."""
        return self.tally.worlds

    @doc.computed
    def runs(self) -> doc.Natural:
        """The number of runs: worlds x places of the lighthouse."""
        return self.tally.runs

    @doc.computed
    def episodes(self) -> doc.Natural:
        """The number of episodes: runs x schedules."""
        return sum(row.episodes for row in self.tally.rows.values())

    @doc.computed
    def left_out(self) -> doc.Natural:
        """The number of worlds without a place for the lighthouse."""
        return self.tally.left_out

    @doc.computed
    def traversals(self) -> doc.Natural:
        """The number of traversals, summed over all episodes."""
        return self.tally.traversals

    @doc.computed
    def checkpoints(self) -> doc.Natural:
        """The number of checkpoints that the explorer has shown to the judge."""
        return self.tally.checkpoints

    @doc.computed
    def rows(self) -> tuple[CheckRow, ...]:
        """A row for each (edges, vertices), ascending."""
        return tuple(_rows(self.tally))

    @doc.computed
    def witnesses(self) -> dict[str, doc.Positive]:
        """The number of times that each [event](verdicts.md#witnesses) occurred."""
        return dict(sorted(self.tally.witnesses.items()))

    @doc.computed
    def missing_witnesses(self) -> doc.Different[doc.Text]:
        """The events that a complete check must have seen, and that did not occur."""
        return self.ending.missing if isinstance(self.ending, Completed) else ()

    @doc.computed
    def remarks(self) -> tuple[doc.Text, ...]:
        """Remarks about processes, which refute nothing; a repeated remark is listed once."""
        return tuple(_remarks(self.tally))

    @doc.computed
    def covered(self) -> doc.IfAny[tuple[CoveredRow, ...]]:
        """For a sample, the least, median and largest value of each feature of its worlds."""
        return tuple(covered_rows(self.tally.covered))

    @doc.computed
    def bred(self) -> doc.IfAny[doc.Natural | None]:
        """The number of worlds made by changing drawn worlds; ``worlds`` does not count them."""
        return self.offspring or None

    @doc.computed
    def corpus(self) -> CorpusReport | None:
        """The files of the user's corpus after the check; null without ``--corpus``."""
        return self.past.report if self.past else None

    @doc.computed
    def findings(self) -> tuple[Finding, ...]:
        """The smallest findings, ascending by (edges, vertices, canonical code, place, choices)."""
        return tuple(self.tally.findings)

    @property
    @override
    def seconds_by_part(self) -> dict[str, list[float]]:
        return {"level_seconds": [*self.seconds]}

    @property
    def complete(self) -> bool:
        """Whether every world of the scope was tried. A sample is never complete."""
        return isinstance(self.ending, Completed) and not self.asked.coverage.drawn

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
    def empty(self) -> bool:
        lacking = isinstance(self.ending, Completed) and self.ending.missing
        return not self.checked_laws or bool(lacking)

    @property
    def checked_laws(self) -> tuple[str, ...]:
        """The laws that were checked in at least one run."""
        return checked_laws(self.asked.rules.judged, self.tally.runs, self.tally.checkpoints)

    @property
    def judged(self) -> Verdict:
        """The verdict; for a sample it is never 'holds'."""
        return self.facts.sample_verdict if self.asked.coverage.drawn else self.facts.verdict


def _rows(tally: Tally) -> Iterator[CheckRow]:
    counts = CheckRow.__struct_fields__[2:]
    for (edges, vertices), row in sorted(tally.rows.items()):
        values = {name: getattr(row, name) for name in counts}
        yield CheckRow(edges=edges, vertices=vertices, **values)


def _remarks(tally: Tally) -> Iterator[str]:
    more_than_hashes = any(found.law == "nondeterministic" for found in tally.findings)
    for text, times in sorted(tally.remarks.items()):
        if text != hash_seeds.GOES_BY_HASHES:
            yield text if times == 1 else f"{text} ({times} times)"
        elif not more_than_hashes:
            yield text


def most_expensive_runs(report: CheckReport) -> Iterator[single.SingleRun]:
    """Yield the most expensive run for each size of worlds, the sizes ascending.

    Of equally expensive runs, the run in the world with the smallest code is taken.  Nothing is
    yielded for an explorer that was given as a function and cannot be found by its name.

    Cost: a run for each size.
    """
    limits, rules = Limits(), report.asked.rules
    try:
        subject = single.subject_of(report.explorer, limits)
    except checks.InputError:  # it was handed over as a function that no name leads to
        return
    for _, row in sorted(report.tally.rows.items()):
        if (run := row.most_expensive) is not None:
            map_ = combinatorial.CombinatorialMap(run.sigma, run.alpha)
            world = World(map_, [*rules.kind.places(map_, 0)][run.place], 0)
            world = labelled(world, report.asked.like(world))
            yield single.single_run(subject, world, rules, run.choices, limits)
