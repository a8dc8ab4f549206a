"""An explorer as the harness calls it, and the faults that its adapter raises."""

from collections.abc import Generator, Mapping
from typing import Any, Literal, Protocol, TypeAlias

from allworlds.protocol.actions import Percept
from allworlds.protocol.choices import Choices

Told: TypeAlias = int | Mapping[str, int] | None
"""The number, or the numbers by their names, that an explorer is told before the start."""


class Player(Protocol):
    """An explorer ready to run: its optional keywords are already bound."""

    def __call__(self, first: Percept, choices: Choices, told: Told) -> Generator[Any, Any, Any]:
        """Return the generator of one run."""


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
