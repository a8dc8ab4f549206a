"""Findings, repeated in a fresh process before they are reported."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from itertools import islice

from allworlds.checker.finding import Finding, canonical_world
from allworlds.checker.pool import POLL, Poisoned, WorkerProcess
from allworlds.checker.scope import Limits, Scope
from allworlds.checker.worker import Ended, ReplayJob, Traced, TraceJob
from allworlds.episode import Answered, Fault
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol import Action, Percept, Transcript
from allworlds.subjects import Subject
from allworlds.world import Lighthouse, World


def unearth(poisoned: Poisoned, scope: Scope, subject: Subject) -> Finding:
    """The finding of a run that killed its worker: its world, found again by its number.

    The walk is not known yet; :func:`trace` finds it if the finding is to be reported.
    """
    runs: Iterator[tuple[CombinatorialMap, int, Lighthouse | None]] = (
        (map_, place, lighthouse)
        for map_, places in poisoned.unit.placed(scope)
        for place, lighthouse in (*places,) or ((0, None),)
    )
    # A worker that dies behind its last run has been put down to a run that does not exist.
    map_, place, lighthouse = deque(islice(runs, poisoned.number + 1), maxlen=1).pop()
    assert lighthouse is not None
    world = canonical_world(World(map_, lighthouse, 0))
    return Finding(
        subject.name,
        poisoned.law,
        world,
        place,
        scope.rules,
        (),
        Transcript(world.first),
        "an action, or an estimate at the end",
        poisoned.seen,
    )


def repeat(finding: Finding, subject: Subject, limits: Limits) -> bool:
    """Whether a fresh process does the same again, from the recorded percepts alone.

    A nondeterministic explorer is confirmed by doing something else.
    """
    job = ReplayJob(
        finding.rules,
        finding.rules.budget(finding.world.map),
        finding.world.told,
        finding.transcript,
        finding.choices,
    )
    with _fresh(subject, limits) as worker:
        worker.send(job)
        ended = _await(worker)
    if ended is None:
        return False
    assert isinstance(ended, Ended)
    same = ended.actions == tuple(action for action, _ in finding.transcript.steps)
    if finding.law == "nondeterministic":
        return not same
    return same and _ends_alike(finding, ended)


def _ends_alike(finding: Finding, ended: Ended) -> bool:
    match ended.ending:
        case Fault(law=law):
            return law == finding.law
        case Answered(estimate):
            if not isinstance(finding.seen, dict):
                return finding.law not in ("crash", "timeout", "illegal-action", "no-estimate")
            answer = {**estimate.map.to_json(), "here": estimate.here}
            return answer == finding.seen


def trace(finding: Finding, scope: Scope, subject: Subject, limits: Limits) -> Finding:
    """The finding of a run that killed its worker, with its walk, and whether it did so again.

    The run is played in a fresh process that tells every step before it can be lost.
    """
    steps: list[tuple[Action, Percept]] = []
    choices: list[int] = []
    with _fresh(subject, limits) as worker:
        worker.send(TraceJob(scope, finding.world, finding.place))
        while isinstance(message := _await(worker), Traced):
            match message.what:
                case None:
                    steps, choices = [], []
                case int() as index:
                    choices.append(index)
                case tuple() as step:
                    steps.append(step)
    return replace(
        finding,
        choices=tuple(choices),
        transcript=Transcript(finding.world.first, tuple(steps)),
        confirmed=message is None,
    )


@contextmanager
def _fresh(subject: Subject, limits: Limits) -> Iterator[WorkerProcess]:
    worker = WorkerProcess(subject, limits)
    try:
        yield worker
    finally:
        worker.kill()


def _await(worker: WorkerProcess) -> object:
    """The worker's next message, or None if it has died or has been silent for too long."""
    while not worker.connection.poll(POLL):
        if worker.is_silent():
            return None
    with suppress(EOFError, ConnectionResetError):
        return worker.receive()
    return None
