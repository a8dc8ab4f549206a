"""Several robots in worlds that change: every schedule, and every choice of the adversary."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property, partial
from typing import Annotated, Any, Literal

from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.documents.report import Report
from allworlds.engines import lanes, single, sweep, units
from allworlds.engines.engine_table import ReadyEngine
from allworlds.engines.job_records import Identity
from allworlds.engines.limits import Limits, TimeoutOptions, positive
from allworlds.engines.listeners import Listener
from allworlds.explorers import sources
from allworlds.inputs.checks import InputError, an_integer, integer_of, not_one_of, show
from allworlds.inputs.requests import (
    RARE_EFFORT,
    RARE_SCOPE,
    RULES,
    SCOPE,
    Converted,
    Option,
    OptionGroup,
    takes_fields,
    values_of,
)
from allworlds.maps import combinatorial, count_source
from allworlds.maps.classes import DEFAULT_EDGES, Extent, ExtentOptions
from allworlds.maps.families import FORMS, family
from allworlds.notations.given import GivenMap, GivenMaps, GivenOptions, held
from allworlds.outcome import Facts, Verdict
from allworlds.robots.finding import LAWS, TeamFinding
from allworlds.robots.lane import SearchLane
from allworlds.robots.model import SCHEDULERS, Model, Scheduler
from allworlds.robots.models.table import NamedModel, model_of
from allworlds.robots.schedulers import ROUNDS, Time
from allworlds.robots.team import Team, TeamRow, TeamScope, TeamTally
from allworlds.studies.check.tally_sweep import record_of, subject_of_record
from allworlds.studies.options import ClusterOptions, ListenerOptions, RunDirectoryOptions
from allworlds.studies.scopes import FileDigests, GivenCount, told_scope
from allworlds.studies.swept import PortionReport
from allworlds.words import plural
from allworlds.world import selection
from allworlds.world.named import world_named

DEFAULT_MODEL = "meeting"


def _model(given: object) -> NamedModel:
    if isinstance(given, NamedModel):
        return given
    if isinstance(given, Model):
        return NamedModel(type(given).__name__, given)
    if not isinstance(given, str):
        raise InputError(f"model = {show(given)} is neither a name nor a model")
    return model_of(given)


def _natural(name: str, least: int) -> Callable[[object], Any]:
    """The value of an option, an integer from ``least`` on, or None."""

    def take(given: object) -> int | None:
        if given is None:
            return None
        number = an_integer(name, given)
        if number < least:
            raise InputError(f"{name} = {show(number)} is less than {least}, the least one")
        return number

    return take


def darts_of(text: str) -> tuple[int, ...]:
    """The darts of a text, with commas between.

    Raises:
        InputError: if these are none.
    """
    return tuple(integer_of(part) for part in text.split(","))


class TeamRequest(
    ListenerOptions,
    RunDirectoryOptions,
    ClusterOptions,
    Limits,
    units.ShardOptions,
    selection.WhereOptions,
    GivenOptions,
    ExtentOptions,
):
    """Request of ``team``: programs, a model, schedules, worlds, and limits."""

    explorers: Annotated[
        Sequence[str | Callable[..., Any]],
        OptionGroup(
            sources.ExplorersWords,
            "names, as on the command line, generator functions or automata; one for all robots, "
            "or one for each",
        ),
    ] = ()
    model: Annotated[
        Converted[str | Model | NamedModel, NamedModel],
        Option(
            SCOPE,
            "NAME|FILE.py:Class",
            "The model of the world, perhaps with options, as in meeting:labels=true.",
            document_type=doc.Text,
        ),
    ] = Converted(_model, DEFAULT_MODEL)
    robots: Annotated[
        Converted[int | None, int | None],
        Option(
            SCOPE,
            "K",
            "The number of robots [default: of the programs, if there are several; else 2].",
            parse=integer_of,
            document_type=Annotated[doc.Positive | None, doc.about("null: as many as programs")],
        ),
    ] = Converted(_natural("robots", 1), None)
    scheduler: Annotated[
        Scheduler | None,
        Option(
            RULES,
            "|".join(SCHEDULERS),
            "Who is activated at once: all, any set, one at a time, or any set makes its next "
            "step, Look with Compute or Move [default: the model's first].",
            document_type=Annotated[Scheduler | None, doc.about("who is activated at once")],
        ),
    ] = None
    budget: Annotated[
        Converted[int, int],
        Option(
            RULES,
            "B",
            "A run of a generator goes on for so many activations of each robot; one that is cut "
            "off leaves the verdict open.",
            parse=integer_of,
        ),
    ] = Converted(_natural("budget", 1), 1000)
    within: Annotated[
        Converted[int | None, int | None],
        Option(
            RULES,
            "B",
            "The same as a bound: a run that goes on is a finding.",
            parse=integer_of,
            document_type=Annotated[doc.Positive | None, doc.about("a bound on the activations")],
        ),
    ] = Converted(_natural("within", 1), None)
    lead: Annotated[
        Converted[int | None, int | None],
        Option(
            RULES,
            "D",
            "No robot is more than D activations ahead of one that could be activated.",
            parse=integer_of,
            document_type=Annotated[doc.Positive | None, doc.about("null: without a limit")],
        ),
    ] = Converted(_natural("lead", 1), None)
    start_delay: Annotated[
        Converted[int, int],
        Option(
            RULES,
            "D",
            "Robot 1 begins up to D rounds later, as the adversary likes.",
            parse=integer_of,
        ),
    ] = Converted(_natural("start-delay", 0), 0)
    configurations: Annotated[
        Converted[int, int],
        Option(
            RARE_EFFORT,
            "N",
            "A search of one world has at most so many configurations.",
            parse=integer_of,
        ),
    ] = Converted(_natural("configurations", 1), 1_000_000)
    max_findings: Annotated[
        Converted[int, int],
        Option(
            RARE_EFFORT,
            "K",
            "Stop after the level with the K-th finding (the smallest of each law and map counts).",
            parse=integer_of,
        ),
    ] = Converted(positive("max-findings"), 1)
    family: Annotated[
        str | None,
        Option(
            SCOPE,
            "F",
            f"One world of a family in place of a class: {FORMS}.",
            document_type=Annotated[
                doc.IfAny[doc.Text | None], doc.about("the family of the one world")
            ],
        ),
    ] = None
    world: Annotated[
        str | None,
        Option(
            RARE_SCOPE,
            "WORLD",
            "One map in place of a class: inline JSON, @file or @file:name, or a name.",
            document_type=Annotated[
                doc.IfAny[doc.Text | None], doc.about("the one map, as it was given")
            ],
        ),
    ] = None
    starts: Annotated[
        Converted[Sequence[int] | None, tuple[int, ...] | None],
        Option(
            RARE_SCOPE,
            "D,D,...",
            "The darts of the robots at the start, in that one map [default: the model's].",
            parse=darts_of,
            document_type=Annotated[
                doc.IfAny[tuple[doc.Natural, ...] | None],
                doc.about("the darts of the robots at the start, where they were given"),
            ],
        ),
    ] = Converted(lambda given: None if given is None else tuple(given), None)

    @property
    def extent(self) -> Extent:
        """The maps.

        Raises:
            InputError: naming the offending bound and what would be legal.
        """
        unbounded = self.edges is None and self.vertices is None and self.given is None
        edges = DEFAULT_EDGES if unbounded else self.edges
        return Extent(self.map_class, edges, self.vertices, self.where, self.given)

    @cached_property
    @override
    def given(self) -> GivenMaps | None:
        """The given maps: of files, of a graph, or the one that is named.

        Raises:
            InputError: naming the option.
        """
        named = {
            name: value
            for name in ("family", "world", "worlds", "graph")
            if (value := getattr(self, name)) is not None
        }
        if len(named) > 1:
            first, second, *_ = named
            raise InputError(f"give {first} or {second}, not both")
        if self.starts is not None and self.world is None:
            raise InputError(f"starts = {show(self.starts)} has no effect without world")
        if self.family is not None:
            return _one(self.family, family(self.family), None)
        if self.world is not None:
            return _one(self.world, world_named(self.world).map, self.starts)
        return GivenOptions.given.func(self)  # type: ignore[attr-defined, no-any-return]

    @property
    def time(self) -> Time:
        """The schedules.

        Raises:
            InputError: naming an option that has no effect under this scheduler.
        """
        legal = self.model.model.schedulers
        scheduler = self.scheduler or legal[0]
        if scheduler not in legal:
            raise not_one_of(f"scheduler of the model {self.model}", scheduler, legal)
        if self.lead is not None and scheduler == "fsync":
            raise InputError(f"lead = {self.lead} has no effect in fsync: all go together")
        if self.start_delay and scheduler not in ROUNDS:
            raise InputError(
                f"start-delay = {self.start_delay} has no effect in {scheduler}, which has no "
                f"rounds; legal schedulers are {' and '.join(ROUNDS)}"
            )
        budget = self.budget if self.within is None else self.within
        bound = self.within is not None
        return Time(scheduler, budget, self.lead, self.start_delay, bound, self.configurations)

    def team(self) -> Team:
        """The programs, loaded.

        Raises:
            InputError: naming one that cannot be loaded, or their number.
        """
        given = [*self.explorers]
        if not given:
            raise InputError("team takes one program, or one for each robot")
        robots = self.robots or (len(given) if len(given) > 1 else 2)
        if len(given) not in (1, robots):
            raise InputError(
                f"{len(given)} programs for {robots} robots; legal is one, or one for each robot"
            )
        each = [*dict.fromkeys(given)]
        subjects = [single.subject_of(explore, self.limits) for explore in each]
        for subject in subjects:
            if subject.compiled:
                raise InputError(
                    f"{show(subject.name)} is a shared library, which cannot be asked turn by "
                    "turn; legal are functions in Python and programs (--exec)"
                )
        numbers = given if len(given) > 1 else given * robots
        return Team(tuple(subjects), tuple(each.index(program) for program in numbers))


def _one(
    name: str, map_: combinatorial.CombinatorialMap, starts: Sequence[int] | None
) -> GivenMaps:
    """One map, with every root up to automorphism; with given starts in its own numbering."""
    if starts is not None:
        _renamed(map_, starts)
        return held("map", name, "one map", [GivenMap(map_, (starts[0],))])
    codes = dict[Any, int]()
    for dart in map_.darts:
        codes.setdefault(combinatorial.rooted_code(map_.sigma, map_.alpha, dart), dart)
    return held("map", name, "one map", [GivenMap(map_, tuple(codes.values()))])


def _renamed(map_: combinatorial.CombinatorialMap, starts: Sequence[int]) -> tuple[int, ...]:
    """The starts in the canonical numbering of the map with its root at the first of them.

    Raises:
        InputError: for one that is no dart of the map.
    """
    for dart in starts:
        if dart not in map_.darts:
            last = len(map_.sigma) - 1
            raise InputError(f"starts: {show(dart)} is no dart of the map; legal are 0 to {last}")
    order = combinatorial.numbering(map_.sigma, map_.alpha, starts[0])
    names = combinatorial.inverse(order)
    return tuple(names[dart] for dart in starts)


class TeamCell(doc.Document):
    """One comparison of the count gate."""

    edges: doc.Edges
    vertices: doc.Vertices
    enumerated: Annotated[doc.Natural, doc.about("rooted maps that were visited")]
    counted: Annotated[doc.Natural, doc.about("those that there are")]
    source: Annotated[doc.Text, doc.about("says who")]

    @property
    def agrees(self) -> bool:
        """Whether the enumeration and the source give the same count."""
        return self.counted == self.enumerated


class TeamCounts(doc.Document):
    """Counts of the worlds of one size."""

    edges: doc.Edges
    vertices: doc.Vertices
    maps: Annotated[doc.Natural, doc.about("rooted maps")]
    worlds: Annotated[doc.Natural, doc.about("maps with starts of all robots")]
    configurations: Annotated[doc.Natural, doc.about("states of a world with all minds")]
    most: Annotated[doc.Natural, doc.about("the largest number of them in one world")]
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
    stopped: Annotated[str | None, doc.about("why it is not complete; null: it is")]


class TeamReport(PortionReport, kw_only=True):
    """Report of 'team'.

    What the searches of all worlds have shown, and what follows from it.

    ``asked`` is what was to be searched, ``tally`` holds the counts of the finished levels and the
    smallest findings.
    """

    explorers: Annotated[doc.Some[doc.Text], doc.about("the program of each robot")]
    asked: doc.NotInDocument[TeamScope]
    tally: doc.NotInDocument[TeamTally]
    cells: doc.NotInDocument[tuple[TeamCell, ...]] = ()
    seconds: doc.NotInDocument[tuple[float, ...]] = ()
    levels: doc.NotInDocument[tuple[int, ...]] = ()

    @doc.computed
    def verdict(self) -> outcome.Verdict:
        """About this scope alone."""
        return self.facts.verdict

    @doc.computed
    def scope(self) -> TeamScopeDocument:
        """All that was searched."""
        return told_scope(
            TeamScopeDocument,
            self.request,
            edges=self.extent.edges,
            scheduler=self.asked.time.scheduler,
            robots=len(self.asked.team.of),
            gate=self.cells,
            complete=isinstance(self.ending, outcome.Completed),
            stopped=self.ending.reason or None,
        )

    @doc.computed
    def rows(self) -> tuple[TeamCounts, ...]:
        """One for each (edges, vertices), ascending."""
        names = TeamRow.__slots__
        return tuple(
            TeamCounts(edges=m, vertices=n, **{name: getattr(row, name) for name in names})
            for (m, n), row in sorted(self.tally.rows.items())
        )

    @doc.computed
    def remarks(self) -> tuple[doc.Text, ...]:
        """Remarks about processes, which refute nothing, each once."""
        return tuple(sorted(self.tally.remarks))

    @doc.computed
    def findings(self) -> tuple[TeamFinding, ...]:
        """Ascending by (edges, vertices, canonical code, starts)."""
        return tuple(self.tally.findings)

    @doc.computed
    def unfinished(self) -> TeamFinding | None:
        """The smallest world in which the budget cuts a run off, with a shortest such run."""
        return next(iter(self.tally.unfinished), None)

    @property
    @override
    def seconds_by_part(self) -> dict[str, list[float]]:
        return {"level_seconds": [*self.seconds]}

    @property
    def explorer(self) -> str:
        """The name of the first program."""
        return self.explorers[0]

    @property
    def total(self) -> TeamRow:
        """The sum of all rows."""
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


def searched(request: TeamRequest) -> TeamReport:
    """Answer a request of ``team``."""
    return TeamSweep(request, request.team()).answer(request.run)


@takes_fields(TeamRequest, several="explorers", answered=searched)
def team(*explorers: str | Callable[..., Any], **options: Any) -> TeamReport:
    """Search every schedule of several robots in every world of a class.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    return searched(TeamRequest(explorers=explorers, **options))


