"""The loop over units: done by an engine, brought by a transport, added up."""

from __future__ import annotations

from collections.abc import Iterable

from allworlds.progress import Listener
from allworlds.work.work import E_contra, Sum, Transport, Unit


def gather(
    transport: Transport[E_contra],
    engine: E_contra,
    units: Iterable[Unit],
    total: Sum,
    listener: Listener,
) -> None:
    """Add the results of all units to ``total``; the listener is told of each part.

    Raises:
        TimeIsUp: when the time limit has been reached; ``total`` holds what was done till then.
    """
    for part in transport.map(engine, units):
        total.add(part.result)
        listener.progress(part.result.worlds)
