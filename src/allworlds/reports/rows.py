"""Rows for programs: named columns of numbers and words, each of one type."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, TypeAlias

from msgspec import Struct

from allworlds.protocol.actions import Action, Percept
from allworlds.reports.telling import ToldWalk

Value: TypeAlias = int | float | str | bool | None
"""A value of a row; None where there is none."""


class CsvRows(Struct, frozen=True):
    """Rows for programs.

    Attributes:
        columns: the type of each column, ``int``, ``float``, ``str`` or ``bool``, by its name.
        rows: a value for each column.
    """

    columns: Mapping[str, type]
    rows: Sequence[Sequence[Value]]

    @classmethod
    def of(cls, results: Iterable[Any], **columns: type) -> CsvRows:
        """A row for each result, whose columns are attributes of these names."""
        return cls(columns, [[getattr(result, name) for name in columns] for result in results])

    @property
    def records(self) -> list[dict[str, Value]]:
        """The rows, each by the names of its columns."""
        return [dict(zip(self.columns, row, strict=True)) for row in self.rows]


_SENSED = {"degree": int, "marks": int, "bearing": int}
_STEPS = {"step": int, "action": str, "number": int, "vertex": int, "dart": int, **_SENSED}


def rows_of_walk(walk: ToldWalk) -> CsvRows:
    """A row for each step.

    The number is that of a motion, or what was written; vertex and dart are those of the world at
    which the robot has arrived. Where a walk is compared, columns ``other_...`` hold what is sensed
    elsewhere.
    """
    walked, elsewhere = walk.walked, walk.elsewhere
    columns = _STEPS
    others: Iterator[Percept | None] = iter(())
    if elsewhere:
        columns = {**columns, **{f"other_{name}": kind for name, kind in _SENSED.items()}}
        others = iter(elsewhere.percepts)
    rows = []
    for step, (action, dart, percept) in enumerate(
        zip([None, *walked.transcript.actions], walked.walked, walked.sensed, strict=True)
    ):
        row = [step, *_action(action), walked.map.vertex_of[dart], dart, *_sensed(percept)]
        rows.append([*row, *(_sensed(next(others, None)) if elsewhere else ())])
    return CsvRows(columns, rows)


def _action(action: Action | None) -> tuple[str, int | None]:
    """The word of an action, and its number if it has one."""
    word, _, number = str(action or "start").partition(" ")
    return word, int(number) if number else None


def _sensed(percept: Percept | None) -> tuple[int | None, ...]:
    if percept is None:
        return None, None, None
    return percept.degree, percept.marks, percept.bearing
