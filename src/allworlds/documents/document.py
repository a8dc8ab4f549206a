"""Documents: the class of a result defines the keys of its JSON, their types and their meanings.

A result is a frozen :class:`Document`.  Its fields are the keys of its JSON object, in this order;
each field is annotated with its type and, by :func:`about`, with one line of meaning.  The same
class yields the JSON (:meth:`Document.to_json`), the strict reading (``reading.parse``), the JSON
Schemas and the reference of keys.

With ``@with_options(Request)`` a class also has a key for each option of a request that the help
shows under "What is checked" or "How it is judged"; the option defines the key's type and meaning.
A method with ``@computed`` defines a key whose value follows from the fields.  This key comes after
the fields; the type that the method returns is the key's type, and the first line of the method's
docstring is the key's meaning.

The annotation of a field with a value of type T has three other forms:

``key: T | UnsetType = UNSET``
    the key may be missing in the object;
``key: IfAny[T]``
    the key is missing if its value is None or empty;
``name: NotInDocument[T]``
    the field belongs to the result in Python only, and is no key.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, fields as fields_of_dataclass, replace as replace_in_dataclass
from enum import Enum
from functools import cache, cached_property
from os import PathLike
from types import NoneType, UnionType
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    Literal,
    NamedTuple,
    TypeAlias,
    TypeVar,
    Union,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

from msgspec import (
    NODEFAULT,
    UNSET,
    Meta,
    Struct,
    defstruct,
    field as key,
    to_builtins,
)
from msgspec.structs import fields, force_setattr, replace as replace_in_struct

from allworlds.inputs.checks import integer

if TYPE_CHECKING:
    from allworlds.inputs.requests import Field

T = TypeVar("T")

NOT_IN_DOCUMENT = Meta(extra={"aside": True})
NotInDocument: TypeAlias = Annotated[T, NOT_IN_DOCUMENT]
"""A field of the result in Python that the document leaves out."""

IF_ANY = Meta(extra={"if any": True})
IfAny: TypeAlias = Annotated[T, IF_ANY]
"""A key that is left out if its value is None or empty."""


class ReadBy(NamedTuple):
    """The type of a value, and the function that reads such a value from JSON."""

    type: Any
    read: Callable[[Any], Any]


def read_by(kind: Any, read: Callable[[Any], Any] | None = None) -> Meta:
    """The annotation for a field with a type that msgspec cannot read.

    Annotate such a field with ``Annotated[Any, read_by(kind, read)]``: for msgspec the type of the
    field is Any, and this program reads the value itself.

    Args:
        kind: the field's true type.
        read: the function from a parsed JSON value to a value of this type; None if the field is
            never read from JSON.
    """
    return Meta(extra={"kind": kind, "read": read and ReadBy(kind, read)})


if TYPE_CHECKING:
    FromJson: TypeAlias = Annotated[T, "read by its from_json"]
    """The type ``FromJson[T]`` of a field; ``T.from_json`` reads its value from JSON."""
else:

    class FromJson:
        """The type ``FromJson[T]`` of a field whose value has the class T.

        The function ``T.from_json`` reads the value from JSON; msgspec sees the type Any.
        """

        def __class_getitem__(cls, kind: Any) -> Any:
            return Annotated[Any, read_by(kind, kind.from_json)]


def about(meaning: str) -> Meta:
    """The annotation that gives a field its meaning, in one line."""
    return Meta(description=meaning)


def narrowed(**keywords: Any) -> Meta:
    """The annotation that narrows a field's type by keywords of JSON Schema."""
    return Meta(extra_json_schema=keywords)


def one_of(*values: object) -> Meta:
    """The annotation that narrows a field's type to these values, by a keyword of JSON Schema."""
    return narrowed(enum=[*values])


Natural = Annotated[int, Meta(ge=0)]
Positive = Annotated[int, Meta(ge=1)]
Seconds = Annotated[float, Meta(ge=0)]
Figure = Annotated[float, Meta(ge=0)]
Text = Annotated[str, Meta(min_length=1)]
ShardText = Annotated[str, Meta(pattern="^[0-9]+/[0-9]+$")]
Entries: TypeAlias = Annotated[Sequence[T], Meta(min_length=1)]
Permutation: TypeAlias = Annotated[tuple[Natural, ...], Meta(min_length=2)]
Pair: TypeAlias = Annotated[tuple[T, ...], Meta(min_length=2, max_length=2)]
Some: TypeAlias = Annotated[tuple[T, ...], Meta(min_length=1)]
Different: TypeAlias = Annotated[tuple[T, ...], narrowed(uniqueItems=True)]


