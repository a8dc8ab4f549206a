"""Minimax over states of knowledge: whether so many traversals are enough, whatever the world is.

A state is the set of the *places* that are possible: a world seen from the robot.  A motion leads
each place to another one, and the percept parts them.  The search goes through states depth first,
on a stack of its own, so that it can be stopped and continued.  Its readable twin is
:class:`allworlds.studies.optimum.fewest_traversals.Search`.

A state is given up at once if it holds more places than the traversals left can tell apart (where
such a limit is known), or two with different answers that no motions of this number tell apart.
So is a motion after which some state is too large, or has no second motion that would do.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from allworlds.engines.kernel.compiling import entry, inner
from allworlds.engines.kernel.minimax_memory import (
    ENOUGH,
    LEAST,
    found,
    keep_enough,
    keep_refuted,
    write_key,
)

NO, YES, UNKNOWN = range(3)
"""Verdicts; as the outcome of :func:`advance` the last one means that there is more to do."""

BASE, SIZE, LEFT, WAYS, WAY, PARTS, PART = range(7)
FIELDS = 7
"""The fields of a frame: where its places begin and how many they are, the traversals left, the
motions worth a try and the one that is tried, its undecided parts and the one that is tried."""


class MinimaxTables(NamedTuple):
    """The places and what motions make of them.

    Attributes:
        step: by place and motion the place after it; -1 from the degree on.
        code: by place and motion the number of the percept after it.
        answer: by place the number of the right answer.
        kind: by percept the row of ``limit`` for states after it.
        limit: by kind and traversals left the largest number of places that can be told apart.
        alike: by traversals left and place a class of places that no such motions tell apart; the
            last row tells all apart that can be told apart.
        sketch: by place and motion a number of the percept and of those that can follow it.
        sketch_code, sketch_row: by such a number the percept, and by motion the next one; -1 from
            the degree on.  No columns: next ones are not looked at.
        random: by place two random numbers, and those of its mirror image.
    """

    step: Any
    code: Any
    answer: Any
    kind: Any
    limit: Any
    alike: Any
    sketch: Any
    sketch_code: Any
    sketch_row: Any
    random: Any


class Stack(NamedTuple):
    """The states from the first one down to the current one.

    Attributes:
        pool: places of states and of their parts.
        frame: by depth the :data:`FIELDS`.
        order: by depth the motions worth a try.
        parts: by depth and part where its places begin, how many they are, and their percept.
        keys: by depth and part its key.
        own: by depth the key of the state itself.
    """

    pool: Any
    frame: Any
    order: Any
    parts: Any
    keys: Any
    own: Any


class Room(NamedTuple):
    """Room for counts.

    Attributes:
        counts: by motion and sketch; zero between two uses, as are the next ones.
        sizes: by percept.
        again: by percept.
        place: by percept the next free place in the pool.
        seen: by class of alike places when it was seen, and with which answer.
        numbers: how often :func:`_confused` was asked, and the number of states looked into.
    """

    counts: Any
    sizes: Any
    again: Any
    place: Any
    seen: Any
    numbers: Any


@entry
def begin(tables, stack, memory, room, width):
    """Whether the state in frame 0 can be decided at once; else prepare its motions."""
    frame = stack.frame
    verdict = _verdict(tables, stack, memory, room, 0, 0, frame[0, SIZE], frame[0, LEFT], 0)
    if verdict == UNKNOWN:
        for i in range(3):
            stack.own[0, i] = stack.keys[0, 0, i]
        _prepare(tables, stack, room, 0, width)
        room.numbers[1] += 1
    return verdict


@entry
def look_up(tables, stack, memory):
    """The entry of the state in frame 0, whose key is written; -1 if there is none."""
    key = stack.keys[0, 0]
    write_key(tables.random, stack.pool, stack.frame[0, BASE], stack.frame[0, SIZE], key)
    return found(memory, key)


@entry
def advance(tables, stack, memory, room, width, depth, most):
    """Go on with the search for at most ``most`` states; return the verdict and the depth.

    Args:
        tables: the places.
        stack: frames 0 .. ``depth`` are those of the search so far.
        memory: bounds found so far, with the same ``width``.
        room: see above.
        width: the number of motions tried in each state, the most promising ones; with fewer than
            there are only a YES is a proof.
        depth: where the search stands.
        most: of states.
    """
    frame, t, states = stack.frame, depth, 0
    while True:
        if frame[t, PART] < 0:
            if frame[t, WAY] < frame[t, WAYS]:
                if not _part(tables, stack, memory, room, t):
                    frame[t, WAY] += 1
                    continue
            elif t == 0:
                keep_refuted(memory, stack.own[t], frame[t, LEFT])
                room.numbers[1] += states
                return NO, 0
            else:
                keep_refuted(memory, stack.own[t], frame[t, LEFT])
                t -= 1
                frame[t, WAY] += 1
                frame[t, PART] = -1
                continue
        if frame[t, PART] < frame[t, PARTS]:
            if states == most:
                room.numbers[1] += states
                return UNKNOWN, t
            t += 1
            _enter(stack, t)
            _prepare(tables, stack, room, t, width)
            states += 1
            continue
        _keep_motion(tables, stack, memory, t)
        if t == 0:
            room.numbers[1] += states
            return YES, 0
        t -= 1
        frame[t, PART] += 1


@inner
def _keep_motion(tables, stack, memory, t):
    """Keep that the current motion of a frame leads to states that are all decided."""
    frame = stack.frame
    motion = stack.order[t, 0, frame[t, WAY]]
    degree = _degree(tables, stack.pool[frame[t, BASE]])
    keep_enough(memory, stack.own[t], frame[t, LEFT], motion, degree)


@inner
def _degree(tables, place):
    """The degree of the robot's vertex at a place."""
    degree = tables.step.shape[1]
    while tables.step[place, degree - 1] < 0:
        degree -= 1
    return degree


