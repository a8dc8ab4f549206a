"""A document as a frozen struct: its keys, its JSON, and a copy with other values."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import MISSING, fields as fields_of_dataclass, replace as replace_in_dataclass
from enum import Enum
from functools import cache, cached_property
from pathlib import PurePath
from types import NoneType, UnionType
from typing import (
    Annotated,
    Any,
    Literal,
    NamedTuple,
    TypeVar,
    Union,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

from msgspec import NODEFAULT, UNSET, Meta, Struct, StructMeta, field as key, to_builtins
from msgspec.structs import fields, force_setattr, replace as replace_in_struct

from allworlds.document.key_types import ASIDE, IF_ANY, ReadBy, Text, about
from allworlds.inputs import Field, Option, in_scope

__all__ = ["key"]
"""Besides what is defined here: the field that takes another name in JSON."""

T = TypeVar("T")

NOTHING = (None, "", ())

_AS_IT_IS = frozenset({int, str, bool, float, NoneType})


class _Computed(cached_property[Any]):
    """A key that is no field: its value is made when it is asked for, once."""

    def __init__(self, function: Callable[[Any], Any], name: str | None) -> None:
        super().__init__(function)
        self.key = name


def computed(
    function: Callable[[Any], Any],
    *,
    name: str | None = None,
    init: Literal[False] = False,  # noqa: ARG001  # tells type checkers that none is given
) -> Any:
    """A key that follows from the fields; ``name`` where its key is not its attribute."""
    return _Computed(function, name)


EXIT_CODE: Any = computed(lambda report: report.facts.exit)
"""The key of a report that holds its exit code."""


class _Keywords(StructMeta):
    """A base whose fields are all given by their names, in subclasses too.

    A class ``of`` a request has a key for each of its options that a scope tells; a key that the
    class itself describes comes in its place.
    """

    def __new__(mcs, name: str, bases: Any, namespace: Any, of: Any = None, **options: Any) -> Any:
        own = namespace.get("__annotations__", {})
        parts = of if isinstance(of, tuple) else (of,) if of else ()
        asked = [one for part in parts for one in in_scope(part) if one.name not in own]
        namespace["__annotations__"] = {one.name: _told(one) for one in asked} | own
        for one in asked:
            if one.option != one.name or one.default is not MISSING:
                default = NODEFAULT if one.default is MISSING else one.default
                if IF_ANY in getattr(_told(one), "__metadata__", ()):
                    default = None
                namespace[one.name] = key(default=default, name=one.option)
        told = namespace["__annotations__"]
        late = {each for each, value in namespace.items() if isinstance(value, _Computed)}
        namespace["__annotations__"] = {each: told[each] for each in told if each not in late}
        made: Any = super().__new__(mcs, name, bases, namespace, kw_only=True, **options)
        made.__annotations__ = told  # of all keys, for keys_of
        return made


def _told(one: Field) -> Any:
    """The type and the meaning of the key for an option, in a document."""
    assert isinstance(one.asked, Option)
    if one.asked.told is not None:
        return one.asked.told
    parts = get_args(one.held) if get_origin(one.held) in (Union, UnionType) else (one.held,)
    if all(part in _AS_IT_IS or get_origin(part) is Literal for part in parts):
        kind = one.held
    else:
        kind = Text | None if NoneType in parts else Text
    return Annotated[kind, about(one.asked.help.rstrip("."))]


@dataclass_transform(frozen_default=True, kw_only_default=True, field_specifiers=(key, computed))
class Document(Struct, metaclass=_Keywords, frozen=True, dict=True, forbid_unknown_fields=True):
    """A JSON object that is written, or a part of one."""

    def __post_init__(self) -> None:
        for name, kind in _read_by_itself(type(self)):
            given = getattr(self, name)
            if not isinstance(given, kind.type):
                force_setattr(self, name, kind.read(given))

    def to_json(self) -> dict[str, Any]:
        """The JSON object of this document, in plain dictionaries and lists."""
        told = ((key, getattr(self, key.attribute)) for key in keys_of(type(self)))
        return {
            key.name: plain(value)
            for key, value in told
            if value is not UNSET and not (key.if_any and value in NOTHING)
        }


class WrittenByFields:
    """A dataclass whose fields are the keys of its JSON object."""

    __slots__ = ()

    def to_json(self) -> dict[str, Any]:
        """The JSON object, with the fields as keys."""
        kind: Any = type(self)
        return {name: plain(getattr(self, name)) for name in names_of(kind)}


@cache
def names_of(kind: Any) -> tuple[str, ...]:
    """The names of the fields of a struct, or of a dataclass."""
    told = fields(kind) if issubclass(kind, Struct) else fields_of_dataclass(kind)
    return tuple(field.name for field in told)


@cache
def _read_by_itself(kind: type[Document]) -> tuple[tuple[str, ReadBy], ...]:
    hints = get_type_hints(kind, include_extras=True)
    notes = ((name, getattr(hints[name], "__metadata__", ())) for name in kind.__struct_fields__)
    return tuple(
        (name, note.extra["read"])
        for name, told in notes
        for note in told
        if isinstance(note, Meta) and note.extra and note.extra.get("read")
    )


class Key(NamedTuple):
    """A key of a document: its attribute, its name, and whether it is left out while empty."""

    attribute: str
    name: str
    if_any: bool


@cache
def keys_of(kind: type[Document]) -> tuple[Key, ...]:
    """The keys, in the order of the document."""
    hints = get_type_hints(kind, include_extras=True)
    notes = {name: getattr(hint, "__metadata__", ()) for name, hint in hints.items()}
    names = {field.name: field.encode_name for field in fields(kind)}
    for name in hints.keys() - names:
        names[name] = getattr(kind, name).key or name
    return tuple(
        Key(name, names[name], IF_ANY in notes[name]) for name in hints if ASIDE not in notes[name]
    )


def plain(value: Any) -> Any:
    """A value as JSON holds it. Anything that is no JSON by itself is asked for ``to_json()``."""
    if type(value) in _AS_IT_IS:  # nearly always
        return value
    match value:
        case Enum():
            return value.value
        case None | bool() | int() | float() | str():
            return value
        case PurePath():
            return str(value)
        case Mapping():
            return {str(plain(name)): plain(inner) for name, inner in value.items()}
        case tuple() | list():
            return [plain(inner) for inner in value]
        case _:
            return value.to_json()


def plain_at_once(value: object) -> Any:
    """The JSON value of what holds nothing but JSON, structs, dataclasses and tuples.

    Cost: a fifth of that of :func:`plain`; tuples stay tuples.
    """
    return to_builtins(value)


def replace(value: T, **changes: Any) -> T:
    """A copy of a struct, such as a document, or of a dataclass, with other values of fields."""
    copied: Any = replace_in_struct if isinstance(value, Struct) else replace_in_dataclass
    found: T = copied(value, **changes)
    return found
