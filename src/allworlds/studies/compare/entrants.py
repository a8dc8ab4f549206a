"""The request of ``compare``, and the common part of its sweeps through fixed and growing worlds.

This part is: the entrants, which are explorers with their rules; the units; the costs; and the base
of the report.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field as entry
from itertools import groupby
from typing import Annotated, Any, ClassVar, NamedTuple, Self, TypeAlias, TypeVar

from msgspec import Struct, field
from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.engines import kept_units, single, sweep, units
from allworlds.engines.engine_table import Job, ReadyEngine, players_for
from allworlds.engines.tally import RunCounter, Tally
from allworlds.explorers import loading, sources
from allworlds.inputs.checks import InputError, a_text, integer_of, show
from allworlds.inputs.requests import RARE_SCOPE, SCOPE, Converted, Option, OptionGroup, as_json
from allworlds.judging.findings.finding import Finding
from allworlds.judging.referee import Outcome
from allworlds.judging.rules import RuleOptions, Rules
from allworlds.maps import classes, combinatorial, families
from allworlds.notations.given import GivenOptions
from allworlds.studies.check.report import ManyWorlds, SharedFile
from allworlds.studies.check.tally_sweep import Confirmation, record_of, rules_record
from allworlds.studies.options import ClusterOptions, RunDirectoryOptions
from allworlds.studies.scopes import FileDigests, GivenCount, TriedPlaces, as_scope, tried_places
from allworlds.studies.swept import RowOptions, SweptReport
from allworlds.world import named, selection, world
from allworlds.world.lighthouses.kinds import LighthouseKind


def _families(given: object) -> tuple[str, ...] | None:
    """The names of families, each once; ``given`` is None, a text with commas, or a list."""
    if given is None:
        return None
    names = given.split(",") if isinstance(given, str) else given
    if not isinstance(names, Iterable):
        raise InputError(f"family = {show(given)} is neither a name nor a list of names")
    return tuple(dict.fromkeys(a_text("family", name) for name in names))


class ContestWorldsOptions(selection.WhereOptions, GivenOptions, classes.ExtentOptions):
    """The part of a request that names the worlds in which explorers are compared.

    If the option ``to``, a largest number of edges, is given, the worlds grow: they are worlds of
    one or more families, in several sizes, and for each size some members of the family.  Otherwise
    they are all worlds of a class, or given worlds, or one world of a family.
    """

    family: Annotated[
        Converted[str | Sequence[str] | None, tuple[str, ...] | None],
        Option(
            SCOPE,
            "F[,F...]",
            f"One world of a family: {families.FORMS}; with --to one or more families that grow: "
            "lattice, torus, strip, dense (without 10% of its edges), cubic, regular:D, random "
            "(twice as many edges as vertices), bouquet, lollipop:D, prism, thick:D, cover, "
            "corridor.",
            document_type=Annotated[
                doc.Some[doc.Text] | None,
                doc.about("the families; if `to` is null, only one; null: a class"),
            ],
        ),
    ] = Converted(_families, None)
    holes: Annotated[str | None, named.HOLES] = None
    seed: Annotated[
        int | None,
        Option(
            RARE_SCOPE,
            "S",
            "The seed for worlds drawn from a family; with --to, of the first world of a size; the "
            "next worlds have the next seeds [default: 0; with --to 1].",
            parse=integer_of,
            document_type=Annotated[
                doc.Natural | None,
                doc.about("the seed of the world, or of the first of each size; null: a class"),
            ],
        ),
    ] = None
    to: Annotated[
        int | None,
        Option(
            SCOPE,
            "M",
            "Worlds of the families up to M edges.",
            parse=integer_of,
            document_type=Annotated[
                doc.Positive | None,
                doc.about("the most edges of worlds that grow; null: no world grows"),
            ],
        ),
    ] = None
    draws: Annotated[
        int | None,
        Option(
            RARE_SCOPE,
            "K",
            "With --to: seeds of each size; isomorphic worlds count once [default: 30].",
            parse=integer_of,
            document_type=Annotated[
                doc.Positive | None, doc.about("seeds of each size; null: worlds that do not grow")
            ],
        ),
    ] = None
    places: Annotated[
        int | None,
        Option(
            RARE_SCOPE,
            "P",
            "With --to: the most places of the lighthouse that are run in each world; if a world "
            "has more, the seed draws P of them [default: 8].",
            parse=integer_of,
            document_type=Annotated[
                doc.Positive | None,
                doc.about("the most places of the lighthouse in a world; null: no world grows"),
            ],
        ),
    ] = None


class CompareRequest(
    RowOptions,
    RunDirectoryOptions,
    ClusterOptions,
    ManyWorlds,
    units.ShardOptions,
    ContestWorldsOptions,
):
    """Request of ``compare``: explorers, and the worlds in which they are compared."""

    explorers: Annotated[
        Sequence[str | Callable[..., Any]],
        OptionGroup(
            sources.ExplorersWords,
            "names, as on the command line, or generator functions; two or more, with ``to`` one "
            "or more.  ``NAME@LIGHTHOUSE`` is run under that lighthouse.",
        ),
    ] = ()


def ensure_unnamed(request: CompareRequest, names: Iterable[str], of: str) -> None:
    """Raise InputError if an option with one of these names is given, since it has no effect.

    ``of`` describes, in words, the worlds on which the option has no effect.
    """
    for name in names:
        if (value := getattr(request, name)) is not None:
            raise InputError(f"{name} = {show(as_json(value))} has no effect on {of}")


MapKey: TypeAlias = tuple[int, int, tuple[int, ...], tuple[int, ...]]
"""The numbers of edges and vertices, sigma and alpha, by which rooted maps are sorted."""


@dataclass(slots=True)
class CostTally(Tally):
    """A tally that keeps the cost of every run.

    Attributes:
        costs: the costs in each rooted map, by the number of the lighthouse's place.
    """

    costs: dict[MapKey, dict[int, int]] = entry(default_factory=dict)

    def add(self, other: Tally) -> None:
        """Add a tally of other runs to this tally."""
        # Zero-argument super() does not know a class with slots.
        Tally.add(self, other)
        if isinstance(other, CostTally):
            for key, costs in other.costs.items():
                self.costs.setdefault(key, {}).update(costs)


class CostEngine(RunCounter, frozen=True):
    """The engine that counts runs, and also keeps the cost of every run."""

    def tally(self) -> CostTally:
        """An empty tally that also keeps the costs of runs."""
        return CostTally(self.keep)

    def count_outcome(self, world: world.World, place: int, outcome: Outcome, tally: Tally) -> None:
        """Add the outcome of a run, and its cost, to the tally.

        ``place`` is the number of the lighthouse's place in the world.  In ``compare`` the policy
        makes all choices, so each run is played under one schedule alone and has one cost.
        """
        super().count_outcome(world, place, outcome, tally)
        assert isinstance(tally, CostTally)
        tally.costs.setdefault(key_of(world.map), {})[place] = outcome.cost


def key_of(map_: combinatorial.CombinatorialMap) -> MapKey:
    """The key by which a map, rooted at its dart 0, is sorted."""
    return map_.edge_count, map_.vertex_count, tuple(map_.sigma), tuple(map_.alpha)


class InWorld(NamedTuple):
    """An explorer's runs in one world.

    Attributes:
        map: the map, rooted at dart 0.
        member: the name of the world in its family; empty without a family.
        explorer: the name of the explorer.
        costs: the traversals of each run, by the number of the lighthouse's place.
        places: the number of places that the lighthouse has in this world; there need not be a run
            for each of them.
        bound: the bound on the traversals of a run, equal for all places; None without a bound.
        drawn_from: in worlds that grow, the number of different rooted maps among the members of
            the family with this size, whatever their seeds are.  None if the number is unknown, or
            if the worlds do not grow.
    """

    map: combinatorial.CombinatorialMap
    member: str
    explorer: str
    costs: Mapping[int, int]
    places: int
    bound: int | None
    drawn_from: int | None = None

    @property
    def mean(self) -> float:
        """The mean cost of the runs."""
        return sum(self.costs.values()) / len(self.costs)


class UnitOfOne(Struct, frozen=True):
    """A unit of runs, and the number of the compared explorer whose runs they are."""

    number: int
    unit: units.UnitOfRuns

    @property
    def key(self) -> str:
        """The unit's name in a run directory: the explorer's number, then the unit's key."""
        return f"{self.number}/{self.unit.key}"


