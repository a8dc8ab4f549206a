"""**The** table of the lighthouses, and their reading from names and from JSON."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Annotated, Any, TypeAlias

from allworlds.document import Text, about
from allworlds.inputs import SCOPE, InputError, Option, Request, Taken, a_text, one_of, show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import UserCode, find_code
from allworlds.world.lighthouses.base import (
    InvalidWorld,
    Lighthouse,
    WalkInAnswer,
    refuse_other_keys,
)
from allworlds.world.lighthouses.cluster import Cluster
from allworlds.world.lighthouses.compass import Compass
from allworlds.world.lighthouses.composed import PLUS, Composed, composed, composed_from_json
from allworlds.world.lighthouses.directional import Directional
from allworlds.world.lighthouses.knowledge import Knowledge
from allworlds.world.lighthouses.labels import Labels
from allworlds.world.lighthouses.movable import Movable
from allworlds.world.lighthouses.natural import Natural
from allworlds.world.lighthouses.nothing import Nothing
from allworlds.world.lighthouses.own_kind import ENTRY_POINTS, own_kind
from allworlds.world.lighthouses.position import Position
from allworlds.world.lighthouses.sensing import Sensing, Where
from allworlds.world.lighthouses.written import Ports, Whiteboard

LIGHTHOUSES: dict[str, type[Lighthouse]] = {
    kind.kind: kind
    for kind in (
        *(Nothing, Position, Directional, Compass, Cluster, Natural, Movable, Labels),
        *(Whiteboard, Ports, Knowledge),
    )
}
"""Every kind of lighthouse that comes with this program, by its name."""

OWN = "path/to/file.py:Class or module:Class"
"""How a lighthouse of the user's own is named."""


@dataclass(frozen=True, slots=True)
class LighthouseKind:
    """A kind of lighthouse as requests and rules hold it, and as it gets to other processes.

    Attributes:
        name: ``KIND[:key=value,...]``, or several of these with ``+`` between them.
        codes: the user's code that it needs, in the order of the name.
    """

    name: str
    codes: tuple[UserCode, ...] = ()

    @property
    def as_class(self) -> type[Lighthouse]:
        """The kind as a class; one of the user's is loaded once in a process."""
        return _type_of(self)

    @property
    def files(self) -> tuple[Path, ...]:
        """The files of the user's that it needs."""
        return tuple(code.file(ENTRY_POINTS) for code in self.codes)

    def __str__(self) -> str:
        return self.name


GivenLighthouse: TypeAlias = str | type[Lighthouse] | LighthouseKind
"""The ways in which users give a kind of lighthouse."""


def lighthouse_kind(given: object) -> LighthouseKind:
    """The kind of a name, or of a class.

    Raises:
        InvalidWorld: naming the legal kinds, or the option that the kind does not have.
    """
    if isinstance(given, LighthouseKind):
        return given
    if isinstance(given, type) and issubclass(given, Lighthouse):
        given = _name_of_class(given)
    text = a_text("lighthouse", given)
    parts = [_part(part) for part in text.split(PLUS)]
    found = LighthouseKind(
        PLUS.join(part if isinstance(part, str) else part.name for part in parts),
        tuple(part for part in parts if isinstance(part, UserCode)),
    )
    found.as_class  # noqa: B018  # it is refused here, and not where it is used
    return found


def lighthouse_named(text: str) -> type[Lighthouse]:
    """The kind of lighthouse of ``KIND[:key=value,...]`` as a class.

    Raises:
        InvalidWorld: naming the legal kinds, or the option that the kind does not have.
    """
    return lighthouse_kind(text).as_class


def kind_of(lighthouse: Lighthouse) -> LighthouseKind:
    """The kind of a lighthouse that stands somewhere."""
    return LighthouseKind(lighthouse.written, tuple(_codes(lighthouse)))


def _codes(lighthouse: Lighthouse) -> list[UserCode]:
    parts = lighthouse.parts if isinstance(lighthouse, Composed) else (lighthouse,)
    return [part.code for part in parts if part.code is not None]


def _part(text: str) -> str | UserCode:
    """One part of a name: as it is for one of ours, else the code, with its text."""
    if text.partition(":")[0] in LIGHTHOUSES:
        return text
    options = re.fullmatch(r"([^?]+):([^:?=]+=[^?]*)", text)
    name = f"{options[1]}?{options[2]}" if options else text
    try:
        return find_code("lighthouse", name, ENTRY_POINTS, _KNOWN)
    except InputError as error:
        raise InvalidWorld(str(error)) from None


_KNOWN = tuple(LIGHTHOUSES)


def _name_of_class(kind: type[Lighthouse]) -> str:
    if own := vars(kind).get("code"):
        return str(own.name)
    if LIGHTHOUSES.get(getattr(kind, "kind", "")) is kind:
        return kind.kind
    if kind.__module__ == "__main__" or "<" in kind.__qualname__:
        raise InvalidWorld(
            f"the lighthouse {kind.__qualname__} lives in this process alone, and no other could "
            "load it; put it into a file of its own"
        )
    return f"{kind.__module__}:{kind.__qualname__}"


