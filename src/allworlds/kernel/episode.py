"""One episode: an explorer behind its C interface meets a world, and everything is recorded."""

from __future__ import annotations

from allworlds.kernel.compiling import inlined, inner
from allworlds.kernel.explorers import go_on, publish, set_out
from allworlds.kernel.invariants import look_at
from allworlds.kernel.laws import BUDGET, ILLEGAL_ACTION
from allworlds.kernel.names import ANSWER_READY, CHECKPOINT, MOVE
from allworlds.kernel.worlds import arrival


@inner
def play(world, explorer, budget, beat, log, judged):
    """The law that ended the episode, or 0 where there is an answer; ``log`` holds the walk.

    Args:
        world: where the robot is.
        explorer: behind its C interface, or a log that is read again.
        budget: the largest legal number of traversals; one checkpoint more is legal.
        beat: ``beat[1]`` grows at each turn of the explorer, for who looks on from outside.
        log: is begun anew; the answer comes to stand in it.
        judged: what the checkpoints are worth, where ``log.watched``.
    """
    percept, action = explorer.percept, explorer.action
    log.cost = log.checkpoints = log.walked = 0
    dart = world.start
    _sense(world, dart, percept)
    action.kind = 0
    turn = 1
    beat[1] = turn
    set_out(explorer, world.told)
    while True:
        turn += 1
        beat[1] = turn
        if action.kind == MOVE:
            if log.cost == budget:
                return BUDGET
            motion = _reduced(action.motion, world.degree[dart])
            dart = arrival(world, dart, motion)
            _sense(world, dart, percept)
            _record(log, motion, percept)
            log.walked |= 1 << dart | 1 << world.alpha[dart]
        elif action.kind == CHECKPOINT:
            if log.checkpoints > budget:
                return BUDGET
            log.checkpoints += 1
            if log.watched:
                publish(explorer, log.published)
                look_at(judged, log.published, world, dart, log.walked)
        elif action.kind == ANSWER_READY:
            log.dart = dart
            publish(explorer, log.published)
            return 0
        else:
            return ILLEGAL_ACTION
        action.kind = 0
        go_on(explorer)


@inlined
def _sense(world, dart, percept):
    """What is sensed on arriving by the dart."""
    percept.degree = world.degree[dart]
    percept.marks = world.marks[dart]
    percept.bearing = world.bearing[dart]


@inlined
def _reduced(motion, degree):
    """The motion modulo the degree."""
    if 0 <= motion < degree:
        return motion
    return motion % degree


@inlined
def _record(log, motion, percept):
    """One traversal, and what was sensed behind it."""
    step = log.cost
    log.motion[step] = motion
    log.degree[step] = percept.degree
    log.marks[step] = percept.marks
    log.bearing[step] = percept.bearing
    log.cost = step + 1
