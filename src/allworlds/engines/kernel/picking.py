"""The choices of a native explorer, as the policies answer them, or every schedule in turn."""

from __future__ import annotations

from functools import cache

from numba import int32, types

from allworlds.engines.kernel.calls import entry_of
from allworlds.engines.kernel.capabilities import MOST_OPTIONS, MOST_PICKS
from allworlds.engines.kernel.compiling import RECORD, callback, inlined
from allworlds.engines.kernel.names import LIFO, NEAREST
from allworlds.engines.kernel.records import ASKED


def pick(asked, of, options, cost):  # pragma: no cover  # compiled
    """Answer ``allworlds_pick``: by the script if every schedule is tried, else by the policy."""
    if options < 1 or of < 0 or of > 3:
        asked.wrong = 1
        return int32(0)
    if asked.every:
        return int32(_scripted(asked, options))
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


@inlined
def _scripted(asked, options):
    """The script's answer, or 0 behind its end; the choice is noted."""
    turn, taken = asked.turns, 0
    if turn == MOST_PICKS or options > MOST_OPTIONS:
        asked.wrong = 1
    else:
        if turn < asked.due and asked.script[turn] < options:
            taken = asked.script[turn]
        asked.picks[turn], asked.widths[turn] = taken, options
        asked.turns = turn + 1
    return taken


@cache
def pick_address() -> int:
    """The address of the compiled answers."""
    return callback(pick, types.int32(RECORD(ASKED), types.int32, types.int32, types.int64))
