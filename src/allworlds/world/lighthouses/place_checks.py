"""Checks of the places of lighthouses that documents name, and the error of invalid worlds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from allworlds.inputs import InputError, integer, show
from allworlds.maps import CombinatorialMap, Dart


class InvalidWorld(InputError):
    """A map, a start and a lighthouse that do not make a world."""


class Unsteady(InvalidWorld):
    """Raised for a lighthouse that senses something else when it is asked twice."""


def refuse_other_keys(what: str, document: Mapping[str, Any], legal: Sequence[str]) -> None:
    """Raise InvalidWorld unless all keys are legal: a misspelt one would have no effect."""
    for key in document:
        if key not in legal:
            raise InvalidWorld(f"{show(key)} is no key of a {what}; legal are {', '.join(legal)}")


def check_at_start(what: str, dart: object, map_: CombinatorialMap, start: Dart) -> None:
    """Raise InvalidWorld unless ``dart`` is a dart of the start's vertex."""
    try:
        found = integer(dart)
    except TypeError:
        raise InvalidWorld(f"lighthouse.dart = {show(dart)} is not an integer") from None
    at_start = map_.vertices[map_.vertex_of[start]]
    if found not in at_start:
        raise InvalidWorld(
            f"the lighthouse {what} dart {show(found)}, which is not at the start's vertex; "
            f"legal are {', '.join(map(str, at_start))}"
        )


def check_leads_away(dart: object, map_: CombinatorialMap, start: Dart) -> None:
    """Raise InvalidWorld unless ``dart`` leads from the start's vertex to another vertex."""
    check_at_start("looks along", dart, map_, start)
    v0 = map_.vertex_of[start]
    if map_.vertex_of[map_.alpha[integer(dart)]] == v0:
        legal = [d for d in map_.vertices[v0] if map_.vertex_of[map_.alpha[d]] != v0]
        raise InvalidWorld(
            f"lighthouse.dart = {show(dart)} leads back to the start's vertex, not to another one; "
            f"legal are {', '.join(map(str, legal)) or 'none'}"
        )


def the_darts(values: object) -> tuple[Dart, ...]:
    """The integers of a list; raise InvalidWorld if it is none."""
    if not isinstance(values, list | tuple):
        raise InvalidWorld(f"lighthouse.darts must be a list of darts, not {show(values)}")
    found = []
    for i, value in enumerate(values):
        try:
            found.append(integer(value))
        except TypeError:
            raise InvalidWorld(f"lighthouse.darts[{i}] = {show(value)} is not an integer") from None
    return tuple(found)


def check_one_of_each_vertex(darts: Sequence[Dart], map_: CombinatorialMap) -> None:
    """Raise InvalidWorld unless these are darts, one of each vertex."""
    for dart in darts:
        if dart not in map_.darts:
            raise InvalidWorld(
                f"lighthouse.darts names {show(dart)}, which is no dart; "
                f"darts are 0..{len(map_.sigma) - 1}"
            )
    chosen = [map_.vertex_of[dart] for dart in darts]
    for v, vertex in enumerate(map_.vertices):
        if chosen.count(v) != 1:
            raise InvalidWorld(
                f"lighthouse.darts = {show(list(darts))} has {chosen.count(v)} darts of the "
                f"vertex {show(list(vertex))}; it must have one of each vertex"
            )
