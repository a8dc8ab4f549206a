"""One run, judged: in this process, or in one of its own if the explorer is a user's."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext
from typing import Annotated

from allworlds.document import (
    EXIT_CODE,
    UNSET,
    Aside,
    Document,
    ExitCode,
    IfAny,
    Natural,
    Report,
    Text,
    UnsetType,
    about,
    computed,
    one_of,
    replace,
)
from allworlds.engines.isolation.apart import examine_apart, walk_apart
from allworlds.engines.python.examiner import Examiner, Outcome, Referee, name_run
from allworlds.engines.python.prints import Silence, printing_to
from allworlds.engines.units.effort import Limits
from allworlds.explorers import BUILT_IN, Subject
from allworlds.inputs import InputError, show
from allworlds.judging import (
    Answered,
    Ending,
    Finding,
    RecordedRules,
    Rules,
    Undecided,
    checked_laws,
    place_of,
    play,
)
from allworlds.outcome import Exit, Facts, Verdict
from allworlds.protocol import Ambiguous, Estimate, Transcript
from allworlds.world import Adversary, Deciding, World


class Decisions(Document):
    """Decisions of an adversary.

    The play against it in which the world came about.
    """

    name: Annotated[Text, about("`adversary:corridor:F` or `adversary:corridor:FxR`")]
    seed: Annotated[Natural, about("of the loops, and of the matching at first")]
    cost: Annotated[Natural, about("traversals against the adversary")]
    excluded: Annotated[Natural, about("pairs of free darts that an answer has excluded")]
    forced: Annotated[Natural, about("edges that were left as the only ones")]
    settled: Annotated[
        Natural, about("edges that were fixed since the explorer had settled the vertex behind")
    ]
    depended: Annotated[
        Natural, about("edges that were fixed before an answer that depended on two")
    ]
    testers: Annotated[
        Natural, about("traversals that every tester of home words needs against it")
    ]
    testers_exclude: Annotated[Natural, about("pairs that the tests of each of them exclude")]
    tester: Annotated[
        bool, about("whether the explorer is known to be a tester: then it reaches both numbers")
    ]
    same: Annotated[bool, about("whether the explorer walks in the world as against the adversary")]

    @property
    def keeps_the_bound(self) -> bool:
        """Whether a known tester has walked and excluded as much as every tester must."""
        enough = self.cost >= self.testers and self.excluded >= self.testers_exclude
        return enough or not self.tester


class SingleRun(Report):
    """Report of 'run'.

    One judged run.
    """

    verdict: Annotated[
        Verdict,
        about("about this run alone; `error`: a tester did less than every tester must"),
        one_of(Verdict.HOLDS, Verdict.REFUTED, Verdict.VACUOUS, Verdict.ERROR),
    ] = computed(lambda run: run.facts.verdict)
    exit_code: Annotated[
        ExitCode, one_of(Exit.HOLDS, Exit.REFUTED, Exit.VACUOUS, Exit.INTERNAL)
    ] = EXIT_CODE
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
    adversary: Annotated[
        IfAny[Decisions | None], about("the adversary that has made the world, if one has")
    ] = None
    output: Annotated[Text | UnsetType, about("what the explorer printed, if anything")] = computed(
        lambda run: run.outcome.output or UNSET
    )
    rules: Aside[Rules]
    outcome: Aside[Outcome]
    shows_walk: Aside[bool] = True

    @property
    def facts(self) -> Facts:
        """Whether a law is broken or none was checked, or the adversary saw another walk.

        A tester that breaks no law and does less than its bounds say refutes the theorem, or the
        adversary.
        """
        made = self.adversary
        refuted = self.finding is not None or (made is not None and not made.same)
        less = made is not None and not made.keeps_the_bound
        return Facts(refuted=refuted, disagrees=less and not refuted, vacuous=not self.checked_laws)

    @property
    def checked_laws(self) -> tuple[str, ...]:
        """The laws of which something was checked."""
        return checked_laws(self.rules.judged, 1, len(self.outcome.episode.checkpoints))

    @property
    def ending(self) -> Ending:
        """The ending of the episode: an answer, or a fault."""
        return self.outcome.episode.ending


def single_run(
    subject: Subject,
    world: World,
    rules: Rules,
    script: tuple[int, ...],
    limits: Limits,
    hash_seed: int | None = None,
) -> SingleRun:
    """One episode in which the script answers the first choices, as far as it fits.

    Both players of a user's explorer have the hash seed, if one is given.
    """
    if subject.from_user:
        outcome = examine_apart(subject, rules, world, script, limits, hash_seed)
    else:
        choices = rules.choices(name_run(rules, world), script)
        outcome = Examiner(subject, rules).examine(world, choices)
    finding = None
    if outcome.violation:
        finding = Referee(subject.name, rules).finding(world, place_of(world), outcome)
    return SingleRun(
        explorer=subject.name, world=world, finding=finding, rules=rules, outcome=outcome
    )


def adversarial_run(
    subject: Subject,
    adversary: Adversary,
    rules: Rules,
    script: tuple[int, ...],
    limits: Limits,
    hash_seed: int | None = None,
) -> SingleRun:
    """One episode in the world that an adversary makes while the explorer plays against it.

    Args:
        subject: plays against the adversary, and then in the world that is left.
        adversary: gets the actions and the checkpoints, no more.
        rules: by which the run is played and judged.
        script: answers to the first choices.
        limits: of processes, for a user's explorer.
        hash_seed: of all players of a user's explorer, if one is given.

    Raises:
        InputError: for another task than ``map``.

    Cost: that of two runs, or of four of a user's explorer.
    """
    if not rules.task.is_map:
        raise InputError(f"task {show(rules.task.name)} is not for {adversary}; 'map' is")
    deciding = Deciding(adversary)
    if subject.from_user and subject.importable:
        traced = walk_apart(subject, rules, adversary, script, limits, hash_seed)
        walk, choices = traced.transcript.actions, traced.choices
        deciding.repeat(walk, traced.settled)
    else:
        heard = rules.choices("", script)
        budget = rules.budget(adversary.at_first.map)
        player = subject.player(settled=deciding.hear)
        with printing_to(Silence()) if subject.from_user else nullcontext():
            episode = play(deciding, player, heard, budget, watch=deciding.heed)
        walk, choices = episode.transcript.actions, tuple(heard.record)
    run = single_run(subject, deciding.world(), rules, choices, limits, hash_seed)
    built_in = None if subject.from_user else BUILT_IN.get(subject.name)
    decisions = Decisions(
        name=str(adversary),
        seed=adversary.seed,
        cost=len(walk),
        excluded=deciding.excluded,
        forced=deciding.forced,
        settled=len(deciding.settled),
        depended=deciding.depended,
        testers=adversary.shape.bound_of_testers,
        testers_exclude=adversary.shape.excluded_by_testers,
        tester=built_in is not None and built_in.tests_home_words,
        same=run.outcome.episode.transcript.actions == walk,
    )
    return replace(run, adversary=decisions)


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
