"""**The** table of the lighthouses, and their reading from names and from JSON.

A kind of the user's own is loaded, and its mistakes are told by its name.
"""

import copyreg
import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, dataclass, fields
from functools import cache, wraps
from typing import Any, TypeAlias

from msgspec import Struct, ValidationError, convert, to_builtins
from msgspec.structs import replace

from allworlds.inputs.checks import InputError, a_text, integer, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import actions, importing, user_code
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.composed import (
    PLUS,
    Composed,
    Knowledge,
    Movable,
    Nothing,
    Ports,
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
from allworlds.world.state import State

SHAPE = "a class with the base allworlds.Lighthouse and a class method places"


def own_kind(code: user_code.UserCode) -> type[Lighthouse]:
    """The class that the code stands for, with its options, ready to be used as one of ours.

    Raises:
        InvalidWorld: if there is none, or it has no such options.
    """
    if code.arguments and isinstance(code.load(), type):
        kind = _kind(code.bare)
        return kind_with(kind, options_in(kind, code.plain, code.name.partition("?")[2]))  # type: ignore[no-any-return]
    return _kind(code)


@cache
def _kind(code: user_code.UserCode) -> type[Lighthouse]:
    """The class, which is loaded once a process; of a factory one for each of its arguments."""
    kind = code.made()
    if not isinstance(kind, type) or not issubclass(kind, Lighthouse) or inspect.isabstract(kind):
        raise InvalidWorld(f"{show(code.name)} is no lighthouse, but {shown(kind)}; one is {SHAPE}")
    if "__dataclass_params__" not in vars(kind):
        kind = dataclass(frozen=True)(kind)
    if not vars(kind)["__dataclass_params__"].frozen or "__hash__" not in vars(kind):
        raise InvalidWorld(
            f"{show(code.name)} is no frozen dataclass; write @dataclass(frozen=True)"
        )
    if kind.refusal is not Lighthouse.refusal and not kind.leaves_marks:
        raise InvalidWorld(f"{show(code.name)} has a method refusal, but leaves_marks is False")
    for each in fields(kind):
        told = vars(kind).get(each.name, each.default)
        if each.default is not MISSING and told != each.default and not hasattr(told, "__get__"):
            raise InvalidWorld(
                f"{show(code.name)} sets {each.name} = {show(told)} without a type, and so the "
                f"field keeps {show(each.default)}; write {each.name}: {type(told).__name__} = ..."
            )
    return _named(kind, code)


def shown(value: object) -> str:
    """A short text for any object, without the name of the module that its class was loaded as."""
    if isinstance(value, type):
        return f"the class {value.__qualname__}"
    plain = type(value).__repr__ is object.__repr__
    return f"an object of the class {type(value).__qualname__}" if plain else show(value)


def _is_method(value: object) -> bool:
    return isinstance(value, property | classmethod) or inspect.isfunction(value)


METHODS = [
    *(name for name, value in vars(Lighthouse).items() if name[0] != "_" and _is_method(value)),
    "__post_init__",
]
"""The methods that can be written anew: their errors are the user's."""


def _named(kind: type[Lighthouse], code: user_code.UserCode) -> type[Lighthouse]:
    """The class itself, which from now on names itself in errors, files and pickles."""
    kind.kind, kind.code = code.plain, code
    for name in METHODS:
        owner = next((each for each in kind.__mro__ if name in vars(each)), Lighthouse)
        theirs = not owner.__module__.startswith("allworlds.")
        if theirs or name == "percepts":
            _check(kind, code.name, name, theirs=theirs)
    copyreg.pickle(kind, _reduced)
    return kind


def _check(kind: type[Lighthouse], name: str, method: str, *, theirs: bool) -> None:
    """Let errors of a method of the user's name the lighthouse, and check what it returns."""
    found = inspect.getattr_static(kind, method)
    if not _is_method(found):  # a plain value in the place of a property
        value = found
        found = property(lambda _self: value)
    function: Any = found.fget if isinstance(found, property) else getattr(found, "__func__", found)
    what = f"lighthouse {show(name)}: {method} raises"
    check, legal = RETURNS.get(method, (None, ""))

    @wraps(function)
    def checked(self: Any, *args: Any, **keywords: Any) -> Any:
        def act() -> Any:
            returned = function(self, *args, **keywords)
            return tuple(returned) if method in ("places", "percepts") else returned

        returned = importing.attempted(what, act, InvalidWorld) if theirs else act()
        try:
            return check(returned, self, *args) if check else returned
        except (TypeError, ValidationError):
            raise InvalidWorld(
                f"{method} of the lighthouse {show(name)} gives {shown(returned)}; legal is {legal}"
            ) from None

    setattr(kind, method, checked if found is function else type(found)(checked))


# ---------------------------------------------------------------- the values of methods


def _places(places: tuple[Any, ...], kind: type[Lighthouse], *_asked: object) -> Iterator[Any]:
    """Places of the class, with the options that were asked for."""
    for place in places:
        made = isinstance(place, Lighthouse) and place.code is kind.code
        if not made or any(getattr(place, key) != kind.chosen[key] for key in kind.chosen):
            raise TypeError
    return iter(places)


def _percepts(
    sensed: tuple[Any, ...], _place: Lighthouse, map_: CombinatorialMap
) -> tuple[actions.Percept, ...]:
    """A percept for each dart, with its degree, in plain integers."""
    if len(sensed) != len(map_.darts):
        raise TypeError
    return tuple(map(_percept, map_.degree_at, sensed))


def _percept(degree: int, given: Any) -> actions.Percept:
    if type(given) is not actions.Percept or integer(given.degree) != degree:
        raise TypeError
    bearing = None if given.bearing is None else _natural(given.bearing)
    if (bearing or 0) >= degree:
        raise TypeError
    return actions.Percept(degree, _natural(given.marks), bearing)


def _told(told: Any, *_asked: object) -> actions.Told:
    if isinstance(told, Mapping):
        return {str.__str__(key): integer(value) for key, value in told.items()}
    return None if told is None else integer(told)


def _natural(number: Any, *_asked: object) -> int:
    if (found := integer(number)) < 0:
        raise TypeError
    return found


def _refusal(text: Any, *_asked: object) -> str:
    return str.__str__(text)


def _state(after: Any, _place: Lighthouse, _map: object, before: State, _action: object) -> State:
    """A state of plain integers, in which the robot has not moved."""
    plain = convert(to_builtins(after), State) if type(after) is State else None
    if plain is None or plain.dart != before.dart:
        raise TypeError
    return plain


RETURNS: dict[str, tuple[Callable[..., Any], str]] = {
    "places": (_places, "what cls(...) has made; write yield cls(...)"),
    "percepts": (
        _percepts,
        "Percept(degree, marks, bearing) for each dart, a bearing is below the degree, or None",
    ),
    "told": (_told, "an integer, a dict of integers by their names, or None"),
    "in_hand": (_natural, "an integer from 0 on"),
    "left_marks": (_natural, "an integer from 0 on"),
    "refusal": (_refusal, "a text, empty if the action is legal"),
    "acted": (_state, "a State with the dart of the one before"),
}
"""By method: its value in plain types, or a TypeError, and the legal values in words."""


# ---------------------------------------------------------------- in other processes


def _reduced(place: Lighthouse) -> tuple[Any, ...]:
    """The content of a pickle: the code with its text, from which any process makes the class."""
    state = {each.name: getattr(place, each.name) for each in fields(place)}  # type: ignore[arg-type]
    return _placed, (type(place).code, state)


def _placed(code: user_code.UserCode, state: Mapping[str, Any]) -> Lighthouse:
    return _kind(code)(**state)


LIGHTHOUSES: dict[str, type[Lighthouse]] = {
    kind.kind: kind
    for kind in (
        *(Nothing, Position, Directional, Door, Word, Compass, Cluster, Natural, Movable, Labels),
        *(Whiteboard, Ports, Knowledge),
    )
}
"""Every kind of lighthouse that comes with this program, by its name."""

OWN = "path/to/file.py:Class or module:Class"
"""How a lighthouse of the user's own is named."""


class LighthouseKind(Struct, frozen=True):
    """A kind of lighthouse as requests and rules hold it, and as it gets to other processes.

    Attributes:
        name: ``KIND[:key=value,...]``, or several of these with ``+`` between them.
        codes: the user's code that it needs, in the order of the name.
    """

    name: str
    codes: tuple[user_code.UserCode, ...] = ()

    @property
    def as_class(self) -> type[Lighthouse]:
        """The kind as a class; one of the user's is loaded once in a process."""
        return _type_of(self)

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
    """The kind of a lighthouse that stands somewhere."""
    codes = [
        replace(part.code, name=part.written)
        for part in parts_of(lighthouse)
        if part.code is not None
    ]
    return LighthouseKind(lighthouse.written, tuple(codes))


def parts_of(lighthouse: Lighthouse) -> tuple[Lighthouse, ...]:
    """The lighthouses that it is put together from; itself alone if it is one."""
    return lighthouse.parts if isinstance(lighthouse, Composed) else (lighthouse,)


def numbers_told(kind: LighthouseKind) -> tuple[str, ...]:
    """The names of the numbers that a robot is told by the lighthouses that come with this program.

    They are known before any world is made.
    """
    parts = kind.as_class.kinds if issubclass(kind.as_class, Composed) else (kind.as_class,)
    return tuple(name for part in parts if issubclass(part, Knowledge) for name in part.names)


def _part(text: str) -> str | user_code.UserCode:
    """One part of a name: as it is for one of ours, else the code, with its text."""
    if text.partition(":")[0] in LIGHTHOUSES:
        return text
    parts = re.fullmatch(r"([^?]+):([^:?=]+=[^?]*)", text)
    return _found(f"{parts[1]}?{parts[2]}" if parts else text)


def _found(name: str) -> user_code.UserCode:
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
    """The lighthouse of a world's JSON; if there is none, one of the kind ``missing``."""
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
    place: Lighthouse = chosen.at(**where) if where else chosen.usual(map_, start)
    return place


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
    """The class of the user's in a document, without its options; that of a factory with them.

    Raises:
        InputError: if there is none, or it has another text than the one in the document.
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
