"""Completeness of a check: every world that exists was visited, and certain events occurred."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

from allworlds.document import Document, Edges, Natural, Text, Vertices, about
from allworlds.engines import Tally
from allworlds.explorers import Subject
from allworlds.judging import Task
from allworlds.maps import Extent, named_map, source_of


class GateCell(Document):
    """One comparison of the count gate."""

    edges: Edges
    vertices: Vertices
    enumerated: Annotated[Natural, about("rooted maps that were visited")]
    counted: Annotated[Natural, about("those that there are")]
    source: Annotated[Text, about("says who")]

    @property
    def agrees(self) -> bool:
        """Whether the enumeration and the source give the same count."""
        return self.counted == self.enumerated


def count_gate(extent: Extent, edges: int, tally: Tally) -> list[GateCell]:
    """Counts of the enumerated maps of a level, beside those of an independent source.

    There are none under a condition that has no source.
    """
    source = source_of(extent)
    if source is None:
        return []
    counted = source.cells(edges)
    cells: list[GateCell] = []
    for vertices in range(1, extent.vertex_limit(edges) + 1):
        row = tally.rows.get((edges, vertices))
        enumerated = row.worlds if row else 0
        known = counted.get(vertices, 0)
        if enumerated or known:
            cells.append(
                GateCell(
                    edges=edges,
                    vertices=vertices,
                    enumerated=enumerated,
                    counted=known,
                    source=source.name,
                )
            )
    return cells


SMALLEST = {"loop-edge": "loop", "parallel-edge": "dipole-2"}
"""For each event that needs no explorer the smallest map in which it occurs."""


def missing_witnesses(
    extent: Extent, subject: Subject, task: Task, seen: Mapping[str, int]
) -> tuple[str, ...]:
    """The events that a check of the whole extent must have seen and has not.

    Those of the explorer itself are about maps: with another task a run may be over before, and
    under a condition they may not occur.
    """
    simple, last = extent.map_class.simple, extent.levels[-1]
    required = {event for event, least in SMALLEST.items() if extent.include(named_map(least))}
    for event, least in subject.witnesses.items() if task.is_map and extent.where is None else ():
        match least[simple]:
            case (edges, vertices) if edges <= last and vertices <= extent.vertex_limit(last):
                required.add(event)
    return tuple(sorted(event for event in required if not seen.get(event)))
