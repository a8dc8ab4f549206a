"""The loop over units: done by an engine, brought by a transport, kept, and added up."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from allworlds.engines.progress import Listener
from allworlds.engines.units.unit import NOTHING_KEPT, E_contra, KeptUnits, Sum, Transport, Unit


def gather(
    transport: Transport[E_contra],
    engine: E_contra,
    units: Iterable[Unit],
    total: Sum,
    listener: Listener,
    kept: KeptUnits = NOTHING_KEPT,
) -> None:
    """Add the results of all units to ``total``; the listener is told of each part.

    Kept units are not done again, and each unit is kept when it is whole.

    Raises:
        TimeIsUp: when the time limit has been reached; ``total`` holds the results till then.
    """

    def undone() -> Iterator[Unit]:
        for unit in units:
            result = kept.result(unit)
            if result is None:
                yield unit
            else:
                total.add(result)
                listener.progress(result.worlds)

    begun: dict[str, Sum] = {}
    for part in transport.map(engine, undone()):
        key, result = part.unit.key, part.result
        total.add(result)
        listener.progress(result.worlds)
        if key in begun:
            begun[key].add(result)
        else:
            begun[key] = result
        if part.last:
            whole = begun.pop(key)
            kept.keep(part.unit, whole)
