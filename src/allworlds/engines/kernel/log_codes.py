"""The bytes of a log with their meaning, for compiled code and for Python.

No compiled code is loaded with it, so that a process that only writes logs starts fast.
"""

from __future__ import annotations

from allworlds.engines.kernel.names import LANES

# Motions below the first of these, and then how it goes on.
LARGEST_MOTION = 199
SHOWN, ANSWERED, OVER_BUDGET, SHOWN_TOO_OFTEN, ILLEGAL, STRANGE = range(200, 206)

CHOICE = 210
"""A choice was answered: two bytes follow, its index and the number of options."""

MOST_PUBLISHED = 64
"""The largest number of darts that can be read again; more are left to the general engine."""


def span(darts: int) -> int:
    """The number of bytes that sigma and alpha take: a byte for each entry, and zeros.

    The zeros behind alpha allow that it is written in whole steps.
    """
    return darts + (darts + LANES - 1 & -LANES)
