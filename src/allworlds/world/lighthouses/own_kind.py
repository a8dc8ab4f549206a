"""A kind of lighthouse of the user's own: loaded, and kept from doing harm by its mistakes."""

from __future__ import annotations

import copyreg
import inspect
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from functools import cache, wraps
from typing import Any, TypeVar

from allworlds.inputs import InputError, integer, let_users_interrupt, show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Argument, Percept, UserCode, called, said
from allworlds.world.lighthouses.base import InvalidWorld, Lighthouse

ENTRY_POINTS = "allworlds.lighthouses"

WATCHED = (
    *("places", "check", "sensed", "percepts", "relabelled", "told", "believed", "number"),
    *("usual", "at", "from_json", "refusal", "written_on"),
)
"""The methods whose errors are the user's."""

T = TypeVar("T")


@cache
def own_kind(code: UserCode) -> type[Lighthouse]:
    """The class that the code stands for, ready to be used as one of ours; loaded once a process.

    Raises:
        InvalidWorld: if there is none.
    """
    kind = code.load(ENTRY_POINTS)
    arguments = code.arguments
    if isinstance(kind, type):
        kind = _with_attributes(code.name, kind, arguments)
    else:
        kind = called(code.name, kind, arguments)
    if not isinstance(kind, type) or not issubclass(kind, Lighthouse) or inspect.isabstract(kind):
        raise InvalidWorld(
            f"{show(code.name)} is no lighthouse, but {show(kind)}; one is a class with the base "
            "allworlds.Lighthouse and a class method places"
        )
    if "__dataclass_params__" not in vars(kind):
        kind = dataclass(frozen=True)(kind)
    if not vars(kind)["__dataclass_params__"].frozen or "__hash__" not in vars(kind):
        raise InvalidWorld(
            f"{show(code.name)} is no frozen dataclass; write @dataclass(frozen=True)"
        )
    return _watched(kind, code)


def _with_attributes(name: str, kind: type[T], arguments: Mapping[str, Argument]) -> type[T]:
    """The class with these values of its attributes."""
    own = {
        key: value
        for each in reversed(kind.__mro__)
        if not each.__module__.startswith(("allworlds.", "builtins"))
        for key, value in vars(each).items()
        if type(value) in (int, bool, str) and not key.startswith("_")
    }
    for key, value in arguments.items():
        if key not in own:
            legal = ", ".join(sorted(own)) or "none"
            raise InvalidWorld(f"{show(name)} has no option {show(key)}; legal are {legal}")
        if type(value) is not type(own[key]):
            raise InvalidWorld(
                f"option {key} = {show(value)} of {show(name)} is of the type "
                f"{type(value).__name__}, not {type(own[key]).__name__}"
            )
    if not arguments:
        return kind
    told = {"__doc__": kind.__doc__, "__module__": kind.__module__}
    return dataclass(frozen=True)(type(kind.__name__, (kind,), {**arguments, **told}))


def _watched(kind: type[Lighthouse], code: UserCode) -> type[Lighthouse]:
    """The class itself, which from now on names itself in errors, files and pickles."""
    kind.kind, kind.code = code.plain, code
    if "keys" not in {key for each in kind.__mro__[:-1] if _is_users(each) for key in vars(each)}:
        kind.keys = tuple(each.name for each in fields(kind)) if is_dataclass(kind) else ()
    for each in kind.__mro__:
        for name in {*WATCHED} & {*vars(each)} if _is_users(each) else ():
            _watch(each, name, code.name)
    places, percepts = kind.places, kind.percepts

    def checked_places(_: object, map_: CombinatorialMap, start: Dart) -> Iterator[Lighthouse]:
        for place in _each(code.name, "places", places(map_, start)):
            if type(place) is not kind:
                raise InvalidWorld(
                    f"places of the lighthouse {show(code.name)} has {show(place)}, which is none "
                    "of its class; write yield cls(...)"
                )
            yield place

    def checked_percepts(self: Lighthouse, map_: CombinatorialMap) -> tuple[Percept, ...]:
        sensed = tuple(_each(code.name, "percepts", percepts(self, map_)))
        if len(sensed) != len(map_.darts):
            raise InvalidWorld(
                f"the lighthouse {show(code.name)} has {len(sensed)} percepts for "
                f"{len(map_.darts)} darts"
            )
        return tuple(_percept(code.name, map_, d, each) for d, each in enumerate(sensed))

    kind.places = classmethod(checked_places)  # type: ignore[assignment, method-assign]
    kind.percepts = checked_percepts  # type: ignore[method-assign]
    copyreg.pickle(kind, _reduced)
    return kind


def _is_users(kind: type) -> bool:
    return not kind.__module__.startswith("allworlds.") and kind.__module__ not in (
        "abc",
        "builtins",
    )


def _watch(kind: type, method: str, name: str) -> None:
    """Let errors of a method name the lighthouse."""
    found = vars(kind)[method]
    function: Callable[..., Any] = getattr(found, "__func__", found)
    if not inspect.isfunction(function) or hasattr(function, "watched"):
        return

    @wraps(function)
    def watched(*args: Any, **keywords: Any) -> Any:
        return _tried(name, method, lambda: function(*args, **keywords))

    watched.watched = True  # type: ignore[attr-defined]
    setattr(kind, method, type(found)(watched) if found is not function else watched)


def _tried(name: str, method: str, act: Callable[[], T]) -> T:
    try:
        return act()
    except InputError:
        raise
    except BaseException as error:  # noqa: BLE001  # a class of the user's may raise anything
        let_users_interrupt(error)
        raise InvalidWorld(f"lighthouse {show(name)}: {method} raises {said(error)}") from None


_END = object()


def _each(name: str, method: str, values: Any) -> Iterator[Any]:
    """The values, with the errors that only come while they are asked for."""
    every = _tried(name, method, lambda: iter(values))
    while (value := _tried(name, method, lambda: next(every, _END))) is not _END:
        yield value


def _percept(name: str, map_: CombinatorialMap, dart: Dart, percept: object) -> Percept:
    """The percept at a dart, as plain integers."""
    plain = _plain(percept) if type(percept) is Percept else None
    if plain is None or plain.degree != map_.degree_at[dart]:
        raise InvalidWorld(
            f"the lighthouse {show(name)} senses {show(percept)} at a dart of degree "
            f"{map_.degree_at[dart]}; legal is Percept(degree, marks, bearing) with that degree, "
            "marks from 0 on, and a bearing from 0 on or None"
        )
    return plain


def _plain(percept: Percept) -> Percept | None:
    try:
        degree, marks = integer(percept.degree), integer(percept.marks)
        bearing = None if percept.bearing is None else integer(percept.bearing)
    except TypeError:
        return None
    return Percept(degree, marks, bearing) if min(marks, bearing or 0) >= 0 else None


def _reduced(place: Lighthouse) -> tuple[Any, ...]:
    """The content of a pickle: the code with its text, from which any process makes the class."""
    state = {each.name: getattr(place, each.name) for each in fields(place)}  # type: ignore[arg-type]
    return _placed, (type(place).code, state)


def _placed(code: UserCode, state: Mapping[str, Any]) -> Lighthouse:
    return own_kind(code)(**state)
