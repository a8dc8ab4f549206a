"""Rows for programs: costs of explorers in single worlds, or in single runs."""

from __future__ import annotations

from collections.abc import Iterable

from allworlds.engines.swept_report import By
from allworlds.reports.rows import CsvRows, Value
from allworlds.studies.compare.entrants import InWorld
from allworlds.world.named import code_of

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
