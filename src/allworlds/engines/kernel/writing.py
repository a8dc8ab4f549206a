"""Logs in bytes as Python writes and reads them.

The twins are :mod:`allworlds.engines.kernel.native`, which writes, and
:mod:`allworlds.engines.kernel.logs`, which reads.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntEnum
from typing import NamedTuple, TypeAlias

from allworlds.engines.kernel import log_codes
from allworlds.engines.kernel.log_codes import span

Published: TypeAlias = tuple[tuple[int, ...], tuple[int, ...], int]
"""Sigma, alpha and ``here``: of a checkpoint, or of the answer."""


class LogEnd(IntEnum):
    """The endings of a log that has no answer."""

    OVER_BUDGET = log_codes.OVER_BUDGET
    SHOWN_TOO_OFTEN = log_codes.SHOWN_TOO_OFTEN
    WITHOUT_ANSWER = log_codes.ILLEGAL
    STRANGE = log_codes.STRANGE
    """A log that only the general engine can play, or describe."""


class Written(NamedTuple):
    """The content of a log.

    Attributes:
        motions: each below the degree.
        shown: the published maps, each with the number of motions before it.
        ending: the answer, or the reason why there is none.
    """

    motions: tuple[int, ...]
    shown: tuple[tuple[int, Published], ...]
    ending: Published | LogEnd


def shown_entry(sigma: Sequence[int], alpha: Sequence[int], here: int) -> bytes:
    """The entry of a checkpoint; STRANGE if it does not fit."""
    entry = _entry(log_codes.SHOWN, sigma, alpha, here)
    return bytes((LogEnd.STRANGE,)) if entry is None else entry


def answer_entry(sigma: Sequence[int], alpha: Sequence[int], here: int) -> bytes:
    """The entry of an answer; an entry for no answer if it does not fit any world here."""
    entry = _entry(log_codes.ANSWERED, sigma, alpha, here)
    return bytes((LogEnd.WITHOUT_ANSWER,)) if entry is None else entry


def _entry(code: int, sigma: Sequence[int], alpha: Sequence[int], here: int) -> bytes | None:
    darts = len(sigma)
    if not (darts == len(alpha) and 1 <= darts <= log_codes.MOST_PUBLISHED):
        return None
    try:
        entry = bytes((code, darts, here, *sigma, *alpha))
    except ValueError:  # there is something in it that is no byte
        return None
    return entry + bytes(span(darts) - 2 * darts)


def read_log(log: bytes) -> Written:
    """The content of the log.

    Raises:
        ValueError: if it is no log.
    """
    motions: list[int] = []
    shown: list[tuple[int, Published]] = []
    at = 0
    while at < len(log):
        code, at = log[at], at + 1
        if code <= log_codes.LARGEST_MOTION:
            motions.append(code)
        elif code in (log_codes.SHOWN, log_codes.ANSWERED):
            darts, here = (*log[at : at + 2], 0, 0)[:2]
            at += 2
            published = tuple(log[at : at + darts]), tuple(log[at + darts : at + 2 * darts]), here
            at += span(darts)
            if code == log_codes.ANSWERED and at <= len(log):
                return Written(tuple(motions), tuple(shown), published)
            shown.append((len(motions), published))
        elif code == log_codes.CHOICE:
            at += 2
        else:
            return Written(tuple(motions), tuple(shown), LogEnd(code))
    raise ValueError("the log has no end")
