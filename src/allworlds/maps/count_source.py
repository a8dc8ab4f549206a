"""The independent source with which enumerated maps are compared: it shares no code with them."""

from __future__ import annotations

from allworlds.maps.classes import Extent
from allworlds.maps.conditions import NamedCondition
from allworlds.maps.counting.narrowed import source_under
from allworlds.maps.counting.sources import CountSource, source_for


def source_of(extent: Extent) -> CountSource | None:
    """The source of the numbers of the maps in an extent; None where a condition has none."""
    where = extent.where
    if where is None:
        return source_for(extent.map_class)
    if isinstance(where, NamedCondition):
        return source_under(extent.map_class, where.kind, where.number)
    return None


def source_name(extent: Extent) -> str:
    """The name of that source; empty where there is none."""
    source = source_of(extent)
    return source.name if source else ""
