"""The options of a lighthouse, and checks of its places."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import MISSING, fields
from functools import cache
from typing import Any, Literal, NamedTuple, TypeAlias, get_args, get_origin, get_type_hints

from msgspec import Meta

from allworlds.document.struct import ASIDE, IF_ANY, plain
from allworlds.inputs.checks import InputError, integer, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.importing import pairs_in


class InvalidWorld(InputError):
    """A map, a start and a lighthouse that do not make a world."""


def refuse_other_keys(what: str, document: Mapping[str, Any], legal: Sequence[str]) -> None:
    """Raise InvalidWorld unless all keys are legal: a misspelt one would have no effect."""
    for key in document:
        if key not in legal:
            raise InvalidWorld(f"{show(key)} is no key of a {what}; legal are {', '.join(legal)}")


def the_integer(what: str, value: object) -> int:
    """The value as an ``int``; raise InvalidWorld, naming it, if it is none."""
    try:
        return integer(value)
    except TypeError:
        raise InvalidWorld(f"{what} = {show(value)} is not an integer") from None


def check_at_start(what: str, dart: object, map_: CombinatorialMap, start: Dart) -> None:
    """Raise InvalidWorld unless ``dart`` is a dart of the start's vertex."""
    found = the_integer("lighthouse.dart", dart)
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
    return tuple(the_integer(f"lighthouse.darts[{i}]", value) for i, value in enumerate(values))


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


OptionValue: TypeAlias = int | bool | str | tuple[str, ...]

PLACE = ("dart", "darts", "parts")
"""The names of fields that say where a lighthouse stands, and are no options."""

LONGEST = 18
"""The digits of the largest integer that is read."""


class FieldOption(NamedTuple):
    """An option of a kind.

    Attributes:
        default: the value where none is given; its type is that of every value.
        least, most: of an integer; None: there is no such limit.
        legal: of a tuple, the words that it may hold, each once.
        told: whether a document holds it even if it is the default.
    """

    default: OptionValue
    least: int | None = None
    most: int | None = None
    legal: tuple[str, ...] = ()
    told: bool = True

    def of_text(self, what: str, text: str) -> OptionValue:
        """The value of a text, as ``key=value`` has it; ``what`` names it.

        Raises:
            InvalidWorld: naming the text and what would be legal.
        """
        value: object = text
        match self.default:
            case bool():
                value = {"true": True, "false": False}.get(text, text)
            case int():
                digits = text.removeprefix("-")
                known = digits.isascii() and digits.isdecimal() and len(digits) <= LONGEST
                value = int(text) if known else text
            case tuple():
                value = text.split(",")
        return self.checked(what, value)

    def checked(self, what: str, value: object) -> OptionValue:
        """The value itself, of the type of the default; ``what`` names it.

        Raises:
            InvalidWorld: naming the value and what would be legal.
        """
        match self.default:
            case bool():
                if type(value) is not bool:
                    raise InvalidWorld(f"{what} = {show(value)} is neither true nor false")
            case int():
                return self._integer(what, value)
            case str():
                if not isinstance(value, str):
                    raise InvalidWorld(f"{what} = {show(value)} is not a text")
            case _:
                return self._words(what, value)
        return value

    def _integer(self, what: str, value: object) -> int:
        number = the_integer(what, value)
        if self.least is not None and number < self.least:
            raise InvalidWorld(f"{what} = {show(number)} is less than {self.least}, the least one")
        if self.most is not None and number > self.most:
            raise InvalidWorld(f"{what} = {show(number)} is more than {self.most}")
        return number

    def _words(self, what: str, value: object) -> tuple[str, ...]:
        legal = f"legal are {', '.join(self.legal)}, each once"
        if not isinstance(value, list | tuple) or not value:
            raise InvalidWorld(f"{what} = {show(value)} is no list of words; {legal}")
        for word in value:
            if word not in self.legal or value.count(word) > 1:
                raise InvalidWorld(f"{what} names {show(word)}; {legal}")
        return tuple(value)


@cache
def options_of(kind: Any) -> dict[str, FieldOption]:
    """The options of a class of lighthouses, in the order of its fields.

    A class that a factory makes for its arguments has none besides.
    """
    if kind.code is not None and kind.code.arguments:
        return {}
    # The annotations of a class of the user's may be texts that mean nothing here.
    hints = get_type_hints(kind, include_extras=True) if kind.code is None else {}
    found = {told.name: _option(told, hints.get(told.name)) for told in fields(kind)}
    return {name: option for name, option in found.items() if option}


def _option(told: Any, hint: Any) -> FieldOption | None:
    notes = getattr(hint, "__metadata__", ())
    kinds = int, str, bool, tuple
    of_place = told.name in PLACE or ASIDE in notes
    if of_place or not told.init or type(told.default) not in kinds:
        return None
    limits = [note for note in notes if isinstance(note, Meta)]
    return FieldOption(
        told.default,
        next((note.ge for note in limits if note.ge is not None), None),  # type: ignore[arg-type]
        next((note.le for note in limits if note.le is not None), None),  # type: ignore[arg-type]
        _words_in(hint),
        IF_ANY not in notes,
    )


