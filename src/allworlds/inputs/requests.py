"""Requests: what a verb is asked for, as a value.

A *request* (:class:`Request`) is composed of parts that verbs share.  Each field says its type, its
default and, by :class:`Option` beside the type, how it is asked for on the command line; a plain
text in that place tells of a field that Python has alone.  From the same class come the function in
Python (:func:`answers`), the command line (``allworlds.cli.groups``), and what a run directory is
of (:func:`meant`).
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, fields
from functools import wraps
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
    """An option without a name: the command line knows it by its place."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Named:
    """A field that the command line expresses by several options.

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
    """A request, or a part that verbs share: a frozen dataclass whose fields are keywords.

    With ``kw_only=False`` the fields of that class alone may be given by their place.
    """

    __dataclass_fields__: ClassVar[dict[str, Any]]

    def __init_subclass__(cls, *, kw_only: bool = True) -> None:
        dataclass(frozen=True, kw_only=kw_only)(cls)


class Field(NamedTuple):
    """A field of a request: its name, its type for callers, and its option."""

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
    """Give a function of a request the signature of the request's constructor.

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
        function.request = request  # type: ignore[attr-defined]  # for the command line
        told = inspect.cleandoc(answered.__doc__ or "")
        function.__doc__ = _with_arguments(told, [of[name] for name in plain.parameters])
        return function

    return made


def ensure_takes(
    name: str, signature: inspect.Signature, /, *args: object, **keywords: object
) -> None:
    """Raise TypeError unless a function of that name and signature takes these arguments.

    Raises:
        TypeError: as Python does.
    """
    try:
        signature.bind(*args, **keywords)
    except TypeError as error:
        raise TypeError(f"{name}() {error}") from None


def answer(function: Callable[..., Answer], request: object) -> Answer:
    """The answer of such a function, or of one that takes a request, to a finished request."""
    answered: Answer = getattr(function, "__wrapped__", function)(request)
    return answered


def _with_arguments(text: str, told: Iterable[Field]) -> str:
    """The docstring, with some lines for each field."""
    lines = ["Args:"]
    for each in told:
        about = each.asked if isinstance(each.asked, str) else getattr(each.asked, "help", "")
        lines.append(fill(f"    {each.name}: {about}", 96, subsequent_indent=" " * 8))
    head, raises, rest = text.partition("\n\nRaises:\n")
    return f"{head}\n\n" + "\n".join(lines) + raises + rest


def meant(request: object) -> dict[str, Any]:
    """All that the answer to a request depends on, but for the explorer, as JSON has it.

    A value that JSON does not have stands there by its name, which is its text; of the user's
    code there is the record, from which it can be loaded again.
    """
    told = {key: getattr(request, name) for key, name in _keys(type(request)).items()}
    records = {
        code.plain: code.record for value in told.values() for code in getattr(value, "codes", ())
    }
    found = {key: _as_json(value) for key, value in told.items()}
    return {**found, "code": records} if records else found


def _as_json(value: object) -> object:
    if isinstance(value, tuple | list):
        return [*value]
    return value if value is None or isinstance(value, str | int | float) else str(value)


def remembered(request: type, told: Mapping[str, Any]) -> dict[str, Any]:
    """The constructor's keywords for the request that :func:`meant` described."""
    return {name: told[key] for key, name in _keys(request).items()}


def _keys(request: type) -> dict[str, str]:
    """The names of the fields for which the condition is true, by the names of their options."""
    return {
        (each.asked.name or each.name): each.name
        for each in fields_of(request)
        if isinstance(each.asked, Option) and not each.asked.apart
    }
