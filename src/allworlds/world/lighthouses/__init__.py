"""Lighthouses: what is marked in a world, and what of it can be sensed.

A new lighthouse is a module with a subclass of :class:`Lighthouse`, and an entry of
``LIGHTHOUSES``.
"""

from __future__ import annotations

from collections.abc import Mapping

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.world.lighthouses.base import InvalidWorld, Lighthouse
from allworlds.world.lighthouses.compass import Compass
from allworlds.world.lighthouses.directional import Directional
from allworlds.world.lighthouses.nothing import Nothing
from allworlds.world.lighthouses.position import Position

LIGHTHOUSES: dict[str, type[Lighthouse]] = {
    kind.kind: kind for kind in (Nothing, Position, Directional, Compass)
}
"""Every kind of lighthouse by its name."""


def lighthouse_named(text: str) -> type[Lighthouse]:
    """The kind of lighthouse of ``KIND[:key=value,...]``.

    Raises:
        InvalidWorld: naming the legal kinds, or the option that the kind does not have.
    """
    kind, colon, options = text.partition(":")
    if kind not in LIGHTHOUSES:
        raise InvalidWorld(f"lighthouse {kind!r} is none of {', '.join(sorted(LIGHTHOUSES))}")
    if colon:
        raise InvalidWorld(f"the {kind} lighthouse takes no options, not {options!r}")
    return LIGHTHOUSES[kind]


def lighthouse_from_json(
    document: object, map_: CombinatorialMap, start: Dart, missing: str = Directional.kind
) -> Lighthouse:
    """The lighthouse of a world's JSON; where there is none, one of the kind ``missing``."""
    if document is None:
        document = {"kind": missing}
    if not isinstance(document, Mapping) or not isinstance(document.get("kind"), str):
        raise InvalidWorld(f"a lighthouse is an object with a 'kind', not {document!r}")
    kind = lighthouse_named(document["kind"])
    if "darts" in document and kind is not Compass:
        raise InvalidWorld(f"a {kind.kind} lighthouse stands at one 'dart', not at 'darts'")
    return kind.from_json(document, map_, start)


__all__ = [
    "LIGHTHOUSES",
    "Compass",
    "Directional",
    "InvalidWorld",
    "Lighthouse",
    "Nothing",
    "Position",
    "lighthouse_from_json",
    "lighthouse_named",
]
