"""Algorithm 1 without a direction, compiled: v0 and a neighbour v1 of it can be recognised.

Before its first pass it searches the dart of v0 that leads to v1, and a test that has come to
v0 is proved by the query: out by that dart, and back.  The twin is
:mod:`allworlds.explorers.builtin.undirected`.
"""

from __future__ import annotations

from functools import cache

from numpy import int64

from allworlds.engines.kernel.algorithm1 import (
    MATCHED,
    PASSING,
    addresses,
    begin,
    confirm,
    next_pass,
    offset,
    reject,
    sense,
)
from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.names import MOVE
from allworlds.engines.kernel.records import NONE

SEARCHING, SEARCHED, ASKING, ASKED = range(MATCHED + 1, MATCHED + 5)
"""At the other end of a dart of v0, and back again; at the other end of the pointed dart, and
back again."""


def start(robot, percept, told, action):  # pragma: no cover  # compiled
    """The first step of the search."""
    robot.degree_of_v0, robot.degree_of_v1 = percept.degree, told
    begin(robot, int64(percept.degree), _is_v0(robot, percept.degree, percept.marks), NONE)
    _search(robot, 0, action)


def step(robot, percept, action):  # pragma: no cover  # compiled
    """Write the explorer's next action, after this percept."""
    degree, marks = percept.degree, percept.marks
    if robot.phase == SEARCHING or robot.phase == ASKING:
        robot.matched = _is_v1(robot, degree, marks)
        robot.phase += 1
        action.kind, action.motion = MOVE, 0
    elif robot.phase == SEARCHED:
        robot.here = robot.pointed
        if robot.matched or robot.pointed + 1 == robot.darts:
            next_pass(robot, action)
        else:
            _search(robot, robot.pointed + 1, action)
    elif robot.phase == PASSING:
        next_pass(robot, action)
    else:
        if robot.phase == ASKED:
            _hear(robot, action)
        else:
            sense(robot, degree, _is_v0(robot, degree, marks), NONE, action)
        if robot.phase == MATCHED:
            _ask(robot, action)


@cache
def two_vertices_addresses() -> tuple[int, int, int]:
    """The addresses of the compiled explorer: start, step, answer."""
    return addresses(start, step)


@inlined
def _is_v0(robot, degree, marks):
    """Return 1 if this is the percept of v0, else 0."""
    if robot.natural:
        return 1 if degree == robot.degree_of_v0 else 0
    return 1 if marks == 1 else 0


@inlined
def _is_v1(robot, degree, marks):
    """Return 1 if this is the percept of v1, else 0."""
    if robot.natural:
        return 1 if degree == robot.degree_of_v1 else 0
    return 1 if marks == 2 else 0


@inner
def _search(robot, dart, action):
    """Leave by this dart of v0, to search v1."""
    robot.phase, robot.pointed = SEARCHING, dart
    action.kind, action.motion = MOVE, dart - robot.here


@inner
def _ask(robot, action):
    """Begin the query: leave by the dart that should be the pointed one."""
    towards = offset(robot, robot.pointed)
    robot.phase = ASKING
    action.kind, action.motion = MOVE, towards - robot.turned
    robot.turned = towards


@inlined
def _hear(robot, action):
    """Use the answer of the query; the robot is back at v0, turned to the dart it left by."""
    if robot.matched:
        confirm(robot, robot.pointed, action)
    else:
        reject(robot, action)
