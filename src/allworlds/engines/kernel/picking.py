"""The choices of a native explorer, as the policies answer them."""

from __future__ import annotations

from functools import cache

from numba import int32, types

from allworlds.engines.kernel.calls import entry_of
from allworlds.engines.kernel.compiling import RECORD, callback
from allworlds.engines.kernel.names import LIFO, NEAREST
from allworlds.engines.kernel.records import ASKED


def pick(asked, of, options, cost):  # pragma: no cover  # compiled
    """Answer ``allworlds_pick`` by the policy."""
    if options < 1 or of < 0 or of > 3:
        asked.wrong = 1
        return int32(0)
    if of != 0:
        return int32(0)
    if asked.policy == LIFO:
        return int32(options - 1)
    taken = 0
    if asked.policy == NEAREST and cost:
        for i in range(1, options):
            if entry_of(cost, i) < entry_of(cost, taken):
                taken = i
    return int32(taken)


@cache
def pick_address() -> int:
    """The address of the compiled answers."""
    return callback(pick, types.int32(RECORD(ASKED), types.int32, types.int32, types.int64))
