"""Findings once more in fresh processes: is the run repeated?"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence

from allworlds.document import replace
from allworlds.engines.isolation.fresh_process import logs_of, record_of, traced
from allworlds.engines.isolation.jobs import PlayerSetup, Trace
from allworlds.engines.isolation.overheard import Overheard
from allworlds.engines.python.comparison import difference_of, nondeterministic, side_by_side
from allworlds.engines.python.examiner import LOST
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.play import Record
from allworlds.engines.python.players import OTHER_SEED
from allworlds.engines.units.effort import Limits
from allworlds.explorers import Subject
from allworlds.judging import (
    Fault,
    Finding,
    Log,
    Over,
    UncheckedAmbiguous,
    UncheckedAnswer,
    UncheckedValue,
    answered,
)
from allworlds.maps import CombinatorialMap
from allworlds.protocol import Estimate, Schedule, action_numbered, number_of

REPEATED = 5
"""The number of plays of the record of a finding in a process."""


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

    If a process does something else, the explorer is nondeterministic; such a one is confirmed by
    plays that differ.
    """
    record, policy = _recorded(finding)
    if finding.law == "nondeterministic":
        return replace(finding, confirmed=_differs(finding, record, setup))
    seed = OTHER_SEED if finding.hash_seed is None else finding.hash_seed
    for logs in _plays(record, policy, setup, [seed]):
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
    """Whether plays of the record differ, with one hash seed, in one process or in two.

    The second has other addresses: a nursery forks it.
    """
    before: Log | None = None
    for logs in _plays(record, finding.rules.policy, setup, [None, 0]):
        if logs is None:
            return False
        before = before or logs[0]
        if any(not _same_walk(finding, log) or difference_of(before, log) for log in logs):
            return True
    return False


def _recorded(finding: Finding) -> tuple[Record, str]:
    """The record of a finding's run, and its policy."""
    rules, world = finding.rules, finding.world
    record = record_of(rules, world, finding.transcript, finding.choices)
    return record, rules.policy


def _plays(
    record: Record, policy: str, setup: PlayerSetup, seeds: Sequence[int | None]
) -> Iterator[list[Log] | None]:
    """Yield the logs of plays of a record, some with each seed; None for a process that is lost.

    The prints of the first play alone are those of the run.
    """
    yield logs_of((record,), policy, setup, seeds[0])
    silent = replace(setup, output=os.devnull)
    for seed in seeds:
        yield logs_of((record,) * REPEATED, policy, silent, seed)


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
    told = traced(job, setup, finding.hash_seed)
    again = told.lost is not None and told.lost.law == finding.law
    return replace(
        finding,
        choices=told.choices,
        transcript=told.transcript,
        confirmed=again,
        traced=True,
    )
