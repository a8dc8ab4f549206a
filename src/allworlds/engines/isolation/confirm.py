"""Single runs in processes of their own, and findings once more in fresh ones."""

from __future__ import annotations

import os
import secrets
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from random import Random
from typing import NamedTuple

from allworlds.document import replace
from allworlds.engines.isolation.jobs import PlayerSetup, PlayRecords, Trace
from allworlds.engines.isolation.messages import RecordLogs, TraceEvent
from allworlds.engines.isolation.one_player import PlayerLost, receive, start_player
from allworlds.engines.isolation.overheard import Overheard
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.process import Process, guardian
from allworlds.engines.python.comparison import difference_of, nondeterministic, side_by_side
from allworlds.engines.python.examiner import LOST, Outcome, name_run
from allworlds.engines.python.hash_seeds import LAYOUTS
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.play import Record
from allworlds.engines.python.players import OneRun, Players
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.runs_of_unit import GivenWorlds
from allworlds.engines.python.scope import Scope
from allworlds.engines.python.second_play import PlayedTwice
from allworlds.engines.python.tour import SEEDS, Tour
from allworlds.engines.units.effort import Limits
from allworlds.explorers import Subject
from allworlds.inputs import InputError
from allworlds.judging import (
    Episode,
    Fault,
    Finding,
    Log,
    LostRun,
    Over,
    Rules,
    UncheckedAmbiguous,
    UncheckedAnswer,
    UncheckedValue,
    Violation,
    answered,
    canonical_world,
    place_of,
)
from allworlds.maps import CombinatorialMap, Dart, Extent, MapClass
from allworlds.protocol import Estimate, Percept, Schedule, Transcript, action_numbered, number_of
from allworlds.world import Adversary, World

REPEATED = 5
"""The number of plays of the record of a finding in a process."""

MOST_CHOICES = 1000
"""The number of choices that are kept of the turn in which a run was lost: there may be no end."""


class Traced(NamedTuple):
    """A walk that was sent step by step.

    Attributes:
        transcript: the walk.
        choices: the index taken at each choice.
        settled: the darts behind which an explorer has settled a vertex, against an adversary,
            each with the number of actions before.
        lost: the way the player was lost; None if it was not.
    """

    transcript: Transcript
    choices: tuple[int, ...]
    settled: tuple[tuple[int, Dart], ...]
    lost: PlayerLost | None


def examine_apart(
    subject: Subject,
    rules: Rules,
    world: World,
    script: tuple[int, ...],
    limits: Limits,
    hash_seed: int | None = None,
) -> Outcome:
    """The judged run of a user's explorer, played twice, as in a check.

    Both players have the hash seed, if one is given.
    """
    engine, unit = _of_these(rules, (world,))
    ((canonical, place),) = unit.worlds
    with _players(subject, limits, hash_seed) as players:
        twice = PlayedTwice(engine, subject.name, players, alone=True)
        placed = {0: OneRun(0, place, canonical)}
        ((_, outcome),) = twice.outcomes(unit, placed, given=script)
    if isinstance(outcome, Outcome) and not subject.importable:
        record = _record_of(rules, canonical, outcome.episode.transcript, outcome.choices)
        return replace(outcome, output=InProcessPlayers(subject).printed(record, rules.policy))
    with Overheard() as heard:
        setup = PlayerSetup.of(subject, limits, heard.path)
        if isinstance(outcome, Outcome):
            record = _record_of(rules, canonical, outcome.episode.transcript, outcome.choices)
            _logs_of((record,), rules.policy, setup, (hash_seed or 0, 0))
        else:
            traced = _traced(Trace(rules, canonical, "one", script), setup, hash_seed)
            outcome = Outcome(
                Episode(traced.transcript, (), outcome),
                Violation(outcome.law, outcome.expected, outcome.seen),
                "",
                traced.choices,
                rules.the_bound.of(world.map, world.start),
                hash_seed,
            )
    return replace(outcome, output=heard.text)


def outcomes_apart(
    subject: Subject,
    rules: Rules,
    worlds: Sequence[World],
    limits: Limits,
    hash_seed: int | None = None,
) -> Iterator[Outcome | LostRun]:
    """The judged runs of a user's explorer in these worlds, each played once, in any order."""
    engine, unit = _of_these(rules, worlds)
    with _players(subject, limits, hash_seed) as players:
        once = PlayedTwice(engine, subject.name, players)
        for _, outcome in once.played_once(unit, [*engine.runs(unit)]):
            yield outcome


