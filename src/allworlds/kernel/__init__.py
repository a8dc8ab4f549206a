"""Compiled engines: the same answers, orders of magnitude further.

Each is compared with a readable twin that shares no code with it.  They hold the interpreter's
lock only to start and to end, so that threads share the work.

``engine``, ``rows``
    the door: plain numbers in, plain rows out;
``runs``, ``episode``, ``explorers``, ``answers``, ``invariants``, ``embedding``, ``folding``
    the judge: every run of every map of a class, played, judged and tallied;
``gluing``, ``classes``, ``worlds``, ``lighthouses``
    what is judged: maps, finished one after the other, as worlds with every lighthouse;
``algorithm1``, ``two_vertices``
    explorers, each behind the C interface of all explorers;
``native``, ``picking``, ``logs``, ``writing``, ``batches``
    foreign explorers, played in processes of their own, many runs at a time;
``demand_driven``, ``ways``, ``tally``
    the demand-driven check of Algorithm 1: a world is decided only where the robot looks;
``schedules``, ``dearest``
    the worst and the best cost of a world over all schedules, and its door;
``counting``
    how many maps there are, by vertices and faces;
``records``, ``walk_records``, ``tables``, ``names``, ``law_numbers``
    what is kept in memory, what is looked up, and the names of small numbers;
``compiling``, ``calls``, ``bits``, ``code``
    how it is compiled, C functions called by their addresses, sets as bit masks, codes.

This package is imported where it is used: the first use compiles for some seconds, later ones
load what was compiled.
"""

from allworlds.kernel.batches import (
    LONGEST_STRETCH,
    MOST_EARLIER,
    Actors,
    Kept,
    Laid,
    Stretch,
    UnitJudge,
    load_native,
)
from allworlds.kernel.compiling import is_compiled
from allworlds.kernel.dearest import Dearest, dearest_of_unit
from allworlds.kernel.demand_driven import explore
from allworlds.kernel.engine import (
    COMPILING,
    EXPLORERS,
    LIGHTHOUSES,
    MOST_BUDGET,
    UNDEFINED,
    by_vertices_and_faces,
    compile_apart,
    costs,
    flag,
    judge,
    load_judge,
    reached_in,
    walk,
)
from allworlds.kernel.law_numbers import CHECKED
from allworlds.kernel.native import RUN_NUMBER, RUN_TOLD, play_worlds
from allworlds.kernel.rows import Bounds, Broken, Counts, Level, Listed, Rows, walk_number
from allworlds.kernel.runs import examine
from allworlds.kernel.schedules import search
from allworlds.kernel.tables import MOST_EDGES, Tables, tables
from allworlds.kernel.writing import End, Written, answer_entry, read_log, shown_entry

__all__ = [
    "CHECKED",
    "COMPILING",
    "EXPLORERS",
    "LIGHTHOUSES",
    "LONGEST_STRETCH",
    "MOST_BUDGET",
    "MOST_EARLIER",
    "MOST_EDGES",
    "RUN_NUMBER",
    "RUN_TOLD",
    "UNDEFINED",
    "Actors",
    "Bounds",
    "Broken",
    "Counts",
    "Dearest",
    "End",
    "Kept",
    "Laid",
    "Level",
    "Listed",
    "Rows",
    "Stretch",
    "Tables",
    "UnitJudge",
    "Written",
    "answer_entry",
    "by_vertices_and_faces",
    "compile_apart",
    "costs",
    "dearest_of_unit",
    "examine",
    "explore",
    "flag",
    "is_compiled",
    "judge",
    "load_judge",
    "load_native",
    "play_worlds",
    "reached_in",
    "read_log",
    "search",
    "shown_entry",
    "tables",
    "walk",
    "walk_number",
]
