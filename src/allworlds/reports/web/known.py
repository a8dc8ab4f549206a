"""Pictures that grow: unknown parts are faint, and open darts are dashed."""

from __future__ import annotations

from xml.etree import ElementTree as ET

from allworlds.maps import CombinatorialMap
from allworlds.reports.markup import tag
from allworlds.reports.telling import ShownMap

NEVER = 10**9
"""Stands for the step at which something is known that never is."""


def let_grow(drawn: ET.Element, map_: CombinatorialMap, seen: ShownMap, *, tested: bool) -> None:
    """Add to a figure the step at which each part appears, and a legend of the styles."""
    for part in drawn.iter():
        if (darts := part.get("data-darts")) is not None:
            part.set("data-since", str(seen.edges.get(int(darts.split()[0]), NEVER)))
        elif (vertex := part.get("data-vertex")) is not None:
            first = map_.vertices[int(vertex)][0]
            part.set("data-since", str(seen.darts.get(first, NEVER)))
        elif (stub := part.get("data-stub")) is not None:
            explored = seen.edges.get(int(stub))
            part.set("class", "stub open" if explored is None else "stub open gone")
            part.set("data-since", str(seen.darts.get(int(stub), NEVER)))
            part.set("data-until", str(NEVER if explored is None else explored))
    legend = drawn[-1]
    legend.append(tag("span", "open: not explored yet", class_="key known-key"))
    if tested:
        legend.append(
            tag("span", "under test: did the robot arrive by this dart?", class_="key tested-key")
        )
        legend.append(tag("span", "the robot's place if it did", class_="key supposed-key"))
