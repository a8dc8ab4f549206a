"""The messages of an explorer in Python as entries of a log, in bytes."""

from __future__ import annotations

from allworlds.engines.kernel.writing import LogEnd, answer_entry, shown_entry
from allworlds.inputs import integer
from allworlds.judging import UncheckedAnswer, ending_of, integers
from allworlds.protocol import Ambiguous, Checkpoint, Move


def motion_of(message: Move, degree: int) -> int:
    """The motion below the degree; raises what an integer of the explorer's may raise."""
    k = message.k
    return (k if type(k) is int else integer(k)) % degree


def entry_of_checkpoint(shown: Checkpoint) -> bytes:
    """The entry of a checkpoint; raises what the explorer's values may raise."""
    sigma, alpha = integers(shown.sigma), integers(shown.alpha)
    return shown_entry(sigma, alpha, integer(shown.here))


def entry_of_answer(answer: object) -> bytes:
    """The entry of an answer, or of none; STRANGE for one that only the general engine judges."""
    if type(answer) is Ambiguous:
        return bytes((LogEnd.STRANGE,))
    ending = ending_of(answer)
    if type(ending) is not UncheckedAnswer:
        return bytes((LogEnd.WITHOUT_ANSWER,))
    return answer_entry(ending.sigma, ending.alpha, ending.here)
