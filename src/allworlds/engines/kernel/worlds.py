"""A glued map as a world: the darts of a vertex are consecutive and clockwise, the start is 0."""

from __future__ import annotations

from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.records import NONE


@inner
def settle(world, g):
    """Write the finished map as a world without a lighthouse."""
    world.darts, world.vertices = g.darts, g.vertices
    world.place = world.pointed = NONE
    for v in range(g.vertices):
        first, degree = g.first[v], g.degree[v]
        world.root[v] = first
        for dart in range(first, first + degree):
            world.owner[dart], world.first[dart], world.degree[dart] = v, first, degree
            world.sigma[dart] = dart + 1
            world.alpha[dart] = g.alpha[dart]
        world.sigma[first + degree - 1] = first
    darken(world)


@inner
def darken(world):
    """Remove the lighthouse: only the degree is sensed, and no number told."""
    world.told = NONE
    for dart in range(world.darts):
        world.marks[dart] = 0
        world.bearing[dart] = NONE


@inlined
def arrival(world, dart, motion):
    """The dart of arrival after leaving ``motion`` places clockwise of the dart."""
    degree, leaving = world.degree[dart], dart + motion
    if leaving >= world.first[dart] + degree:
        leaving -= degree
    return world.alpha[leaving]


@inner
def doubled(world):
    """Return 1 if there is a loop, plus 2 if two edges have the same two ends."""
    found = 0
    for v in range(world.vertices):
        joined = 0
        dart = world.root[v]
        for _ in range(world.degree[dart]):
            u = world.owner[world.alpha[dart]]
            if u == v:
                found |= 1
            elif joined >> u & 1:
                found |= 2
            joined |= 1 << u
            dart += 1
    return found
