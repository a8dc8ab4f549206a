"""The judgement of one run by a referee, which also makes the finding if the run breaks a law.

An examiner is a referee that also plays the run.
"""

from msgspec import Struct

from allworlds.documents.document import replace
from allworlds.explorers.loading import Subject
from allworlds.inputs.checks import show
from allworlds.judging.episode import Answered, Episode, Fault, play
from allworlds.judging.findings.finding import (
    Believed,
    EarlierRun,
    Finding,
    canonical_world,
    place_of,
)
from allworlds.judging.laws.law_table import LAWS, Case, Violation, first_broken, first_wrong
from allworlds.judging.rules import Rules
from allworlds.judging.walk import Walk
from allworlds.maps.combinatorial import rooted_code
from allworlds.protocol import actions, choices
from allworlds.world.world import World

LOST = ("crash", "timeout")
"""The laws that a run may break because of the machine, without a fault of the explorer."""


class Outcome(Struct, frozen=True):
    """One judged run.

    Attributes:
        episode: the walk of the run, its checkpoints and its ending.
        violation: the violation of the first law that the run breaks; None if it breaks none.
        detail: more about a fault: a traceback, or a program's stderr; may be empty.
        choices: for each choice of the explorer the index of the option that was taken.
        bound: the largest number of traversals that the law ``bound`` allows in the run's world;
            None if there is no bound.
        hash_seed: the players' ``PYTHONHASHSEED`` if the outcome depends on this number; else None.
        output: the text that the explorer has printed, if prints were recorded; else empty.
        after: the worlds of earlier runs in the same process, if the outcome depends on those runs.
    """

    episode: Episode
    violation: Violation | None
    detail: str
    choices: tuple[int, ...]
    bound: int | None
    hash_seed: int | None = None
    output: str = ""
    after: tuple[World, ...] = ()

    @property
    def cost(self) -> int:
        """The number of edge traversals."""
        return self.episode.walk.cost


class Referee:
    """A referee judges runs by the rules ``rules``; ``explorer`` is the name of the explorer."""

    def __init__(self, explorer: str, rules: Rules) -> None:
        self.explorer = explorer
        self.rules = rules
        self._checks = [LAWS[law].check for law in rules.applying]

    def outcome(self, world: World, episode: Episode, choices: tuple[int, ...]) -> Outcome:
        """Judge the episode of a run in ``world``; return the outcome of the run.

        ``choices`` holds for each choice of the explorer the index of the option that was taken.
        """
        bound = self.rules.the_bound.of(world.map, world.start)
        violation = self.verdict(episode, bound)
        ending = episode.ending
        detail = ending.detail if isinstance(ending, Fault) else ""
        return Outcome(episode, violation, detail, choices, bound)

    def verdict(self, episode: Episode, bound: int | None) -> Violation | None:
        """The violation of the first law that a finished episode breaks; None if it breaks none.

        ``bound`` is the largest number of traversals that the law ``bound`` allows; None if there
        is no bound.
        """
        walk, ending = episode.walk, episode.ending
        if isinstance(ending, Fault):
            expected = ending.expected
            if ending.law == "budget" and self.rules.task.ends_runs:  # without an answer
                done = self.rules.task.asks.partition(";")[0]
                expected = expected.replace("an answer within", f"{done} within")
            return Violation(ending.law, expected, ending.seen)
        task, answer = self.rules.task, ending.answer if isinstance(ending, Answered) else None
        lighthouse = walk.world.lighthouse
        if (
            task.is_map
            and isinstance(answer, actions.Ambiguous)
            and not lighthouse.as_kind.leaves_open
        ):
            return Violation(
                "no-estimate",
                f"a map: the {lighthouse.kind} lighthouse has no answer without one",
                show(answer),
            )
        if not task.is_map and (wrong := task.flaw(walk, ending)) is not None:
            return Violation("task", task.asks, wrong)
        estimate = answer if task.is_map else None
        return first_broken(Case(walk, episode.checkpoints, estimate, bound), self._checks)

    def finding(self, world: World, place: int, outcome: Outcome) -> Finding:
        """The finding about a run that breaks a law; ``outcome`` is the run's outcome.

        ``world`` is the world of the run, and ``place`` the number of the lighthouse's place in the
        map.  In the finding, the darts of the world are numbered canonically.
        """
        assert outcome.violation is not None
        violation, ending = outcome.violation, outcome.episode.ending
        canonical, step = canonical_world(world), violation.step
        believed, wrong = _believed(outcome.episode, step)
        if not isinstance(ending, Fault) or "invariant-1" not in self.rules.applying:
            wrong = ""
        if believed and wrong:
            step = believed.step
        if not isinstance(ending, Fault):
            # The texts of the violation may name darts, so judge again with canonical numbers.
            walk = Walk.of(canonical, outcome.episode.walk.actions)
            again = self.verdict(replace(outcome.episode, walk=walk), outcome.bound)
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
            step=step,
            wrong_checkpoint=wrong,
            believed=believed,
            machine=isinstance(ending, Fault) and ending.machine,
            hash_seed=outcome.hash_seed,
            output=outcome.output,
            after=tuple(EarlierRun(world=before) for before in outcome.after),
        )


DARTS = range(1 << 63)
"""The numbers that a document can hold as darts; a checkpoint may also hold other numbers."""


def _believed(episode: Episode, step: int | None) -> tuple[Believed | None, str]:
    """The first checkpoint that breaks the law invariant-1 or invariant-2, and its fault in words.

    Only the checkpoints after exactly ``step`` steps are examined; if ``step`` is None, all
    checkpoints are.  If no examined checkpoint breaks these laws, the result is the last examined
    checkpoint, with an empty text.  If there is no checkpoint to examine, the result is None, with
    an empty text.
    """
    at = [i for i, (steps, _) in enumerate(episode.checkpoints) if step in (None, steps)]
    given = tuple([episode.checkpoints[i] for i in at])
    wrong = first_wrong(Case(episode.walk, given, None, None))
    if not at:
        return None, ""
    number = at[wrong[0] if wrong else -1]
    steps, shown = episode.checkpoints[number]
    sigma, alpha, what = tuple(shown.sigma), tuple(shown.alpha), wrong[1] if wrong else ""
    here = shown.here if shown.here in DARTS else 0
    if not all(dart in DARTS for dart in (*sigma, *alpha)):
        sigma, alpha = (), ()
    return Believed(number=number, step=steps, sigma=sigma, alpha=alpha, here=here), what


class Examiner(Referee):
    """An examiner plays each run of a built-in explorer once, in this process, and judges it."""

    def __init__(self, subject: Subject, rules: Rules) -> None:
        super().__init__(subject.name, rules)
        self._player = subject.player()

    def examine(self, world: World, choices: choices.Choices) -> Outcome:
        """Play one run in ``world``, and judge it; ``choices`` makes the explorer's choices."""
        rules, task = self.rules, self.rules.task
        budget = rules.budget(world.map)
        episode = play(world, self._player, choices, budget, maps=task.is_map, over=task.over)
        return self.outcome(world, episode, tuple(choices.record))


def name_run(rules: Rules, world: World) -> str:
    """The name of the run in ``world``; empty if the policy of ``rules`` is not random.

    Under a policy ``random:SEED`` the choices of a run follow from SEED and the name of the run.
    The name depends on the world and the place of its lighthouse, but not on the order in which
    runs are played.
    """
    if not rules.policy.startswith("random"):
        return ""
    return f"{rooted_code(world.map.sigma, world.map.alpha, 0)}/{place_of(world)}"
