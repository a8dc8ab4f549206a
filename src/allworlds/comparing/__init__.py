"""Explorers side by side on the same worlds: the verb ``compare``.

Each explorer is run under its own lighthouse unless one is named, and every run is judged.  In a
rooted map an explorer's cost is the mean over the places of its lighthouse; a map in which one of
the explorers has no place is left out for all.

``contest``
    the runs;
``comparison``
    what they have shown.
"""

from allworlds.comparing.comparison import ComparedRow, Comparison, DifferMost
from allworlds.comparing.contest import CompareOptions, compare

__all__ = ["CompareOptions", "ComparedRow", "Comparison", "DifferMost", "compare"]
