"""Cost by size on families of large worlds, with fitted exponents: the verb ``grow``.

Of each family a few members of each size are drawn from seeds.  Every member has a name that gives
it back (``allworlds run greedy --family torus:6x6 --seed 1``), and every run in it is judged.

``ladder``
    the families and their members;
``climb``
    the runs;
``growth``
    what they have shown.
"""

from allworlds.growing.climb import Climb, grow
from allworlds.growing.growth import Exponent, GrowRow, Growth
from allworlds.growing.ladder import GROWING, Growing, Member, members_of

__all__ = [
    "GROWING",
    "Climb",
    "Exponent",
    "GrowRow",
    "Growing",
    "Growth",
    "Member",
    "grow",
    "members_of",
]