def _words_in(hint: Any) -> tuple[str, ...]:
    """The words of the ``Literal`` in a type."""
    if get_origin(hint) is Literal:
        return get_args(hint)
    return next((words for part in get_args(hint) if (words := _words_in(part))), ())


def kind_with(kind: Any, options: Mapping[str, OptionValue]) -> Any:
    """The kind with other values of some options, which are known to be legal; one class each.

    A place of it is one of ``kind`` itself, with these values in its fields.
    """
    of = options_of(kind)
    other = [
        (key, options[key]) for key in of if options.get(key, of[key].default) != of[key].default
    ]
    return _another_kind(kind, tuple(other)) if other else kind


@cache
def _another_kind(kind: Any, options: tuple[tuple[str, OptionValue], ...]) -> Any:
    given, names = dict(options), [told.name for told in fields(kind)]

    def place(_: object, *values: Any, **named: Any) -> Any:
        return kind(**{**given, **dict(zip(names, values, strict=False)), **named})

    told = {"__new__": place, "__doc__": kind.__doc__, "__module__": kind.__module__}
    return type(kind.__name__, (kind,), {**given, **told, "chosen": given})


def options_in(kind: Any, name: str, text: str) -> dict[str, OptionValue]:
    """The options of a kind in the text ``key=value,...`` behind its name.

    Raises:
        InvalidWorld: naming the option, or the value, that the kind does not have.
    """
    for key, option in options_of(kind).items():
        if type(option.default) is tuple:  # the words of the only one stand without its name
            return {key: option.of_text(f"the lighthouse {name}", text)}
    try:
        pairs = pairs_in(f"{name}:{text}", text)
    except InputError as error:
        raise InvalidWorld(str(error)) from None
    return {key: _legal(kind, name, key).of_text(f"option {key}", value) for key, value in pairs}


def ensure_options(kind: Any, name: str, given: Mapping[str, object]) -> dict[str, OptionValue]:
    """The options of a document, which are legal.

    Raises:
        InvalidWorld: naming the option, or the value, that the kind does not have.
    """
    return {
        key: _legal(kind, name, key).checked(f"lighthouse.{key}", value)
        for key, value in given.items()
    }


def _legal(kind: Any, name: str, key: str) -> FieldOption:
    of = options_of(kind)
    if key in of:
        return of[key]
    legal = f"legal: {', '.join(of)}" if of else "it has none"
    default = next((field.default for field in fields(kind) if field.name == key), MISSING)
    if key not in PLACE and default is not MISSING:
        legal = f"its field of that name is {show(default)}, no integer, text or boolean"
    raise InvalidWorld(f"the lighthouse {show(name)} has no option {show(key)}; {legal}")


def value_of(kind: Any, key: str) -> OptionValue:
    """The value of an option that the places of a kind have."""
    chosen: dict[str, OptionValue] = getattr(kind, "chosen", {})
    return chosen.get(key, options_of(kind)[key].default)


def values_in(place: Any) -> dict[str, OptionValue]:
    """The options of a place that have another value than the default."""
    kind: Any = type(place)
    of = options_of(kind)
    return {key: value for key in of if (value := getattr(place, key)) != of[key].default}


def ensure_legal(place: Any) -> None:
    """Raise InvalidWorld unless the options of a place are legal."""
    kind: Any = type(place)
    for key, option in options_of(kind).items():
        option.checked(f"lighthouse.{key}", getattr(place, key))


def name_of(kind: Any) -> str:
    """The name of a kind, with its options."""
    return named_with(kind, getattr(kind, "chosen", {}))


def named_with(kind: Any, options: Mapping[str, OptionValue]) -> str:
    """The name of a kind with these options."""
    if kind.code is None:
        return with_arguments(kind.kind, options, ":")
    return with_arguments(kind.code.name, options)


def with_arguments(name: str, arguments: Mapping[str, Any], mark: str = "?") -> str:
    """A name, a mark, and arguments; the words of a tuple stand without its key."""
    told = [
        ",".join(value)
        if isinstance(value, tuple)
        else f"{key}={str(value).lower() if isinstance(value, bool) else value}"
        for key, value in arguments.items()
    ]
    return f"{name}{mark}{','.join(told)}" if told else name


def written_as(place: Any) -> dict[str, Any]:
    """The document of a place: its kind, its options, and where it is.

    Of a class of the user's the options stand apart, with the content by which it is known.
    """
    kind: Any = type(place)
    of, code, where = options_of(kind), kind.code, place_keys(kind)
    told = {key: plain(getattr(place, key)) for key in where}
    if code is not None:
        options = code.arguments or values_in(place)
        return {"kind": code.plain, "options": options, "digest": code.digest, **told}
    usual = [key for key, option in of.items() if not option.told and told[key] == option.default]
    return {"kind": place.kind, **{key: each for key, each in told.items() if key not in usual}}


@cache
def place_keys(kind: Any) -> tuple[str, ...]:
    """The fields that stand in a document beside the kind: of the user's, all but the options."""
    if kind.code is not None:
        return tuple(told.name for told in fields(kind) if told.name not in options_of(kind))
    hints = get_type_hints(kind, include_extras=True)
    notes = {key: getattr(hint, "__metadata__", ()) for key, hint in hints.items()}
    return tuple(told.name for told in fields(kind) if ASIDE not in notes[told.name])