def _of_these(rules: Rules, worlds: Sequence[World]) -> tuple[PythonEngine, GivenWorlds]:
    """An engine that judges by these rules, and these worlds as its unit."""
    most = max(world.map.edge_count for world in worlds)
    engine = PythonEngine(Scope(Extent(MapClass.MAPS, most), rules), keep=1)
    return engine, GivenWorlds(tuple((canonical_world(w), place_of(w)) for w in worlds))


def walk_apart(
    subject: Subject,
    rules: Rules,
    adversary: Adversary,
    script: tuple[int, ...],
    limits: Limits,
    hash_seed: int | None,
) -> Traced:
    """The walk of an explorer in a process of its own, against an adversary.

    Of a lost player it is what was before.
    """
    job = Trace(rules, adversary.at_first, "one", script, adversary)
    return _traced(job, PlayerSetup.of(subject, limits), hash_seed)


@contextmanager
def _players(subject: Subject, limits: Limits, hash_seed: int | None) -> Iterator[Players]:
    if not subject.importable:
        yield InProcessPlayers(subject)
        return
    order = Random(secrets.randbits(64))  # noqa: S311  # drawn from the system
    tour = Tour() if hash_seed is None else Tour(hash_seed, alike=True, stays=True)
    pair = PlayerPair(guardian(), PlayerSetup.of(subject, limits), order, tour=tour)
    try:
        yield pair
    finally:
        pair.close()


def played_again(
    finding: Finding, subject: Subject, limits: Limits, schedules: Schedule
) -> Finding:
    """The finding with the prints of a fresh process, and whether that repeated the run.

    A finding whose run was lost is traced, and so gets its walk.  An explorer that no other
    process can import is not confirmed; it plays once more in this process, for its prints.
    """
    if not subject.importable and subject.from_user:
        return replace(finding, output=InProcessPlayers(subject).printed(*_recorded(finding)))
    with Overheard() as heard:
        setup = PlayerSetup.of(subject, limits, heard.path)
        again = repeat(finding, setup) if finding.traced else trace(finding, setup, schedules)
    return replace(again, output=heard.text)


def repeat(finding: Finding, setup: PlayerSetup) -> Finding:
    """The finding, and whether fresh processes repeat the run, from the recorded percepts alone.

    A run that goes by its hash seed must be repeated on several layouts.  If a process does
    something else, the explorer is nondeterministic; such a one is confirmed by plays that differ.
    """
    record, policy = _recorded(finding)
    if finding.law == "nondeterministic":
        return replace(finding, confirmed=_differs(finding, record, setup))
    places = [(1, 0)]
    if finding.hash_seed is not None:
        places = [(finding.hash_seed, layout) for layout in range(1, LAYOUTS + 1)]
    for logs in _plays(record, policy, setup, places):
        if logs is None:
            return replace(finding, confirmed=False)
        for log in logs:
            if not (_same_walk(finding, log) and _ends_alike(finding, log)):
                return _unlike(finding, log)
    return replace(finding, confirmed=True)


def _unlike(finding: Finding, again: Log) -> Finding:
    """The finding of an explorer that does something else in a fresh process."""
    if finding.law in LOST:
        return replace(finding, confirmed=False)
    broken = nondeterministic(f"it breaks the law {finding.law} in some plays only")
    actions = tuple(map(number_of, finding.transcript.actions))
    before = Log(actions, (), Fault(f"what breaks the law {finding.law}", "", ""))
    return replace(
        finding,
        law=broken.law,
        expected=broken.expected,
        seen=broken.seen,
        detail="\n".join(filter(None, [side_by_side(before, again), finding.detail])),
        hash_seed=None,
        confirmed=True,
    )


def _differs(finding: Finding, record: Record, setup: PlayerSetup) -> bool:
    """Whether plays of the record differ, with one hash seed, in one process or in several.

    The explorer may go by addresses, and by chance do the same in some processes.
    """
    before: Log | None = None
    places = [(0, layout) for layout in range(SEEDS)]
    for logs in _plays(record, finding.rules.policy, setup, places):
        if logs is None:
            return False
        before = before or logs[0]
        if any(not _same_walk(finding, log) or difference_of(before, log) for log in logs):
            return True
    return False


