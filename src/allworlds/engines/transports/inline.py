"""Units one after the other, in this thread."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Self

from allworlds.engines.units.effort import check_deadline
from allworlds.engines.units.unit import PartialResult, R, U, UnitEngine


class ThisThread:
    """The transport in this thread; the engine's work here cannot be stopped from outside."""

    def __init__(self, deadline: float | None = None) -> None:
        self._deadline = deadline

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Leave the context; no work goes on."""

    def map(self, engine: UnitEngine[U, R], units: Iterable[U]) -> Iterator[PartialResult[U, R]]:
        """Yield the parts of all units, in their order."""
        for unit in units:
            for result, last in with_last(engine.parts(unit)):
                yield PartialResult(unit, result, last)
                check_deadline(self._deadline)


def with_last(items: Iterable[R]) -> Iterator[tuple[R, bool]]:
    """Each of at least one item with whether it is the last one."""
    iterator = iter(items)
    item = next(iterator)
    for following in iterator:
        yield item, False
        item = following
    yield item, True
