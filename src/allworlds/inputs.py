"""What comes from outside: checks of values, requests, and the error that is the user's to mend.

A *request* is what a verb is asked for, as a value (:class:`Request`), composed of parts that verbs
share.  Each field says its type, its default and, by :class:`Option` beside the type, how it
is asked for on the command line; a plain text in that place tells of a field that Python has alone.
From the same class come the function in Python (:func:`answers`), the command line
(``allworlds.cli.groups``), and what a run directory is of (:func:`meant`).
"""

from __future__ import annotations

import inspect
import json
import operator
import os
import re
import signal
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, fields
from functools import wraps
from importlib.util import find_spec
from pathlib import Path
from textwrap import fill
from typing import (
    Annotated,
    Any,
    ClassVar,
    Final,
    Generic,
    NamedTuple,
    ParamSpec,
    TypeVar,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

P = ParamSpec("P")
Given = TypeVar("Given")
Value = TypeVar("Value")
Asked = TypeVar("Asked")
Answer = TypeVar("Answer")

SHOWN = 200
"""The number of characters of a value that are shown."""

LARGEST_SIZE = 100_000
"""The largest number of edges, or of vertices, that is taken at all."""


class InputError(ValueError):
    """Bad input: one line that names the offending value and what would be legal."""


def let_users_interrupt(error: BaseException) -> None:
    """Raise an interrupt again; where interrupts are ignored only an explorer raises one."""
    ignored = signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    if isinstance(error, KeyboardInterrupt) and not ignored:
        raise error


def show(value: object) -> str:
    """A short text for any object, also for one whose repr fails."""
    try:
        text = str.__str__(repr(value))
    except BaseException as error:  # noqa: BLE001  # repr may be anybody's code
        let_users_interrupt(error)
        return f"an object of type {type(value).__name__} whose repr fails"
    return text if len(text) <= SHOWN else text[: SHOWN - 3] + "..."


def integer(value: object) -> int:
    """``value`` as a plain ``int`` if it is an integer and no boolean.

    Raises:
        TypeError: for booleans, floats, strings and everything else.
    """
    if type(value) is int:
        return value
    if isinstance(value, bool):
        raise TypeError(f"{show(value)} is a boolean, not an integer")
    index = operator.index(value)  # type: ignore[arg-type]  # refuses what is no integer
    return int.__index__(index)  # also for a subclass with operators of its own


def are_plain(values: Iterable[object]) -> bool:
    """Whether all are of the type ``int`` itself, as nearly always; then none need be converted."""
    return {*map(type, values)} <= {int}


def an_integer(name: str, value: object) -> int:
    """The value as an ``int``.

    Raises:
        InputError: naming it, for booleans and everything else that is no integer.
    """
    try:
        return integer(value)
    except TypeError:
        raise InputError(f"{name} = {show(value)} is not an integer") from None


def at_most(name: str, value: float, most: int) -> None:
    """Nothing, if the value is no larger.

    What follows from larger ones could not be counted, printed or waited for.

    Raises:
        InputError: naming it.
    """
    if value > most:
        raise InputError(f"{name} = {show(value)} is too big; at most {most:,} is legal")


def a_text(name: str, value: object) -> str:
    """The value, if it is a text.

    Raises:
        InputError: naming it.
    """
    if not isinstance(value, str):
        raise InputError(f"{name} = {show(value)} is not a text")
    return value


def a_path(name: str, value: object) -> Path:
    """The value as a path.

    Raises:
        InputError: naming it, for what is no path, and for an empty text, which Python would
            take for the current directory.
    """
    if value == "" or not isinstance(value, str | os.PathLike):
        raise InputError(f"{name} = {show(value)} is no path, not even of the current directory")
    try:
        nameable = b"\0" not in os.fsencode(value)
    except UnicodeEncodeError:
        nameable = False
    if not nameable:
        raise InputError(f"{name} = {show(value)} is no path: no file can be named so")
    return Path(value)


def ensure_installed(package: str, extra: str, what: str) -> None:
    """Nothing, if the package can be imported.

    Raises:
        InputError: saying what needs it, and which extra brings it.
    """
    if find_spec(package) is None:
        raise InputError(f"{what} needs {package}: pip install 'allworlds[{extra}]'")


def parse_json(text: str, kind: type[InputError] = InputError) -> Any:
    """The value of a JSON text.

    Raises:
        InputError: of the kind that was asked for, if it is none, or if an object has a key
            twice: which value is meant cannot be told.
    """

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        found = dict(pairs)
        if len(found) < len(pairs):
            keys = [key for key, _ in pairs]
            twice = next(key for key in keys if keys.count(key) > 1)
            raise kind(f"the key {show(twice)} stands twice in one object")
        return found

    try:
        return json.loads(text, object_pairs_hook=once)
    except InputError:
        raise
    except (ValueError, RecursionError) as error:
        raise kind(f"not JSON: {show(str(error))[1:-1]}") from None


def read_text(path: str) -> str:
    """The text of a file that the user has named; of stdin for ``-``.

    Raises:
        InputError: naming the file and the reason why it cannot be read.
    """
    try:
        if path == "-":
            return sys.stdin.read()
        return a_path("file", path).read_text(encoding="utf-8")
    except (OSError, UnicodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is no text"
        raise InputError(f"file {show(path)} cannot be read: {reason}") from None


# ---------------------------------------------------------------- texts that become values


def integer_of(text: str) -> int:
    """The integer of a text; unlike ``int`` without 1_0 and other scripts.

    Raises:
        ValueError: saying what the text is not; so do all that read the text of an option.
    """
    if re.fullmatch(r"[+-]?[0-9]{1,4000}", text):
        return int(text)
    raise ValueError(f"{show(text)} is not an integer")


def seconds_of(text: str) -> float:
    """The number of a text."""
    if re.fullmatch(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?|-?inf|nan", text):
        return float(text)
    raise ValueError(f"{show(text)} is not a number of seconds")


def one_of(names: Iterable[str]) -> str:
    """The names of a table, as a help says them: ``a, b or c``."""
    *others, last = names
    return f"{', '.join(others)} or {last}"


# ---------------------------------------------------------------- requests

SCOPE, RULES, EFFORT, OUTPUT = "What is checked", "How it is judged", "Effort", "Output"
PANELS = (SCOPE, RULES, EFFORT, OUTPUT)
"""The panels of the help, in their order."""

AS_IN_PYTHON: Final = object()


@dataclass(frozen=True, slots=True)
class Option:
    """How a field is asked for on the command line.

    Attributes:
        panel: of the help, under which it stands.
        metavar: stands for the value in the help; empty for a flag.
        help: what it is, in a line or two, for Python too.
        name: of the option, without dashes; by default that of the field.
        short: a letter that is a name, too.
        parse: what the field gets of the text.
        default: the text where the option is left out, if that means something else in Python.
        apart: it says where, how long or for whom a job is done; what is found does not depend
            on it.
        repeated: it may be given several times; the field gets a list.
    """

    panel: str
    metavar: str
    help: str
    name: str = ""
    short: str = ""
    parse: Callable[[str], Any] = str
    default: Any = AS_IN_PYTHON
    apart: bool = False
    repeated: bool = False


class Argument(Option):
    """The same for a field that has no name on the command line, but a place."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Named:
    """A field that the command line names in words of its own.

    Attributes:
        words: a dataclass of these words, whose ``value()`` is the field's.
        help: what the field is, for Python.
    """

    words: type
    help: str


class Taken(Generic[Given, Value]):
    """A field that takes what users may give, and holds the value that is meant by it.

    ``field: Taken[str, Color] = Taken(color_named, "red")``
    """

    def __init__(self, take: Callable[[Given], Value], default: Given) -> None:
        self._take, self._default = take, default

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, request: object, owner: type | None = None) -> Value:
        if request is None:
            return self._default  # type: ignore[return-value]  # dataclasses ask for the default
        value: Value = vars(request)[self._name]
        return value

    def __set__(self, request: object, given: Given) -> None:
        vars(request)[self._name] = self._take(given)


# Type checkers are not told that it is frozen: mypy would take each Taken field that is inherited
# for what is given.
@dataclass_transform(kw_only_default=True, field_specifiers=(field,))
class Request:
    """What is asked for, or a part of it that verbs share: a frozen dataclass of keywords.

    With ``kw_only=False`` the fields of that class alone may be given by their place.
    """

    __dataclass_fields__: ClassVar[dict[str, Any]]

    def __init_subclass__(cls, *, kw_only: bool = True) -> None:
        dataclass(frozen=True, kw_only=kw_only)(cls)


class Field(NamedTuple):
    """A field of a request: its name, its type for those who give it, and how it is asked for."""

    name: str
    type: Any
    asked: Option | Named | str | None


def fields_of(request: type[Any]) -> Iterator[Field]:
    """The fields of a class of requests, in the order of the constructor."""
    hints = get_type_hints(request, include_extras=True)
    for told in fields(request):
        kind, asked = hints[told.name], None
        if get_origin(kind) is Annotated:
            kind, asked = get_args(kind)
        if get_origin(kind) is Taken:
            kind = get_args(kind)[0]
        yield Field(told.name, kind, asked)


def values_of(part: type[Request], request: object) -> dict[str, Any]:
    """The fields that a request shares with a part of it, as keywords."""
    return {told.name: getattr(request, told.name) for told in fields(part)}


def answers(
    request: Callable[P, Asked],
) -> Callable[[Callable[[Asked], Answer]], Callable[P, Answer]]:
    """A function of a request as one that takes what the constructor of the request takes.

    Type checkers know its keywords.  Its docstring tells of each, in the words of the help.
    """

    def made(answered: Callable[[Asked], Answer]) -> Callable[P, Answer]:
        plain = inspect.signature(request)
        of = {each.name: each for each in fields_of(request)}  # type: ignore[arg-type]  # a class
        taken = [each.replace(annotation=of[name].type) for name, each in plain.parameters.items()]
        returned = inspect.signature(answered).return_annotation
        signature = inspect.Signature(taken, return_annotation=returned)

        @wraps(answered)
        def function(*args: P.args, **keywords: P.kwargs) -> Answer:
            ensure_takes(answered.__name__, signature, *args, **keywords)
            return answered(request(*args, **keywords))

        function.__signature__ = signature  # type: ignore[attr-defined]  # for those who ask
        told = inspect.cleandoc(answered.__doc__ or "")
        function.__doc__ = _with_arguments(told, [of[name] for name in plain.parameters])
        return function

    return made


def ensure_takes(
    name: str, signature: inspect.Signature, /, *args: object, **keywords: object
) -> None:
    """Nothing, if a function of that name and signature takes these arguments.

    Raises:
        TypeError: as Python does.
    """
    try:
        signature.bind(*args, **keywords)
    except TypeError as error:
        raise TypeError(f"{name}() {error}") from None


def answer(function: Callable[..., Answer], request: object) -> Answer:
    """What such a function, or one of a request alone, answers to one that is made already."""
    answered: Answer = getattr(function, "__wrapped__", function)(request)
    return answered


def _with_arguments(text: str, told: Iterable[Field]) -> str:
    """A docstring with some lines for each field."""
    lines = ["Args:"]
    for each in told:
        about = each.asked if isinstance(each.asked, str) else getattr(each.asked, "help", "")
        lines.append(fill(f"    {each.name}: {about}", 96, subsequent_indent=" " * 8))
    head, raises, rest = text.partition("\n\nRaises:\n")
    return f"{head}\n\n" + "\n".join(lines) + raises + rest


def meant(request: object) -> dict[str, Any]:
    """All that the answer to a request depends on, but for the explorer, as JSON has it."""
    return {
        key: [*value] if isinstance(value, tuple) else value
        for key, name in _keys(type(request)).items()
        for value in (getattr(request, name),)
    }


def remembered(request: type, told: Mapping[str, Any]) -> dict[str, Any]:
    """The keywords of the constructor that make a request of which this was :func:`meant`."""
    return {name: told[key] for key, name in _keys(request).items()}


def _keys(request: type) -> dict[str, str]:
    """The name of each field of which that is true, by the name of its option."""
    return {
        (each.asked.name or each.name): each.name
        for each in fields_of(request)
        if isinstance(each.asked, Option) and not each.asked.apart
    }