class TeamSweep(sweep.Sweep[TeamTally, TeamReport]):
    """The sweep of the searches of a team.

    Args:
        request: what was asked for.
        team: the programs.
    """

    verb, asked, result = "team", TeamRequest, TeamTally
    extent: Extent

    def __init__(self, request: TeamRequest, team: Team) -> None:
        super().__init__(request, request.extent)
        model = request.model
        digest = model.code.digest if model.code else ""
        starts = None
        if request.starts and request.world:
            starts = _renamed(world_named(request.world).map, request.starts)
        self.scope = TeamScope(
            self.extent,
            model.model,
            model.name,
            digest,
            team,
            request.time,
            request.max_findings,
            starts,
        )
        self._tally = self.scope.tally()
        self._levels: list[int] = []
        self._gate: list[TeamCell] = []

    @override
    @classmethod
    def known(cls, identity: Identity, portion: units.Shard, listener: Listener) -> TeamSweep:
        subjects = tuple(subject_of_record(each) for each in identity.explorer["explorers"])
        of = tuple(identity.explorer["of"])
        return cls(cls.asked_then(identity, portion, listener), Team(subjects, of))

    @override
    def explorer(self) -> dict[str, Any]:
        records = [record_of(subject) for subject in self.scope.team.subjects]
        return {"name": self.scope.team.name, "explorers": records, "of": [*self.scope.team.of]}

    @override
    def parameters(self) -> dict[str, Any]:
        return {**super().parameters(), "edges": self.extent.edges}

    @override
    def ready(self) -> ReadyEngine:
        where = self.extent.where
        models = bool(self.request.model.code or getattr(where, "codes", ()))
        made: Any = partial(lanes.workers_for, models=models, make=SearchLane)
        limits, team = self.request.limits, self.scope.team
        if self.request.dask is None:
            return ReadyEngine(made(team, limits, self.deadline), self.scope)
        from allworlds.engines.dask import Dask

        alone = doc.replace(limits, workers=1, time_limit=None)
        there = Dask(
            self.request.dask,
            limits.workers,
            self.deadline,
            inside=partial(made, team.with_content, alone),
            probe=partial(team.not_alike, team.digests, limits.answer_timeout),
        )
        return ReadyEngine(there, self.scope)

    @override
    def empty(self) -> TeamTally:
        return self.scope.tally()

    @override
    def finish(self, level: units.SweptLevel, total: TeamTally) -> outcome.Ending | None:
        whole = self.portion == units.WHOLE
        total.findings = [doc.replace(found, minimal=whole) for found in total.findings]
        self._tally.add(total)
        self._levels.append(level.edges)
        if whole:
            self._gate += gate_of(self.extent, level.edges, total)
        if not all(cell.agrees for cell in self._gate):
            return outcome.Disagreed("the count gate: the enumeration and its source disagree")
        found = len(self._tally.findings)
        if found >= self.scope.keep and level.edges != self.extent.levels[-1]:
            return outcome.Stopped(f"{found} findings in finished levels", final=True)
        return None

    @override
    def leave(self, level: units.SweptLevel, total: TeamTally) -> None:
        """Store the findings. Counts enter the report only if their level is finished."""
        for found in total.findings:
            self._tally.find(doc.replace(found, minimal=False))

    @override
    def report(self, ending: outcome.Ending) -> TeamReport:
        return TeamReport(
            **self.ended(ending),
            explorers=self.scope.team.names,
            asked=self.scope,
            tally=self._tally,
            cells=tuple(self._gate),
            seconds=tuple(self.seconds),
            levels=tuple(self._levels),
        )


