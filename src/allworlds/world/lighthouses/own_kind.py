"""Users' lighthouses: the loading of their classes, and their names in errors."""

import copyreg
import inspect
from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, dataclass, fields
from functools import cache, wraps
from typing import Any

from msgspec import ValidationError, convert, to_builtins

from allworlds.inputs.checks import integer, show
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol import actions, importing, user_code
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.options import InvalidWorld, kind_with, options_in
from allworlds.world.state import State

SHAPE = "a class with the base allworlds.Lighthouse and a class method places"


def own_kind(code: user_code.UserCode) -> type[Lighthouse]:
    """The lighthouse class that a user's program defines, as a kind with chosen options.

    The name of the program has the values of the options, as in ``file.py:Class?size=2``.  The
    result is a subclass of the user's class, which this program can use like a built-in kind.

    Raises:
        InvalidWorld: if there is no class of this name, or the class has no such options.
    """
    if code.arguments and isinstance(code.load(), type):
        kind = _kind(code.bare)
        return kind_with(kind, options_in(kind, code.plain, code.name.partition("?")[2]))  # type: ignore[no-any-return]
    return _kind(code)


@cache
def _kind(code: user_code.UserCode) -> type[Lighthouse]:
    """The subclass that is made of the class in a user's program; see :func:`_subclass`.

    In one process a second call with the same program returns the same subclass.  The program may
    also name a function that makes a class, with arguments for this function; then other arguments
    make another subclass.
    """
    made = code.made()
    if not isinstance(made, type) or not issubclass(made, Lighthouse) or inspect.isabstract(made):
        raise InvalidWorld(f"{show(code.name)} is no lighthouse, but {shown(made)}; one is {SHAPE}")
    kind = _subclass(made, code)
    if not vars(kind)["__dataclass_params__"].frozen or "__hash__" not in vars(kind):
        raise InvalidWorld(
            f"{show(code.name)} is no frozen dataclass; write @dataclass(frozen=True)"
        )
    if kind.refusal is not Lighthouse.refusal and not kind.leaves_marks:
        raise InvalidWorld(f"{show(code.name)} has a method refusal, but leaves_marks is False")
    for each in fields(kind):  # type: ignore[arg-type]  # it is a dataclass
        value = vars(kind).get(each.name, each.default)
        if each.default is not MISSING and value != each.default and not hasattr(value, "__get__"):
            raise InvalidWorld(
                f"{show(code.name)} sets {each.name} = {show(value)} without a type, and so the "
                f"field keeps {show(each.default)}; write {each.name}: {type(value).__name__} = ..."
            )
    _check_methods(kind, code)
    copyreg.pickle(kind, _reduced)
    _OF_THEIRS[made] = kind
    return kind


_OF_THEIRS: dict[type[Lighthouse], type[Lighthouse]] = {}
"""For each user's class the subclass that was made from it."""

NOT_INHERITED = {"__dict__", "__weakref__", "__slots__", "__abstractmethods__", "_abc_impl"}
"""The attributes that Python makes for each class anew, so that no subclass gets a copy of them."""


def _subclass(theirs: Any, code: user_code.UserCode) -> type[Lighthouse]:
    """A subclass of a user's class; this program changes the subclass, not the user's class.

    The subclass has copies of the attributes and methods that the user's class defines.  Its
    ``kind``, the name in errors and files, is the name of the user's program.  The subclass is a
    dataclass even if the user's class is none.

    Args:
        theirs: the user's class.
        code: the user's program.
    """
    body = {name: part for name, part in vars(theirs).items() if name not in NOT_INHERITED}
    body |= {"kind": code.plain, "code": code}
    own: type[Lighthouse] = type(theirs)(theirs.__name__, (theirs,), body)
    return own if "__dataclass_params__" in body else dataclass(frozen=True)(own)


def own_place(placed: Lighthouse) -> Lighthouse:
    """The lighthouse ``placed`` as an instance of the subclass that was made from its class.

    If there is no such subclass, ``placed`` is returned.
    """
    own = _OF_THEIRS.get(type(placed))
    if own is None:
        return placed
    return own(**{each.name: getattr(placed, each.name) for each in fields(own) if each.init})  # type: ignore[arg-type]  # as above


def shown(value: object) -> str:
    """A short text for any object, without the name of the module of its class."""
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
"""The methods that a user may write, so that their errors are the user's."""