class CostsOfAll(Struct):
    """The costs of the runs of each compared explorer, by the explorer's number.

    The costs of several units can be added up in any order.
    """

    of: dict[int, CostTally] = field(default_factory=dict)

    @property
    def worlds(self) -> int:
        """The sum, over all explorers, of the numbers of rooted maps in which the explorer was run.

        A map in which two explorers were run counts twice.
        """
        return sum(tally.worlds for tally in self.of.values())

    def one(self, number: int) -> CostTally:
        """The tally of the explorer with this number; an empty tally if it has no runs yet."""
        return self.of.setdefault(number, CostTally(keep=1))

    def add(self, other: "CostsOfAll") -> None:
        """Add the costs of other runs."""
        for number, tally in other.of.items():
            self.one(number).add(tally)


class SideBySide:
    """One transport for the units of all compared explorers; a transport sends units to workers.

    This transport consists of one transport for each explorer.
    """

    def __init__(self, transports: Sequence[units.Transport]) -> None:
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
        self, engines: Sequence[CostEngine], given: Iterable[UnitOfOne]
    ) -> Iterator[units.PartialResult]:
        """Yield the results of all units, part by part, as they come.

        ``engines`` has an engine for each explorer.  In ``given``, all units of one explorer come
        before the units of the next one.
        """
        for number, own in groupby(given, key=lambda unit: unit.number):
            transport = self._transports[number]
            for part in transport.map(engines[number], (each.unit for each in own)):
                result = CostsOfAll({number: part.result})
                unit = UnitOfOne(number, part.unit)
                yield units.PartialResult(unit, result, part.last, part.anew)


