"""Single runs: the run of the verb ``run``, and findings that are played again."""

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from typing import Annotated, Any

from msgspec import UNSET, UnsetType, field
from typing_extensions import override

from allworlds import log as entries
from allworlds.documents import document as doc
from allworlds.documents.report import Report
from allworlds.engines import limits, players
from allworlds.engines.batch import FIRST, SECOND, Due, Recorded
from allworlds.engines.judge import PythonJudge
from allworlds.engines.lane import Lane
from allworlds.engines.players import answered, lost_log, started
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import GivenWorlds, Scope
from allworlds.engines.user_code_checks import ensure_same_senses
from allworlds.explorers import loading, program, sources
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.nesting import ensure_outermost
from allworlds.judging.differences import (
    after_worlds,
    difference_of,
    in_words,
    nondeterministic,
    overruled,
    side_by_side,
)
from allworlds.judging.episode import Answered, Fault, Over, ending_of
from allworlds.judging.findings.finding import Finding, canonical_world, place_of
from allworlds.judging.laws.law_table import checked_laws
from allworlds.judging.referee import LOST, Examiner, Outcome, Referee, name_run
from allworlds.judging.rules import RecordedRules, Rules
from allworlds.judging.walk import Walk
from allworlds.log import Log
from allworlds.maps.classes import Extent, MapClass
from allworlds.outcome import Facts, Verdict
from allworlds.protocol.actions import Action, Ambiguous, Estimate, Transcript, action_numbered
from allworlds.world.world import World


class SingleRun(Report):
    """Report of 'run'.

    One judged run.
    """

    explorer: Annotated[doc.Text, doc.about("its name")]
    world: Annotated[World, doc.about("as it was given")]
    finding: Annotated[Finding | None, doc.about("null: no law is broken")]
    rules: doc.NotInDocument[Rules]
    outcome: doc.NotInDocument[Outcome]
    shows_walk: doc.NotInDocument[bool] = True

    @doc.computed
    def verdict(
        self,
    ) -> Annotated[Verdict, doc.one_of(Verdict.HOLDS, Verdict.REFUTED, Verdict.VACUOUS)]:
        """The verdict about this run alone."""
        return self.facts.verdict

    @doc.computed
    def options(self) -> RecordedRules:
        """The options by which the run was played and judged."""
        return self.rules.recorded

    @doc.computed
    def choices(self) -> tuple[doc.Natural, ...]:
        """The index of the option taken at each choice."""
        return self.outcome.choices

    @doc.computed
    def cost(self) -> doc.Natural:
        """The number of traversals."""
        return self.outcome.cost

    @doc.computed
    def bound(self) -> int | None:
        """The bound of the traversals; null without a bound."""
        return self.outcome.bound

    @doc.computed
    def estimate(self) -> Estimate | None:
        """The answer, if it is an estimate; else null."""
        return self.answer if isinstance(self.answer, Estimate) else None

    @doc.computed
    def transcript(self) -> Transcript | UnsetType:
        """The steps of the run; absent with ``--no-walk``."""
        return self.outcome.episode.transcript if self.shows_walk else UNSET

    @doc.computed
    def ambiguous(self) -> Ambiguous | UnsetType:
        """The answer, if it is a rooted quotient (``Ambiguous``) in place of a map; else absent."""
        return self.answer if isinstance(self.answer, Ambiguous) else UNSET

    @doc.computed
    def output(self) -> doc.Text | UnsetType:
        """The prints of the explorer; absent if it printed nothing."""
        return self.outcome.output or UNSET

    @property
    def facts(self) -> Facts:
        """The facts behind the verdict: whether a law is broken, and whether no law was checked."""
        return Facts(refuted=self.finding is not None, vacuous=not self.checked_laws)

    @property
    def checked_laws(self) -> tuple[str, ...]:
        """The laws that were checked at least once in this run."""
        return checked_laws(self.rules.judged, 1, len(self.outcome.episode.checkpoints))

    @cached_property
    def walk(self) -> Walk:
        """The walk in the world that was given; the darts keep the given numbers."""
        return Walk.of(self.world, self.outcome.episode.walk.actions)

    @property
    def answer(self) -> Any:
        """The explorer's answer; None if the run has ended without an answer."""
        ending = self.outcome.episode.ending
        return ending.answer if isinstance(ending, Answered) else None


