"""One run: judged, and made a finding if it breaks a law."""

from __future__ import annotations

from msgspec import Struct

from allworlds.explorers.loading import Subject
from allworlds.inputs.checks import show
from allworlds.judging.episode import Answered, Episode, Fault, play
from allworlds.judging.findings.finding import Finding, canonical_world, place_of
from allworlds.judging.findings.rules import Rules
from allworlds.judging.laws.finished_run import Case, Violation, first_wrong
from allworlds.judging.laws.law_table import LAWS, judge
from allworlds.maps.canonical import rooted_code
from allworlds.protocol.answers import Ambiguous
from allworlds.protocol.choices import Choices
from allworlds.world.world import World


class Outcome(Struct, frozen=True):
    """One judged episode.

    Attributes:
        episode: the run.
        violation: the first broken law, or None.
        detail: a traceback, or a program's stderr; may be empty.
        choices: the index taken at each choice.
        bound: the largest legal number of traversals, or None.
        hash_seed: the players' one, if it makes a difference.
        output: the explorer's prints, if they were recorded.
    """

    episode: Episode
    violation: Violation | None
    detail: str
    choices: tuple[int, ...]
    bound: int | None
    hash_seed: int | None = None
    output: str = ""

    @property
    def cost(self) -> int:
        """The number of edge traversals."""
        return self.episode.transcript.cost


class Referee:
    """A referee judges runs under one set of rules; it knows only the name of the explorer."""

    def __init__(self, explorer: str, rules: Rules) -> None:
        self.explorer = explorer
        self.rules = rules
        self._checks = [LAWS[law].check for law in rules.applying]

    def outcome(self, world: World, episode: Episode, choices: tuple[int, ...]) -> Outcome:
        """Judge an episode."""
        bound = self.rules.the_bound.of(world.map, world.start)
        violation = self.verdict(world, episode, bound)
        ending = episode.ending
        detail = ending.detail if isinstance(ending, Fault) else ""
        return Outcome(episode, violation, detail, choices, bound)

    def verdict(self, world: World, episode: Episode, bound: int | None) -> Violation | None:
        """The first law that a finished episode breaks."""
        ending = episode.ending
        if isinstance(ending, Fault):
            return Violation(ending.law, ending.expected, ending.seen)
        task, answer = self.rules.task, ending.answer if isinstance(ending, Answered) else None
        leaves_open = world.lighthouse.as_kind.leaves_open
        if task.is_map and isinstance(answer, Ambiguous) and not leaves_open:
            return Violation(
                "no-estimate",
                f"a map: the {world.lighthouse.kind} lighthouse has no answer without one",
                show(answer),
            )
        if not task.is_map and (wrong := task.flaw(world, episode.transcript, ending)) is not None:
            return Violation("task", task.asks, wrong)
        case = Case(
            world.map,
            world.start,
            episode.transcript,
            episode.checkpoints,
            answer if task.is_map else None,
            bound,
        )
        return judge(case, self._checks)

    def finding(self, world: World, place: int, outcome: Outcome) -> Finding:
        """The finding of a refuting outcome, in canonical numbering."""
        assert outcome.violation is not None
        violation, ending = outcome.violation, outcome.episode.ending
        canonical = canonical_world(world)
        wrong = None
        if isinstance(ending, Fault):
            wrong = self._wrong_checkpoint(world, outcome.episode)
        else:
            # What was expected and seen may name darts: judge again under the canonical names.
            again = self.verdict(canonical, outcome.episode, outcome.bound)
            if again and again.law == violation.law:
                violation = again
        return Finding(
            version=2,
            explorer=self.explorer,
            world=canonical,
            at=place,
            options=self.rules.recorded,
            under=self.rules,
            law=violation.law,
            choices=outcome.choices,
            transcript=outcome.episode.transcript,
            expected=violation.expected,
            seen=violation.seen,
            detail=outcome.detail,
            step=wrong[0] if wrong else violation.step,
            wrong_checkpoint=wrong[1] if wrong else "",
            machine=isinstance(ending, Fault) and ending.machine,
            hash_seed=outcome.hash_seed,
            output=outcome.output,
        )

    def _wrong_checkpoint(self, world: World, episode: Episode) -> tuple[int, str] | None:
        """The first wrong checkpoint of a run without an answer, and what is wrong with it."""
        if "invariant-1" not in self.rules.applying:
            return None
        case = Case(world.map, world.start, episode.transcript, episode.checkpoints, None, None)
        return first_wrong(case)


class Examiner(Referee):
    """An examiner plays and judges runs of a built-in explorer in this process, each once."""

    def __init__(self, subject: Subject, rules: Rules) -> None:
        super().__init__(subject.name, rules)
        self._player = subject.player()

    def examine(self, world: World, choices: Choices) -> Outcome:
        """Play one episode, and judge it."""
        rules, task = self.rules, self.rules.task
        around, budget = task.environment(world), rules.budget(world.map)
        episode = play(around, self._player, choices, budget, maps=task.is_map)
        return self.outcome(world, episode, tuple(choices.record))


LOST = ("crash", "timeout")
"""The laws that the machine may break, not the explorer alone."""


def name_run(rules: Rules, world: World) -> str:
    """A name for a run that does not depend on the order of runs; empty if unused."""
    if not rules.policy.startswith("random"):
        return ""
    return f"{rooted_code(world.map.sigma, world.map.alpha, 0)}/{place_of(world)}"
