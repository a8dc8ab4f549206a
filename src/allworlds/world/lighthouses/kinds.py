"""**The** table of the lighthouses, and the reading of a lighthouse from a name or from JSON."""

import re
from collections.abc import Mapping
from functools import cache
from typing import Any, TypeAlias

from msgspec import Struct
from msgspec.structs import replace

from allworlds.inputs.checks import InputError, a_text, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import user_code
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.composed import (
    PLUS,
    Composed,
    Doormarks,
    Knowledge,
    Movable,
    Nothing,
    Whiteboard,
    composed,
)
from allworlds.world.lighthouses.marked import (
    Cluster,
    Compass,
    Directional,
    Door,
    Labels,
    Natural,
    Position,
    Word,
)
from allworlds.world.lighthouses.options import (
    InvalidWorld,
    ensure_options,
    kind_with,
    named_with,
    options_in,
    options_of,
    place_keys,
    refuse_other_keys,
    with_arguments,
)
from allworlds.world.lighthouses.own_kind import own_kind

LIGHTHOUSES: dict[str, type[Lighthouse]] = {
    kind.kind: kind
    for kind in (
        *(Nothing, Position, Directional, Door, Word, Compass, Cluster, Natural, Movable, Labels),
        *(Whiteboard, Doormarks, Knowledge),
    )
}
"""The kinds of lighthouses that come with this program, by their names."""

OWN = "path/to/file.py:Class or module:Class"
"""The form of the name of a user's lighthouse."""


class LighthouseKind(Struct, frozen=True):
    """A kind of lighthouse, by its name; in this form it can be sent to other processes.

    Attributes:
        name: ``KIND[:key=value,...]``, or several of these with ``+`` between them.
        codes: the user's programs that the kind needs, in the order in which ``name`` names them.
    """

    name: str
    codes: tuple[user_code.UserCode, ...] = ()

    @property
    def as_class(self) -> type[Lighthouse]:
        """The class of the kind; a user's class is loaded once in a process."""
        return _type_of(self)

    def __str__(self) -> str:
        return self.name


GivenLighthouse: TypeAlias = str | type[Lighthouse] | LighthouseKind
"""The ways in which users give a kind of lighthouse."""


def lighthouse_kind(given: object) -> LighthouseKind:
    """The kind of lighthouse that a name or a class means.

    Raises:
        InvalidWorld: naming the legal kinds, or the option that the kind does not have.
    """
    if isinstance(given, LighthouseKind):
        return given
    if isinstance(given, type) and issubclass(given, Lighthouse):
        parts: list[str | user_code.UserCode] = [_of_class(given)]
    else:
        parts = [_part(part) for part in a_text("lighthouse", given).split(PLUS)]
    found = LighthouseKind(
        PLUS.join(part if isinstance(part, str) else part.name for part in parts),
        tuple(part for part in parts if isinstance(part, user_code.UserCode)),
    )
    found.as_class  # noqa: B018  # it is refused here, and not where it is used
    return found


def kind_of(lighthouse: Lighthouse) -> LighthouseKind:
    """The kind of a lighthouse that stands at a place, with its options."""
    codes = [
        replace(part.code, name=part.written)
        for part in parts_of(lighthouse)
        if part.code is not None
    ]
    return LighthouseKind(lighthouse.written, tuple(codes))


def parts_of(lighthouse: Lighthouse) -> tuple[Lighthouse, ...]:
    """The parts of a composed lighthouse; any other lighthouse is its own only part."""
    return lighthouse.parts if isinstance(lighthouse, Composed) else (lighthouse,)


def numbers_told(kind: LighthouseKind) -> tuple[str, ...]:
    """The names of the numbers that the built-in parts of a kind tell a robot.

    These names are known before any world is made.
    """
    parts = kind.as_class.kinds if issubclass(kind.as_class, Composed) else (kind.as_class,)
    return tuple(name for part in parts if issubclass(part, Knowledge) for name in part.names)


def _part(text: str) -> str | user_code.UserCode:
    """The part of a kind that a text names: the text for a built-in part, else a user's program."""
    if text.partition(":")[0] in LIGHTHOUSES:
        return text
    parts = re.fullmatch(r"([^?]+):([^:?=]+=[^?]*)", text)
    return _found(f"{parts[1]}?{parts[2]}" if parts else text)


RENAMED = (
    "lighthouse 'ports' is now called 'doormarks' (numbers that the robot writes on darts); for "
    "port numbers, by which it tells the darts of a vertex apart, take 'compass'"
)


def _found(name: str) -> user_code.UserCode:
    if re.match(r"ports\b(?!\.)", name):
        raise InvalidWorld(RENAMED)
    try:
        return LIGHTHOUSE.find(name)
    except InputError as error:
        raise InvalidWorld(str(error)) from None


