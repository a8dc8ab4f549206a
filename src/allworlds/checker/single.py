"""One world at a time: all of them for a loop of one's own, and a run that is told."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from allworlds.checker.confirm import examine_apart
from allworlds.checker.examine import Examiner, Outcome, make_finding
from allworlds.checker.finding import Finding, place_of
from allworlds.checker.report import EXIT_CODES, SCHEMA, Verdict
from allworlds.checker.scope import Limits, Rules, Scope, ScopeError, make_rules, make_scope
from allworlds.episode import Answered
from allworlds.errors import an_integer, show
from allworlds.maps.enumeration import rooted_maps
from allworlds.subjects import own_bound, subject_of
from allworlds.world import World


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
        map_class: ``maps``, ``simple``, ``planar`` or ``planar-simple``.
        lighthouse: the kind of lighthouse.
        places: ``first``: one world a rooted map, as reports count worlds; ``all``: one for
            every place of the lighthouse, as reports count runs.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    scope = make_scope(edges=edges, vertices=vertices, map_class=map_class, lighthouse=lighthouse)
    if places not in ("all", "first"):
        raise ScopeError(f"places {show(places)} is none of all, first")
    return _worlds(scope, places)


def _worlds(scope: Scope, places: str) -> Iterator[World]:
    bounds, kind = scope.bounds, scope.rules.kind
    for level in bounds.levels:
        for map_ in rooted_maps(level, bounds.map_class, bounds.vertices):
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
    def exit_code(self) -> int:
        """The exit code of the command."""
        return EXIT_CODES[self.verdict]

    def to_json(self) -> dict[str, Any]:
        """The document of ``run --json``."""
        ending = self.outcome.episode.ending
        estimate = None
        if isinstance(ending, Answered):
            estimate = {**ending.estimate.map.to_json(), "here": ending.estimate.here}
        return {
            "schema": SCHEMA,
            "verdict": self.verdict.value,
            "exit_code": self.exit_code,
            "explorer": self.explorer,
            "world": self.world.to_json(),
            "options": self.rules.to_json(),
            "choices": list(self.outcome.choices),
            "cost": self.outcome.cost,
            "bound": self.outcome.bound,
            "estimate": estimate,
            "transcript": self.outcome.episode.transcript.to_json(),
            "finding": self.finding.to_json() if self.finding else None,
        }


def run(
    explore: str | Callable[..., Any],
    world: World,
    *,
    policy: str = "fifo",
    choices: Sequence[int] = (),
    bound: str | int | None = None,
    laws: Iterable[str] | None = None,
    step_budget: int | None = None,
    answer_timeout: float = 10.0,
) -> SingleRun:
    """One episode, judged.

    An explorer that is not ours and that another process can import is played in one of its
    own, as in a check; any other in this process.

    Args:
        explore: a name or a generator function.
        world: map, lighthouse and start.
        policy: answers the choices after those of ``choices``.
        choices: answers to the first choices, by index.
        bound: ``paper``, ``two-vertices``, ``none``, an expression or an integer; None takes
            the explorer's own, else the lighthouse's.
        laws: those to check; None takes all that apply.
        step_budget: the largest legal number of traversals.
        answer_timeout: seconds of silence after which the explorer is killed.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if not isinstance(world, World):
        raise ScopeError(f"world = {show(world)} is no World; World.from_json makes one")
    script = _indices(choices)
    limits = Limits(answer_timeout=answer_timeout)
    subject = subject_of(explore, answer_timeout)
    rules = make_rules(
        lighthouse=world.lighthouse.kind,
        policy=policy,
        bound=bound,
        own_bound=own_bound(subject.name, world.lighthouse.kind),
        laws=laws,
        step_budget=step_budget,
    )
    examiner = Examiner(subject, rules)
    if subject.foreign and subject.importable:
        outcome = examine_apart(subject, rules, world, script, limits)
    else:
        name = examiner.name_run(world)
        outcome = examiner.examine(world, rules.choices(name, script), name)
    finding = None
    if outcome.violation:
        finding = make_finding(examiner, world, place_of(world), outcome)
    return SingleRun(subject.name, world, rules, outcome, finding)


def _indices(choices: object) -> tuple[int, ...]:
    if isinstance(choices, str) or not isinstance(choices, Iterable):
        raise ScopeError(f"choices = {show(choices)} is not a list of indices")
    return tuple(an_integer(f"choices[{i}]", index) for i, index in enumerate(choices))


def refuse_unused(choices: Sequence[int], told: SingleRun) -> None:
    """Nothing, if a run has taken all these choices.

    Raises:
        InputError: naming the first that it has not taken.
    """
    if unused := unused_choice(choices, told):
        raise ScopeError(unused)


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
