"""How an explorer that is no generator of this process reports what went wrong with it."""

from __future__ import annotations

from typing import Literal

ANSWER_TIMEOUT = 10.0
"""Seconds of silence that break the law ``timeout``, unless another time is named."""


class ExplorerFault(Exception):
    """Raised by an adapter (a pipe to a foreign program) in place of an action.

    Attributes:
        law: the broken law: ``crash``, ``timeout``, ``illegal-action`` or ``no-estimate``.
        seen: a sentence: what happened instead of an answer.
        detail: for example the tail of the program's stderr; may be empty.
        machine: it may be the machine's doing, not the program's.
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
