"""Single runs in processes of their own, and findings once more in fresh ones."""

from __future__ import annotations

import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from random import Random

from allworlds.engines.isolation.jobs import PlayerSetup, PlayRecords, Trace
from allworlds.engines.isolation.messages import RecordLogs, TraceEvent
from allworlds.engines.isolation.player_pair import PlayerLost, PlayerPair, receive, start_player
from allworlds.engines.isolation.process import Process, guardian
from allworlds.engines.python.examiner import Outcome, name_run
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.play import Record
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.runs_of_unit import GivenWorlds
from allworlds.engines.python.scope import Scope
from allworlds.engines.python.second_play import OneRun, PlayedTwice, Players
from allworlds.engines.units.effort import Limits
from allworlds.explorers import Subject
from allworlds.inputs import InputError
from allworlds.judging import (
    Episode,
    Fault,
    Finding,
    Log,
    Rules,
    UncheckedAmbiguous,
    UncheckedAnswer,
    Violation,
    canonical_world,
    place_of,
)
from allworlds.maps import CombinatorialMap, Extent, MapClass
from allworlds.protocol import Estimate, Percept, Schedule, Transcript, action_numbered
from allworlds.world import World

MOST_CHOICES = 1000
"""The number of choices that are kept of the turn in which a run was lost: there may be no end."""


def examine_apart(
    subject: Subject,
    rules: Rules,
    world: World,
    script: tuple[int, ...],
    limits: Limits,
) -> Outcome:
    """The judged run of a foreign explorer, played twice, as in a check."""
    engine = PythonEngine(Scope(Extent(MapClass.MAPS, world.map.edge_count), rules), keep=1)
    canonical, place = canonical_world(world), place_of(world)
    unit = GivenWorlds(((canonical, place),))
    with _players(subject, limits) as players:
        twice = PlayedTwice(engine, subject.name, players)
        placed = {0: OneRun(0, place, canonical)}
        ((_, outcome),) = twice.outcomes(unit, placed, given=script)
    if isinstance(outcome, Outcome):
        return outcome
    log, _ = _traced(Trace(rules, canonical, "one", script), subject, limits)
    return Outcome(
        Episode(log[0], (), outcome),
        Violation(outcome.law, outcome.expected, outcome.seen),
        "",
        log[1],
        rules.the_bound.of(world.map, world.start),
    )


@contextmanager
def _players(subject: Subject, limits: Limits) -> Iterator[Players]:
    if not subject.importable:
        yield InProcessPlayers(subject)
        return
    order = Random(secrets.randbits(64))  # noqa: S311  # drawn from the system
    pair = PlayerPair(guardian(), PlayerSetup.of(subject, limits), order)
    try:
        yield pair
    finally:
        pair.close()


def confirmed(finding: Finding, subject: Subject, limits: Limits, schedules: Schedule) -> Finding:
    """The finding with the remark whether a fresh process did the same again.

    A finding whose run was lost is traced, and so gets its walk.  An explorer that no other
    process can import is not confirmed.
    """
    if not subject.importable and subject.from_user:
        return finding
    if finding.traced:
        return replace(finding, confirmed=repeat(finding, subject, limits))
    return trace(finding, subject, limits, schedules)


def repeat(finding: Finding, subject: Subject, limits: Limits) -> bool:
    """Whether a fresh process does the same again, from the recorded percepts alone.

    A nondeterministic explorer is confirmed by another walk.
    """
    rules, world = finding.rules, finding.world
    record = Record(
        tuple(finding.transcript.percepts),
        world.told,
        finding.choices,
        rules.budget(world.map),
        name_run(rules, world),
    )
    setup = PlayerSetup.of(subject, limits)
    try:
        with _fresh(setup) as player:
            player.send(PlayRecords((record,), rules.policy, 0))
            message = receive(player, setup)
    except (InputError, PlayerLost):  # an explorer may not be importable any more
        return False
    assert isinstance(message, RecordLogs)
    (log,) = message.logs
    same = tuple(map(action_numbered, log.actions)) == finding.transcript.actions
    if finding.law == "nondeterministic":
        return not same
    return same and _ends_alike(finding, log)


def _ends_alike(finding: Finding, log: Log) -> bool:
    match log.ending:
        case Fault(law=law):
            return law == finding.law
        case UncheckedAmbiguous():
            return finding.law not in ("crash", "timeout", "illegal-action", "map", "pose")
        case UncheckedAnswer(sigma, alpha, here):
            if finding.law == "no-estimate":
                return True
            if not isinstance(finding.seen, Estimate):
                return finding.law not in ("crash", "timeout", "illegal-action")
            return Estimate(CombinatorialMap.trusted(sigma, alpha), here) == finding.seen


def trace(finding: Finding, subject: Subject, limits: Limits, schedules: Schedule) -> Finding:
    """The finding of a run that cost a player its life, with its walk, and whether it did again.

    The run is played in a fresh process that sends every step before it can be lost.
    """
    job = Trace(finding.rules, finding.world, schedules)
    (transcript, choices), end = _traced(job, subject, limits)
    again = isinstance(end, PlayerLost) and end.law == finding.law
    return replace(finding, choices=choices, transcript=transcript, confirmed=again, traced=True)


def _traced(
    job: Trace, subject: Subject, limits: Limits
) -> tuple[tuple[Transcript, tuple[int, ...]], PlayerLost | None]:
    """The walk and the choices, as far as they are known, and how the player was lost."""
    steps: list[tuple[int, Percept]] = []
    choices: list[int] = []
    settled = 0
    lost: PlayerLost | None = None
    setup = PlayerSetup.of(subject, limits)
    try:
        with _fresh(setup) as player:
            player.send(job)
            while isinstance(message := receive(player, setup), TraceEvent):
                match message.what:
                    case None:
                        steps, choices, settled = [], [], 0
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
    return (Transcript(job.world.first, walk), tuple(kept)), lost


@contextmanager
def _fresh(setup: PlayerSetup) -> Iterator[Process]:
    player, _ = start_player(guardian(hash_seed=1), setup)
    try:
        yield player
    finally:
        player.close()
