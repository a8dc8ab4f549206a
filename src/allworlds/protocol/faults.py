"""The fault that the adapter of an explorer outside this process raises."""

from __future__ import annotations

from typing import Literal, TypeAlias

ANSWER_TIMEOUT = 10.0
"""Seconds of silence that break the law ``timeout``, unless another time is named."""


FaultLaw: TypeAlias = Literal["crash", "timeout", "illegal-action", "no-estimate"]
"""The laws that an explorer outside this process breaks by what it says."""


class ExplorerFault(Exception):
    """Raised by an adapter (a pipe to a user's program) in place of an action.

    Attributes:
        law: the broken law.
        seen: a sentence: the event in place of an answer.
        detail: for example the tail of the program's stderr; may be empty.
        machine: whether the machine, not the program, may be the cause.
    """

    def __init__(
        self,
        law: FaultLaw,
        seen: str,
        detail: str = "",
        *,
        machine: bool = False,
    ) -> None:
        super().__init__(seen)
        self.law = law
        self.seen = seen
        self.detail = detail
        self.machine = machine


class IllegalAction(ValueError):
    """Raised for an action that is illegal in this world."""


class BeyondRecord(Exception):
    """Raised where recorded percepts end: the first play made no action there."""
