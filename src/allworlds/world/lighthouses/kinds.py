"""**The** table of the lighthouses, and how one is read from a name or from JSON."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

from allworlds.inputs import SCOPE, Option, Request, Taken, a_text, one_of, show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.world.lighthouses.base import (
    InvalidWorld,
    Lighthouse,
    WalkInAnswer,
    refuse_other_keys,
)
from allworlds.world.lighthouses.cluster import Cluster
from allworlds.world.lighthouses.compass import Compass
from allworlds.world.lighthouses.directional import Directional
from allworlds.world.lighthouses.labels import Labels
from allworlds.world.lighthouses.movable import Movable
from allworlds.world.lighthouses.natural import Natural
from allworlds.world.lighthouses.nothing import Nothing
from allworlds.world.lighthouses.position import Position
from allworlds.world.lighthouses.sensing import Sensing, Where

LIGHTHOUSES: dict[str, type[Lighthouse]] = {
    kind.kind: kind
    for kind in (Nothing, Position, Directional, Compass, Cluster, Natural, Movable, Labels)
}
"""Every kind of lighthouse by its name."""


def lighthouse_named(text: str) -> type[Lighthouse]:
    """The kind of lighthouse of ``KIND[:key=value,...]``.

    Raises:
        InvalidWorld: naming the legal kinds, or the option that the kind does not have.
    """
    kind, colon, rest = text.partition(":")
    if kind not in LIGHTHOUSES:
        raise InvalidWorld(
            f"lighthouse {show(kind)} is not one of {', '.join(sorted(LIGHTHOUSES))}"
        )
    return LIGHTHOUSES[kind].with_options(_options(text, rest)) if colon else LIGHTHOUSES[kind]


def _options(text: str, rest: str) -> dict[str, str]:
    """The options of ``key=value,...``."""
    options: dict[str, str] = {}
    for part in rest.split(","):
        key, equals, value = part.partition("=")
        if not equals:
            raise InvalidWorld(
                f"{show(part)} in lighthouse {show(text)} is not of the form key=value"
            )
        if key in options:
            raise InvalidWorld(f"lighthouse {show(text)} names {show(key)} twice")
        options[key] = value
    return options


def lighthouse_from_json(
    document: object, map_: CombinatorialMap, start: Dart, missing: str = Directional.kind
) -> Lighthouse:
    """The lighthouse of a world's JSON; where there is none, one of the kind ``missing``."""
    if document is None:
        document = {"kind": missing}
    if not isinstance(document, Mapping) or not isinstance(document.get("kind"), str):
        raise InvalidWorld(f"a lighthouse is an object with a 'kind', not {show(document)}")
    kind = lighthouse_named(document["kind"])
    refuse_other_keys(f"{kind.kind} lighthouse", document, ("kind", *kind.keys))
    return kind.from_json(document, map_, start)


def _lighthouse(given: object) -> str | None:
    if given is None:
        return None
    text = a_text("lighthouse", given)
    lighthouse_named(text)
    return text


class AskedLighthouse(Request):
    """Under which lighthouse explorers are run."""

    lighthouse: Annotated[
        Taken[str | None, str | None],
        Option(
            SCOPE,
            "KIND",
            f"KIND[:key=value,...]: {one_of(LIGHTHOUSES)} (default: directional, or the one "
            "that a built-in explorer is written for).",
        ),
    ] = Taken(_lighthouse, None)


__all__ = [
    "LIGHTHOUSES",
    "AskedLighthouse",
    "Cluster",
    "Compass",
    "Directional",
    "InvalidWorld",
    "Labels",
    "Lighthouse",
    "Movable",
    "Natural",
    "Nothing",
    "Position",
    "Sensing",
    "WalkInAnswer",
    "Where",
    "lighthouse_from_json",
    "lighthouse_named",
    "refuse_other_keys",
]
