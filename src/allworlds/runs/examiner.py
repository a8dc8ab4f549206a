"""One run: played, judged, and made a finding if it breaks a law."""

from __future__ import annotations

from collections.abc import Callable, MutableSequence
from dataclasses import dataclass

from allworlds.episode import Answered, Episode, Fault, Player, own_copy, play, the_same
from allworlds.findings import Finding, Rules, canonical_world, place_of
from allworlds.judge import LAWS, PRECEDENCE, Case, Violation, judge
from allworlds.maps.canonical import rooted_code
from allworlds.protocol import Choices
from allworlds.subjects import Subject
from allworlds.world import World


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
        self.beat = beat if beat is not None else [0, 0]
        self._checks = [LAWS[law].check for law in rules.applying]
        self._player: Player = subject.player(self.events.append)
        self._hand = own_copy if subject.foreign else the_same
        self._intact = intact

    def examine(self, world: World, choices: Choices, name: str = "") -> Outcome:
        """Play one episode, and judge it; a foreign explorer plays a second one."""
        map_ = world.map
        bound = self.rules.the_bound.of(map_, world.start)
        budget = self.rules.budget(map_)
        episode = self._play(world, choices, budget)
        record = tuple(choices.record)
        violation = self.verdict(world, episode, bound)
        ending = episode.ending
        if self.subject.foreign and _may_be_overruled(violation):
            again = self.rules.choices(name, record)
            second = self._play(_renamed(world), again, budget)
            difference = _difference(episode, second)
            violation = difference or violation
            if difference and isinstance(second.ending, Fault):
                ending = second.ending
        detail = ending.detail if isinstance(ending, Fault) else ""
        return Outcome(episode, violation, detail, record, bound)

    def _play(self, world: World, choices: Choices, budget: int) -> Episode:
        episode = play(world, self._player, choices, budget, self.beat, self._hand)
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
        return judge(case, self._checks)

    def name_run(self, world: World) -> str:
        """A name for a run that does not depend on the order of runs; empty if unused."""
        if not self.rules.policy.startswith("random"):
            return ""
        return f"{rooted_code(world.map.sigma, world.map.alpha, 0)}/{place_of(world)}"


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
        violation.step,
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
