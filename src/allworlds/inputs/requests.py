"""Requests: the arguments of a verb as one value.

A *request* (:class:`Request`) consists of parts that verbs share.  Each field has a type, a default
and an annotation: an :class:`Option` describes the form of the field on the command line, and a
plain text describes a field that only Python has.  From the same class follow the function in
Python (:func:`answers`), the command line (``allworlds.cli.app``), and the values by which a run
directory is recognised (:func:`meant`).
"""

import inspect
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextvars import ContextVar
from dataclasses import dataclass, field, fields, replace
from functools import cached_property, wraps
from operator import index
from textwrap import fill
from typing import (
    Annotated,
    Any,
    ClassVar,
    Generic,
    NamedTuple,
    ParamSpec,
    SupportsIndex,
    TypeVar,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

from allworlds.inputs.nesting import ensure_outermost

P = ParamSpec("P")
T = TypeVar("T")
Given = TypeVar("Given")
Value = TypeVar("Value")
Asked = TypeVar("Asked")
Answer = TypeVar("Answer")

SCOPE, RULES, EFFORT, OUTPUT = "What is checked", "How it is judged", "Effort", "Output"
PANELS = (SCOPE, RULES, EFFORT, OUTPUT)
"""The panels of the help, which are groups of options, in their order."""


class Rare(str):
    """The name of a panel of the help, as the mark of an option that is rarely needed.

    If a verb has many options, ``--help`` leaves out the options with this mark, and
    ``--help-all`` shows all options.  Other verbs show all options by ``--help``.
    """

    __slots__ = ()


RARE_SCOPE, RARE_RULES, RARE_EFFORT = Rare(SCOPE), Rare(RULES), Rare(EFFORT)

EXPLORER_FIELDS = ("explore", "explorers")
"""The fields of requests that name explorers to be played."""

GIVEN_IN_FILE: ContextVar[frozenset[str]] = ContextVar("given in a file", default=frozenset())
"""The options whose defaults a user's file sets, so that printed commands name the options."""


@dataclass(frozen=True, slots=True)
class Option:
    """The form of a field on the command line.

    Attributes:
        panel: the panel of the help in which the option is shown.
        metavar: the word for the value in the help; empty for a flag.
        help: the description in a line or two, also for Python.
        name: the name of the option, without dashes; by default the name of the field.
        short: a letter as a second name.
        parse: the function from the text to the value of the field.
        default: the text that is parsed if the option is not given; if this text is empty, the
            field has its own default if the option is not given.
        apart: whether results are independent of the option, because it only tells where, how long
            or for whom a job is done.
        repeated: whether the option may be given several times; the field then gets a list.
        document_type: the type and the meaning of the option's key in documents; by default the
            field's type, and the help.
    """

    panel: str
    metavar: str
    help: str
    name: str = ""
    short: str = ""
    parse: Callable[[str], Any] = str
    default: str = ""
    apart: bool = False
    repeated: bool = False
    document_type: Any = None


class Argument(Option):
    """An option without a name, which the command line recognises by its position."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class OptionGroup:
    """The form of a field for which the command line has several options.

    Attributes:
        words: the dataclass of these options; its method ``value`` returns the value of the field.
        help: the description of the field for Python.
    """

    words: type
    help: str


class Converted(Generic[Given, Value]):
    """A field that takes a user's value, converts it, and holds the converted value.

    ``field: Converted[str, Color] = Converted(color_named, "red")``
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


# Type checkers are not told that it is frozen: mypy would take each Converted field that is
# inherited for what is given.
@dataclass_transform(kw_only_default=True, field_specifiers=(field,))
class Request:
    """A request, or a part of requests that several verbs share.

    Each subclass becomes a frozen dataclass whose fields are given as keywords.  In a subclass with
    ``kw_only=False`` the fields may also be given by position.
    """

    __dataclass_fields__: ClassVar[dict[str, Any]]

    def __init_subclass__(cls, *, kw_only: bool = True) -> None:
        dataclass(frozen=True, kw_only=kw_only)(cls)
        for each in fields(cls):
            for part in cls.__mro__:
                if isinstance(vars(part).get(each.name), property | cached_property):
                    raise TypeError(
                        f"the field {each.name} of {cls.__name__} has the name of a property of "
                        f"{part.__name__}: give one of them another name"
                    )

    @property
    def in_effect(self) -> dict[str, Any]:
        """Values for the scope of a report, by key; they replace the options' values there.

        A subclass returns values that took effect but are no option's value, such as the digest of
        a given file.  By default there are none.
        """
        return {}


class Field(NamedTuple):
    """A field of a request.

    Attributes:
        name: the name in Python.
        type: the type of the values that callers may give.
        held: the type of the value that the field holds.
        asked: the annotation that describes the field: an option, a group of options, or a text.
        default: the default value.
    """

    name: str
    type: Any
    held: Any
    asked: Option | OptionGroup | str | None
    default: Any

    @property
    def option(self) -> str:
        """The name of the field's option, which is also the field's key in documents."""
        return (isinstance(self.asked, Option) and self.asked.name) or self.name


def fields_of(request: type[Any]) -> Iterator[Field]:
    """The fields of a class of requests, in the order of the constructor."""
    hints = get_type_hints(request, include_extras=True)
    for each in fields(request):
        kind, asked = hints[each.name], None
        if get_origin(kind) is Annotated:
            kind, asked = get_args(kind)
        given, held = get_args(kind) if get_origin(kind) is Converted else (kind, kind)
        yield Field(each.name, given, held, asked, each.default)


def values_of(part: type[Request], request: object) -> dict[str, Any]:
    """The values of a request in the fields of ``part``, by the names of the fields."""
    return {each.name: getattr(request, each.name) for each in fields(part)}


def answers(
    request: Callable[P, Asked],
) -> Callable[[Callable[[Asked], Answer]], Callable[P, Answer]]:
    """Turn a function that takes a request into one that takes the request's fields as keywords.

    Type checkers know the keywords.  The docstring describes each keyword by the words of the help.
    """

    def made(answered: Callable[[Asked], Answer]) -> Callable[P, Answer]:
        @wraps(answered)
        def function(*args: P.args, **keywords: P.kwargs) -> Answer:
            return answered(request(*args, **keywords))

        return takes_fields(request)(function)

    return made


def takes_fields(
    request: Callable[..., Any],
    several: str = "",
    answered: Callable[[Any], Any] | None = None,
) -> Callable[[Callable[P, Answer]], Callable[P, Answer]]:
    """Give a function that takes the fields of a request a signature and a docstring with them.

    The decorated function takes the fields as keywords.  It is only called with legal keywords and,
    if the request names explorers, never inside another check.

    Args:
        request: the class of the request.
        several: the name of a field whose values the function takes as any number of positional
            arguments; empty if there is no such field.
        answered: the function that gives the same answer, but takes a request; :func:`answer` calls
            it.  By default it is the function that :func:`answers` has turned into the decorated
            function.
    """

    def made(function: Callable[P, Answer]) -> Callable[P, Answer]:
        of = {each.name: each for each in fields_of(request)}  # type: ignore[arg-type]  # a class
        plain = inspect.signature(request).parameters
        taken = [each.replace(annotation=of[name].type) for name, each in plain.items()]
        if several:
            given = inspect.Parameter(several, inspect.Parameter.VAR_POSITIONAL)
            taken = [given, *(each for each in taken if each.name != several)]
        plays = not of.keys().isdisjoint(EXPLORER_FIELDS)
        returned = inspect.signature(function).return_annotation
        signature = inspect.Signature(taken, return_annotation=returned)

        @wraps(function)
        def checked(*args: P.args, **keywords: P.kwargs) -> Answer:
            ensure_takes(function.__name__, signature, *args, **keywords)
            if plays:  # before a file that the request names is loaded
                ensure_outermost()
            return function(*args, **keywords)

        checked.__wrapped__ = answered or function  # type: ignore[assignment]  # for answer()
        checked.__signature__ = signature  # type: ignore[attr-defined]  # for those who ask
        checked.request = request  # type: ignore[attr-defined]  # for the command line
        text = inspect.cleandoc(function.__doc__ or "")
        checked.__doc__ = _with_arguments(text, [of[each.name] for each in taken])
        return checked

    return made


def ensure_takes(
    name: str, signature: inspect.Signature, /, *args: object, **keywords: object
) -> None:
    """Raise TypeError unless a function of that name and signature accepts these arguments.

    Raises:
        TypeError: with the words of Python's own error.
    """
    try:
        signature.bind(*args, **keywords)
    except TypeError as error:
        raise TypeError(f"{name}() {error}") from None


def answer(function: Callable[..., Answer], request: object) -> Answer:
    """Answer a request by a function that :func:`takes_fields` has made for its fields.

    The function that takes the request itself is called, see :func:`takes_fields`.
    """
    answered: Answer = inspect.unwrap(function)(request)
    return answered


def _with_arguments(text: str, fields_: Iterable[Field]) -> str:
    """The docstring with a section ``Args:`` that describes each field."""
    lines = ["Args:"]
    for each in fields_:
        about = each.asked if isinstance(each.asked, str) else getattr(each.asked, "help", "")
        lines.append(fill(f"    {each.name}: {about}", 96, subsequent_indent=" " * 8))
    head, raises, rest = text.partition("\n\nRaises:\n")
    return f"{head}\n\n" + "\n".join(lines) + raises + rest


def meant(request: object) -> dict[str, Any]:
    """The values of a request on which its answer depends, except the explorer, as JSON.

    A value that JSON cannot express is replaced by its name.  The key ``code`` holds the texts of
    users' programs, so that they can be loaded again, and the digests of given files.
    """
    values = [getattr(request, each.name) for each in _meant(type(request))]
    values.append(getattr(request, "given", None))
    codes = [code for value in values for code in getattr(value, "codes", ())]
    found = meant_by(type(request), request)
    return {**found, "code": {code.plain: code.record for code in codes}} if codes else found


def meant_by(part: type[Any], request: object) -> dict[str, Any]:
    """The values of a request in the options of ``part`` on which its answer depends, as JSON."""
    return {each.option: as_json(getattr(request, each.name)) for each in _meant(part)}


def as_json(value: object) -> Any:
    """The JSON value for a value of a request; a value that JSON cannot express becomes a text."""
    if isinstance(value, tuple | list):
        return [*value]
    if value is None or isinstance(value, str | int | float):
        return value
    return index(value) if isinstance(value, SupportsIndex) else str(value)


def given_again(part: type[Any], request: object, but: Iterable[str] = ()) -> list[str]:
    """The words of the command line that give the values of this part of a request again.

    Options with default values, and the fields in ``but``, are left out.
    """
    words, left, in_file = list[str](), {*but}, GIVEN_IN_FILE.get()
    for each in _meant(part):
        name, value = each.option.replace("_", "-"), as_json(getattr(request, each.name))
        needed = value != as_json(each.default) or (name in in_file and value is not None)
        if needed and each.name not in left:
            text = ",".join(map(str, value)) if isinstance(value, list) else str(value)
            words += [f"--{name}", text]
    return words


def remembered(request: type, options: Mapping[str, Any]) -> dict[str, Any]:
    """The keywords that make a request again from the options that :func:`meant` has returned."""
    return {each.name: options[each.option] for each in _meant(request)}


def without_effort(request: T) -> T:
    """A copy of the request with default values for the options on which no result depends.

    These are the options with ``apart``; only the option ``shard`` keeps its value.
    """
    apart = (
        each
        for each in fields_of(type(request))
        if isinstance(each.asked, Option) and each.asked.apart and each.name != "shard"
    )
    return replace(request, **{each.name: each.default for each in apart})  # type: ignore[type-var]


def in_scope(request: type[Any]) -> Iterator[Field]:
    """The fields of a request that are keys of the scope: they tell what is checked and how."""
    return (
        each
        for each in _meant(request)
        if isinstance(each.asked, Option) and each.asked.panel in (SCOPE, RULES)
    )


def _meant(request: type[Any]) -> Iterator[Field]:
    """The fields of a request that are options on which the answer depends."""
    for each in fields_of(request):
        if isinstance(each.asked, Option) and not each.asked.apart:
            yield each