Answer = TypeVar("Answer")

AT = "@"
"""The sign between an explorer and its lighthouse."""


class Entrant(Struct, frozen=True):
    """An explorer with the rules by which its runs are played and judged.

    Attributes:
        subject: the explorer.
        rules: the rules of its runs.
        at: the lighthouse that the user has named behind ``@``; empty if none is named there.
    """

    subject: loading.Subject
    rules: Rules
    at: str = ""

    @property
    def name(self) -> str:
        """The explorer's name; ``@`` and a lighthouse follow if the user has named one there."""
        return self.named(self.subject.name)

    def named(self, explorer: str) -> str:
        """The name ``explorer``, with ``@`` and a lighthouse if the entrant's own name has them."""
        return f"{explorer}{AT}{self.at}" if self.at else explorer

    def scope(self, extent: classes.Extent, portion: units.Shard = units.WHOLE) -> units.Scope:
        """The scope of the explorer's runs in the worlds of ``extent``.

        If ``portion`` is a shard, the scope has only the worlds of this shard; by default all
        worlds.
        """
        return units.Scope(extent, self.rules, coverage=portion)

    def first_world(self, map_: combinatorial.CombinatorialMap) -> world.World:
        """The world of a map rooted at dart 0; the explorer's lighthouse is at its first place."""
        return world.World(map_, next(iter(self.rules.kind.places(map_, 0))), 0)


def entrants_of(request: CompareRequest) -> tuple[Entrant, ...]:
    """The explorers of a request, each with the rules of its runs.

    An explorer's lighthouse is the one that the user has named behind ``@``; else the one that the
    request names; else the explorer's default lighthouse.

    Raises:
        InputError: for a name that is no explorer or comes twice, or for an illegal option.
    """
    entrants: list[Entrant] = []
    for given in request.explorers:
        explore, kind = _with_lighthouse(given)
        asked = doc.replace(request, lighthouse=kind) if kind else request
        subject = single.subject_of(explore, request.limits)
        entrant = Entrant(subject, asked.rules(subject), str(kind or ""))
        if any(entrant.name == other.name for other in entrants):
            raise InputError(f"explorer {show(entrant.name)} is named twice")
        entrants.append(entrant)
    return tuple(entrants)


def _with_lighthouse(explore: object) -> tuple[Any, LighthouseKind | None]:
    """An explorer without ``@LIGHTHOUSE`` behind its name, and this lighthouse, or None.

    Paths and commands may contain ``@``, too.  So the last ``@`` separates explorer and lighthouse
    only if the name of a lighthouse follows.

    Raises:
        InputError: if no name of a lighthouse follows the last ``@``, and the text before it is the
            name of an explorer.  A program (``exec:COMMAND``) is excepted, since the ``@`` may
            belong to its command.
    """
    name, at, lighthouse = explore.rpartition(AT) if isinstance(explore, str) else ("", "", "")
    try:
        return (name, selection.tried_kind(lighthouse)) if at else (explore, None)
    except InputError:
        if sources.names_explorer(name) and not loading.is_program(name):
            raise
        return explore, None


@doc.with_options(selection.LighthouseOptions, RuleOptions)
class Compared(doc.Document):
    """An explorer of a comparison, with the rules of its runs."""

    name: Annotated[doc.Text, doc.about("the explorer's, with `@` and a lighthouse if so named")]
    places: TriedPlaces
    shared_file: SharedFile


@doc.with_options(ContestWorldsOptions)
class ContestScope(doc.Document):
    """The worlds of a comparison."""

    given: GivenCount
    sha256: FileDigests
    shard: doc.WhichShard


