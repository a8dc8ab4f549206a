"""Logs in bytes as Python writes and reads them.

The twin of what :mod:`allworlds.engines.kernel.native` writes, and
:mod:`allworlds.engines.kernel.logs` reads.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import IntEnum
from typing import NamedTuple, TypeAlias

from allworlds.engines.kernel import logs

_span: Callable[[int], int] = logs.span.py_func

Published: TypeAlias = tuple[tuple[int, ...], tuple[int, ...], int]
"""Sigma, alpha and ``here``: of a checkpoint, or of the answer."""


class LogEnd(IntEnum):
    """How a log ends that has no answer."""

    OVER_BUDGET = logs.OVER_BUDGET
    SHOWN_TOO_OFTEN = logs.SHOWN_TOO_OFTEN
    WITHOUT_ANSWER = logs.ILLEGAL
    STRANGE = logs.STRANGE
    """What only the general engine can play, or say something of."""


class Written(NamedTuple):
    """What stands in a log.

    Attributes:
        motions: each below the degree.
        shown: what was published, each with the number of motions before it.
        ending: the answer, or why there is none.
    """

    motions: tuple[int, ...]
    shown: tuple[tuple[int, Published], ...]
    ending: Published | LogEnd


def shown_entry(sigma: Sequence[int], alpha: Sequence[int], here: int) -> bytes:
    """A checkpoint; strange, if it does not fit."""
    entry = _entry(logs.SHOWN, sigma, alpha, here)
    return bytes((LogEnd.STRANGE,)) if entry is None else entry


def answer_entry(sigma: Sequence[int], alpha: Sequence[int], here: int) -> bytes:
    """An answer; none, if it does not fit: then it is no map of any world here."""
    entry = _entry(logs.ANSWERED, sigma, alpha, here)
    return bytes((LogEnd.WITHOUT_ANSWER,)) if entry is None else entry


def _entry(code: int, sigma: Sequence[int], alpha: Sequence[int], here: int) -> bytes | None:
    darts = len(sigma)
    if not (darts == len(alpha) and 1 <= darts <= logs.MOST_PUBLISHED):
        return None
    try:
        entry = bytes((code, darts, here, *sigma, *alpha))
    except ValueError:  # there is something in it that is no byte
        return None
    return entry + bytes(_span(darts) - 2 * darts)


def read_log(log: bytes) -> Written:
    """What stands in the log.

    Raises:
        ValueError: if it is none.
    """
    motions: list[int] = []
    shown: list[tuple[int, Published]] = []
    at = 0
    while at < len(log):
        code, at = log[at], at + 1
        if code <= logs.LARGEST_MOTION:
            motions.append(code)
        elif code in (logs.SHOWN, logs.ANSWERED):
            darts, here = (*log[at : at + 2], 0, 0)[:2]
            at += 2
            published = tuple(log[at : at + darts]), tuple(log[at + darts : at + 2 * darts]), here
            at += _span(darts)
            if code == logs.ANSWERED and at <= len(log):
                return Written(tuple(motions), tuple(shown), published)
            shown.append((len(motions), published))
        else:
            return Written(tuple(motions), tuple(shown), LogEnd(code))
    raise ValueError("the log has no end")
