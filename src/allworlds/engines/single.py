"""One run, judged: in this process, or in one of its own where the explorer is foreign."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from allworlds.engines.isolation.confirm import examine_apart
from allworlds.engines.python.examiner import Examiner, Outcome, Referee, name_run
from allworlds.engines.units.effort import Limits
from allworlds.explorers import Subject
from allworlds.inputs import show
from allworlds.judging import Answered, Finding, Rules, Undecided, place_of
from allworlds.outcome import SCHEMA, Exit, Verdict
from allworlds.world import World

if TYPE_CHECKING:
    from allworlds import documents


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

    def to_json(self) -> documents.RunDocument:
        """The document of ``run --json``."""
        ending = self.outcome.episode.ending
        document: documents.RunDocument = {
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


def single_run(
    subject: Subject, world: World, rules: Rules, script: tuple[int, ...], limits: Limits
) -> SingleRun:
    """One episode in which the script answers the first choices, as far as it fits."""
    if subject.from_user:
        outcome = examine_apart(subject, rules, world, script, limits)
    else:
        choices = rules.choices(name_run(rules, world), script)
        outcome = Examiner(subject, rules).examine(world, choices)
    finding = None
    if outcome.violation:
        finding = Referee(subject.name, rules).finding(world, place_of(world), outcome)
    return SingleRun(subject.name, world, rules, outcome, finding)


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
