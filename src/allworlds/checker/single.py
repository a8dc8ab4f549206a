"""One world at a time: all of them for a loop of one's own, and a run that is told."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Unpack

from allworlds.checker.options import RunOptions, own_rules, refuse_others
from allworlds.episode import Answered, Undecided
from allworlds.findings import Finding, Rules, place_of
from allworlds.inputs import InputError, an_integer, show
from allworlds.isolation import examine_apart, subject_of
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.enumeration import rooted_maps
from allworlds.outcome import SCHEMA, Exit, Verdict
from allworlds.protocol import ANSWER_TIMEOUT
from allworlds.runs import DEFAULT_EDGES, Examiner, Outcome, Referee, name_run
from allworlds.subjects import Subject
from allworlds.work import Limits
from allworlds.world import Lighthouse, World, lighthouse_named, world_named

if TYPE_CHECKING:
    from allworlds import documents


def worlds(
    *,
    edges: int | None = None,
    vertices: int | None = None,
    map_class: str = "maps",
    lighthouse: str = "directional",
    places: Literal["all", "first"] = "first",
) -> Iterator[World]:
    """Every world of a class, in the fixed order.

    Args:
        edges: the largest number of edges (default: one that takes seconds).
        vertices: the largest number of vertices.
        map_class: one of :class:`~allworlds.maps.classes.MapClass`.
        lighthouse: the kind of lighthouse.
        places: ``first``: one world a rooted map, as reports count worlds; ``all``: one for
            every place of the lighthouse, as reports count runs.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if edges is None and vertices is None:
        edges = DEFAULT_EDGES
    extent = Extent(MapClass.named(map_class), edges, vertices)
    kind = lighthouse_named(lighthouse)
    if places not in ("all", "first"):
        raise InputError(f"places {show(places)} is not one of all, first")
    return _worlds(extent, kind, places)


def _worlds(extent: Extent, kind: type[Lighthouse], places: str) -> Iterator[World]:
    for level in extent.levels:
        for map_ in rooted_maps(level, extent.map_class, extent.vertices):
            for placed in kind.places(map_, 0):
                yield World(map_, placed, 0)
                if places == "first":
                    break


@dataclass(frozen=True, slots=True)
class SingleRun:
    """One judged run.

    Attributes:
        explorer: its name.
        world: as it was given.
        rules: how it was played and judged.
        outcome: the episode with its violation.
        finding: the finding, if a law was broken.
    """

    explorer: str
    world: World
    rules: Rules
    outcome: Outcome
    finding: Finding | None

    @property
    def verdict(self) -> Verdict:
        """``holds`` or ``refuted``, about this run alone."""
        return Verdict.REFUTED if self.finding else Verdict.HOLDS

    @property
    def exit_code(self) -> Exit:
        """The exit code of the command."""
        return self.verdict.exit

    def to_json(self) -> documents.RunReport:
        """The document of ``run --json``."""
        ending = self.outcome.episode.ending
        document: documents.RunReport = {
            "schema": SCHEMA,
            "verdict": self.verdict.value,
            "exit_code": self.exit_code,
            "explorer": self.explorer,
            "world": self.world.to_json(),
            "options": self.rules.to_json(),
            "choices": list(self.outcome.choices),
            "cost": self.outcome.cost,
            "bound": self.outcome.bound,
            "estimate": ending.estimate.to_json() if isinstance(ending, Answered) else None,
            "transcript": self.outcome.episode.transcript.to_json(),
            "finding": self.finding.to_json() if self.finding else None,
        }
        if isinstance(ending, Undecided):
            document["ambiguous"] = ending.quotient.to_json()
        return document


def run(
    explore: str | Callable[..., Any],
    world: World | str,
    *,
    choices: Sequence[int] = (),
    **options: Unpack[RunOptions],
) -> SingleRun:
    """One episode, judged.

    An explorer that is not ours and that another process can import is played in one of its
    own, as in a check; any other in this process.

    Args:
        explore: a name or a generator function.
        world: map, lighthouse and start; or what :func:`allworlds.world.world_named` reads,
            under the explorer's own lighthouse where none is named.
        choices: answers to the first choices, by index; then the policy goes on.
        options: see :class:`~allworlds.checker.options.RunOptions` and
            :class:`~allworlds.findings.RulesOptions`.

    Raises:
        InputError: naming the offending option and what would be legal, or the first choice
            that was not taken.
    """
    refuse_others("run", options, RunOptions)
    script = _indices(choices)
    limits = Limits(answer_timeout=options.get("answer_timeout", ANSWER_TIMEOUT))
    subject = subject_of(explore, limits)
    if isinstance(world, str):
        world = world_named(world, subject.lighthouse)
    if not isinstance(world, World):
        raise InputError(f"world = {show(world)} is no World; World.from_json makes one")
    kind = world.lighthouse.kind
    rules = own_rules(subject, options, kind)
    told = single_run(subject, world, rules, script, limits)
    if unused := unused_choice(script, told):
        raise InputError(unused)
    return told


def single_run(
    subject: Subject, world: World, rules: Rules, script: tuple[int, ...], limits: Limits
) -> SingleRun:
    """One episode in which the script answers the first choices, as far as it fits."""
    if subject.foreign:
        outcome = examine_apart(subject, rules, world, script, limits)
    else:
        choices = rules.choices(name_run(rules, world), script)
        outcome = Examiner(subject, rules).examine(world, choices)
    finding = None
    if outcome.violation:
        finding = Referee(subject.name, rules).finding(world, place_of(world), outcome)
    return SingleRun(subject.name, world, rules, outcome, finding)


def _indices(choices: object) -> tuple[int, ...]:
    if isinstance(choices, str) or not isinstance(choices, Iterable):
        raise InputError(f"choices = {show(choices)} is not a list of indices")
    return tuple(an_integer(f"choices[{i}]", index) for i, index in enumerate(choices))


def unused_choice(choices: Sequence[int], told: SingleRun) -> str:
    """The first of these choices that a run has not taken, and why; empty if it has taken all."""
    for i, index in enumerate(choices):
        if told.outcome.choices[i : i + 1] != (index,):
            asked = len(told.outcome.choices)
            only = "none was asked for"
            if asked:
                only = f"only {asked} {'was' if asked == 1 else 'were'} asked for"
            reason = "there are fewer options" if i < asked else only
            return f"choice {i} is {show(index)}, but {reason}"
    return ""
