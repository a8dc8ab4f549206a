"""Findings, repeated in a fresh process before they are reported."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import islice

from allworlds.episode import Answered, Episode, Fault
from allworlds.findings import Finding, Rules, canonical_world
from allworlds.isolation.jobs import Ended, ReplayJob, RunJob, Traced, TraceJob
from allworlds.isolation.process import GRACE, WorkerProcess
from allworlds.judge import Violation
from allworlds.protocol import Action, Percept, Transcript
from allworlds.runs import Outcome, Schedule, Scope, Worlds, numbered_runs
from allworlds.subjects import Subject
from allworlds.work import POLL, Limits
from allworlds.world import World

_ANSWER = "an action, or an estimate at the end"

MOST_CHOICES = 1000
"""So many choices are kept of the turn in which a run was lost; it may choose for ever."""


@dataclass(frozen=True, slots=True)
class WorkerLost:
    """In place of a worker's message: it was silent for too long, or has died."""

    law: str
    seen: str


def finding_of_lost_run(
    unit: Worlds, number: int, scope: Scope, subject: Subject, law: str, seen: str
) -> Finding:
    """The finding of a run that cost its worker its life: its world, found again by its number.

    The walk is not known yet; :func:`confirmed` finds it if the finding is to be reported.
    """
    runs = numbered_runs(unit, scope.extent, scope.rules.kind)
    # A worker that dies behind its last run has been put down to a run that does not exist.
    lost = deque(islice(runs, number + 1), maxlen=1).pop()
    assert lost.lighthouse is not None
    world = canonical_world(World(lost.map, lost.lighthouse, 0))
    return Finding(
        subject.name,
        law,
        world,
        lost.place,
        scope.rules,
        (),
        Transcript(world.first),
        _ANSWER,
        seen,
        traced=False,
    )


def examine_apart(
    subject: Subject,
    rules: Rules,
    world: World,
    script: tuple[int, ...],
    limits: Limits,
) -> Outcome:
    """One judged episode, played in a process of its own, whatever becomes of that process."""
    with _fresh(subject, limits) as worker:
        worker.send(RunJob(rules, world, script))
        outcome = _await(worker)
    if isinstance(outcome, WorkerLost):
        job = TraceJob(rules, world, "one", script)
        return _lost_run(job, outcome, subject, limits)
    assert isinstance(outcome, Outcome)
    return outcome


def _lost_run(job: TraceJob, lost: WorkerLost, subject: Subject, limits: Limits) -> Outcome:
    fault = Fault(lost.law, _ANSWER, lost.seen)
    transcript, choices, _ = _trace(job, subject, limits)
    return Outcome(
        Episode(transcript, (), fault),
        Violation(fault.law, fault.expected, fault.seen),
        "",
        choices,
        job.rules.the_bound.of(job.world.map, job.world.start),
    )


def confirmed(finding: Finding, subject: Subject, limits: Limits, schedules: Schedule) -> Finding:
    """The finding with the remark whether a fresh process did the same again.

    One whose run was lost is traced, and so gets its walk.  What no other process can import is
    not confirmed.
    """
    if not subject.importable:
        return finding
    if finding.traced:
        return replace(finding, confirmed=repeat(finding, subject, limits))
    return trace(finding, subject, limits, schedules)


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
    if isinstance(ended, WorkerLost):
        return False
    assert isinstance(ended, Ended)
    same = ended.actions == finding.transcript.actions
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
            return estimate.to_json() == finding.seen


def trace(finding: Finding, subject: Subject, limits: Limits, schedules: Schedule) -> Finding:
    """The finding of a run that killed its worker, with its walk, and whether it did so again.

    The run is played in a fresh process that tells every step before it can be lost.
    """
    job = TraceJob(finding.rules, finding.world, schedules)
    transcript, choices, end = _trace(job, subject, limits)
    again = isinstance(end, WorkerLost) and end.law == finding.law
    return replace(finding, choices=choices, transcript=transcript, confirmed=again, traced=True)


def _trace(
    job: TraceJob, subject: Subject, limits: Limits
) -> tuple[Transcript, tuple[int, ...], object]:
    """The walk and the choices, as far as they are known, and the last message."""
    steps: list[tuple[Action, Percept]] = []
    choices: list[int] = []
    settled = 0
    with _fresh(subject, limits) as worker:
        worker.send(job)
        while isinstance(message := _await(worker), Traced):
            match message.what:
                case None:
                    steps, choices, settled = [], [], 0
                case int() as index:
                    choices.append(index)
                case tuple() as step:
                    steps.append(step)
                    settled = len(choices)
    kept = choices[: settled + MOST_CHOICES] if isinstance(message, WorkerLost) else choices
    return Transcript(job.world.first, tuple(steps)), tuple(kept), message


@contextmanager
def _fresh(subject: Subject, limits: Limits) -> Iterator[WorkerProcess]:
    worker = WorkerProcess(subject, limits, hash_seed=1)
    try:
        yield worker
    finally:
        worker.kill()


def _await(worker: WorkerProcess) -> object:
    """The worker's next message, or how it was lost."""
    while True:
        told = worker.connection.poll(POLL)
        # What it has told before it fell silent is still heard; but it may tell choices for ever.
        if worker.is_silent(GRACE if told else 0.0):
            return WorkerLost("timeout", worker.silence)
        if told:
            break
        if worker.has_ended():
            return WorkerLost("crash", worker.death())
    try:
        return worker.receive()
    except (EOFError, ConnectionResetError):
        return WorkerLost("crash", worker.death())
