"""Explorers side by side on the same worlds, and as the worlds grow.

Each explorer is run under its own lighthouse unless one is named, and every run is judged.  In a
rooted map an explorer's cost is the mean over the places of its lighthouse; a map in which one of
the explorers has no place is left out for all.  Of a growing family a few members of each size are
drawn from seeds; every member has a name that gives it back (``allworlds run greedy --family
torus:6x6 --seed 1``).

``compare_request``
    what is asked for;
``contestants``
    explorers that are run in the same worlds;
``contest``, ``comparison``
    the runs in every world of a class, and what they have shown;
``growing_families``, ``climb``, ``growth``
    families and their members, the runs in them, and cost by size with fitted exponents.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.compare.climb import Climb as Climb
    from allworlds.studies.compare.compare_request import CompareRequest as CompareRequest
    from allworlds.studies.compare.comparison import (
        ComparedRow as ComparedRow,
        Comparison as Comparison,
    )
    from allworlds.studies.compare.contest import compare as compare, compared as compared
    from allworlds.studies.compare.contestants import Contestant as Contestant
    from allworlds.studies.compare.growing_families import Member as Member
    from allworlds.studies.compare.growth import GrowRow as GrowRow, Growth as Growth
else:
    open_door(__name__)
