"""Checks of two worlds without any formula: do they look alike, and are they different?

This knows worlds, and nothing of formulas: it is what a pair that a solver has found must pass.
"""

from __future__ import annotations

from allworlds.maps import Dart, numbering, rooted_code
from allworlds.world import World


def bisimulation(a: World, b: World) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    """Class numbers of the darts of ``a`` and of ``b``; None if a motion tells them apart.

    The finest classes of which the starts share one, sigma and alpha take classes to classes,
    and the darts of a class sense the same.  They are numbered in the order of the darts of
    ``a``.

    Cost: O(m^2) at worst.
    """
    pairs = {(a.start, b.start)}
    for x, y in (todo := list(pairs)):
        if a.percepts[x] != b.percepts[y]:
            return None
        for pair in ((a.map.sigma[x], b.map.sigma[y]), (a.map.alpha[x], b.map.alpha[y])):
            if pair not in pairs:
                pairs.add(pair)
                todo.append(pair)
    # Every dart of b is met, for its map is connected; the least dart of a names the class.
    label = list(a.map.darts), [len(a.map.sigma)] * len(b.map.sigma)
    changed = True
    while changed:
        changed = False
        for x, y in sorted(pairs):
            least = min(label[0][x], label[1][y])
            if (label[0][x], label[1][y]) != (least, least):
                label[0][x] = label[1][y] = least
                changed = True
    names = {least: i for i, least in enumerate(sorted(set(label[0])))}
    return tuple(names[x] for x in label[0]), tuple(names[y] for y in label[1])


def code(world: World, start: Dart) -> tuple[object, ...]:
    """The canonical code from a dart, equal exactly for the same world entered at the same dart."""
    sigma, alpha = world.map.sigma, world.map.alpha
    sensed = (world.percepts[dart] for dart in numbering(sigma, alpha, start))
    return (*rooted_code(sigma, alpha, start), *sensed)


def same_world_from(a: World, b: World) -> Dart | None:
    """The start at which ``b`` would be the same world as ``a``; None if the two differ.

    Where v0 is marked it is a dart of v0, as every start is.
    """
    if len(a.map.sigma) != len(b.map.sigma):
        return None
    mine = code(a, a.start)
    return next((dart for dart in b.map.darts if code(b, dart) == mine), None)