def _recorded(finding: Finding) -> tuple[Record, str]:
    """The record of a finding's run, and its policy."""
    rules, world = finding.rules, finding.world
    record = _record_of(rules, world, finding.transcript, finding.choices)
    return record, rules.policy


def _record_of(
    rules: Rules, world: World, transcript: Transcript, choices: tuple[int, ...]
) -> Record:
    return Record(
        tuple(transcript.percepts),
        world.told,
        choices,
        rules.budget(world.map),
        name_run(rules, world),
        any_answer=not rules.task.is_map,
        over=rules.task.over_at_the_end(world, transcript),
    )


def _plays(
    record: Record, policy: str, setup: PlayerSetup, places: Sequence[tuple[int, int]]
) -> Iterator[list[Log] | None]:
    """Yield the logs of plays of a record, some in each place; None for a process that is lost.

    The prints of the first play alone are those of the run.
    """
    yield _logs_of((record,), policy, setup, places[0])
    silent = replace(setup, output=os.devnull)
    for place in places:
        yield _logs_of((record,) * REPEATED, policy, silent, place)


def _logs_of(
    records: tuple[Record, ...], policy: str, setup: PlayerSetup, place: tuple[int, int]
) -> list[Log] | None:
    """The logs of records in a fresh process of that place; None if it is lost."""
    try:
        with _fresh(setup, place) as player:
            player.send(PlayRecords(records, policy, 0))
            message = receive(player, setup)
    except (InputError, PlayerLost):  # an explorer may not be importable any more
        return None
    assert isinstance(message, RecordLogs)
    return message.logs


def _same_walk(finding: Finding, log: Log) -> bool:
    return tuple(map(action_numbered, log.actions)) == finding.transcript.actions


def _ends_alike(finding: Finding, log: Log) -> bool:
    match log.ending:
        case Fault(law=law):
            return law == finding.law
        case UncheckedAmbiguous():
            return finding.law not in ("crash", "timeout", "illegal-action", "map", "pose")
        case UncheckedValue() | Over():
            return finding.law in ("task", "bound")
        case UncheckedAnswer(sigma, alpha, here):
            if finding.law == "no-estimate":
                return isinstance(answered(log.ending), Fault)
            if not isinstance(finding.seen, Estimate):
                return finding.law not in ("crash", "timeout", "illegal-action")
            return Estimate(CombinatorialMap.trusted(sigma, alpha), here) == finding.seen


def trace(finding: Finding, setup: PlayerSetup, schedules: Schedule) -> Finding:
    """The finding of a run that killed its player, with its walk, and whether it did so again.

    The run is played in a fresh process that sends every step before it can be lost.
    """
    job = Trace(finding.rules, finding.world, schedules)
    told = _traced(job, setup, finding.hash_seed)
    again = told.lost is not None and told.lost.law == finding.law
    return replace(
        finding,
        choices=told.choices,
        transcript=told.transcript,
        confirmed=again,
        traced=True,
    )


def _traced(job: Trace, setup: PlayerSetup, hash_seed: int | None) -> Traced:
    """The walk, as far as it is known."""
    steps: list[tuple[int, Percept]] = []
    choices: list[int] = []
    vertices: list[tuple[int, Dart]] = []
    settled = 0
    lost: PlayerLost | None = None
    try:
        with _fresh(setup, (1 if hash_seed is None else hash_seed, 0)) as player:
            player.send(job)
            while isinstance(message := receive(player, setup), TraceEvent):
                match message.what:
                    case None:
                        steps, choices, vertices, settled = [], [], [], 0
                    case int() as dart if message.settled:
                        vertices.append((len(steps), dart))
                    case int() as index:
                        choices.append(index)
                    case tuple() as step:
                        steps.append(step)
                        settled = len(choices)
    except InputError:
        pass  # the explorer may not be importable any more: the run was not repeated
    except PlayerLost as error:
        lost = error
    kept = choices if lost is None else choices[: settled + MOST_CHOICES]
    walk = tuple((action_numbered(number), percept) for number, percept in steps)
    return Traced(Transcript(job.world.first, walk), tuple(kept), tuple(vertices), lost)


@contextmanager
def _fresh(setup: PlayerSetup, place: tuple[int, int]) -> Iterator[Process]:
    player, _ = start_player(guardian(), setup, *place)
    try:
        yield player
    finally:
        player.close()
