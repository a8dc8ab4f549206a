"""The fault that the adapter of an explorer outside this process raises."""

from __future__ import annotations

from typing import Literal

ANSWER_TIMEOUT = 10.0
"""Seconds of silence that break the law ``timeout``, unless another time is named."""


class ExplorerFault(Exception):
    """Raised by an adapter (a pipe to a user's program) in place of an action.

    Attributes:
        law: the broken law: ``crash``, ``timeout``, ``illegal-action`` or ``no-estimate``.
        seen: a sentence: the event in place of an answer.
        detail: for example the tail of the program's stderr; may be empty.
        machine: whether the machine, not the program, may be the cause.
    """

    def __init__(
        self,
        law: Literal["crash", "timeout", "illegal-action", "no-estimate"],
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
