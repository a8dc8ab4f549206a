"""A tree of runs, walked by an explorer that can be copied: in worlds, and against records.

Where the world is not decided yet the tree branches.  Behind a branch the explorer goes on from a
copy of its state, once for every way, so that the common part of several runs is walked once.

The first play decides the world on demand (:mod:`allworlds.engines.kernel.on_demand`); the second
one has no world: it walks along the recorded segments, in another order.  The bytes that both write
are those of :mod:`allworlds.engines.kernel.native`; its readable twin is
:mod:`allworlds.engines.isolation.chunk_player`.
"""

from __future__ import annotations

from numba import int32
from numpy import int64

from allworlds.engines.kernel.calls import (
    address_of,
    call_choose,
    call_clone,
    call_new,
    call_start,
    call_step,
    put_word,
)
from allworlds.engines.kernel.compiling import entry, inlined, inner
from allworlds.engines.kernel.log_codes import (
    OVER_BUDGET,
    SHOWN,
    STRANGE,
)
from allworlds.engines.kernel.logs import LONGEST_ENTRY
from allworlds.engines.kernel.names import AMBIGUOUS, ANSWER_READY, CHECKPOINT, MOVE
from allworlds.engines.kernel.native import (
    ACTED,
    ASKED,
    CHOOSE,
    NOTHING_DUE,
    PICK,
    SENSED,
    START,
    STATE,
    STEP,
    end,
    publish,
    write,
)
from allworlds.engines.kernel.on_demand import (
    NOWHERE,
    ONE_WAY,
    SEVERAL,
    begin,
    decide,
    decide_again,
    places,
)
from allworlds.engines.kernel.records import NONE
from allworlds.engines.kernel.tree_requests import (
    AT,
    DEAD_END,
    INSIDE,
    LAST,
    MOTIONS,
    NEXT,
    PERCEPTS,
)

# The functions that copy a state, and make one.
CLONE, NEW = range(2)


@entry
def play_tree(
    d,
    explorer,
    percept,
    action,
    here,
    room,
    asked,
    states,
    pool,
    prefix,
    viable,
    budgets,
    logs,
    runs,
    beat,
):
    """Play a chunk of a tree; return the number of bytes of its log, -1 if it cannot be played so.

    ``d`` is the world that is decided on demand, with the request filled in: the kind of
    lighthouse, the place, and the ways from the start that are given.  ``explorer`` to ``asked``,
    and ``beat``, are as for :func:`allworlds.engines.kernel.native.play_worlds`.  ``states`` holds
    the addresses of the functions that copy a state and make one, ``pool`` those of states for
    the branches, 0 where none has been made yet.  Each map begins with the decisions of
    ``prefix``; ``viable`` is as for :func:`allworlds.engines.kernel.gluing.advance`, ``budgets``
    as for :func:`allworlds.engines.kernel.on_demand.begin`.  ``logs`` is written.  The chunk ends
    after so many ``runs``, that which is repeated included.
    """
    handed = (percept, action, here, room)
    at, due, played, turn = int64(0), NOTHING_DUE, 0, 0
    if runs == 0:
        return at
    begin(d, prefix, budgets)
    dart = int64(0)
    _sense(d.world, dart, percept)
    _begin(explorer, action, asked, beat)
    while True:
        turn += 1
        beat[1] = turn
        at, due, dart, going = _act(
            d, explorer, handed, asked, states, pool, viable, budgets, logs, at, due, dart
        )
        if at < 0:
            return at
        if not going:
            if dart != NONE:
                played += 1
                d.given = 0
                if played >= runs or at >= len(logs) // 2:
                    break
            dart = _go_on(d, explorer, states, pool, viable, budgets)
            if dart == NONE:
                d.place += 1
                if d.place >= places(d, prefix):
                    break
                begin(d, prefix, budgets)
                dart = int64(0)
                _sense(d.world, dart, percept)
                _begin(explorer, action, asked, beat)
                continue
            _sense(d.world, dart, percept)
        action[0] = action[1] = 0
        call_step(explorer[STEP], explorer[STATE], explorer[SENSED], explorer[ACTED])
    beat[1] = 0
    write(explorer, logs, due)
    return at


