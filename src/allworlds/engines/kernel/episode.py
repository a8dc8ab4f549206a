"""One episode: an explorer behind its C interface meets a world, and everything is recorded."""

from __future__ import annotations

from numba import int32

from allworlds.engines.kernel.calls import call_answer, call_start, call_step
from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.invariants import look_at
from allworlds.engines.kernel.law_numbers import BUDGET, ILLEGAL_ACTION
from allworlds.engines.kernel.names import ANSWER_READY, CHECKPOINT, MOVE
from allworlds.engines.kernel.worlds import arrival


@inner
def meet(world, explorer, budget, beat, log, judged):
    """Play an episode; see :func:`allworlds.engines.kernel.explorers.play`."""
    percept, action = explorer.percept, explorer.action
    log.cost = log.checkpoints = log.walked = 0
    log.published.bytes = 0
    dart = world.start
    _sense(world, dart, percept)
    action.kind = 0
    turn = 1
    beat[1] = turn
    call_start(explorer.start, explorer.state, percept, int32(world.told), action)
    while True:
        turn += 1
        beat[1] = turn
        if action.kind == MOVE:
            if log.cost == budget:
                return BUDGET
            dart = arrival(world, dart, _reduced(action.motion, world.degree[dart]))
            _sense(world, dart, percept)
            log.arrived[log.cost] = dart
            log.cost += 1
            log.walked |= 1 << dart | 1 << world.alpha[dart]
        elif action.kind == CHECKPOINT:
            if log.checkpoints > budget:
                return BUDGET
            log.checkpoints += 1
            if log.watched:
                call_answer(explorer.answer, explorer.state, log.published)
                look_at(judged, log.published, world, dart, log.walked)
        elif action.kind == ANSWER_READY:
            log.dart = dart
            call_answer(explorer.answer, explorer.state, log.published)
            return 0
        else:
            return ILLEGAL_ACTION
        action.kind = 0
        call_step(explorer.step, explorer.state, percept, action)


@inlined
def _sense(world, dart, percept):
    """Write the percept on arriving by the dart."""
    percept.degree = world.degree[dart]
    percept.marks = world.marks[dart]
    percept.bearing = world.bearing[dart]


@inlined
def _reduced(motion, degree):
    """The motion modulo the degree."""
    if 0 <= motion < degree:
        return motion
    return motion % degree