def unused_choice(choices: Sequence[int], run: SingleRun) -> str:
    """A clause that names a wanted choice that a run did not make; empty if it made all of them.

    ``choices`` holds the index of the option to be taken at each of the first choices of the run.
    The first index that was not taken is named, with the reason: the run had fewer choices, or this
    choice had fewer options.  For example: "choice 2 is 5, but there are fewer options".
    """
    for i, index in enumerate(choices):
        if run.outcome.choices[i : i + 1] != (index,):
            asked = len(run.outcome.choices)
            few = f"only {asked} {'was' if asked == 1 else 'were'}" if asked else "none was"
            reason = "there are fewer options" if i < asked else f"{few} asked for"
            return f"choice {i} is {show(index)}, but {reason}"
    return ""


def subject_of(explore: str | Callable[..., Any], limits: limits.Limits) -> loading.Subject:
    """The explorer with the name ``explore``, or the generator function ``explore``, as a subject.

    A named explorer is loaded in another process, so that users' code stays out of this process.

    Raises:
        InputError: if no such explorer exists, if it cannot be imported or is no explorer, or if
            this process is itself a player, or is loading an explorer.
    """
    ensure_outermost()
    if not isinstance(explore, str):
        if not callable(explore):
            raise InputError(f"explore = {show(explore)} is neither a name nor a function")
        return loading.in_process_subject(explore)
    explore = sources.whole_name(explore)
    if explore in BUILT_IN:
        return loading.built_in(explore)
    if loading.is_program(explore):
        # Here an explorer that cannot be played is refused.
        program.Program(loading.command_or_path(explore), limits.answer_timeout)
        return loading.Subject(explore, frozenset({"told"}))
    subject = loading.Subject(explore, frozenset(), source=loading.source_of(explore))
    player = players.PlayerProcess(players.Setup(subject, limits), 0)
    try:
        description = player.loaded()
    except BaseException:
        player.close()
        raise
    found = doc.replace(subject, keywords=description.keywords)
    found = loading.with_shield(found) if description.has_shield else found
    players.keep(player, found)
    return found


REPEATED = 5
"""The number of times that one process plays the run of a finding by its percepts."""


class OutcomeCounter(RunCounter, frozen=True):
    """The counter of a single run, which keeps the outcomes of the run in place of counts.

    There is an outcome after the first play.  If this outcome breaks a law, or if the second play
    differs, there is a second outcome, after the comparison of the plays.  The report shows the
    last outcome.
    """

    outcomes: list[Outcome] = field(default_factory=list)

    @override
    def count_outcome(self, world: World, place: int, outcome: Outcome, tally: Tally) -> None:
        self.outcomes.append(outcome)

    @override
    def settle(
        self, referee: Referee, world: World, place: int, outcome: Outcome, tally: Tally
    ) -> None:
        self.outcomes.append(outcome)


def _outcome_of(
    subject: loading.Subject,
    rules: Rules,
    world: World,
    script: tuple[int, ...],
    limits: limits.Limits,
    hash_seed: int | None,
) -> Outcome:
    """The outcome of one run of a user's explorer.

    A lane plays the run twice, and compares the two plays.

    Args:
        subject: the explorer.
        rules: the rules by which the run is played and judged.
        world: the world, in canonical numbering, so that the start is dart 0.
        script: the index of the option to be taken at each of the first choices.
        limits: the limits of the players.
        hash_seed: the hash seed of both players; None for two different seeds.
    """
    counter = OutcomeCounter(Scope(Extent(MapClass.MAPS, world.map.edge_count), rules), keep=1)
    seeds = (FIRST, SECOND) if hash_seed is None else (hash_seed, hash_seed)
    lane = Lane(subject, counter, limits, given=script, seeds=seeds)
    try:
        lane.offer(GivenWorlds(((world, place_of(world)),)))
        while lane.busy:
            lane.turn()
    finally:
        lane.close()
    return counter.outcomes[-1]


