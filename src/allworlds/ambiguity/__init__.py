"""What no robot can tell apart: ambiguity classes, twins and their certificates.

Glossary
--------
quotient
    The world with the darts that no motion tells apart taken together
    (:mod:`allworlds.maps.quotient`).
ambiguity class
    All worlds with the same rooted quotient; a world with a class of one member can be
    mapped.
pose hypothesis
    A member of the class and a dart in it, up to automorphisms, at which the robot can be.
bisimulation
    Classes of darts that prove that no motion tells two worlds apart
    (:mod:`allworlds.bisimulation`).
separation
    Motions that tell them apart.

Modules
-------
``comparison``
    two worlds: a bisimulation or a separation;
``members``, ``lifting``, ``marked``
    the class of a world: its members, how they are made from the quotient, and their codes;
``census``
    every map with a marked vertex.
"""

from allworlds.ambiguity.census import AmbiguityCensus, CensusRow, census, merged_census
from allworlds.ambiguity.comparison import (
    Bisimulation,
    ComparedWorlds,
    Separation,
    sensed,
    twins,
)
from allworlds.ambiguity.members import DEFAULT_LIMIT, AmbiguityClass, class_of, projection_of
from allworlds.maps.criterion import Disagreement, class_size, is_ambiguous, pose_count

__all__ = [
    "DEFAULT_LIMIT",
    "AmbiguityCensus",
    "AmbiguityClass",
    "Bisimulation",
    "CensusRow",
    "ComparedWorlds",
    "Disagreement",
    "Separation",
    "census",
    "class_of",
    "class_size",
    "is_ambiguous",
    "merged_census",
    "pose_count",
    "projection_of",
    "sensed",
    "twins",
]
