"""Single runs in processes of their own, and findings once more in fresh ones."""

from __future__ import annotations

import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from random import Random

from allworlds.engines.isolation.cast import Cast, PlayerLost, hear, started
from allworlds.engines.isolation.jobs import Casting, PlayRecords, Trace, TraceEvent
from allworlds.engines.isolation.process import Process, guardian
from allworlds.engines.python.examiner import Outcome, name_run
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.play import Record
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.runs_of_unit import GivenWorlds
from allworlds.engines.python.scope import Schedule, Scope
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
from allworlds.protocol import Estimate, Percept, Transcript, action_numbered
from allworlds.world import World

MOST_CHOICES = 1000
"""So many choices are kept of the turn in which a run was lost; it may choose for ever."""


def casting_of(subject: Subject, limits: Limits) -> Casting:
    """What a player must know of the explorer."""
    return Casting(subject.name, subject.source, limits.answer_timeout, limits.memory)


def examine_apart(
    subject: Subject,
    rules: Rules,
    world: World,
    script: tuple[int, ...],
    limits: Limits,
) -> Outcome:
    """One judged run of a foreign explorer, played twice, as in a check."""
    examination = PythonEngine(Scope(Extent(MapClass.MAPS, world.map.edge_count), rules), keep=1)
    canonical, place = canonical_world(world), place_of(world)
    unit = GivenWorlds(((canonical, place),))
    with _players(subject, limits) as players:
        twice = PlayedTwice(examination, subject.name, players)
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
    cast = Cast(guardian(), casting_of(subject, limits), order)
    try:
        yield cast
    finally:
        cast.close()


def confirmed(finding: Finding, subject: Subject, limits: Limits, schedules: Schedule) -> Finding:
    """The finding with the remark whether a fresh process did the same again.

    One whose run was lost is traced, and so gets its walk.  What no other process can import is
    not confirmed.
    """
    if not subject.importable and subject.from_user:
        return finding
    if finding.traced:
        return replace(finding, confirmed=repeat(finding, subject, limits))
    return trace(finding, subject, limits, schedules)


def repeat(finding: Finding, subject: Subject, limits: Limits) -> bool:
    """Whether a fresh process does the same again, from the recorded percepts alone.

    A nondeterministic explorer is confirmed by doing something else.
    """
    rules, world = finding.rules, finding.world
    record = Record(
        tuple(finding.transcript.percepts),
        world.told,
        finding.choices,
        rules.budget(world.map),
        name_run(rules, world),
    )
    casting = casting_of(subject, limits)
    try:
        with _fresh(casting) as player:
            player.send(PlayRecords((record,), rules.policy, 0))
            logs = hear(player, casting)
    except (InputError, PlayerLost):  # what cannot be imported once more has done what it has done
        return False
    assert isinstance(logs, list)
    log: Log = logs[0]
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

    The run is played in a fresh process that tells every step before it can be lost.
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
    casting = casting_of(subject, limits)
    try:
        with _fresh(casting) as player:
            player.send(job)
            while isinstance(message := hear(player, casting), TraceEvent):
                match message.what:
                    case None:
                        steps, choices, settled = [], [], 0
                    case int() as index:
                        choices.append(index)
                    case tuple() as step:
                        steps.append(step)
                        settled = len(choices)
    except InputError:
        pass  # as in repeat: what is no longer imported has done what it has done
    except PlayerLost as error:
        lost = error
    kept = choices if lost is None else choices[: settled + MOST_CHOICES]
    walk = tuple((action_numbered(number), percept) for number, percept in steps)
    return (Transcript(job.world.first, walk), tuple(kept)), lost


@contextmanager
def _fresh(casting: Casting) -> Iterator[Process]:
    player, _ = started(guardian(hash_seed=1), casting)
    try:
        yield player
    finally:
        player.close()