@inner
def _enter(stack, t):
    """Make the current part of frame ``t - 1`` the state of frame ``t``."""
    frame, parts = stack.frame, stack.parts
    u, j = t - 1, frame[t - 1, PART]
    # Behind the state above, and all its parts.
    first, size = frame[u, BASE] + 2 * frame[u, SIZE], parts[u, j, 1]
    for i in range(size):
        stack.pool[first + i] = stack.pool[parts[u, j, 0] + i]
    frame[t, BASE], frame[t, SIZE], frame[t, LEFT] = first, size, frame[u, LEFT] - 1
    for i in range(3):
        stack.own[t, i] = stack.keys[u, j, i]


@inner
def _prepare(tables, stack, room, t, width):
    """List the motions worth a try: those whose largest part is smallest come first."""
    frame, order, counts = stack.frame, stack.order, room.counts
    first, size, left = frame[t, BASE], frame[t, SIZE], frame[t, LEFT]
    degree = _degree(tables, stack.pool[first])
    for i in range(first, first + size):
        place = stack.pool[i]
        for k in range(degree):
            counts[k, tables.sketch[place, k]] += 1
    ways = 0
    for k in range(degree):
        largest = _largest(tables, room, k, left - 1)
        for s in range(counts.shape[1]):
            counts[k, s] = 0
        if largest:
            j = ways
            while j and order[t, 1, j - 1] > largest:
                order[t, 0, j], order[t, 1, j] = order[t, 0, j - 1], order[t, 1, j - 1]
                j -= 1
            order[t, 0, j], order[t, 1, j] = k, largest
            ways += 1
    frame[t, WAYS], frame[t, WAY], frame[t, PART] = min(ways, width), 0, -1


@inner
def _largest(tables, room, k, left):
    """The size of the largest part after a motion; 0 if a part is too large to be told apart."""
    sizes, largest, large = room.sizes, 0, False
    for s in range(len(tables.sketch_code)):
        sizes[tables.sketch_code[s]] += room.counts[k, s]
    for c in range(len(sizes)):
        largest = max(largest, sizes[c])
        if sizes[c] > tables.limit[tables.kind[c], left]:
            large = True
        if sizes[c] > 1 and not large:
            large = not _goes_on(tables, room, k, c, left)
        sizes[c] = 0
    return 0 if large else largest