@inlined
def _act(d, explorer, handed, asked, states, pool, viable, budgets, logs, at, due, dart):
    """Do what the explorer asks for.

    Return the place in the log (-1: only another engine can), the map that is due, the robot's dart
    (NONE: no world goes on so), and whether the run goes on.
    """
    percept, action, _, _ = handed
    g, world, kind = d.gluing, d.world, action[0]
    if at + LONGEST_ENTRY > len(logs) or asked.wrong:
        return int64(-1), due, dart, False
    if kind == MOVE:
        if d.cost == d.budget:
            logs[at] = OVER_BUDGET
            return (at + 1 if d.whole else int64(-1)), due, dart, False
        motion = _write_motion(logs, at, action, world.degree[dart])
        y = dart + motion
        if y >= world.first[dart] + world.degree[dart]:
            y -= world.degree[dart]
        d.cost += 1
        if g.open >> y & 1:
            d.cost -= 1
            way = decide(d, y, viable, budgets)
            if way == NOWHERE:
                return at + 1, due, int64(NONE), False
            if way == SEVERAL:
                _store(explorer, states, pool, d.depth - 1)
            d.cost += 1
        dart = world.alpha[y]
        _sense(world, dart, percept)
        return at + 1, due, dart, True
    if kind == CHECKPOINT and d.shown <= d.budget:
        d.shown += 1
        at, due = publish(explorer, handed, logs, at, SHOWN, due)
        return (at if due[0] >= 0 else int64(-1)), due, dart, True
    if kind == CHECKPOINT and not d.whole:
        return int64(-1), due, dart, False
    at, due = end(explorer, handed, kind, logs, at, due)
    strange = kind == AMBIGUOUS or (kind == ANSWER_READY and due[0] < 0)
    return (int64(-1) if strange else at + 1), due, dart, False


@inner
def _store(explorer, states, pool, place):
    """Copy the explorer's state to the pool."""
    if pool[place] == 0:
        pool[place] = call_new(states[NEW])
    call_clone(states[CLONE], explorer[STATE], pool[place])


@inlined
def _write_motion(logs, at, action, degree):
    """The motion modulo the degree, which is written to the log."""
    motion = int64(action[1])
    if motion < 0 or motion >= degree:
        motion %= degree
    logs[at] = motion
    return motion


@inlined
def _go_on(d, explorer, states, pool, viable, budgets):
    """Go on from the last branch in its next way; return the dart behind it, or NONE at the end.

    The explorer's state is a copy of that at the branch; for the last way, that one itself.
    """
    while d.depth:
        way = decide_again(d, viable, budgets)
        if way == SEVERAL:
            call_clone(states[CLONE], pool[d.depth - 1], explorer[STATE])
        elif way == ONE_WAY:
            pool[d.depth], explorer[STATE] = explorer[STATE], pool[d.depth]
        if way != NOWHERE:
            d.cost += 1
            return d.world.alpha[d.branches[d.depth - (way == SEVERAL)].y]
    return int64(NONE)


@inlined
def _sense(world, dart, percept):
    """Write the percept on arriving by the dart."""
    put_word(address_of(percept), world.degree[dart] | world.marks[dart] << 32)
    percept[2] = int32(world.bearing[dart])


@inlined
def _begin(explorer, action, asked, beat):
    """Let the explorer take the first step of a run."""
    beat[0], beat[1] = 0, 1
    asked.wrong = 0
    if explorer[CHOOSE]:
        call_choose(explorer[CHOOSE], explorer[STATE], explorer[PICK], explorer[ASKED])
    action[0] = action[1] = 0
    call_start(explorer[START], explorer[STATE], explorer[SENSED], int32(NONE), explorer[ACTED])


