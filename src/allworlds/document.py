"""A document, described once: the class of a result names its keys, their types and meanings.

A result is a frozen :class:`Document`: its fields are the keys of its JSON object, in their order,
each annotated with its type and, by :func:`about`, with one line of meaning.  From the same class
come the JSON (:meth:`Document.to_json`), the strict reading (:func:`taken`), the JSON Schemas and
the reference of keys.

The keys of a class may be those of a request's options (``class Scope(Document, of=Request)``),
whose types and meanings stand beside the options.

Three things are said beside a type:

``key: T = computed(function)``
    follows from the fields, and is made when it is asked for;
``key: T | UnsetType = UNSET``
    may be missing in the object;
``key: IfAny[T]``
    is missing while it is None or empty;
``name: Aside[T]``
    belongs to the result in Python, and is no key.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import MISSING, fields as fields_of_dataclass, replace as replace_in_dataclass
from enum import Enum
from functools import cache, cached_property
from pathlib import PurePath
from types import NoneType, UnionType
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    Final,
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
    StructMeta,
    UnsetType,
    ValidationError,
    convert,
    field as key,
    inspect,
    to_builtins,
)
from msgspec.structs import fields, force_setattr, replace as replace_in_struct

from allworlds.inputs import Field, InputError, Option, in_scope, show
from allworlds.lazy import loaded
from allworlds.outcome import Exit, Facts

__all__ = ["UNSET", "Meta", "UnsetType", "key", "replace"]

T = TypeVar("T")

SCHEMA: Final = 1
"""The version of every document that a verb writes, and of a corpus's manifest."""

ASIDE = Meta(extra={"aside": True})
Aside: TypeAlias = Annotated[T, ASIDE]
"""A field that is no key of the document."""

IF_ANY = Meta(extra={"if any": True})
IfAny: TypeAlias = Annotated[T, IF_ANY]
"""A key that is left out where its value is None or empty."""


NOTHING = (None, "", ())

_AS_IT_IS = frozenset({int, str, bool, float, NoneType})


class ReadBy(NamedTuple):
    """The type of a value, and how it is read from JSON."""

    type: Any
    read: Callable[[Any], Any]


def read_by(kind: Any, read: Callable[[Any], Any] | None = None) -> Meta:
    """Values of a type that msgspec does not read, in a field of the type Any.

    Args:
        kind: the type.
        read: makes a value of what a parser of JSON hands back; None where none is read.
    """
    return Meta(extra={"kind": kind, "read": read and ReadBy(kind, read)})


if TYPE_CHECKING:
    FromJson: TypeAlias = Annotated[T, "read by its from_json"]
    """A field of a class that reads its values by itself."""
else:

    class FromJson:
        """The annotation of such a field, which msgspec need not know."""

        def __class_getitem__(cls, kind: Any) -> Any:
            return Annotated[Any, read_by(kind, kind.from_json)]


def about(meaning: str) -> Meta:
    """A one-line meaning of a field."""
    return Meta(description=meaning)


def narrowed(**keywords: Any) -> Meta:
    """Keywords of JSON Schema that narrow a type which needs no words."""
    return Meta(extra_json_schema=keywords)


def one_of(*values: object) -> Meta:
    """One of these values of a wider type."""
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
ExitCode = Annotated[Exit, about("the exit code of the command")]
Bounded = Annotated[Positive | None, about("at most so many; null: not bounded")]
WhichShard = Annotated[ShardText, about("`K/N`; `0/1` is the whole")]
AnyShard = Annotated[ShardText | UnsetType, about("`K/N`; missing: the whole")]


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


class Pictured:
    """A value that notebooks show as a picture."""

    __slots__ = ()

    def _repr_svg_(self) -> str:
        """The picture that notebooks show."""
        svg: str = loaded("reports.drawing.standalone:draw")(self).svg
        return svg


class Paged:
    """A value that is printed as text, and that notebooks show as a page, or as a part of one."""

    __slots__ = ()

    def __str__(self) -> str:
        """The text of the command line, 100 columns wide."""
        told: str = loaded("reports.notebook:text_of")(self)
        return told

    def __init_subclass__(cls, **keywords: Any) -> None:
        super().__init_subclass__(**keywords)
        # IPython takes the first class in line that has this, or a repr as dataclasses have.
        cls._repr_pretty_ = Paged._repr_pretty_  # type: ignore[method-assign]

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:  # noqa: ARG002  # IPython's call
        """Print the text in a plain IPython."""
        printer.text(str(self))

    def _repr_html_(self) -> str:
        """The element that notebooks show."""
        shown: str = loaded("reports.notebook:shown")(self)
        return shown


class WrittenByFields:
    """A dataclass whose fields are the keys of its JSON object."""

    __slots__ = ()

    def to_json(self) -> dict[str, Any]:
        """The JSON object, with the fields as keys."""
        kind: Any = type(self)
        return {name: plain(getattr(self, name)) for name in _names_of(kind)}


@cache
def _names_of(kind: Any) -> tuple[str, ...]:
    return tuple(field.name for field in fields_of_dataclass(kind))


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
    """The JSON value of what holds nothing but JSON, dataclasses and tuples.

    Cost: a fifth of that of :func:`plain`; tuples stay tuples.
    """
    return to_builtins(value)