def _check_methods(kind: type[Lighthouse], code: user_code.UserCode) -> None:
    """Replace the methods that the user has written by methods that check what they return.

    The method ``percepts`` is replaced, too, if it is not the user's.  See :func:`_check`.

    Args:
        kind: the class made for the user's lighthouse; its methods are replaced.
        code: the user's program, whose name the errors give.
    """
    for name in METHODS:
        owner = next((each for each in kind.__mro__ if name in vars(each)), Lighthouse)
        theirs = not owner.__module__.startswith("allworlds.")
        if theirs or name == "percepts":
            _check(kind, code.name, name, theirs=theirs)


def _check(kind: type[Lighthouse], name: str, method: str, *, theirs: bool) -> None:
    """Replace a method of a class by one that checks the returned value.

    The function in :data:`RETURNS` checks the value, and turns it into a plain value; if the value
    is not legal, the new method raises InvalidWorld.  For a method that is not in :data:`RETURNS`
    any value is legal.

    Args:
        kind: the class.
        name: the name of the lighthouse, for errors.
        method: the name of the method.
        theirs: whether the user wrote the method.  If so, the new method also turns the errors that
            the user's method raises into InvalidWorld.
    """
    found = inspect.getattr_static(kind, method)
    if not _is_method(found):  # a plain value instead of a property
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


USUAL = ("dart", "darts")
"""The fields whose darts need no name in pictures, because marks and bearings show them."""


def named_darts(placed: Lighthouse, map_: CombinatorialMap) -> dict[str, tuple[int, ...]]:
    """The darts in the fields of a user's lighthouse, by the names of the fields.

    The fields ``dart`` and ``darts`` are left out.  Another field holds darts if its numbers change
    when the darts of the map are renamed.
    """
    if type(placed).code is None:
        return {}
    moved = placed.relabelled([dart + len(map_.darts) for dart in map_.darts])
    found = {}
    for each in fields(placed):  # type: ignore[arg-type]  # it is a dataclass
        old, new = (_several(getattr(one, each.name)) for one in (placed, moved))
        if old and each.name not in USUAL and new == tuple(d + len(map_.darts) for d in old):
            found[each.name] = old
    return found


def _several(value: Any) -> tuple[int, ...]:
    """The integers in a field that holds one or several integers; empty for any other field."""
    values = value if isinstance(value, tuple) else (value,)
    return values if all(type(each) is int for each in values) else ()


# ---------------------------------------------------------------- the values of methods


def _places(places: tuple[Any, ...], kind: type[Lighthouse], *_asked: object) -> Iterator[Any]:
    """The places ``places`` that a user's method has yielded, after a check.

    Raise TypeError unless all places are lighthouses of the class ``kind``, with the options that
    were given to this class.
    """
    made = [own_place(placed) if isinstance(placed, Lighthouse) else placed for placed in places]
    for placed in made:
        ours = isinstance(placed, Lighthouse) and placed.code is kind.code
        if not ours or any(getattr(placed, key) != kind.chosen[key] for key in kind.chosen):
            raise TypeError
    return iter(made)


def _percepts(
    sensed: tuple[Any, ...], _place: Lighthouse, map_: CombinatorialMap
) -> tuple[actions.Percept, ...]:
    """The percepts ``sensed`` that a user's method has returned, in plain integers.

    Raise TypeError unless there is one percept for each dart, with the degree of the dart's vertex.
    """
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
    """The state ``after``, which a user's method has returned, in plain integers.

    Raise TypeError if ``after`` is no state, or if the robot's dart is another one than in the
    state ``before`` the action.
    """
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
"""For each method a function and words for messages: the function turns the returned value into a
plain value, or raises TypeError; the words tell the legal values."""


# ---------------------------------------------------------------- in other processes


def _reduced(placed: Lighthouse) -> tuple[Any, ...]:
    """The content of a pickle: the user's program, and the fields of the lighthouse.

    Another process makes the class from the text of the program.
    """
    state = {each.name: getattr(placed, each.name) for each in fields(placed)}  # type: ignore[arg-type]
    return _placed, (type(placed).code, state)


def _placed(code: user_code.UserCode, state: Mapping[str, Any]) -> Lighthouse:
    return _kind(code)(**state)
