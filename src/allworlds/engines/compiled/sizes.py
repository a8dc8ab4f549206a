"""The sizes from which on a check is done in another way; no compiled code is loaded here."""

from __future__ import annotations

from allworlds.protocol import Schedule

COMPILED_FROM = 5
"""The least m of a check that is worth the compiling; smaller ones end before it would."""

SCHEDULES_FROM = 4
"""The least m of a check of every schedule that is compiled: its runs have up to some hundreds."""

WALKED_FROM = 6
"""The least m whose maps are walked once for every bearing, where that can be done.  Up to
there every bearing is walked."""

COMPILER = "numba", "fast"
"""The package without which there is no compiled engine, and the extra that brings it."""


def compiled_from(schedules: Schedule) -> int:
    """The least m of a check of these schedules that is done in compiled code."""
    return COMPILED_FROM if schedules == "one" else SCHEDULES_FROM
