"""The best that any explorer can do: minimax over all worlds with a known number of edges.

``knowledge``
    what a robot can still believe, as a value, and what a motion makes of it;
``search``
    the fewest traversals that are enough, whatever the world is;
``strategy``
    how: a tree of motions and answers;
``replay``
    the strategy followed in every world, by code of its own;
``table``
    the optimum beside the worst cases of the built-in explorers.
"""

from allworlds.minimax.replay import dearest
from allworlds.minimax.strategy import Leaf, Node, Step, Strategy
from allworlds.minimax.table import OptimumReport, OptimumRow, Solved, minimax, optimum

__all__ = [
    "Leaf",
    "Node",
    "OptimumReport",
    "OptimumRow",
    "Solved",
    "Step",
    "Strategy",
    "dearest",
    "minimax",
    "optimum",
]