AllRows = Annotated[
    bool, about("whether every row is there; false: stopped, or interrupted by the user")
]
Why = Annotated[
    IfAny[str | None],
    about("why rows are missing; left out: none is missing, or the user interrupted"),
]
Edges = Annotated[Positive, about("the number of edges")]
Vertices = Annotated[Positive, about("the number of vertices")]
Bounded = Annotated[Positive | None, about("at most so many; null: not bounded")]
WhichShard = Annotated[ShardText, about("`K/N`; `0/1` is the whole")]


__all__ = ["key"]
"""A name from msgspec that this module exports: the function ``field``, here named ``key``.

A field that is made by ``key(name=...)`` has another name in JSON than in Python.
"""

NOTHING = (None, "", ())

_AS_IT_IS = frozenset({int, str, bool, float, NoneType})


class computed(cached_property[T]):  # noqa: N801  # as cached_property
    """A key of a document whose value is computed by a method when the value is first needed.

    The value is then kept.  The key's type is the type that the method returns; the key's meaning
    is the first line of the method's docstring.  The key comes after the fields in the JSON object.
    """


def with_options(*parts: type[Any]) -> Callable[[type[T]], type[T]]:
    """Return a decorator that gives a class of documents a key for each option of the scope.

    An option belongs to the scope if results depend on the option, and if the help shows the option
    under "What is checked" or "How it is judged".  If the class itself defines a key of the same
    name, that key stays.

    Args:
        parts: the requests that have the options.
    """
    from allworlds.inputs.requests import in_scope  # which players do not need

    def made(kind: Any) -> Any:
        asked = [one for part in parts for one in in_scope(part)]
        keys = [
            (one.name, _type_of_key(one), key(default=_default_of_key(one), name=one.option))
            for one in asked
            if one.name not in kind.__struct_fields__
        ]
        about_class = {"__doc__": kind.__doc__, "__qualname__": kind.__qualname__}
        return defstruct(
            kind.__name__,
            keys,
            bases=(kind,),
            kw_only=True,
            module=kind.__module__,
            namespace=about_class,
        )

    return made


def _default_of_key(one: Field) -> Any:
    """The value that an option's key gets if the document that is read does not have this key.

    ``one`` is the request's field for this option.  The result is NODEFAULT if every document must
    have the key; a document without the key is then an error.
    """
    if IF_ANY in getattr(_type_of_key(one), "__metadata__", ()):
        return None
    return NODEFAULT if one.default is MISSING else one.default


def _type_of_key(one: Field) -> Any:
    """The type of the key that documents have for an option, annotated with the key's meaning.

    ``one`` is the request's field for this option.
    """
    from allworlds.inputs.requests import Option  # which players do not need

    assert isinstance(one.asked, Option)
    if one.asked.document_type is not None:
        return one.asked.document_type
    parts = get_args(one.held) if get_origin(one.held) in (Union, UnionType) else (one.held,)
    if all(part in _AS_IT_IS or get_origin(part) is Literal for part in parts):
        kind = one.held
    else:
        kind = Text | None if NoneType in parts else Text
    return Annotated[kind, about(one.asked.help.rstrip("."))]


# Type checkers see every field given by its name; subclasses take over that they are frozen.
@dataclass_transform(frozen_default=True, kw_only_default=True, field_specifiers=(key,))
class Document(Struct, frozen=True, dict=True, forbid_unknown_fields=True):
    """A result, or a part of a result, that is written as a JSON object."""

    def __post_init__(self) -> None:
        for name, kind in _read_by_itself(type(self)):
            given = getattr(self, name)
            if not isinstance(given, kind.type):
                force_setattr(self, name, kind.read(given))

    def to_json(self) -> dict[str, Any]:
        """The JSON object of this document, in plain dictionaries and lists."""
        values = ((key, getattr(self, key.attribute)) for key in keys_of(type(self)))
        return {
            key.name: plain(value)
            for key, value in values
            if value is not UNSET and not (key.if_any and value in NOTHING)
        }