class TeamReplay(Report):
    """Report of 'replay', of a team.

    The search of a finding's world, made again.
    """

    again: Annotated[TeamReport, doc.about("the search of today")] = doc.key(name="search")
    recorded: doc.NotInDocument[TeamFinding]
    notice: doc.NotInDocument[str] = ""

    @doc.computed
    def law(self) -> doc.Text:
        """The recorded one."""
        return self.recorded.law

    @doc.computed
    def law_now(self) -> doc.Text | None:
        """The law that is broken now; null: none."""
        return self.again.findings[0].law if self.again.findings else None

    @doc.computed
    def outcome(self) -> Literal["reproduced", "fixed", "not-reproduced"]:
        """``reproduced``: a law is broken again; ``fixed``: none is; else it is left open."""
        if self.again.findings:
            return "reproduced"
        holds = self.again.verdict is Verdict.HOLDS
        cut_off = self.recorded.law == "budget" and self.again.unfinished is not None
        return "reproduced" if cut_off else "fixed" if holds else "not-reproduced"

    @property
    @override
    def facts(self) -> Facts:
        said = self.outcome
        return Facts(fixed=said == "fixed", undecided=said == "not-reproduced")


def replayed(finding: TeamFinding, explore: Any, limits: TimeoutOptions) -> TeamReplay:
    """Search the world of a finding again, with another program in place of all if one is named.

    Raises:
        InputError: if a program or the model is not to be found, or the model has another text.
    """
    time = finding.time
    model = model_of(finding.model)
    if finding.model_digest and model.code is not None:
        model.code.ensure_recorded(finding.model_digest)
    request = TeamRequest(
        explorers=(explore,) if explore is not None else finding.team,
        model=model,
        robots=len(finding.starts),
        scheduler=time.scheduler,
        budget=time.budget,
        within=time.budget if time.within else None,
        lead=time.lead,
        start_delay=time.start_delay,
        world=json.dumps({"sigma": finding.sigma, "alpha": finding.alpha}),
        starts=finding.starts,
        **values_of(TimeoutOptions, limits),
    )
    return TeamReplay(again=searched(request), recorded=finding)