LIGHTHOUSE = user_code.Role("lighthouse", "allworlds.lighthouses", known=tuple(LIGHTHOUSES))


def _of_class(kind: type[Lighthouse]) -> str | user_code.UserCode:
    ours = kind.__module__.startswith("allworlds.")
    if {"code", "chosen"} & {*vars(kind)} or ours:
        name = named_with(kind, kind.chosen)
        return name if kind.code is None else replace(kind.code, name=name)
    return LIGHTHOUSE.of(kind)


@cache
def _type_of(kind: LighthouseKind) -> type[Lighthouse]:
    codes = iter(kind.codes)
    names = tuple(kind.name.split(PLUS))
    types = []
    for name in names:
        plain, colon, rest = name.partition(":")
        if plain not in LIGHTHOUSES:
            types.append(own_kind(next(codes)))
        elif colon:
            own = LIGHTHOUSES[plain]
            types.append(kind_with(own, options_in(own, plain, rest)))
        else:
            types.append(LIGHTHOUSES[plain])
    return types[0] if len(types) == 1 else composed(names, tuple(types))


def lighthouse_from_json(
    document: object,
    map_: CombinatorialMap,
    start: Dart,
    missing: GivenLighthouse = Directional.kind,
) -> Lighthouse:
    """The lighthouse that the JSON of a world describes.

    Args:
        document: the JSON object of the lighthouse; None if the JSON of the world has none.
        map_: the map of the world.
        start: the start of the world.
        missing: the kind of the lighthouse if ``document`` is None; the result is then a lighthouse
            of this kind at its default place.

    Raises:
        InvalidWorld: naming the offending value and what would be legal.
    """
    if document is None:
        return lighthouse_kind(missing).as_class.usual(map_, start)
    if not isinstance(document, Mapping) or not isinstance(document.get("kind"), str):
        raise InvalidWorld(f"a lighthouse is an object with a 'kind', not {show(document)}")
    name = document["kind"]
    if "parts" in document:
        refuse_other_keys(f"{name} lighthouse", document, ("kind", "parts"))
        return _of_parts(name, document["parts"], map_, start)
    if name in LIGHTHOUSES:
        kind, apart = LIGHTHOUSES[name], ["kind"]
        given = {key: document[key] for key in options_of(kind) if key in document}
    else:
        kind, apart = _own_of(document), ["kind", "options", "digest"]
        made = kind.code is not None and kind.code.arguments  # by a factory, which has taken them
        given = {} if made else document.get("options", {})
    refuse_other_keys(f"{name} lighthouse", document, (*apart, *place_keys(kind)))
    chosen = kind_with(kind, ensure_options(kind, name, given))
    where = {key: document[key] for key in place_keys(kind) if key in document.keys() - given}
    placed: Lighthouse = chosen.at(**where) if where else chosen.usual(map_, start)
    return placed


def _of_parts(name: str, parts: object, map_: CombinatorialMap, start: Dart) -> Composed:
    if not isinstance(parts, list) or len(parts) < 2:
        raise InvalidWorld(f"lighthouse.parts = {show(parts)} is no list of two lighthouses")
    for part in parts:
        if not isinstance(part, Mapping) or PLUS in str(part.get("kind")):
            raise InvalidWorld(f"lighthouse.parts holds {show(part)}, which is no lighthouse")
    found = Composed(tuple(lighthouse_from_json(part, map_, start) for part in parts))
    if found.kind != name:
        raise InvalidWorld(f"lighthouse.kind = {show(name)}, but its parts are {found.kind}")
    return found


def _own_of(document: Mapping[str, Any]) -> type[Lighthouse]:
    """The class of a user's lighthouse that the JSON of a world names.

    The document may name a factory instead: a function that makes a class from options.  The
    factory is called with the options in the document.  If the document names a class, the class is
    returned without these options; the caller, :func:`lighthouse_from_json`, applies the options.

    Raises:
        InputError: if the class is missing, or the digest of its program differs from the digest
            in the document.
    """
    name, given = document["kind"], document.get("options", {})
    if not isinstance(given, Mapping):
        raise InvalidWorld(f"lighthouse.options = {show(given)} is no object")
    if name.partition(":")[0] in LIGHTHOUSES or re.search(r"[+?=]", name):
        raise InvalidWorld(
            f"lighthouse.kind = {show(name)} is more than a name; its options are keys beside it, "
            "or those of the key options if it is your own; several lighthouses are the key parts"
        )
    code = _found(name)
    code.ensure_recorded(document.get("digest"))
    if given and not isinstance(code.load(), type):
        code = replace(code, name=with_arguments(name, given))
    return own_kind(code)
