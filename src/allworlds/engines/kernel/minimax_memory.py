"""The memory of the minimax search: bounds for states, by keys of 128 random bits.

A state and its mirror image are one entry, under the smaller of their keys.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import int64, uint64

from allworlds.engines.kernel.compiling import inner

LEAST, ENOUGH, MOTION, WORTH = range(4)
VALUES = 4
"""The values of an entry: bounds from below and above, a motion that attains the one above, and the
traversals left at the last visit."""

FAR = 255
"""The value for a bound that is not known."""

BUCKET = 4
"""The entries that are looked at for one key."""

HIGH, LOW, MIRRORED = range(3)
"""The parts of a key: its halves, and whether it is that of the mirror image."""


class Memory(NamedTuple):
    """Known bounds: a table in which newer entries replace older ones.

    Attributes:
        keys: by entry the two halves of its key.
        values: by entry the :data:`VALUES`.
    """

    keys: Any
    values: Any


@inner
def write_key(random, pool, first, size, key):
    """Write the key of the state with these places.

    Args:
        random: by place two random numbers, and those of its mirror image.
        pool: holds places.
        first: where those of the state begin.
        size: their number.
        key: is written.
    """
    a, b, c, d = uint64(0), uint64(0), uint64(0), uint64(0)
    for i in range(first, first + size):
        place = pool[i]
        a += random[place, 0]
        b += random[place, 1]
        c += random[place, 2]
        d += random[place, 3]
    mirrored = c < a or (c == a and d < b)
    if mirrored:
        a, b = c, d
    key[HIGH], key[LOW], key[MIRRORED] = a, b, uint64(mirrored)


@inner
def found(memory, key):
    """The entry of a key; -1 if there is none."""
    mask = uint64(len(memory.keys) - 1)
    for j in range(BUCKET):
        i = int64((key[HIGH] & mask) ^ uint64(j))
        if memory.keys[i, 0] == key[HIGH] and memory.keys[i, 1] == key[LOW]:
            return i
    return -1


@inner
def keep_refuted(memory, key, left):
    """Keep that so many traversals are not enough."""
    values = memory.values[_entry(memory, key)]
    values[WORTH] = left
    values[LEAST] = max(int64(values[LEAST]), left + 1)


@inner
def keep_enough(memory, key, left, motion, degree):
    """Keep that so many traversals are enough with this motion, of a state of this degree."""
    values = memory.values[_entry(memory, key)]
    values[WORTH] = left
    if left < values[ENOUGH]:
        values[ENOUGH] = left
        values[MOTION] = (degree - motion) % degree if key[MIRRORED] else motion


@inner
def _entry(memory, key):
    """The entry of a key; if there is none, that of the fewest traversals left is replaced."""
    i = found(memory, key)
    if i >= 0:
        return i
    mask = uint64(len(memory.keys) - 1)
    i, least = int64(0), int64(FAR + 1)
    for j in range(BUCKET):
        other = int64((key[HIGH] & mask) ^ uint64(j))
        if memory.values[other, WORTH] < least:
            i, least = other, int64(memory.values[other, WORTH])
    memory.keys[i, 0], memory.keys[i, 1] = key[HIGH], key[LOW]
    memory.values[i, LEAST], memory.values[i, ENOUGH] = 0, FAR
    return i
