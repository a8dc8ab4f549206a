"""What a complete check must have met: every world that there is, and certain events."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from allworlds.engines import Tally
from allworlds.explorers import Subject
from allworlds.maps import Extent, named_map, source_for


@dataclass(frozen=True, slots=True)
class Cell:
    """One comparison of the count gate.

    Attributes:
        edges, vertices: the size.
        enumerated: the rooted maps that were visited.
        counted: those that there are according to ``source``.
    """

    edges: int
    vertices: int
    enumerated: int
    counted: int
    source: str

    @property
    def agrees(self) -> bool:
        """Nothing speaks against the enumeration."""
        return self.counted == self.enumerated


def count_gate(extent: Extent, edges: int, tally: Tally) -> list[Cell]:
    """What was enumerated on a level beside what an independent source counts."""
    source = source_for(extent.map_class)
    counted = source.cells(edges)
    cells = []
    for vertices in range(1, extent.vertex_limit(edges) + 1):
        row = tally.rows.get((edges, vertices))
        enumerated = row.worlds if row else 0
        known = counted.get(vertices, 0)
        if enumerated or known:
            cells.append(Cell(edges, vertices, enumerated, known, source.name))
    return cells


SMALLEST = {"loop-edge": "loop", "parallel-edge": "dipole-2"}
"""For each event that needs no explorer the smallest map in which it occurs."""


def missing_witnesses(extent: Extent, subject: Subject, seen: Mapping[str, int]) -> tuple[str, ...]:
    """The events that a check of the whole extent must have seen and has not."""
    simple, last = extent.map_class.simple, extent.levels[-1]
    required = {event for event, least in SMALLEST.items() if extent.include(named_map(least))}
    for event, least in subject.witnesses.items():
        match least[simple]:
            case (edges, vertices) if edges <= last and vertices <= extent.vertex_limit(last):
                required.add(event)
    return tuple(sorted(event for event in required if not seen.get(event)))
