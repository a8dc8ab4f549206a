"""Where an explorer is put through worlds, whatever it does to the processes it runs in."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace

from allworlds.checker.confirm import repeat, trace, unearth
from allworlds.checker.finding import Finding
from allworlds.checker.pool import LocalPool, Poisoned, Pool, WorkerPool
from allworlds.checker.scope import Limits, Scope, Work
from allworlds.checker.tally import Tally
from allworlds.subjects import Subject


class Laboratory:
    """One explorer under one scope, with workers that may be lost and are replaced.

    Usage: ``with laboratory.open() as pool: ... laboratory.examine(pool, works) ...``.
    """

    def __init__(self, scope: Scope, subject: Subject, limits: Limits) -> None:
        self.scope, self.subject, self.limits = scope, subject, limits
        self._deadline = limits.deadline()
        self._pool: AbstractContextManager[Pool] = (
            WorkerPool(subject, limits, self._deadline)
            if subject.importable
            else nullcontext(LocalPool(subject, self._deadline))
        )
        self._lost: set[object] = set()

    def open(self) -> AbstractContextManager[Pool]:
        """The workers; they end with the context."""
        return self._pool

    def examine(self, pool: Pool, works: Iterable[Work]) -> Iterator[Tally]:
        """The tallies of all works in parts, as they come; a lost run is a finding.

        Raises:
            TimeIsUp: when the time limit has been reached.
        """
        keep = self.limits.max_findings
        for part in pool.examine(self.scope, works, keep):
            if isinstance(part, Poisoned):
                tally = Tally(keep)
                tally.find(unearth(part, self.scope, self.subject))
                self._lost.update(found.key[:4] for found in tally.findings)
                yield tally
            else:
                yield part

    def confirmed(self, finding: Finding) -> Finding:
        """The finding with the remark whether a fresh process did the same again.

        One whose run was lost is traced, and so gets its walk.  Past the time limit nothing is
        confirmed any more.
        """
        late = self._deadline is not None and time.monotonic() > self._deadline
        if late or not self.subject.importable:
            return finding
        if finding.law in ("timeout", "crash") and finding.key[:4] in self._lost:
            return trace(finding, self.subject, self.limits, self.scope.schedules)
        return replace(finding, confirmed=repeat(finding, self.subject, self.limits))
