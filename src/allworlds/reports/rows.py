"""Rows for programs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, TypeAlias

from msgspec import Struct

from allworlds.engines import By
from allworlds.protocol import Action, Percept
from allworlds.reports.telling import ToldWalk
from allworlds.studies.compare import InWorld
from allworlds.world import code_of

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


NAMES = {"code": str, "family": str, "holes": str, "seed": int, "edges": int, "vertices": int}
RUN = {**NAMES, "explorer": str, "place": int, "cost": int, "bound": int, "finished": bool}
WORLD = {**NAMES, "drawn_from": int, "explorer": str, "runs": int, "places": int}
COSTS = {"mean": float, "worst": int, "bound": int, "ratio": float, "finished": bool}


def _names(one: InWorld) -> list[Value]:
    """The words by which ``run`` finds the world, and its size."""
    family, _, seed = one.member.partition(" --seed ")
    family, _, holes = family.partition(" --holes ")
    words = [family or None, holes or None, int(seed) if seed else None]
    return [code_of(one.map), *words, one.map.edge_count, one.map.vertex_count]


def rows_of_worlds(worlds: Iterable[InWorld], first: str, by: By) -> CsvRows:
    """A row for each world and explorer, or for each run.

    Where the job ended early, rows of a size that was begun are not ``finished``.

    Args:
        worlds: in the order of the rows.
        first: the explorer with which the others are compared.
        by: which rows.
    """
    if by == "run":
        runs = [
            [*_names(one), one.explorer, place, cost, one.bound, one.finished]
            for one in worlds
            for place, cost in one.costs.items()
        ]
        return CsvRows(RUN, runs)
    every = [*worlds]
    beside = {(one.map, one.member): one.mean for one in every if one.explorer == first}
    rows = [
        [
            *(*_names(one), one.drawn_from, one.explorer, len(one.costs), one.places),
            *(round(one.mean, 6), max(one.costs.values()), one.bound),
            *(_ratio(one.mean, beside.get((one.map, one.member))), one.finished),
        ]
        for one in every
    ]
    return CsvRows({**WORLD, **COSTS}, rows)


def _ratio(cost: float, first: float | None) -> float | None:
    """The cost divided by that of the first explorer in the same world, if there is one."""
    return round(cost / first, 6) if first else None
