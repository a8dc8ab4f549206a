"""The report of one judged run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

from allworlds.document import (
    EXIT_CODE,
    UNSET,
    Aside,
    ExitCode,
    Natural,
    Report,
    Text,
    UnsetType,
    about,
    computed,
    one_of,
)
from allworlds.engines.python.examiner import Outcome
from allworlds.inputs import show
from allworlds.judging import (
    Answered,
    Ending,
    Finding,
    RecordedRules,
    Rules,
    Undecided,
    checked_laws,
)
from allworlds.outcome import Exit, Facts, Verdict
from allworlds.protocol import Ambiguous, Estimate, Transcript
from allworlds.world import World


class SingleRun(Report):
    """Report of 'run'.

    One judged run.
    """

    verdict: Annotated[
        Verdict,
        about("about this run alone"),
        one_of(Verdict.HOLDS, Verdict.REFUTED, Verdict.VACUOUS),
    ] = computed(lambda run: run.facts.verdict)
    exit_code: Annotated[ExitCode, one_of(Exit.HOLDS, Exit.REFUTED, Exit.VACUOUS)] = EXIT_CODE
    explorer: Annotated[Text, about("its name")]
    world: Annotated[World, about("as it was given")]
    options: Annotated[RecordedRules, about("how it was played and judged")] = computed(
        lambda run: run.rules.recorded
    )
    choices: Annotated[tuple[Natural, ...], about("the index taken at each choice")] = computed(
        lambda run: run.outcome.choices
    )
    cost: Annotated[Natural, about("traversals")] = computed(lambda run: run.outcome.cost)
    bound: Annotated[int | None, about("of the traversals; null without one")] = computed(
        lambda run: run.outcome.bound
    )
    estimate: Annotated[Estimate | None, about("the answer; null where there is none")] = computed(
        lambda run: run.ending.estimate if isinstance(run.ending, Answered) else None
    )
    transcript: Annotated[Transcript | UnsetType, about("the log; not with `--no-walk`")] = (
        computed(lambda run: run.outcome.episode.transcript if run.shows_walk else UNSET)
    )
    finding: Annotated[Finding | None, about("null: no law is broken")]
    ambiguous: Annotated[
        Ambiguous | UnsetType, about("the answer that names no map, where there is one")
    ] = computed(lambda run: run.ending.quotient if isinstance(run.ending, Undecided) else UNSET)
    output: Annotated[Text | UnsetType, about("what the explorer printed, if anything")] = computed(
        lambda run: run.outcome.output or UNSET
    )
    rules: Aside[Rules]
    outcome: Aside[Outcome]
    shows_walk: Aside[bool] = True

    @property
    def facts(self) -> Facts:
        """Whether a law is broken, or none was checked."""
        return Facts(refuted=self.finding is not None, vacuous=not self.checked_laws)

    @property
    def checked_laws(self) -> tuple[str, ...]:
        """The laws of which something was checked."""
        return checked_laws(self.rules.judged, 1, len(self.outcome.episode.checkpoints))

    @property
    def ending(self) -> Ending:
        """The ending of the episode: an answer, or a fault."""
        return self.outcome.episode.ending


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