def replace(value: T, **changes: Any) -> T:
    """A copy of a struct, such as a document, or of a dataclass, with other values of fields."""
    copied: Any = replace_in_struct if isinstance(value, Struct) else replace_in_dataclass
    found: T = copied(value, **changes)
    return found


def taken(document: object, kind: type[T], what: str) -> T:
    """The value of that type that a JSON value stands for.

    Args:
        document: as a parser of JSON hands it back.
        kind: a type that msgspec knows.
        what: the words for the whole.

    Raises:
        InputError: naming the offending value, where it stands, and what would be legal.
    """
    try:
        return convert(document, kind)
    except ValidationError as error:
        if isinstance(error.__cause__, InputError):
            raise error.__cause__ from None
        said, path = _PLACED.fullmatch(str(error)).groups("")  # type: ignore[union-attr]
        steps = path.lstrip(".").replace("[", ".[").split(".") if path else []
        where = f"{path.lstrip('.')} = {show(_at(document, steps))}" if path else what
        if legal := _legal(kind, steps) if said.startswith("Invalid enum") else []:
            raise InputError(f"{where} is not one of {', '.join(map(str, legal))}") from None
        said = show(said[:1].lower() + said[1:].replace("`", ""))[1:-1]
        raise InputError(f"{where}: {said}") from None
    except UnicodeEncodeError:
        raise InputError(f"{what}: a key or a word in it is no text") from None


_PLACED = re.compile(r"(.*?)(?: - at `(?:key` in `)?\$([^`\n]*)`)?", re.DOTALL)
"""An error of msgspec: its words, and the path of the value."""


def _at(document: Any, steps: Iterable[str]) -> object:
    """The value to which steps such as ``rows`` and ``[0]`` lead, or the last one on the way."""
    for step in steps:
        if step == "[...]":
            return document
        try:
            document = document[int(step[1:-1])] if step[:1] == "[" else document[step]
        except (LookupError, TypeError, ValueError):
            return document
    return document


def _legal(kind: Any, steps: Iterable[str]) -> list[object]:
    """The values of an enumeration that stands where the steps lead."""
    kinds = _alternatives(inspect.type_info(kind))
    for step in steps:
        kinds = [part for one in kinds for part in _part(one, step)]
    legal: list[object] = []
    for one in kinds:
        if isinstance(one, inspect.LiteralType):
            legal += one.values
        elif isinstance(one, inspect.EnumType):
            legal += [each.value for each in one.cls]
    return legal


def _part(kind: inspect.Type, step: str) -> list[inspect.Type]:
    match kind:
        case inspect.StructType(fields=told):
            return [part for f in told if f.encode_name == step for part in _alternatives(f.type)]
        case inspect.DictType(value_type=part) | inspect.CollectionType(item_type=part):
            return _alternatives(part)
    return []


def _alternatives(kind: inspect.Type) -> list[inspect.Type]:
    match kind:
        case inspect.Metadata(type=one):
            return _alternatives(one)
        case inspect.UnionType(types=several):
            return [one for each in several for one in _alternatives(each)]
    return [kind]


# ---------------------------------------------------------------- what many documents hold


class Host(Document):
    """Host.

    A machine and its software.
    """

    name: Annotated[str, about("in its network")]
    system: Annotated[str, about("its operating system")]
    machine: Annotated[str, about("its architecture")]
    processor: Annotated[str, about("the model")]
    cores: Annotated[Positive | None, about("of all processors")]
    load: Annotated[Figure, about("processes that wanted a core, averaged over the last minute")]
    python: Annotated[Text, about("the version of Python")]
    numba: Annotated[Text | None, about("the version of the compiler; null: there is none")]


class MadeBy(Document):
    """Made by.

    Who made a document, where, when and how fast: nothing else in it depends on that.
    """

    version: Annotated[Text, about("of this program")]
    command: Annotated[tuple[str, ...], about("the words of the command line, as they were given")]
    workers: Annotated[Positive | None, about("processes or threads; null: the verb takes none")]
    host: Annotated[Host, about("the machine and its software")]
    started: Annotated[
        str,
        Meta(
            description="when the command began, in UTC",
            pattern="^[0-9-]{10}T[0-9:]{8}Z$",
        ),
    ]
    seconds: Annotated[Seconds, about("from the beginning until this document was written")]
    level_seconds: Annotated[
        tuple[Seconds, ...] | UnsetType, about("of `search`: for each of its `levels`")
    ] = UNSET
    claim_seconds: Annotated[
        tuple[Seconds, ...] | UnsetType, about("of `claims`: for each of them")
    ] = UNSET


class Report(Paged, Document):
    """A document that a verb writes."""

    schema: Annotated[Literal[1], about("the version of the document")] = SCHEMA
    made_by: Annotated[MadeBy | UnsetType, about("in Python; always there on the command line")] = (
        UNSET
    )

    @property
    def facts(self) -> Facts:
        """Facts that the exit code depends on.

        The default stands for a question that was answered.
        """
        return Facts()

    @property
    def exit_code(self) -> Exit:
        """One of the exit codes of the command."""
        return self.facts.exit

    @property
    def seconds_by_part(self) -> dict[str, list[float]]:
        """The seconds that its parts took, by their keys in ``made_by``; by default no part."""
        return {}

    def records(self) -> list[dict[str, Any]]:
        """The rows of ``--csv``, by the names of their columns: ``pandas.DataFrame`` takes them."""
        rows: list[dict[str, Any]] = loaded("reports.notebook:records")(self)
        return rows
