"""Confirmation: playing findings again in fresh processes, in one place for all studies."""

from __future__ import annotations

import hashlib
import time
from collections.abc import Callable, Iterable
from typing import Any

from msgspec import Struct

from allworlds.document.struct import replace
from allworlds.engines.comparison import nondeterministic
from allworlds.engines.effort import Limits
from allworlds.engines.examiner import LOST
from allworlds.engines.job_records import Records, canonical
from allworlds.engines.scope import Scope
from allworlds.engines.single import played_again
from allworlds.engines.tally import Tally, finding_from_record, finding_to_record
from allworlds.explorers.loading import Subject
from allworlds.judging.findings.finding import Finding

UNREPEATED = "what happened to the explorer was not repeated by a fresh process"


class Confirmation(Struct, frozen=True):
    """How the findings of a job are confirmed.

    Attributes:
        subject, limits, scope: of the job.
        deadline: past it findings are left as they are.
        records: what is on record is believed, so that a finding is the same whoever reports it.
    """

    subject: Subject
    limits: Limits
    scope: Scope
    deadline: float | None
    records: Records

    def confirmed(self, findings: Iterable[Finding]) -> list[Finding]:
        """The findings, each played again in a fresh process."""
        return [self._noted("confirmed", found, self._again)[0] or found for found in findings]

    def settle(self, tally: Tally, known: Callable[[Finding], bool] | None = None) -> bool:
        """Confirm the findings of a tally. Return whether there is more to report than they say.

        A crash or a time-out that a fresh process does not repeat refutes nothing: it becomes a
        remark.  Those that are known already stay as they are.
        """
        kept: list[Finding] = []
        remarks = []
        for found in tally.findings:
            settled, remark = found, ""
            if not (known and known(found)):
                again, remark = self._noted("confirmed", found, self._settled)
                settled = again or found
            if remark:
                remarks.append(remark)
            else:
                kept.append(settled)
        tally.findings = kept
        for remark in remarks:
            tally.remark(remark)
        return bool(remarks)

    def replaced(self, name: str, found: Finding, by: Callable[[Finding], Finding]) -> Finding:
        """The finding that replaces this one, recorded under the name."""
        return self._noted(name, found, by)[0] or found

    @property
    def is_late(self) -> bool:
        """Whether the deadline is past."""
        return self.deadline is not None and time.monotonic() > self.deadline

    def _again(self, found: Finding) -> Finding:
        return played_again(found, self.subject, self.limits)

    def _settled(self, found: Finding) -> Finding | str:
        """Confirm in a fresh process. A crash that is not repeated becomes a remark."""
        again = self._again(found)
        if again.law not in LOST or not self.subject.importable or again.confirmed:
            return again
        if not again.machine:
            difference = nondeterministic(f"{again.law}, and not in a fresh process: {again.seen}")
            return replace(
                again,
                law=difference.law,
                expected=difference.expected,
                seen=difference.seen,
                confirmed=True,
            )
        size = f"{found.key[0]} edges and {found.key[1]} vertices"
        return (
            f"a {found.law} in a world with {size} ({found.seen}) that a fresh process did "
            "not repeat"
        )

    def _noted(
        self, name: str, found: Finding, settle: Callable[[Finding], Finding | str]
    ) -> tuple[Finding | None, str]:
        """The finding or remark on record, or a new one, which is then recorded.

        After the deadline nothing new is made.
        """
        plain = replace(found, minimal=False)
        digest = hashlib.sha256(canonical(finding_to_record(plain)).encode()).hexdigest()
        told: Any = self.records.recall(f"{name} {digest}")
        if told is None:
            if self.is_late:
                return None, ""
            settled = settle(plain)
            if isinstance(settled, str):
                told = {"remark": settled}
            else:
                told = {"finding": finding_to_record(settled)}
            if not self.is_late:  # else it may have been given up
                self.records.note(f"{name} {digest}", told)
        if "remark" in told:
            return None, str(told["remark"])
        again = finding_from_record(told["finding"])
        return replace(again, under=self.scope.rules, minimal=found.minimal), ""