class ContestReport(SweptReport, kw_only=True):
    """The base of the reports of ``compare``: explorers in the same worlds.

    ``entrants`` are the explorers, with their rules. ``by`` is the user's choice of the rows of the
    CSV file that ``-o FILE.csv`` writes: one for each size, world or run. None: the default,
    sizes, or runs for worlds that grow.

    Attributes:
        steps: the word for the levels of the job in texts: ``levels`` or ``sizes``.
    """

    steps: ClassVar[str] = "levels"

    findings: Annotated[
        tuple[Finding, ...], doc.about("the smallest of each explorer that broke a law")
    ] = ()
    entrants: doc.NotInDocument[tuple[Entrant, ...]]
    by: doc.NotInDocument[sweep.By | None] = None

    @doc.computed
    def verdict(self) -> outcome.Verdict:
        """The verdict: ``refuted`` if a run of any explorer broke a law."""
        return self.facts.verdict if self.request.to is None else self.facts.sample_verdict

    @doc.computed
    def explorers(self) -> doc.Some[Compared]:
        """The explorers, with the rules of their runs, in the order in which they were named."""
        return tuple(
            Compared(
                name=one.name,
                **one.rules.in_effect,
                places=tried_places(one.rules.lighthouse, self.extent),
                shared_file=one.rules.shared_file,
            )
            for one in self.entrants
        )

    @doc.computed
    def scope(self) -> ContestScope:
        """A description of the worlds in which the explorers were run."""
        return as_scope(ContestScope, self.request)

    @property
    @override
    def refuted(self) -> bool:
        return bool(self.findings)

    @property
    def names(self) -> list[str]:
        """The names of the explorers."""
        return [one.name for one in self.entrants]


class Contest(sweep.Sweep[CostsOfAll, Answer]):
    """The sweep of several explorers through the same worlds.

    Args:
        entrants: the explorers.
        request: the request.
        extent: a class of maps with bounds that include every world of the comparison.
        every: whether explorers run in all worlds of this class and these bounds.
    """

    verb, request_type, result = "compare", CompareRequest, CostsOfAll

    def __init__(
        self,
        entrants: Sequence[Entrant],
        request: CompareRequest,
        extent: classes.Extent,
        *,
        every: bool = False,
    ) -> None:
        super().__init__(request, extent if every else None)
        self.entrants, self.bounds = tuple(entrants), extent
        self.names = [one.name for one in entrants]
        self.findings: list[Finding] = []
        self._found: dict[tuple[int, int], CostTally] = {}

    @override
    def explorer(self) -> dict[str, Any]:
        explorers = [
            {**record_of(one.subject), **rules_record(one.rules), "at": one.at}
            for one in self.entrants
        ]
        return {"name": ", ".join(self.names), "explorers": explorers}

    @override
    def ready(self) -> ReadyEngine:
        limits, cluster, notice = self.request.limits, self.request.dask, self.listener.notice
        engines = [CostEngine(one.scope(self.bounds), 1) for one in self.entrants]
        transports = [
            players_for(Job(engine.scope, one.subject, limits, 1, self.deadline, notice, cluster))
            for one, engine in zip(self.entrants, engines, strict=True)
        ]
        return ReadyEngine(SideBySide(transports), engines)

    @override
    def read(self, kept: Any) -> CostsOfAll:
        total = kept_units.from_kept(kept, CostsOfAll)
        for number, tally in total.of.items():
            tally.under(self.entrants[number].rules)
        return total

    @override
    def costs(self, total: CostsOfAll) -> Iterable[tuple[int, int, int]]:
        return (cost for tally in total.of.values() for cost in tally.costs_by_size)

    @override
    def leave(self, level: units.SweptLevel, total: CostsOfAll) -> None:
        """Keep the smallest findings of a level, whether the level is finished or not.

        One finding is kept for each explorer; in worlds that grow, one for each explorer and
        family.  ``total`` has the results of the finished units of the level.
        """
        family = getattr(level.of, "number", 0)
        for number, tally in total.of.items():
            known = self._found.setdefault((family, number), CostTally(keep=1))
            for found in tally.findings:
                known.find(found)

    @override
    def list_by(self, by: sweep.By) -> None:
        self.request = doc.replace(self.request, by=by)

    def contest(self, ending: outcome.Ending) -> dict[str, Any]:
        """Return the values of the fields of a :class:`ContestReport`, by the fields' names."""
        return {
            **self.ended(ending, self.bounds),
            "findings": tuple(self.findings),
            "entrants": self.entrants,
            "by": self.request.by,
        }

    @override
    def conclude(self, ending: outcome.Ending) -> outcome.Ending | None:
        """Confirm the findings of all explorers.

        If there are findings, and the job was stopped and would do nothing more if it began again
        (``ending.final``), return :class:`Completed`.  So a job that was stopped because a law is
        broken counts as completed.  In all other cases return None: the job ends with ``ending``,
        which may say that two engines disagree.
        """
        for (_, number), tally in sorted(self._found.items()):
            one, limits = self.entrants[number], self.request.limits
            scope = one.scope(self.bounds)
            job = one.subject, limits, scope, self.deadline, self.kept
            self.findings += Confirmation(*job).confirmed(map(scope.labelled, tally.findings))
        stopped = isinstance(ending, outcome.Stopped) and ending.final
        return outcome.Completed() if stopped and self.findings else None
