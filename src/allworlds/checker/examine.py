"""Playing and judging runs: the loop that everything else stands round."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Iterator, MutableSequence
from dataclasses import dataclass

from allworlds.checker.finding import Finding, canonical_world, place_of
from allworlds.checker.scope import Rules, Scope, Work
from allworlds.checker.tally import Tally
from allworlds.episode import Answered, Episode, Fault, Player, own_copy, play, the_same
from allworlds.judge import LAWS, PRECEDENCE, Case, Violation, judge
from allworlds.maps.canonical import rooted_code
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol import Choices
from allworlds.subjects import Subject
from allworlds.world import World

REPORT_EVERY = 0.25
"""Seconds after which a part of a unit is handed over."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """One judged episode.

    Attributes:
        episode: what happened.
        violation: the first broken law, or None.
        detail: a traceback, or a program's stderr; may be empty.
        choices: the index taken at each choice.
        bound: the largest legal number of traversals, or None.
    """

    episode: Episode
    violation: Violation | None
    detail: str
    choices: tuple[int, ...]
    bound: int | None

    @property
    def cost(self) -> int:
        """Edge traversals."""
        return self.episode.transcript.cost


class Examiner:
    """One explorer under one set of rules.

    Args:
        subject: the explorer.
        rules: how runs are played and judged.
        beat: see :func:`allworlds.episode.play`.
        intact: called after each episode, to look at what the explorer may have broken.
    """

    def __init__(
        self,
        subject: Subject,
        rules: Rules,
        beat: MutableSequence[int] | None = None,
        intact: Callable[[], None] = lambda: None,
    ) -> None:
        self.subject = subject
        self.rules = rules
        self.events: list[str] = []
        self._beat = beat if beat is not None else [0, 0]
        self._laws = [LAWS[law] for law in rules.applying]
        self._player: Player = subject.player(self.events.append)
        self._hand = own_copy if subject.foreign else the_same
        self._intact = intact

    def examine(self, world: World, choices: Choices, run: str = "") -> Outcome:
        """Play one episode, and judge it; a foreign explorer plays a second one."""
        map_ = world.map
        bound = self.rules.the_bound.of(map_, world.start)
        budget = self.rules.budget(map_)
        episode = self._play(world, choices, budget)
        record = tuple(choices.record)
        violation = self.verdict(world, episode, bound)
        ending = episode.ending
        if self.subject.foreign and _may_be_overruled(violation):
            again = self.rules.choices(run, record)
            second = self._play(_renamed(world), again, budget)
            difference = _difference(episode, second)
            violation = difference or violation
            if difference and isinstance(second.ending, Fault):
                ending = second.ending
        detail = ending.detail if isinstance(ending, Fault) else ""
        return Outcome(episode, violation, detail, record, bound)

    def _play(self, world: World, choices: Choices, budget: int) -> Episode:
        episode = play(world, self._player, choices, budget, self._beat, self._hand)
        self._intact()
        return episode

    def verdict(self, world: World, episode: Episode, bound: int | None) -> Violation | None:
        """The first law that a finished episode breaks."""
        ending = episode.ending
        if isinstance(ending, Fault):
            return Violation(ending.law, ending.expected, ending.seen)
        case = Case(
            world.map,
            world.start,
            episode.transcript,
            episode.checkpoints,
            ending.estimate,
            bound,
        )
        return judge(case, self._laws)

    def name_run(self, world: World) -> str:
        """A name for a run that does not depend on the order of runs; empty if unused."""
        if not self.rules.policy.startswith("random"):
            return ""
        return f"{rooted_code(world.map.sigma, world.map.alpha, 0)}/{place_of(world)}"


def examine_unit(
    examiner: Examiner,
    scope: Scope,
    unit: Work,
    keep: int,
    beat: MutableSequence[int],
    start: int = 0,
    skip: Collection[int] = (),
) -> Iterator[tuple[int, Tally]]:
    """All runs of a unit, tallied in parts.

    Args:
        examiner: explorer and rules.
        scope: for its schedules and bounds.
        unit: the maps to visit.
        keep: how many findings are kept.
        beat: ``beat[0]`` is set to the number of the run within the unit.
        start: the number of the first run that has not been tallied yet; a world without a
            place counts as one.
        skip: runs that must not be tried (they have killed a worker); they are counted.

    Yields:
        After some time, and at the end, the number of the next run and the tally since.
    """
    tally = Tally(keep)
    due = time.monotonic() + REPORT_EVERY
    number = 0
    for map_, places in unit.placed(scope):
        for i, (place, lighthouse) in enumerate(places or [(0, None)]):
            if number >= start:
                if i == 0:
                    _count_world(tally, map_)
                if lighthouse is None:
                    tally.left_out += 1
                elif number in skip:
                    tally.row(map_.edge_count, map_.vertex_count).runs += 1
                else:
                    beat[0] = number
                    _run(examiner, scope, World(map_, lighthouse, 0), place, tally)
            number += 1
            if number > start and time.monotonic() > due:
                yield number, tally
                tally = Tally(keep)
                due = time.monotonic() + REPORT_EVERY
    yield number, tally


def _count_world(tally: Tally, map_: CombinatorialMap) -> None:
    tally.row(map_.edge_count, map_.vertex_count).worlds += 1
    if map_.loop_count:
        tally.witnesses["loop-edge"] += 1
    if map_.parallel_count:
        tally.witnesses["parallel-edge"] += 1


def _run(examiner: Examiner, scope: Scope, world: World, place: int, tally: Tally) -> None:
    """Every schedule of one run."""
    map_ = world.map
    name = examiner.name_run(world)
    row = tally.row(map_.edge_count, map_.vertex_count)
    row.runs += 1
    for choices in scope.schedule(name):
        outcome = examiner.examine(world, choices, name)
        cost = outcome.cost
        row.episodes += 1
        row.traversals += cost
        if place == 0:
            row.traversals_rooted += cost
        row.max_cost = max(row.max_cost, cost)
        row.bound_of(outcome.bound)
        tally.checkpoints += len(outcome.episode.checkpoints)
        if outcome.violation and tally.wants(map_.edge_count, map_.vertex_count):
            tally.find(make_finding(examiner, world, place, outcome))
    tally.witnesses.update(examiner.events)
    examiner.events.clear()


def make_finding(examiner: Examiner, world: World, place: int, outcome: Outcome) -> Finding:
    """The finding of a refuting outcome, in canonical numbering."""
    assert outcome.violation is not None
    violation = outcome.violation
    canonical = canonical_world(world)
    if isinstance(outcome.episode.ending, Answered):
        # What was expected and seen may name darts: judge again under the canonical names.
        again = examiner.verdict(canonical, outcome.episode, outcome.bound)
        if again and again.law == violation.law:
            violation = again
    return Finding(
        examiner.subject.name,
        violation.law,
        canonical,
        place,
        examiner.rules,
        outcome.choices,
        outcome.episode.transcript,
        violation.expected,
        violation.seen,
        outcome.detail,
    )


def _may_be_overruled(violation: Violation | None) -> bool:
    if violation is None:
        return True
    return PRECEDENCE.index("nondeterministic") < PRECEDENCE.index(violation.law)


def _renamed(world: World) -> World:
    """The same world under other names of its darts."""
    return world.relabelled([*reversed(world.map.darts)])


def _difference(first: Episode, second: Episode) -> Violation | None:
    """What the same explorer has done otherwise when the darts had other names.

    A second run that ended without an answer has broken a law of its own, which precedes.
    """
    if first.transcript == second.transcript and _meaning(first) == _meaning(second):
        return None
    fault = second.ending
    if isinstance(fault, Fault) and not isinstance(first.ending, Fault):
        return Violation(
            fault.law, fault.expected, f"in the second run of this world: {fault.seen}"
        )
    if first.transcript == second.transcript:
        return _nondeterministic("the second answer differs")
    steps = zip(first.transcript.steps, second.transcript.steps, strict=False)
    same = next((i for i, (a, b) in enumerate(steps) if a != b), None)
    where = "in its length" if same is None else f"at step {same + 1}"
    return _nondeterministic(f"the second walk differs {where}")


def _nondeterministic(seen: str) -> Violation:
    return Violation(
        "nondeterministic",
        "the same walk and answer when the same world is explored again under other names",
        seen,
    )


def _meaning(episode: Episode) -> object:
    """What must be equal in both runs: the estimate, or the law of the fault."""
    ending = episode.ending
    return ending.law if isinstance(ending, Fault) else ending.estimate