def single_run(
    subject: loading.Subject,
    world: World,
    rules: Rules,
    script: tuple[int, ...],
    limits: limits.Limits,
    hash_seed: int | None = None,
    after: Sequence[World] = (),
) -> SingleRun:
    """Play one run, and return its report.

    Args:
        subject: the explorer.
        world: the world, in any numbering of its darts.
        rules: the rules by which the run is played and judged.
        script: the index of the option to be taken at each of the first choices.  The policy
            decides at later choices, and if an index is too large for the number of options.
        limits: the limits of the players of a user's explorer.
        hash_seed: the hash seed of both players of a user's explorer; None for two different seeds.
        after: worlds of earlier runs, for a user's explorer.  If there are any, and no player was
            lost, two further plays are made by the percepts of the run: one by a fresh player, and
            one by a player that has first played in these worlds.  If these two plays differ, the
            report says that the explorer is nondeterministic; else it is about the run alone.
    """
    if subject.from_user:
        canonical = canonical_world(world)
        outcome = _outcome_of(subject, rules, canonical, script, limits, hash_seed)
        played = Plays(subject, rules, canonical, limits)
        lost = outcome.violation is not None and outcome.violation.law in LOST
        choices, seed = outcome.choices, hash_seed or FIRST
        if lost:
            _, printed = played.in_world(choices, seed)
        else:
            made = outcome.episode.walk.actions
            (alone,), printed = played.again(made, choices, seed)
            if after:
                later = Plays(subject, rules, canonical, limits, after)
                (log,), printed = later.again(made, choices, seed)
                outcome = after_worlds(overruled(outcome, alone, log), after)
        outcome = doc.replace(outcome, output=printed)
    else:
        choices_made = rules.choices(name_run(rules, world), script)
        outcome = Examiner(subject, rules).examine(world, choices_made)
    finding = None
    if outcome.violation:
        finding = Referee(subject.name, rules).finding(world, place_of(world), outcome)
        ensure_same_senses(finding)
    return SingleRun(
        explorer=subject.name, world=world, finding=finding, rules=rules, outcome=outcome
    )


class Plays:
    """Plays of one run by fresh players, whose prints are recorded.

    In all methods ``script`` holds the index of the option to be taken at each of the first
    choices, and ``seed`` is the hash seed of the player.

    Args:
        subject: the explorer.
        rules: the rules by which the run is played.
        world: the world, in canonical numbering.
        limits: the limits of the players.
        after: worlds in which each player plays before it plays the run.
    """

    def __init__(
        self,
        subject: loading.Subject,
        rules: Rules,
        world: World,
        limits: limits.Limits,
        after: Sequence[World] = (),
    ) -> None:
        self._setup = players.Setup(subject, limits, prints=True)
        self._rules, self._world = rules, world
        self._before = [Due(0, place_of(one), one) for one in after]
        counter = RunCounter(Scope(Extent(MapClass.MAPS, world.map.edge_count), rules), keep=1)
        self.judge = PythonJudge(counter, subject.name)

    def in_world(self, script: tuple[int, ...], seed: int) -> tuple[Log, str]:
        """Let a fresh player play the run in its world; return the log and the prints.

        If the player is lost, the log ends with the loss.
        """
        message = self.judge.worlds_message([Due(0, 0, self._world, script)])
        (log,), printed = self._played(message | {"hear": True}, seed)
        return log, printed

    def again(
        self, actions: Iterable[Action], script: tuple[int, ...], seed: int, times: int = 1
    ) -> tuple[list[Log], str]:
        """Let one fresh player play the run ``times`` times by percepts; return logs and prints.

        The percepts are those of the walk that consists of ``actions``.
        """
        walk = Walk.of(self._world, actions)
        record = Recorded(walk.percepts, self._world, script, self._rules.task.is_over(walk))
        return self._played(self.judge.percepts_message([record] * times), seed)

    def traced(self, runs: Sequence[Due]) -> Sequence[bytes]:
        """Let a fresh player play ``runs`` in their worlds; return the logs, and one item more.

        This last item says for each run separately which lines of the explorer's code ran, in the
        form of :func:`allworlds.protocol.code_lines.written`.
        """
        message = self.judge.worlds_message(runs)
        return self._logs(message | {"lines": True, "runs": len(runs) + 1}, FIRST)[0]

    def _played(self, message: dict[str, Any], seed: int) -> tuple[list[Log], str]:
        logs, printed = self._logs(message, seed)
        return [*map(Log, logs)], printed

    def _logs(self, message: dict[str, Any], seed: int) -> tuple[Sequence[bytes], str]:
        player = started(self._setup, seed)
        try:
            if self._before:
                answered(player, self.judge.worlds_message(self._before))
            logs = answered(player, message)
        except players.Lost as lost:
            logs = [lost_log(bytes(player.part), lost)] * message["runs"]
        finally:
            player.close()
        return logs, player.prints.text


