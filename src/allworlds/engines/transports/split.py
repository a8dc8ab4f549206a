"""A transport that does small levels at one place, all others at another."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack
from itertools import chain
from typing import Any, Self

from allworlds.engines.units.unit import PartialResult, Transport


class Split:
    """Two transports as one: the first unit of a level decides which one does the level.

    A level costs a scheduler some round trips before all workers are busy, and again at its end.
    A small one is done in less.

    Args:
        soon: whether units such as this one are faster done near.
        near: the transport of such units; a context as long as this one is.
        far: that of the others, likewise.
    """

    def __init__(
        self, soon: Callable[[Any], bool], near: Transport[Any], far: Transport[Any]
    ) -> None:
        self._soon, self._near, self._far = soon, near, far

    def __enter__(self) -> Self:
        with ExitStack() as stack:
            stack.enter_context(self._near)
            stack.enter_context(self._far)
            stack.pop_all()
        return self

    def __exit__(self, *error: object) -> None:
        try:
            self._far.__exit__(*error)
        finally:
            self._near.__exit__(*error)

    def map(self, engine: Any, units: Iterable[Any]) -> Iterator[PartialResult[Any, Any]]:
        """Yield the parts of all units of one level, as they come."""
        waiting = iter(units)
        for first in waiting:
            where = self._near if self._soon(first) else self._far
            yield from where.map(engine, chain((first,), waiting))