@entry
def play_segments(
    explorer,
    percept,
    action,
    here,
    room,
    asked,
    states,
    pool,
    roots,
    segments,
    percepts,
    waiting,
    logs,
    beat,
):
    """Play trees of recorded segments; return 0, or -1 if one of them cannot be played so.

    ``explorer`` to ``pool``, and ``beat``, are as for :func:`play_tree`.  ``roots`` are the first
    segments of trees, in the order in which they are played; ``segments`` and ``percepts`` are as
    they stand in the memory of a tree.  ``waiting`` has room for a segment for each branch.
    ``logs`` is written where each segment's bytes stand.
    """
    handed = (percept, action, here, room)
    due = NOTHING_DUE
    for root in roots:
        segment, depth, fresh = int64(root), 0, True
        while segment >= 0:
            _sense_record(percepts, int64(segments[segment, PERCEPTS]), percept)
            if fresh:
                _begin(explorer, action, asked, beat)
                fresh = False
            else:
                action[0] = action[1] = 0
                call_step(explorer[STEP], explorer[STATE], explorer[SENSED], explorer[ACTED])
            due, going = _play_segment(
                explorer, handed, asked, segments[segment], percepts, logs, due, beat
            )
            if due[0] < -1:
                return -1
            segment, depth = _next(explorer, states, pool, segments, segment, going, waiting, depth)
    beat[1] = 0
    write(explorer, logs, due)
    return 0


FAILED = (int64(-2), int64(0), int64(0))
"""In place of the map that is due: this cannot be played here."""


@inlined
def _play_segment(explorer, handed, asked, segment, percepts, logs, due, beat):
    """Play one segment after its first action; return the map due, and whether it branches."""
    percept, action, _, _ = handed
    at, left, inside = int64(segment[AT]), int64(segment[MOTIONS]), segment[INSIDE]
    place = int64(segment[PERCEPTS])
    while True:
        beat[1] += 1
        kind = action[0]
        if at + LONGEST_ENTRY > len(logs) or asked.wrong:
            return FAILED, False
        if kind == MOVE:
            if left == 0:
                logs[at] = STRANGE
                return due, False
            _write_motion(logs, at, action, int64(percepts[place]))
            at += 1
            left -= 1
            if left == 0 and (inside >= 0 or inside == DEAD_END):
                return due, inside >= 0
            place += 3
            _sense_record(percepts, place, percept)
        elif kind == CHECKPOINT:
            at, due = publish(explorer, handed, logs, at, SHOWN, due)
            if due[0] < 0:
                return FAILED, False
        else:
            _, due = end(explorer, handed, kind, logs, at, due)
            return due, False
        action[0] = action[1] = 0
        call_step(explorer[STEP], explorer[STATE], explorer[SENSED], explorer[ACTED])


@inlined
def _next(explorer, states, pool, segments, segment, going, waiting, depth):
    """The next segment, or -1 at the end of the tree, and the number of branches with ways left.

    ``pool`` holds the explorer's states at these branches.
    """
    if going:
        inside = int64(segments[segment, INSIDE])
        after = int64(segments[inside, NEXT])
        if after != LAST:
            waiting[depth] = after
            _store(explorer, states, pool, depth)
            depth += 1
        return inside, depth
    if depth == 0:
        return int64(-1), depth
    segment = int64(waiting[depth - 1])
    after = int64(segments[segment, NEXT])
    if after != LAST:
        waiting[depth - 1] = after
        call_clone(states[CLONE], pool[depth - 1], explorer[STATE])
    else:
        depth -= 1
        pool[depth], explorer[STATE] = explorer[STATE], pool[depth]
    return segment, depth


@inlined
def _sense_record(percepts, place, percept):
    """Write a recorded percept."""
    put_word(address_of(percept), int64(percepts[place]) | int64(percepts[place + 1]) << 32)
    percept[2] = int32(percepts[place + 2]) - 1
