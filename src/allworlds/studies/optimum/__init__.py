"""The best worst case of any explorer: minimax over all worlds with a known number of edges.

``knowledge``, ``place_tables``
    what a robot can still believe, as a value, and what a motion makes of it; the same in numbers;
``bracket``, ``fewest_traversals``
    bounds on the fewest traversals that are enough, by compiled searches, and their readable twin;
``strategy``, ``strategy_making``
    how: a tree of motions and answers, made of the motions that a search has found;
``in_every_world``
    the strategy followed in every world, by code of its own;
``minimax_of_worlds``, ``bouquets``
    minimax over given worlds, and the worlds of a family;
``optimum_request``
    what is asked for;
``optimum_table``
    the optimum beside the worst cases of the built-in explorers.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.optimum.in_every_world import most_expensive as most_expensive
    from allworlds.studies.optimum.minimax_of_worlds import minimax as minimax
    from allworlds.studies.optimum.optimum_request import OptimumRequest as OptimumRequest
    from allworlds.studies.optimum.optimum_table import (
        OptimumReport as OptimumReport,
        OptimumRow as OptimumRow,
        OptimumSweep as OptimumSweep,
        optimum as optimum,
    )
    from allworlds.studies.optimum.strategy import Strategy as Strategy
else:
    open_door(__name__)