def played_again(finding: Finding, subject: loading.Subject, limits: limits.Limits) -> Finding:
    """Play the run of a finding again; return the finding with the result of the new plays.

    In the returned finding the field ``output`` holds the prints of a new play, and ``confirmed``
    says whether fresh processes repeat the run.  In most cases the run is played by the percepts of
    its recorded walk.  There are two exceptions:

    - If the law is ``crash`` or ``timeout``, and the finding has no error text, the player was
      lost, and the recorded walk may be incomplete.  Then the run is played in its world, and the
      finding gets the walk of this play.
    - If no other process can import the explorer, the finding is not confirmed.  The explorer plays
      the run once more in this process, for its prints.

    Raises:
        InputError: if a user's lighthouse gives another answer when it is asked again.
    """
    ensure_same_senses(finding)
    rules, world, choices = finding.rules, finding.world, finding.choices
    plays = Plays(subject, rules, world, limits)
    seed = SECOND if finding.hash_seed is None else finding.hash_seed
    try:
        if not subject.importable and subject.from_user:
            _, printed = plays.again(finding.transcript.actions, choices, seed)
            return doc.replace(finding, output=printed)
        if finding.law in LOST and not finding.detail:
            log, printed = plays.in_world(choices, seed)
            return doc.replace(_found_again(finding, plays, log), output=printed)
        (first,), printed = plays.again(
            finding.transcript.actions,
            choices,
            FIRST if finding.law == "nondeterministic" else seed,
        )
        later = Plays(subject, rules, world, limits, finding.earlier)
        return doc.replace(_repeated(finding, plays, later, first, seed), output=printed)
    except InputError:  # an explorer may not be importable any more
        return doc.replace(finding, confirmed=False)


def _found_again(finding: Finding, plays: Plays, log: Log) -> Finding:
    """The finding about the loss of a player, with the walk of a later play as its walk.

    ``log`` is the log of the later play, in the world.  The field ``confirmed`` of the result says
    whether a player was lost in that play, too, by the same law.
    """
    episode = plays.judge.episode(finding.world, log)
    ending = episode.ending
    return doc.replace(
        finding,
        choices=max(tuple(log.choices), finding.choices, key=len),
        transcript=episode.transcript,
        confirmed=isinstance(ending, Fault) and ending.law == finding.law,
    )


