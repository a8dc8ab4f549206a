"""Work that can be done piece by piece: what is done with a piece, and where.

``work``
    the words: a :class:`Unit` of work, an :class:`Engine` that does it, a :class:`Transport`
    that says where, the :class:`Part` of a result that comes back, and where it is :class:`Kept`;
``here``, ``threads``
    two transports: this thread, and several;
``cluster``, ``lanes``
    another one, to the machines of a Dask cluster, and what these have for what is sent there;
``split``
    small levels by one transport, large ones by another;
``levels``
    the units into which all maps with one number of edges are cut;
``shards``
    those of them that one of several machines does;
``effort``
    what bounds the effort: workers, and time;
``gather``
    **the** loop: the units of a level through an engine by a transport, added up.
"""

from allworlds.work.cluster import LOCAL, Dask, local_cluster
from allworlds.work.effort import (
    LEAST_TIMEOUT,
    POLL,
    EffortOptions,
    Limits,
    TimeIsUp,
    check_deadline,
)
from allworlds.work.gather import gather
from allworlds.work.here import Here, with_last
from allworlds.work.lanes import ClusterLost
from allworlds.work.levels import (
    LevelUnit,
    cells_of_level,
    drawn_units,
    level_size,
    tell_of_size,
    units_of_level,
)
from allworlds.work.shards import UNMERGEABLE, WHOLE, Portion, Shard, Whole, a_shard, shards_of
from allworlds.work.split import Split
from allworlds.work.threads import Threads
from allworlds.work.work import (
    NOTHING_KEPT,
    Engine,
    Kept,
    Part,
    Sum,
    Transport,
    Unit,
)

__all__ = [
    "LEAST_TIMEOUT",
    "LOCAL",
    "NOTHING_KEPT",
    "POLL",
    "UNMERGEABLE",
    "WHOLE",
    "ClusterLost",
    "Dask",
    "EffortOptions",
    "Engine",
    "Here",
    "Kept",
    "LevelUnit",
    "Limits",
    "Part",
    "Portion",
    "Shard",
    "Split",
    "Sum",
    "Threads",
    "TimeIsUp",
    "Transport",
    "Unit",
    "Whole",
    "a_shard",
    "cells_of_level",
    "check_deadline",
    "drawn_units",
    "gather",
    "level_size",
    "local_cluster",
    "shards_of",
    "tell_of_size",
    "units_of_level",
    "with_last",
]