class WrittenByFields:
    """The base of a dataclass or struct whose fields are the keys of its JSON object."""

    __slots__ = ()

    def to_json(self) -> dict[str, Any]:
        """The JSON object, with the fields as keys."""
        kind: Any = type(self)
        return {name: plain(getattr(self, name)) for name in names_of(kind)}


@cache
def names_of(kind: Any) -> tuple[str, ...]:
    """The names of the fields of a struct, or of a dataclass."""
    every = fields(kind) if issubclass(kind, Struct) else fields_of_dataclass(kind)
    return tuple(field.name for field in every)


@cache
def _read_by_itself(kind: type[Document]) -> tuple[tuple[str, ReadBy], ...]:
    hints = get_type_hints(kind, include_extras=True)
    notes = ((name, getattr(hints[name], "__metadata__", ())) for name in kind.__struct_fields__)
    return tuple(
        (name, note.extra["read"])
        for name, metadata in notes
        for note in metadata
        if isinstance(note, Meta) and note.extra and note.extra.get("read")
    )


class Key(NamedTuple):
    """A key of a document.

    Attributes:
        attribute: the name of the attribute that holds the value.
        name: the name of the key in the JSON object.
        type: the annotated type, with the meaning.
        if_any: whether the key is left out if the value is None or empty.
    """

    attribute: str
    name: str
    type: Any
    if_any: bool


NAMES = {"map_class": "class"}
"""For attributes whose keys have names that Python reserves: the names of these keys in JSON."""


def _meaning(key: computed[Any]) -> str:
    """The meaning of a computed key: the first line of its docstring."""
    line = (key.__doc__ or "").partition("\n")[0].rstrip(".").replace("``", "`")
    return line[:1].lower() + line[1:]


@cache
def keys_of(kind: type[Document]) -> tuple[Key, ...]:
    """The keys in the order of the document: the fields, then the computed keys."""
    hints = get_type_hints(kind, include_extras=True)
    notes = {name: getattr(hint, "__metadata__", ()) for name, hint in hints.items()}
    names = {field.name: field.encode_name for field in fields(kind)}
    found = [
        Key(name, names[name], hint, IF_ANY in notes[name])
        for name, hint in hints.items()
        if name in names and NOT_IN_DOCUMENT not in notes[name]
    ]
    known = {name: each for part in reversed(kind.__mro__) for name, each in vars(part).items()}
    for name, each in known.items():
        if isinstance(each, computed):
            returned = get_type_hints(each.func, include_extras=True)["return"]
            noted = getattr(returned, "__metadata__", ())
            if not any(isinstance(note, Meta) and note.description for note in noted):
                returned = Annotated[returned, about(_meaning(each))]
            found.append(Key(name, NAMES.get(name, name), returned, IF_ANY in noted))
    return tuple(found)


def plain(value: Any) -> Any:
    """The JSON value for a Python value.

    Enums, paths, mappings, sequences and integers are converted; a value of any other class must
    have a method ``to_json``.
    """
    if type(value) in _AS_IT_IS:  # nearly always
        return value
    match value:
        case Enum():
            return value.value
        case None | bool() | int() | float() | str():
            return value
        case PathLike():
            return str(value)
        case Mapping():
            return {str(plain(name)): plain(inner) for name, inner in value.items()}
        case tuple() | list():
            return [plain(inner) for inner in value]
        case _ if hasattr(value, "__index__"):  # as of numpy
            return integer(value)
        case _:
            return value.to_json()


def plain_at_once(value: object) -> Any:
    """The JSON value for a value that consists of JSON values, structs, dataclasses and tuples.

    Tuples stay tuples, which Python writes as lists of JSON. This function takes a fifth of the
    time of :func:`plain`.
    """
    return to_builtins(value)


def replace(value: T, **changes: Any) -> T:
    """A copy of a dataclass or a struct, such as a document, in which some fields are changed."""
    copied: Any = replace_in_struct if isinstance(value, Struct) else replace_in_dataclass
    found: T = copied(value, **changes)
    return found
