"""Compiled engines for the class ``maps``: the same answers, orders of magnitude further.

Each is compared with a readable twin that shares no code with it.  They hold the interpreter's
lock only to start and to end, so that threads share the work.

``bits``, ``code``, ``names``
    sets as bit masks, canonical codes, and the names of small numbers;
``tables``
    what the engines look up: bounds, the gluing rule; mutants are damaged tables;
``walk``
    the demand-driven check of Algorithm 1: a world is decided only where the robot looks;
``thorough``
    every finished map, one after the other, held to the judge's laws;
``gluing``
    every rooted map, one after the other, or only counted by vertices and faces;
``schedules``
    the worst and the best cost of a world over all schedules;
``engine``
    the door to them: plain numbers in, plain rows out.

This package is imported where it is used: the first use compiles for some seconds, later ones
load what was compiled.
"""

from allworlds.kernel.engine import (
    COMPILING,
    Counts,
    Mode,
    Rows,
    by_vertices_and_faces,
    costs,
    examine,
    flag,
    is_compiled,
)
from allworlds.kernel.schedules import Dearest, dearest_of_maps, dearest_of_unit, search, take
from allworlds.kernel.tables import Tables, tables
from allworlds.kernel.walk import explore

__all__ = [
    "COMPILING",
    "Counts",
    "Dearest",
    "Mode",
    "Rows",
    "Tables",
    "by_vertices_and_faces",
    "costs",
    "dearest_of_maps",
    "dearest_of_unit",
    "examine",
    "explore",
    "flag",
    "is_compiled",
    "search",
    "tables",
    "take",
]
