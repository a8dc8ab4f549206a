"""A kind of lighthouse of the user's own: loaded, and its mistakes told by its name."""

from __future__ import annotations

import copyreg
import inspect
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, dataclass, fields
from functools import cache, wraps
from typing import Any

from allworlds.inputs.checks import integer, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Action, Percept
from allworlds.protocol.importing import attempted
from allworlds.protocol.player import Told
from allworlds.protocol.user_code import UserCode
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.options import InvalidWorld, kind_with, options_in
from allworlds.world.state import State

SHAPE = "a class with the base allworlds.Lighthouse and a class method places"


def own_kind(code: UserCode) -> type[Lighthouse]:
    """The class that the code stands for, with its options, ready to be used as one of ours.

    Raises:
        InvalidWorld: if there is none, or it has no such options.
    """
    if code.arguments and isinstance(code.load(), type):
        kind = _kind(code.bare)
        return kind_with(kind, options_in(kind, code.plain, code.name.partition("?")[2]))  # type: ignore[no-any-return]
    return _kind(code)


@cache
def _kind(code: UserCode) -> type[Lighthouse]:
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


def _named(kind: type[Lighthouse], code: UserCode) -> type[Lighthouse]:
    """The class itself, which from now on names itself in errors, files and pickles."""
    kind.kind, kind.code = code.plain, code
    checks = _Checks(code.name, kind)
    for name in METHODS:
        owner = next((each for each in kind.__mro__ if name in vars(each)), Lighthouse)
        theirs = not owner.__module__.startswith("allworlds.")
        if theirs or name == "percepts":
            _check(kind, name, checks, theirs=theirs)
    copyreg.pickle(kind, _reduced)
    return kind


METHODS = [
    *(name for name, value in vars(Lighthouse).items() if name[0] != "_" and _is_method(value)),
    "__post_init__",
]
"""The methods that can be written anew: their errors are the user's."""

LISTED = ("places", "percepts")
"""Those that yield: they are called to their end."""


def _check(kind: type[Lighthouse], method: str, checks: _Checks, *, theirs: bool) -> None:
    """Let errors of a method of the user's name the lighthouse, and check what it returns."""
    found = inspect.getattr_static(kind, method)
    if not _is_method(found):  # a plain value in the place of a property
        value = found
        found = property(lambda _self: value)
    function: Any = found.fget if isinstance(found, property) else getattr(found, "__func__", found)
    what = f"lighthouse {show(checks.name)}: {method} raises"
    check = getattr(checks, method, None)

    @wraps(function)
    def checked(self: Any, *args: Any, **keywords: Any) -> Any:
        def act() -> Any:
            returned = function(self, *args, **keywords)
            return tuple(returned) if method in LISTED else returned

        returned = attempted(what, act, InvalidWorld) if theirs else act()
        return check(returned, self, *args) if check else returned

    setattr(kind, method, checked if found is function else type(found)(checked))


class _Checks:
    """Checks of the values that the methods of these names return.

    Args:
        name: of the lighthouse, for messages.
        kind: its class.
    """

    def __init__(self, name: str, kind: type[Lighthouse]) -> None:
        self.name, self.kind = name, kind

    def places(
        self, places: tuple[Any, ...], kind: type[Lighthouse], _map: CombinatorialMap, _start: Dart
    ) -> Iterator[Lighthouse]:
        """Places of the class, with the options that were asked for."""
        chosen = getattr(kind, "chosen", {})
        for place in places:
            if type(place) is not self.kind or any(
                getattr(place, key) != value for key, value in chosen.items()
            ):
                raise InvalidWorld(
                    f"places of the lighthouse {show(self.name)} has {shown(place)}, which "
                    "cls(...) has not made; write yield cls(...)"
                )
        return iter(places)

    def percepts(
        self, sensed: tuple[Any, ...], _self: Lighthouse, map_: CombinatorialMap
    ) -> tuple[Percept, ...]:
        """A percept for each dart, with its degree, in plain integers."""
        if len(sensed) != len(map_.darts):
            raise InvalidWorld(
                f"the lighthouse {show(self.name)} has {len(sensed)} percepts for "
                f"{len(map_.darts)} darts"
            )
        return tuple(self._percept(map_, dart, each) for dart, each in enumerate(sensed))

    def _percept(self, map_: CombinatorialMap, dart: Dart, percept: object) -> Percept:
        degree = map_.degree_at[dart]
        plain = _plain(percept) if type(percept) is Percept else None
        if plain is None or plain.degree != degree or (plain.bearing or 0) >= degree:
            raise InvalidWorld(
                f"the lighthouse {show(self.name)} senses {show(percept)} at a dart of degree "
                f"{degree}; legal is Percept(degree, marks, bearing) with that degree, marks from "
                "0 on, and a bearing from 0 on and below the degree, or None"
            )
        return plain

    def told(self, told: Any, _self: Lighthouse, _map: CombinatorialMap) -> Told:
        """An integer, integers by their names, or None."""
        try:
            if isinstance(told, Mapping):
                if all(isinstance(key, str) for key in told):
                    return {str(key): integer(value) for key, value in told.items()}
            else:
                return None if told is None else integer(told)
        except TypeError:
            pass
        raise self._wrong("told", told, "an integer, a dict of integers by their names, or None")

    def in_hand(self, number: Any, _self: Lighthouse) -> int:
        """A number of markers."""
        return self._natural("in_hand", number)

    def left_marks(self, marks: Any, _self: Lighthouse, *_asked: object) -> int:
        """A number of marks."""
        return self._natural("left_marks", marks)

    def refusal(
        self, text: Any, _self: Lighthouse, _action: object, _lying: int, _hand: int
    ) -> str:
        """A text."""
        if not isinstance(text, str):
            raise self._wrong("refusal", text, "a text, empty if the action is legal")
        return text

    def acted(
        self, after: Any, _self: Lighthouse, _map: object, state: State, _action: Action
    ) -> State:
        """A state in which the robot has not moved."""
        if type(after) is not State or after.dart != state.dart or not after.is_plain:
            raise self._wrong("acted", after, "a State with the dart of the one before")
        return after

    def _natural(self, method: str, number: object) -> int:
        try:
            found = integer(number)
        except TypeError:
            found = -1
        if found < 0:
            raise self._wrong(method, number, "an integer from 0 on")
        return found

    def _wrong(self, method: str, value: object, legal: str) -> InvalidWorld:
        return InvalidWorld(
            f"{method} of the lighthouse {show(self.name)} gives {shown(value)}; legal is {legal}"
        )


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
    return _kind(code)(**state)
