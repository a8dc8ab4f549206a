"""Single runs in processes of their own, and findings once more in fresh ones."""

from __future__ import annotations

import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from random import Random
from typing import NamedTuple

from allworlds.document import replace
from allworlds.engines.isolation.jobs import PlayerSetup, PlayRecords, Trace
from allworlds.engines.isolation.messages import RecordLogs, TraceEvent
from allworlds.engines.isolation.overheard import Overheard
from allworlds.engines.isolation.player_pair import PlayerLost, PlayerPair, receive, start_player
from allworlds.engines.isolation.process import Process, guardian
from allworlds.engines.python.examiner import Outcome, name_run
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.play import Record
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.runs_of_unit import GivenWorlds
from allworlds.engines.python.scope import Scope
from allworlds.engines.python.second_play import OneRun, PlayedTwice, Players
from allworlds.engines.python.tour import SEEDS, Tour
from allworlds.engines.units.effort import Limits
from allworlds.explorers import Subject
from allworlds.inputs import InputError
from allworlds.judging import (
    Episode,
    Fault,
    Finding,
    Log,
    Over,
    Rules,
    UncheckedAmbiguous,
    UncheckedAnswer,
    UncheckedValue,
    Violation,
    canonical_world,
    place_of,
)
from allworlds.maps import CombinatorialMap, Dart, Extent, MapClass
from allworlds.protocol import Estimate, Percept, Schedule, Transcript, action_numbered
from allworlds.world import Adversary, World

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
    engine = PythonEngine(Scope(Extent(MapClass.MAPS, world.map.edge_count), rules), keep=1)
    canonical, place = canonical_world(world), place_of(world)
    unit = GivenWorlds(((canonical, place),))
    with _players(subject, limits, hash_seed) as players:
        twice = PlayedTwice(engine, subject.name, players)
        placed = {0: OneRun(0, place, canonical)}
        ((_, outcome),) = twice.outcomes(unit, placed, given=script)
    with Overheard() as heard:
        setup = PlayerSetup.of(subject, limits, heard.path)
        if not isinstance(outcome, Outcome):
            traced = _traced(Trace(rules, canonical, "one", script), setup, hash_seed)
            outcome = Outcome(
                Episode(traced.transcript, (), outcome),
                Violation(outcome.law, outcome.expected, outcome.seen),
                "",
                traced.choices,
                rules.the_bound.of(world.map, world.start),
                hash_seed,
            )
        elif subject.importable:
            percepts = tuple(outcome.episode.transcript.percepts)
            budget, name = rules.budget(canonical.map), name_run(rules, canonical)
            record = Record(percepts, canonical.told, outcome.choices, budget, name)
            _log_of(record, rules.policy, setup, hash_seed or 0)
    return replace(outcome, output=heard.text)


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


def confirmed(finding: Finding, subject: Subject, limits: Limits, schedules: Schedule) -> Finding:
    """The finding with the prints of a fresh process, and whether that repeated the run.

    A finding whose run was lost is traced, and so gets its walk.  An explorer that no other
    process can import is not confirmed.
    """
    if not subject.importable and subject.from_user:
        return finding
    with Overheard() as heard:
        setup = PlayerSetup.of(subject, limits, heard.path)
        if finding.traced:
            again = replace(finding, confirmed=repeat(finding, setup))
        else:
            again = trace(finding, setup, schedules)
    return replace(again, output=heard.text)


def repeat(finding: Finding, setup: PlayerSetup) -> bool:
    """Whether a fresh process repeats the run, from the recorded percepts alone.

    A nondeterministic explorer is confirmed by another walk.
    """
    rules, world = finding.rules, finding.world
    record = Record(
        tuple(finding.transcript.percepts),
        world.told,
        finding.choices,
        rules.budget(world.map),
        name_run(rules, world),
        any_answer=not rules.task.is_map,
        over=rules.task.over_at_the_end(world, finding.transcript),
    )
    if finding.law != "nondeterministic":
        log = _log_of(record, rules.policy, setup, _seed_of(finding))
        return log is not None and _same_walk(finding, log) and _ends_alike(finding, log)
    # It may go by addresses, and by chance do the same in some of the processes.
    for seed in range(1, SEEDS):
        log = _log_of(record, rules.policy, setup, seed)
        setup = replace(setup, output=os.devnull)  # what the first has printed is enough
        if log is None:
            return False
        if not _same_walk(finding, log):
            return True
    return False


def _log_of(record: Record, policy: str, setup: PlayerSetup, hash_seed: int) -> Log | None:
    """The log of a record in a fresh process; None if it is lost."""
    try:
        with _fresh(setup, hash_seed) as player:
            player.send(PlayRecords((record,), policy, 0))
            message = receive(player, setup)
    except (InputError, PlayerLost):  # an explorer may not be importable any more
        return None
    assert isinstance(message, RecordLogs)
    return message.logs[0]


def _seed_of(finding: Finding) -> int:
    """The hash seed of a process that is to repeat the finding."""
    return 1 if finding.hash_seed is None else finding.hash_seed


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
                return True
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
        with _fresh(setup, 1 if hash_seed is None else hash_seed) as player:
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
        pass  # as in repeat
    except PlayerLost as error:
        lost = error
    kept = choices if lost is None else choices[: settled + MOST_CHOICES]
    walk = tuple((action_numbered(number), percept) for number, percept in steps)
    return Traced(Transcript(job.world.first, walk), tuple(kept), tuple(vertices), lost)


@contextmanager
def _fresh(setup: PlayerSetup, hash_seed: int) -> Iterator[Process]:
    player, _ = start_player(guardian(), setup, hash_seed)
    try:
        yield player
    finally:
        player.close()
