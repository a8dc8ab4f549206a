"""Requests: the arguments of a verb as one value.

A *verb* is a command such as ``check``, which is also a function in Python.  Its *request* is an
object of a class of its own, a subclass of :class:`Request`, with a field for each argument.  The
class inherits most fields from *parts*, which are classes that several verbs share.  Each field has
a type, a default and an annotation: an :class:`Option` describes the form of the field on the
command line, and a plain text describes a field that only Python has.  Three things are made from
this class: the function in Python (:func:`answers`), the command line (``allworlds.cli.app``), and
the values by which a run directory is recognised (:func:`meant`).
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
    """The name of a panel, as the attribute ``panel`` of an option that is rarely needed.

    The other options of the same panel have the name as a plain text.  If a verb has many options,
    ``--help`` leaves out those that are rarely needed, and ``--help-all`` shows all options.  If a
    verb has few options, ``--help`` shows them all.
    """

    __slots__ = ()


RARE_SCOPE, RARE_RULES, RARE_EFFORT = Rare(SCOPE), Rare(RULES), Rare(EFFORT)

EXPLORER_FIELDS = ("explore", "explorers")
"""The fields of requests that name explorers to be played."""

GIVEN_IN_FILE: ContextVar[frozenset[str]] = ContextVar("given in a file", default=frozenset())
"""The names of the options whose defaults a user's file sets.  Commands that are printed name these
options even if they have their default values, so that the commands do not depend on the file."""


@dataclass(frozen=True, slots=True)
class Option:
    """The form of a field on the command line.

    Attributes:
        panel: the panel of the help in which the option is shown; of the class :class:`Rare` if the
            option is rarely needed.
        metavar: the word for the value in the help; empty for a flag.
        help: the description in a line or two, also for Python.
        name: the name of the option, without dashes; by default the name of the field.
        short: a letter as a second name.
        parse: the function that makes the value of the field from the text on the command line.
        default: the text that is parsed if the option is not given; if this text is empty, the
            default of the field is taken instead.
        apart: whether results are independent of the option, because the option only tells where,
            how long or for whom a job is done.
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
        words: the class of requests with these options; its method ``value`` returns the value of
            the field.
        help: the description of the field for Python.
    """

    words: type
    help: str


class Converted(Generic[Given, Value]):
    """A field that takes a user's value, converts the value, and holds the result.

    In a class with ``field: Converted[str, Color] = Converted(color_named, "red")`` the user gives
    a ``str``, the function ``color_named`` makes a ``Color`` from it, and the field holds this
    ``Color``; if the user gives nothing, "red" is converted.
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
        """Values that the scope of a report shows in addition to the values of the options.

        The result holds each value by its key in the scope: for example the digests of given files
        by the key ``sha256``, and the shard, as a text, by the key ``shard``.  If an option has one
        of these keys, the scope shows the value of this result.  By default there are no such
        values; a subclass adds its own.
        """
        return {}


class Field(NamedTuple):
    """A field of a request.

    Attributes:
        name: the name in Python.
        type: the type of the values that callers may give.
        held: the type of the value that the field holds; another one than ``type`` if the field is
            a :class:`Converted`.
        asked: the annotation that describes the field: an option, a group of options, or a text;
            None without an annotation.
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
    """The fields of a class of requests, in the order of the constructor's arguments."""
    hints = get_type_hints(request, include_extras=True)
    for each in fields(request):
        kind, asked = hints[each.name], None
        if get_origin(kind) is Annotated:
            kind, asked = get_args(kind)
        given, held = get_args(kind) if get_origin(kind) is Converted else (kind, kind)
        yield Field(each.name, given, held, asked, each.default)


def values_of(part: type[Request], request: object) -> dict[str, Any]:
    """The values that ``request`` has in the fields of the class ``part``, by the fields' names.

    ``request`` needs attributes of these names; its class need not inherit from ``part``.
    """
    return {each.name: getattr(request, each.name) for each in fields(part)}


def answers(
    request: Callable[P, Asked],
) -> Callable[[Callable[[Asked], Answer]], Callable[P, Answer]]:
    """Turn a function that takes a request into one that takes the request's fields as keywords.

    ``request`` is the class of the request; the result is a decorator.  Type checkers know the
    keywords of the new function, and its docstring describes each keyword in the words of the help.
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
    """Return a decorator for a function whose keywords are the fields of a request.

    The decorator returns a new function, with a signature and a docstring that list all these
    fields.  The new function calls the decorated one only with legal keywords and, if the request
    names explorers, never inside another check.

    Args:
        request: the class of the request.
        several: the name of a field whose values the function takes as any number of positional
            arguments; empty if there is no such field.
        answered: a function that returns the same answer as the decorated function, but takes an
            object of the class ``request``; :func:`answer` calls it.  None is legal only if the
            decorated function is itself a wrapper (by ``functools.wraps``) round such a function,
            as in :func:`answers`: then ``answer`` calls the function inside the wrapper.
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
    """Raise TypeError unless a function with this name and signature accepts these arguments.

    Raises:
        TypeError: with the words that Python itself uses for such an error.
    """
    try:
        signature.bind(*args, **keywords)
    except TypeError as error:
        raise TypeError(f"{name}() {error}") from None


