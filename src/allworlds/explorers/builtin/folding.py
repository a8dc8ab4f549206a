"""Explorers that only fold their log: right if they stop, in whatever way they walk.

All percepts of a run are one map, the folded log
(:mod:`allworlds.explorers.builtin.folded_log`); where no dart of it is open it is the world.
Hypotheses are not tested, and two vertices are merged only when an arrival at v0 proves them equal.
Which open dart is next is left to a *way*, and it must be a fair one: every dart that is open is
walked through some day, or closed by others.  Then every vertex that was entered is left some day
by its way home, and merged; so it ends.  The open dart that is nearest to the robot is not fair:
the robot can walk on for ever, from copy to copy.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeAlias

from allworlds.explorers.builtin.algorithm1 import Walk, nobody
from allworlds.explorers.builtin.folded_log import OPEN, FoldedLog
from allworlds.explorers.builtin.partial_map import bearing_of
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol.actions import Move, Percept
from allworlds.protocol.answers import Estimate
from allworlds.protocol.choices import Choices

Way: TypeAlias = Callable[[FoldedLog, int], list[int]]
"""The darts to leave by, one after the other, from the robot's dart to the end of an open one."""


def folding(
    first: Percept,
    *,
    choices: Choices | None = None,  # noqa: ARG001  # its way leaves none
    notice: Callable[[str], None] = nobody,
) -> Walk[Estimate]:
    """Go home to v0, then to the open dart that is nearest to v0.

    An event is ``merged``, an arrival at v0 that makes nodes one.

    Cost: the explorer stops; no bound is known (up to 1,206 traversals for m = 5).
    """
    return (yield from explore_folding(first, by_home, notice))


def folding_oldest(
    first: Percept,
    *,
    choices: Choices | None = None,  # noqa: ARG001  # its way leaves none
    notice: Callable[[str], None] = nobody,
) -> Walk[Estimate]:
    """Go a shortest way to the dart that is open for the longest time; else as :func:`folding`."""
    return (yield from explore_folding(first, to_oldest, notice))


def by_home(log: FoldedLog, here: int) -> list[int]:
    """The way to v0, then to the open dart nearest to it, clockwise from the pointed dart."""
    home = way(log, here, lambda dart: log.node[dart] == 0)
    return [*home[:-1], *way(log, 0, lambda dart: log.beyond(dart) == OPEN)]


def to_oldest(log: FoldedLog, here: int) -> list[int]:
    """The way to the open dart with the smallest number, which is the oldest."""
    oldest = next(dart for dart in _darts(log) if log.beyond(dart) == OPEN)
    return way(log, here, lambda dart: dart == oldest)


def explore_folding(
    first: Percept, next_way: Way, hears: Callable[[str], None] = nobody
) -> Walk[Estimate]:
    """Walk these ways and fold the percepts until no dart is open."""
    log, here = begun(first)
    while has_open_dart(log):
        for dart in next_way(log, here):
            seen = yield Move((dart - here) % log.degree[log.node[here]])
            merges = log.merges
            here = log.arrive(dart, seen)
            if log.merges > merges:
                hears("merged")
    return estimate(log, here)


def begun(first: Percept) -> tuple[FoldedLog, int]:
    """The log of the first percept, which has a bearing, and the dart that the robot faces."""
    log = FoldedLog(first)
    return log, log.turn(0, -bearing_of(first))


def has_open_dart(log: FoldedLog) -> bool:
    """Whether a dart is open, so that the log does not determine the map yet."""
    return any(log.beyond(dart) == OPEN for dart in _darts(log))


def estimate(log: FoldedLog, here: int) -> Estimate:
    """The folded map, with the robot's dart in it; no dart may be open."""
    darts = [*_darts(log)]
    number = {dart: i for i, dart in enumerate(darts)}
    sigma = [number[log.turn(dart, 1)] for dart in darts]
    alpha = [number[log.beyond(dart)] for dart in darts]
    return Estimate(CombinatorialMap(sigma, alpha), number[here])


def _darts(log: FoldedLog) -> Iterator[int]:
    """The canonical darts, ascending."""
    for first, degree, stands in zip(log.base, log.degree, log.stands, strict=True):
        if stands == first:
            yield from range(first, first + degree)


def way(log: FoldedLog, start: int, is_goal: Callable[[int], bool]) -> list[int]:
    """The darts by which a shortest walk leaves, up to the first dart that is a goal.

    Darts of one node are looked at clockwise, from its dart of entry on.
    """
    came: dict[int, list[int]] = {log.node[start]: []}
    queue = [start]
    for entry in queue:
        darts = [log.turn(entry, k) for k in range(log.degree[log.node[entry]])]
        leading = came[log.node[entry]]
        for dart in darts:
            if is_goal(dart):
                return [*leading, dart]
        for dart in darts:
            other = log.beyond(dart)
            if other != OPEN and log.node[other] not in came:
                came[log.node[other]] = [*leading, dart]
                queue.append(other)
    raise AssertionError("the folded log is connected")
