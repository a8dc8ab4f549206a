"""What a broken law hands back when it is told a story."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

from allworlds.explaining.story import Story
from allworlds.protocol import Estimate


@dataclass(frozen=True, slots=True)
class Telling:
    """What there is to say of a run that breaks a law.

    Attributes:
        sentences: in plain words.
        step: the first step at which belief and truth part; None where they part at none.
        answer: the wrong answer; None where the law is not about the answer.
    """

    sentences: list[str]
    step: int | None = None
    answer: Estimate | None = None


Teller: TypeAlias = Callable[[Story], Telling]
"""What a law has to tell of a story; it may raise InputError."""
