"""Greedy in round worlds; in long worlds, near v0 first.

In a world that is as round as a lattice every place is near v0, and the nearest dart is the best.
In a long one (a thick path, a prism) the nearest dart leads away from v0, where tests are
expensive, and leaves open darts behind, each of which is a hypothesis in every later pass: there
darts near v0 come first.  The settled part of the map shows which of the two the world is.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from math import inf

from allworlds.explorers.builtin.algorithm1 import nobody, unseen
from allworlds.explorers.builtin.greedy import Greedy
from allworlds.explorers.builtin.unforgetting import Settled, Spread, Walk
from allworlds.protocol import Estimate, Percept

HOME = 4
"""The weight of a step between a dart and v0 in a long world, in steps of the robot."""


def prudent(
    first: Percept, *, notice: Callable[[str], None] = nobody, settled: Settled = unseen
) -> Walk[Estimate]:
    """Explore from a directional lighthouse; return an estimate equal to the world, pose included.

    While the settled part is round this is :func:`allworlds.explorers.builtin.greedy.greedy`.
    While it is long, the next dart is the one with the least sum of the robot's way to it and, four
    times, its way to v0.

    Args:
        first: the percept at v0 before any motion; it has a bearing.
        notice: told of the events of
            :func:`allworlds.explorers.builtin.remembering.remembering`.
        settled: told of S when it grows.

    Cost: at most (1) + (2) of Section VI traversals.
    """
    return (yield from Prudent(first, notice, settled).explore())


class Prudent(Greedy):
    """The state of an exploration that stays near v0 while the settled part is long."""

    def next_dart(self, unexplored: list[int]) -> int:
        """The nearest dart, or in a long world the one nearest to v0 and the robot."""
        if not self._is_long():
            return super().next_dart(unexplored)
        log = self.log
        darts = defaultdict(list)
        for dart in unexplored:
            darts[log.node[dart]].append(dart)
        here = log.node[self.here]
        spread = Spread(log, here)
        best: tuple[float, int, int] = (inf, 0, 0)
        while darts and spread.distance <= best[0]:
            for v in spread.layer:
                turned = self.here if v == here else log.base[v]
                for dart in darts.pop(v, ()):
                    cost = spread.distance + HOME * self.distance[v]
                    best = min(best, (cost, (dart - turned) % log.degree[v], dart))
            spread.grow()
        return best[2]

    def _is_long(self) -> bool:
        """Whether one of the s settled vertices is further than 3/2 sqrt(s) from v0."""
        return 4 * max(self.distance.values()) ** 2 > 9 * len(self.distance)


__all__ = ["Prudent", "prudent"]
