"""Who plays: an explorer behind its C interface, or a log that is read again.

The episode asks both in the same way; which of them answers is known when it is compiled.
"""

from __future__ import annotations

from typing import Any

from numba import int32, types
from numba.extending import overload

from allworlds.kernel.calls import call_answer, call_start, call_step
from allworlds.kernel.compiling import RECORD
from allworlds.kernel.logs import begin_reading, go_on_reading, show
from allworlds.kernel.records import READER


def set_out(explorer: Any, told: int) -> None:
    """A new episode: ``explorer.percept`` is sensed, ``explorer.action`` comes to be the first."""
    raise NotImplementedError


def go_on(explorer: Any) -> None:
    """The same after the last action."""
    raise NotImplementedError


def publish(explorer: Any, published: Any) -> None:
    """The answer, or the S of a checkpoint, comes to stand in ``published``."""
    raise NotImplementedError


@overload(set_out, inline="always")
def _set_out(explorer, told):
    def call(explorer, told):
        call_start(explorer.start, explorer.state, explorer.percept, int32(told), explorer.action)

    def read(explorer, told):
        begin_reading(explorer)

    return _either(explorer, call, read)


@overload(go_on, inline="always")
def _go_on(explorer):
    def call(explorer):
        call_step(explorer.step, explorer.state, explorer.percept, explorer.action)

    def read(explorer):
        go_on_reading(explorer)

    return _either(explorer, call, read)


@overload(publish, inline="always")
def _publish(explorer, published):
    def call(explorer, published):
        call_answer(explorer.answer, explorer.state, published)

    def read(explorer, published):
        show(explorer, published)

    return _either(explorer, call, read)


def _either(explorer: types.Record, call: Any, read: Any) -> Any:
    """What such an explorer is asked by."""
    return read if explorer == RECORD(READER) else call
