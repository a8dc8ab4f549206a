"""The request of ``team``: programs, a model, schedules, worlds, and limits.

A *model* says how a world changes: where the robots can start, what they sense, and what can follow
their actions.  A model is built in, or a user's Python class.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Annotated, Any

from typing_extensions import override

from allworlds.documents import document as doc
from allworlds.engines import single, units
from allworlds.engines.limits import Limits, positive
from allworlds.explorers import sources
from allworlds.inputs.checks import InputError, a_text, an_integer, integer_of, not_one_of, show
from allworlds.inputs.requests import (
    RARE_EFFORT,
    RARE_RULES,
    RARE_SCOPE,
    RULES,
    SCOPE,
    Converted,
    Option,
    OptionGroup,
)
from allworlds.maps import combinatorial
from allworlds.maps.classes import DEFAULT_EDGES, Extent, ExtentOptions
from allworlds.maps.families import FORMS, family
from allworlds.notations.given import GivenMap, GivenMaps, GivenOptions, held
from allworlds.robots.model import SCHEDULERS, Model, Scheduler
from allworlds.robots.models.table import NamedModel, named_model
from allworlds.robots.schedulers import ROUNDS, Timing, schedule_of
from allworlds.robots.team import Team
from allworlds.studies.options import ClusterOptions, ListenerOptions, RunDirectoryOptions
from allworlds.studies.user_corpus import CorpusOptions
from allworlds.world import selection
from allworlds.world.named import world_named

DEFAULT_MODEL = "meeting"


def _model(given: object) -> NamedModel:
    if isinstance(given, NamedModel):
        return given
    if isinstance(given, Model):
        return NamedModel(type(given).__name__, given, here=True)
    if not isinstance(given, str):
        raise InputError(f"model = {show(given)} is neither a name nor a model")
    return named_model(given)


def _natural(name: str, least: int) -> Callable[[object], Any]:
    """A function that checks that an option's value is None or an integer of at least ``least``.

    The function returns the value, or raises InputError, which names the option, ``name``, and the
    value.
    """

    def take(given: object) -> int | None:
        if given is None:
            return None
        number = an_integer(name, given)
        if number < least:
            raise InputError(f"{name} = {show(number)} is less than {least}, the least one")
        return number

    return take


def _schedule(given: object) -> str | None:
    if given is not None:
        schedule_of(a_text("schedule", given))
    return None if given is None else str(given)


def darts_of(text: str) -> tuple[int, ...]:
    """The darts that a text such as ``0,3,5`` names.

    Raises:
        InputError: if the text does not consist of integers with commas between.
    """
    return tuple(integer_of(part) for part in text.split(","))


class TeamRequest(
    CorpusOptions,
    ListenerOptions,
    RunDirectoryOptions,
    ClusterOptions,
    Limits,
    units.ShardOptions,
    selection.WhereOptions,
    GivenOptions,
    ExtentOptions,
):
    """Request of ``team``: the robots' programs, and the searches to make with these programs.

    A search is about one world under one model, and tries every schedule that the options
    ``scheduler``, ``lead``, ``start_delay`` and ``schedule`` allow.  The maps are those of a class,
    or given maps.
    """

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
            "MODEL",
            "The model of the world: one of ours, or FILE.py:Class, perhaps with options, as in "
            "meeting:labels=true.",
            document_type=Annotated[doc.Text, doc.about("the model of the world, by its name")],
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
            "A run of generators is cut off after B activations of each robot, and then leaves the "
            "verdict open.",
            parse=integer_of,
            document_type=Annotated[
                doc.Positive, doc.about("the most activations of a robot in a run of generators")
            ],
        ),
    ] = Converted(_natural("budget", 1), 1000)
    within: Annotated[
        Converted[int | None, int | None],
        Option(
            RARE_RULES,
            "B",
            "As --budget, but a run that goes on is a finding.",
            parse=integer_of,
            document_type=Annotated[doc.Positive | None, doc.about("a bound on the activations")],
        ),
    ] = Converted(_natural("within", 1), None)
    lead: Annotated[
        Converted[int | None, int | None],
        Option(
            RARE_RULES,
            "D",
            "No robot is more than D activations ahead of one that could be activated.",
            parse=integer_of,
            document_type=Annotated[doc.Positive | None, doc.about("null: without a limit")],
        ),
    ] = Converted(_natural("lead", 1), None)
    start_delay: Annotated[
        Converted[int, int],
        Option(
            RARE_RULES,
            "D",
            "Robot 1 begins up to D rounds later, as the adversary likes.",
            parse=integer_of,
            document_type=Annotated[
                doc.Natural, doc.about("by how many rounds robot 1 may begin later")
            ],
        ),
    ] = Converted(_natural("start-delay", 0), 0)
    configurations: Annotated[
        Converted[int, int],
        Option(
            RARE_EFFORT,
            "N",
            "The most configurations in the search of one world.",
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

    schedule: Annotated[
        Converted[str | None, str | None],
        Option(
            RARE_RULES,
            "E E ...",
            "One schedule in place of every one, as in '0L 1L 0M 0+1:2': the robots of each event, "
            "L for a look and M for its move, and behind a colon the index of what the adversary "
            "does.",
            document_type=Annotated[
                doc.IfAny[doc.Text | None], doc.about("the only schedule that was tried")
            ],
        ),
    ] = Converted(_schedule, None)

    @property
    def extent(self) -> Extent:
        """The maps that are searched: a class with its bounds, or the given maps.

        Raises:
            InputError: naming the offending bound and what would be legal.
        """
        unbounded = self.edges is None and self.vertices is None and self.given is None
        edges = DEFAULT_EDGES if unbounded else self.edges
        return Extent(self.map_class, edges, self.vertices, self.where, self.given)

    @cached_property
    @override
    def given(self) -> GivenMaps | None:
        """The given maps, from files, from a graph, or by name; None: a class of maps is searched.

        Raises:
            InputError: naming an option that excludes another one, or has no effect.
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
    def timing(self) -> Timing:
        """The schedules that are tried, and the bounds of a run and of a search.

        Raises:
            InputError: naming an option that has no effect under this scheduler.
        """
        legal = self.model.model.schedulers
        scheduler = legal[0] if self.scheduler is None else self.scheduler
        if scheduler not in legal:
            raise not_one_of(f"scheduler of the model {self.model}", scheduler, legal)
        if self.lead is not None and scheduler == "fsync":
            raise InputError(f"lead = {self.lead} has no effect in fsync: all go together")
        if self.start_delay and scheduler not in ROUNDS:
            raise InputError(
                f"start-delay = {self.start_delay} has no effect in {scheduler}, which has no "
                f"rounds; legal schedulers are {' and '.join(ROUNDS)}"
            )
        schedule = None
        if self.schedule is not None:
            schedule = schedule_of(self.schedule)
            if self.starts is None:
                raise InputError(f"schedule = {show(self.schedule)} needs a world and its starts")
        budget = self.budget if self.within is None else self.within
        limits = self.within is not None, self.configurations, schedule
        return Timing(scheduler, budget, self.lead, self.start_delay, *limits)

    def team(self) -> Team:
        """Load the programs, and return the team.

        Raises:
            InputError: naming a program that cannot be loaded, or a wrong number of programs.
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
    """Make given maps that consist of one map; ``name`` is the map's name in the request.

    If ``starts`` is None, every dart of the map is a root; if an automorphism takes one root to
    another, only the first of these roots is used.  Otherwise ``starts`` has the dart of each robot
    at the start.  Then the dart of the first robot is the only root; the other darts have no
    effect, but must be darts of the map.

    Raises:
        InputError: for a start that is no dart of the map.
    """
    if starts is not None:
        renamed(map_, starts)
        return held("map", name, "the map is given", [GivenMap(map_, (starts[0],))])
    codes = dict[Any, int]()
    for dart in map_.darts:
        codes.setdefault(combinatorial.rooted_code(map_.sigma, map_.alpha, dart), dart)
    return held("map", name, "the map is given", [GivenMap(map_, tuple(codes.values()))])


def renamed(map_: combinatorial.CombinatorialMap, starts: Sequence[int]) -> tuple[int, ...]:
    """The numbers of the starts after the map is numbered canonically from the first start on.

    Raises:
        InputError: for a start that is no dart of the map.
    """
    for dart in starts:
        if dart not in map_.darts:
            last = len(map_.sigma) - 1
            raise InputError(f"starts: {show(dart)} is no dart of the map; legal are 0 to {last}")
    order = combinatorial.numbering(map_.sigma, map_.alpha, starts[0])
    names = combinatorial.inverse(order)
    return tuple(names[dart] for dart in starts)