class TeamExplanation(Report):
    """Report of 'explain', of a team.

    The run of a finding, as a space-time diagram.
    """

    finding: TeamFinding
    number: Annotated[doc.Positive, doc.about("of the finding in its report; 1: the first")]
    findings: Annotated[doc.Positive, doc.about("how many findings the report holds")]

    @doc.computed
    def sentences(self) -> doc.Some[doc.Text]:
        """In plain words."""
        return tuple(told_of(self.finding))


def told_of(finding: TeamFinding) -> Iterator[str]:
    """A finding in a few sentences."""
    yield f"{LAWS[finding.law]} Here it does not hold: {finding.seen}."
    events = len(finding.events)
    if finding.loop:
        before = plural(events - finding.loop, "event")
        yield f"After {before} the last {plural(finding.loop, 'event')} repeat for ever."
        yield "In them every robot is activated, or cannot be: the schedule is fair."
    elif events:
        yield f"It is so after {plural(events, 'event')}, and in this world never after fewer."
    late = [*_stale(finding)]
    if late:
        yield f"A move is done by what was sensed earlier: {'; '.join(late)}."
    chosen = [event.world for event in finding.events if event.world]
    if chosen:
        yield f"The adversary: {'; '.join(dict.fromkeys(chosen))}."


def _stale(finding: TeamFinding) -> Iterator[str]:
    """The moves between whose look and themselves another robot has moved."""
    looked: dict[int, int] = {}
    moved: dict[int, int] = {}
    for number, event in enumerate(finding.events, 1):
        for turn in event.robots:
            since = looked.get(turn.robot, number)
            others = [at for robot, at in moved.items() if robot != turn.robot and at > since]
            if turn.phase == "move" and others:
                yield f"robot {turn.robot} looks in event {since} and moves in event {number}"
        for turn in event.robots:
            if turn.phase == "look":
                looked[turn.robot] = number
            else:
                moved[turn.robot] = number


def gate_of(extent: Extent, edges: int, tally: TeamTally) -> Iterator[TeamCell]:
    """Counts of the maps of a level, beside those of an independent source, if there is one."""
    source = count_source.source_of(extent)
    if source is None:
        return
    for vertices, counted in units.cells_of_level(extent, edges).items():
        row = tally.rows.get((edges, vertices))
        maps = row.maps if row else 0
        if maps or counted:
            yield TeamCell(
                edges=edges,
                vertices=vertices,
                enumerated=maps,
                counted=counted,
                source=source.name,
            )