@inner
def _goes_on(tables, room, k, c, left):
    """Whether the part with percept ``c`` has a next motion after which no part is too large."""
    again = room.again
    if tables.sketch_row.shape[1] == 0:
        return True
    for follow in range(tables.sketch_row.shape[1]):
        fits = True
        for s in range(len(tables.sketch_code)):
            if room.counts[k, s] and tables.sketch_code[s] == c:
                if tables.sketch_row[s, follow] < 0:
                    fits = False
                else:
                    again[tables.sketch_row[s, follow]] += room.counts[k, s]
        for d in range(len(again)):
            if again[d] and (left < 1 or again[d] > tables.limit[tables.kind[d], left - 1]):
                fits = False
            again[d] = 0
        if fits:
            return True
    return False


@inner
def _part(tables, stack, memory, room, t):
    """Part the state by the current motion; whether no part is known to be too hard.

    The parts that are not decided are left, larger ones first.
    """
    frame, parts = stack.frame, stack.parts
    left = frame[t, LEFT] - 1
    number = _split(tables, stack, room, t, stack.order[t, 0, frame[t, WAY]])
    undecided = 0
    for j in range(number):
        verdict = _verdict(
            *(tables, stack, memory, room, t, parts[t, j, 0], parts[t, j, 1], left, undecided)
        )
        if verdict == NO:
            return False
        if verdict == UNKNOWN:
            for i in range(3):
                parts[t, undecided, i] = parts[t, j, i]
            undecided += 1
    frame[t, PARTS], frame[t, PART] = undecided, 0
    return True


@inner
def _split(tables, stack, room, t, k):
    """Write the parts after motion ``k`` behind the state, larger ones first; return how many."""
    frame, parts, pool, sizes = stack.frame, stack.parts, stack.pool, room.sizes
    first, size = frame[t, BASE], frame[t, SIZE]
    for i in range(first, first + size):
        sizes[tables.code[pool[i], k]] += 1
    number = 0
    for c in range(len(sizes)):
        if sizes[c]:
            j = number
            while j and parts[t, j - 1, 1] < sizes[c]:
                parts[t, j, 1], parts[t, j, 2] = parts[t, j - 1, 1], parts[t, j - 1, 2]
                j -= 1
            parts[t, j, 1], parts[t, j, 2] = sizes[c], c
            sizes[c] = 0
            number += 1
    free = first + size
    for j in range(number):
        parts[t, j, 0] = room.place[parts[t, j, 2]] = free
        free += parts[t, j, 1]
    for i in range(first, first + size):
        place = pool[i]
        c = tables.code[place, k]
        pool[room.place[c]] = tables.step[place, k]
        room.place[c] += 1
    return number


@inner
def _verdict(tables, stack, memory, room, t, first, size, left, j):
    """The verdict on a state without a search; if it is unknown, its key is in ``keys[t, j]``."""
    pool, answer = stack.pool, tables.answer
    settled = True
    for i in range(first + 1, first + size):
        if answer[pool[i]] != answer[pool[first]]:
            settled = False
            break
    if settled:
        return YES
    if left == 0 or _confused(tables, pool, room, first, size, left):
        return NO
    key = stack.keys[t, j]
    write_key(tables.random, pool, first, size, key)
    known = found(memory, key)
    if known >= 0:
        if left >= memory.values[known, ENOUGH]:
            return YES
        if left < memory.values[known, LEAST]:
            return NO
    return UNKNOWN


@inner
def _confused(tables, pool, room, first, size, left):
    """Whether two places with different answers are alike for as long as traversals are left."""
    if left >= len(tables.alike) - 1:
        return False
    seen = room.seen
    room.numbers[0] += 1
    for i in range(first, first + size):
        place = pool[i]
        c = tables.alike[left, place]
        if seen[c, 0] == room.numbers[0]:
            if seen[c, 1] != tables.answer[place]:
                return True
        else:
            seen[c, 0], seen[c, 1] = room.numbers[0], tables.answer[place]
    return False