def _repeated(finding: Finding, plays: Plays, later: Plays, first: Log, seed: int) -> Finding:
    """The finding, with the result of playing its run again by the percepts of its walk.

    The returned finding is confirmed in these cases:

    - The field ``after`` of the given finding is not empty: the run was different after earlier
      runs in the same process.  The finding is confirmed if a play of the run alone has the
      recorded walk, and a play after these runs differs from it.
    - The given finding says that the explorer is nondeterministic.  A process with the hash seed
      FIRST and a process with the hash seed SECOND then play the run several times.  The finding is
      confirmed if any play differs from the log ``first`` or from the recorded walk.
    - In all other cases a process with the hash seed ``seed`` plays the run several times.  The
      finding is confirmed if ``first`` and these plays repeat its walk and its end.  Otherwise the
      result is that of :func:`_unlike`: a confirmed finding that the explorer is nondeterministic,
      or the unconfirmed finding of a lost player.

    Args:
        finding: the finding.
        plays: the maker of plays of the run alone.
        later: the maker of plays after the earlier runs; used only if there are such runs.
        first: the log of a play of the run alone, which is compared with the new plays; used only
            in the last two cases.
        seed: the hash seed of the new plays in the last case.
    """
    record = finding.transcript.actions, finding.choices
    if finding.after:
        with_seed = finding.hash_seed or FIRST
        (alone,), _ = plays.again(*record, with_seed)
        (after,), _ = later.again(*record, with_seed)
        differ = difference_of(alone, after) is not None and _same_walk(finding, alone)
        return doc.replace(finding, confirmed=differ)
    if finding.law == "nondeterministic":
        logs = [first]
        for each in (SECOND, FIRST):
            logs += plays.again(*record, each, REPEATED)[0]
        differ = any(not _same_walk(finding, log) or difference_of(first, log) for log in logs)
        return doc.replace(finding, confirmed=differ)
    for log in (first, *plays.again(*record, seed, REPEATED)[0]):
        if not (_same_walk(finding, log) and _ends_alike(finding, log)):
            return _unlike(finding, log)
    return doc.replace(finding, confirmed=True)


def _unlike(finding: Finding, again: Log) -> Finding:
    """A copy of a finding, after a later play of its run had another walk or another end.

    ``again`` is the log of the later play.  In general the copy says that the explorer is
    nondeterministic, and is confirmed.  But if ``finding`` is about the loss of a player, the
    machine may have caused the loss; so the copy says the same as ``finding``, and is not
    confirmed.
    """
    if finding.law in LOST:
        return doc.replace(finding, confirmed=False)
    broken = nondeterministic(f"it breaks the law {finding.law} in some plays only")
    before = [*map(str, finding.transcript.actions)], f"what breaks the law {finding.law}"
    return doc.replace(
        finding,
        law=broken.law,
        expected=broken.expected,
        seen=broken.seen,
        detail="\n".join(filter(None, [side_by_side(before, in_words(again)), finding.detail])),
        hash_seed=None,
        confirmed=True,
    )


def _same_walk(finding: Finding, log: Log) -> bool:
    walk = tuple(map(action_numbered, log.actions))
    shown = finding.transcript.actions
    return walk[: len(shown)] == shown and len(walk) <= len(shown) + 1


def _ends_alike(finding: Finding, log: Log) -> bool:
    """Whether the end of a play, given by its log, does not contradict a finding.

    The play has the walk of the finding, so it is not judged again; the function only excludes ends
    with which the law of the finding cannot be broken.  The first of these cases that applies
    decides:

    - The play ends without an answer, because it breaks a law such as ``crash`` or ``budget``: the
      finding must be about the same law.  Texts, such as that of an exception, are not compared.
    - The play ends because the task is done, or its answer is a JSON value: the law of the finding
      must be ``task`` or ``bound``.
    - The finding shows a wrong estimate: the play must answer with the same estimate.
    - In all other cases the play has an answer, so the law of the finding must not be ``crash``,
      ``timeout``, ``illegal-action`` or ``budget``.  If the answer is a quotient, the law must not
      be ``map`` or ``pose``, either; if the answer is an estimate, it must not be ``no-estimate``.
    """
    end = ending_of(log)
    if isinstance(end, Fault):
        return end.law == finding.law
    if isinstance(end, Over) or log.ending[0] == entries.VALUE:
        return finding.law in ("task", "bound")
    if isinstance(finding.seen, Estimate):
        return bool(end.answer == finding.seen)
    others = ("map", "pose") if isinstance(end.answer, Ambiguous) else ("no-estimate",)
    return finding.law not in ("crash", "timeout", "illegal-action", "budget", *others)