@cache
def _type_of(kind: LighthouseKind) -> type[Lighthouse]:
    codes = iter(kind.codes)
    names = tuple(kind.name.split(PLUS))
    types = tuple(
        own_kind(next(codes)) if name.partition(":")[0] not in LIGHTHOUSES else _built_in(name)
        for name in names
    )
    return types[0] if len(types) == 1 else composed(names, types)


def _built_in(name: str) -> type[Lighthouse]:
    kind, colon, rest = name.partition(":")
    if colon:
        return LIGHTHOUSES[kind].with_options(_options(name, rest, kind == Knowledge.kind))
    return LIGHTHOUSES[kind]


def _options(text: str, rest: str, alone: bool) -> dict[str, str]:
    """The options of ``key=value,...``; of the lighthouse told their names stand alone."""
    options: dict[str, str] = {}
    for part in rest.split(","):
        key, equals, value = part.partition("=")
        if not equals and not alone:
            raise InvalidWorld(
                f"{show(part)} in lighthouse {show(text)} is not of the form key=value"
            )
        if key in options:
            raise InvalidWorld(f"lighthouse {show(text)} names {show(key)} twice")
        options[key] = value
    return options


def lighthouse_from_json(
    document: object,
    map_: CombinatorialMap,
    start: Dart,
    missing: GivenLighthouse = Directional.kind,
) -> Lighthouse:
    """The lighthouse of a world's JSON; if there is none, one of the kind ``missing``."""
    if document is None:
        return lighthouse_kind(missing).as_class.from_json({}, map_, start)
    if not isinstance(document, Mapping) or not isinstance(document.get("kind"), str):
        raise InvalidWorld(f"a lighthouse is an object with a 'kind', not {show(document)}")
    name = document["kind"]
    if "parts" in document:
        refuse_other_keys(f"{name} lighthouse", document, ("kind", "parts"))
        parts = composed_from_json(
            document["parts"], lambda part: lighthouse_from_json(part, map_, start)
        )
        if parts.kind != name:
            raise InvalidWorld(f"lighthouse.kind = {show(name)}, but its parts are {parts.kind}")
        return parts
    if name in LIGHTHOUSES:
        kind = LIGHTHOUSES[name]
        refuse_other_keys(f"{name} lighthouse", document, ("kind", *kind.keys))
        return kind.from_json(document, map_, start)
    found = lighthouse_kind(name + _as_arguments(document.get("options", {})))
    kind = found.as_class
    at: tuple[str, ...] = ("kind",)
    if found.codes:
        at = ("kind", "options", "digest")
        _ensure_digest(found.codes, document.get("digest"))
    refuse_other_keys(f"{name} lighthouse", document, (*at, *kind.keys))
    return kind.from_json(document, map_, start)


def _as_arguments(options: Any) -> str:
    """The options of a document as they stand in a name."""
    if not isinstance(options, Mapping):
        raise InvalidWorld(f"lighthouse.options = {show(options)} is no object")
    told = [
        f"{key}={str(value).lower() if isinstance(value, bool) else value}"
        for key, value in options.items()
    ]
    return "?" + ",".join(told) if told else ""


def _ensure_digest(codes: tuple[UserCode, ...], digest: object) -> None:
    """Raise InvalidWorld if a document is of another text of the class than the one found."""
    for code in codes:
        if digest not in (None, code.digest):
            raise InvalidWorld(
                f"the lighthouse {show(code.name)} has another text now: its digest is "
                f"{code.digest[:12]}..., and {show(digest)} is recorded"
            )


def _lighthouse(given: object) -> LighthouseKind | None:
    return None if given is None else lighthouse_kind(given)


class AskedLighthouse(Request):
    """The part of a request that names the kind of lighthouse."""

    lighthouse: Annotated[
        Taken[GivenLighthouse | None, LighthouseKind | None],
        Option(
            SCOPE,
            "KIND",
            f"KIND[:key=value,...]: {one_of(LIGHTHOUSES)}, {OWN}, or several with + between them "
            "(default: directional, or the one that a built-in explorer is written for).",
            told=Annotated[Text, about("`KIND[:key=value,...]`")],
        ),
    ] = Taken(_lighthouse, None)


__all__ = [
    "LIGHTHOUSES",
    "OWN",
    "AskedLighthouse",
    "Cluster",
    "Compass",
    "Composed",
    "Directional",
    "GivenLighthouse",
    "InvalidWorld",
    "Knowledge",
    "Labels",
    "Lighthouse",
    "LighthouseKind",
    "Movable",
    "Natural",
    "Nothing",
    "Ports",
    "Position",
    "Sensing",
    "WalkInAnswer",
    "Where",
    "Whiteboard",
    "kind_of",
    "lighthouse_from_json",
    "lighthouse_kind",
    "lighthouse_named",
    "refuse_other_keys",
]
