"""Logs in bytes as Python writes and reads them: the twin of what :mod:`.native` writes, and
:mod:`.logs` reads."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

from allworlds.kernel.logs import (
    ANSWERED,
    ILLEGAL,
    LARGEST_MOTION,
    MOST_PUBLISHED,
    OVER_BUDGET,
    SHOWN,
    SHOWN_TOO_OFTEN,
    STRANGE,
)

Published: TypeAlias = tuple[Sequence[int], Sequence[int], int]
"""Sigma, alpha and ``here``: of a checkpoint, or of the answer."""

STRANGE_LOG = bytes((STRANGE,))
"""The log of a run of which nothing more can be written; the general engine plays it anew."""

ENDS = {OVER_BUDGET: "budget", SHOWN_TOO_OFTEN: "budget", ILLEGAL: "illegal-action"}
"""The laws that are broken by a run without an answer whose log is not strange."""


class Written(NamedTuple):
    """What stands in a log.

    Attributes:
        motions: each below the degree.
        shown: what was published, each with the number of motions before it.
        ending: the answer; or the law that the run broke instead.
    """

    motions: tuple[int, ...]
    shown: tuple[tuple[int, Published], ...]
    ending: Published | str


def written_log(
    motions: Sequence[int], shown: Sequence[tuple[int, Published]], answer: Published
) -> bytes:
    """The log of a run with an answer; ``STRANGE_LOG`` if it is none that could be read."""
    if motions and max(motions) > LARGEST_MOTION:
        return STRANGE_LOG
    at, parts = 0, []
    try:
        for steps, published in shown:
            parts.append(bytes(motions[at:steps]))
            parts.append(_entry(SHOWN, published))
            at = steps
        parts.append(bytes(motions[at:]))
        parts.append(_entry(ANSWERED, answer))
    except ValueError:  # what is no byte
        return STRANGE_LOG
    return b"".join(parts)


def _entry(code: int, published: Published) -> bytes:
    sigma, alpha, here = published
    darts = len(sigma)
    if not (darts == len(alpha) and 1 <= darts <= MOST_PUBLISHED):
        raise ValueError(darts)
    return bytes((code, darts, here, *sigma, *alpha))


def read_log(log: bytes) -> Written:
    """What stands in the log.

    Raises:
        ValueError: if it is strange, or none.
    """
    motions: list[int] = []
    shown: list[tuple[int, Published]] = []
    at = 0
    while at < len(log):
        code, at = log[at], at + 1
        if code <= LARGEST_MOTION:
            motions.append(code)
        elif code in (SHOWN, ANSWERED):
            darts, here = log[at : at + 2]
            middle, end = at + 2 + darts, at + 2 + 2 * darts
            published = tuple(log[at + 2 : middle]), tuple(log[middle:end]), here
            if end > len(log):
                break
            at = end
            if code == ANSWERED:
                return Written(tuple(motions), tuple(shown), published)
            shown.append((len(motions), published))
        elif code in ENDS:
            return Written(tuple(motions), tuple(shown), ENDS[code])
        else:
            break
    raise ValueError("a log that is none")