def answer(function: Callable[..., Answer], request: object) -> Answer:
    """The answer of a verb to a request that is given as one object.

    A verb takes the fields of its request as keywords, but there is always another function that
    takes the request itself.  That function is called.  The verb is not called, so its checks of
    the keywords are left out.

    Args:
        function: a function made by :func:`takes_fields` or :func:`answers`, such as a verb.  The
            other function is the argument ``answered`` of ``takes_fields``, or the function that
            ``answers`` decorated.
        request: the request.
    """
    answered: Answer = inspect.unwrap(function)(request)
    return answered


def _with_arguments(text: str, fields_: Iterable[Field]) -> str:
    """The docstring ``text`` with a further section ``Args:``, which describes each field.

    The new section stands before the section ``Raises:``, if there is one.
    """
    lines = ["Args:"]
    for each in fields_:
        about = each.asked if isinstance(each.asked, str) else getattr(each.asked, "help", "")
        lines.append(fill(f"    {each.name}: {about}", 96, subsequent_indent=" " * 8))
    head, raises, rest = text.partition("\n\nRaises:\n")
    return f"{head}\n\n" + "\n".join(lines) + raises + rest


def meant(request: object) -> dict[str, Any]:
    """The values of a request's options on which its answer depends, as JSON, by option names.

    The explorer is not among them.  A value that JSON cannot express is replaced by its text.  If
    the request uses programs or files of a user, the further key ``code`` holds the texts of the
    programs, so that they can be loaded again, and the digests of the files.
    """
    values = [getattr(request, each.name) for each in _meant(type(request))]
    values.append(getattr(request, "given", None))
    codes = [code for value in values for code in getattr(value, "codes", ())]
    found = meant_by(type(request), request)
    return {**found, "code": {code.plain: code.record for code in codes}} if codes else found


def meant_by(part: type[Any], request: object) -> dict[str, Any]:
    """The values of ``request`` in those options of ``part`` on which the answer depends, as JSON.

    ``part`` is a class of requests whose fields ``request`` has; the keys are the options' names.
    """
    return {each.option: as_json(getattr(request, each.name)) for each in _meant(part)}


def as_json(value: object) -> Any:
    """The JSON value for the value of a field; a value that JSON cannot express becomes a text."""
    if isinstance(value, tuple | list):
        return [*value]
    if value is None or isinstance(value, str | int | float):
        return value
    return index(value) if isinstance(value, SupportsIndex) else str(value)


def given_again(part: type[Any], request: object, but: Iterable[str] = ()) -> list[str]:
    """The options of a command line, with their values, by which a request can be given again.

    An option is left out if its value is the default.  But if a user's file sets the default (see
    :data:`GIVEN_IN_FILE`), the option is written, because the file may be missing the next time.

    Args:
        part: the class of requests whose options are written, if the answer depends on them.
        request: the request, which has the fields of ``part``.
        but: the names of fields whose options are left out, whatever their values.
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
    """The keywords from which the class ``request`` makes a request again.

    ``options`` holds the values that :func:`meant` has returned for the earlier request.
    """
    return {each.name: options[each.option] for each in _meant(request)}


def without_effort(request: T) -> T:
    """A copy of the request with default values for the options on which no result depends.

    These are the options whose attribute ``apart`` is true; but the option ``shard`` keeps its
    value.
    """
    apart = (
        each
        for each in fields_of(type(request))
        if isinstance(each.asked, Option) and each.asked.apart and each.name != "shard"
    )
    return replace(request, **{each.name: each.default for each in apart})  # type: ignore[type-var]


def in_scope(request: type[Any]) -> Iterator[Field]:
    """The fields of a class of requests that are keys of a report's scope.

    They are the options that tell what is checked, or how it is judged.
    """
    return (
        each
        for each in _meant(request)
        if isinstance(each.asked, Option) and each.asked.panel in (SCOPE, RULES)
    )


def _meant(request: type[Any]) -> Iterator[Field]:
    """The fields of a class of requests that are options on which the answer depends."""
    for each in fields_of(request):
        if isinstance(each.asked, Option) and not each.asked.apart:
            yield each
