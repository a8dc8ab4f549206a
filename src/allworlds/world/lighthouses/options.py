"""The options of a kind of lighthouse, which are fields of its class."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import fields
from functools import cache
from typing import Any, Literal, NamedTuple, TypeAlias, get_args, get_origin, get_type_hints

from msgspec import Meta

from allworlds.documents.document import IF_ANY, NOT_IN_DOCUMENT
from allworlds.inputs.checks import InputError, did_you_mean, integer, show
from allworlds.protocol.importing import pairs_in


class InvalidWorld(InputError):
    """Raised if a map, a start and a lighthouse do not make a world."""


def refuse_other_keys(what: str, document: Mapping[str, Any], legal: Sequence[str]) -> None:
    """Raise InvalidWorld unless all keys are legal, since a misspelt key would have no effect.

    ``what`` is the noun for the document in the error.
    """
    for key in document:
        if key not in legal:
            raise InvalidWorld(f"{show(key)} is no key of a {what}; legal are {', '.join(legal)}")


def the_integer(what: str, value: object) -> int:
    """The value as an ``int``; raise InvalidWorld if it is no integer.

    ``what`` names the value in the error.
    """
    try:
        return integer(value)
    except TypeError:
        raise InvalidWorld(f"{what} = {show(value)} is not an integer") from None


OptionValue: TypeAlias = int | bool | str | tuple[str, ...]

PLACE = ("dart", "darts", "parts")
"""The names of the fields that hold a lighthouse's place, and are no options."""


class FieldOption(NamedTuple):
    """An option of a kind of lighthouse.

    Attributes:
        default: the default value; all values have the same type as the default.
        limits: the limits of an integer, or the pattern of a text; None if there are none.
        legal: the legal words; if the option's value is a tuple, it may hold each word once.
        always: whether a JSON document names the option even if its value is the default.
    """

    default: OptionValue
    limits: Meta | None = None
    legal: tuple[str, ...] = ()
    always: bool = True

    @property
    def alone(self) -> bool:
        """Whether this is the kind's only option, so that its value is written without its name."""
        return type(self.default) is tuple or bool(self.limits and self.limits.pattern)

    def of_text(self, what: str, text: str) -> OptionValue:
        """The value that the text behind ``key=`` means; ``what`` names the option in errors.

        Raises:
            InvalidWorld: naming the text and what would be legal.
        """
        value: object = text
        if isinstance(self.default, bool):
            value = {"true": True, "false": False}.get(text, text)
        elif isinstance(self.default, int) and re.fullmatch("-?[0-9]{1,18}", text):
            value = int(text)
        elif isinstance(self.default, tuple):
            value = text.split(",")
        return self.checked(what, value)

    def checked(self, what: str, value: Any) -> OptionValue:
        """The value, if it is legal; ``what`` names the option in errors.

        Raises:
            InvalidWorld: naming the value and what would be legal.
        """
        kind = type(self.default)
        if kind is int:
            value = the_integer(what, value)
            least, most = self.limits and self.limits.ge, self.limits and self.limits.le
            if least is not None and value < least:
                raise InvalidWorld(f"{what} = {show(value)} is less than {least}, the least one")
            if most is not None and value > most:
                raise InvalidWorld(f"{what} = {show(value)} is more than {most}")
        elif kind is tuple:
            legal = f"legal are {', '.join(self.legal)}, each once"
            if not isinstance(value, list | tuple) or not value:
                raise InvalidWorld(f"{what} = {show(value)} is no list of words; {legal}")
            for word in value:
                if word not in self.legal or value.count(word) > 1:
                    raise InvalidWorld(f"{what} names {show(word)}; {legal}")
            value = tuple(value)
        elif not isinstance(value, kind):
            wrong = "neither true nor false" if kind is bool else "not a text"
            raise InvalidWorld(f"{what} = {show(value)} is {wrong}")
        elif self.legal and value not in self.legal:
            raise InvalidWorld(f"{what} = {show(value)}; legal are {' and '.join(self.legal)}")
        elif (
            self.limits
            and self.limits.pattern
            and not re.fullmatch(self.limits.pattern, str(value))
        ):
            raise InvalidWorld(
                f"{what} = {show(value)} is no pattern; legal are digits, one of which may have a "
                "* behind it, as in word:12 and word:10*"
            )
        found: OptionValue = value
        return found


@cache
def options_of(kind: Any) -> dict[str, FieldOption]:
    """The options of a class of lighthouses, in the order of its fields.

    A class that a user's function has made has no options; only the function has arguments.
    """
    if kind.code is not None and kind.code.arguments:
        return {}
    # The annotations of a user's class may be texts that cannot be evaluated here.
    hints = get_type_hints(kind, include_extras=True) if kind.code is None else {}
    found = {each.name: _option(each, hints.get(each.name)) for each in fields(kind)}
    return {name: option for name, option in found.items() if option}


def _option(field: Any, hint: Any) -> FieldOption | None:
    notes = getattr(hint, "__metadata__", ())
    of_place = field.name in PLACE or NOT_IN_DOCUMENT in notes
    if of_place or not field.init or type(field.default) not in (int, str, bool, tuple):
        return None
    limits = (
        note
        for note in notes
        if isinstance(note, Meta) and (note.ge is not None or note.pattern is not None)
    )
    return FieldOption(
        field.default, next(limits, None), _words_in(hint), always=IF_ANY not in notes
    )


def _words_in(hint: Any) -> tuple[str, ...]:
    """The words of the ``Literal`` in a type; empty if the type has no ``Literal``."""
    if get_origin(hint) is Literal:
        return get_args(hint)
    return next((words for part in get_args(hint) if (words := _words_in(part))), ())


def kind_with(kind: Any, options: Mapping[str, OptionValue]) -> Any:
    """A class like ``kind`` in which some options have other values.

    ``options`` has the values, which must be legal, by the names of the options.  A call of the new
    class makes a lighthouse of the class ``kind`` with these values in its fields.  Calls of this
    function with equal values return the same class.
    """
    of = options_of(kind)
    other = [
        (key, options[key]) for key in of if options.get(key, of[key].default) != of[key].default
    ]
    return _another_kind(kind, tuple(other)) if other else kind


@cache
def _another_kind(kind: Any, options: tuple[tuple[str, OptionValue], ...]) -> Any:
    given, names = dict(options), [each.name for each in fields(kind)]

    def made(_: object, *values: Any, **named: Any) -> Any:
        return kind(**{**given, **dict(zip(names, values, strict=False)), **named})

    own = {"__new__": made, "__doc__": kind.__doc__, "__module__": kind.__module__}
    return type(kind.__name__, (kind,), {**given, **own, "chosen": given})


def options_in(kind: Any, name: str, text: str) -> dict[str, OptionValue]:
    """The options that the text ``key=value,...`` behind the name of a kind gives.

    ``name`` is the name of the kind, for errors.

    Raises:
        InvalidWorld: naming the option, or the value, that is not legal for the kind.
    """
    for key, option in options_of(kind).items():
        if option.alone:
            return {key: option.of_text(f"the lighthouse {name}", text)}
    try:
        pairs = pairs_in(f"{name}:{text}", text)
    except InputError as error:
        raise InvalidWorld(str(error)) from None
    return {key: _legal(kind, name, key).of_text(f"option {key}", value) for key, value in pairs}


def ensure_options(kind: Any, name: str, given: Mapping[str, object]) -> dict[str, OptionValue]:
    """The options ``given``, which come from a JSON document, after a check that they are legal.

    ``name`` is the name of the kind of lighthouse, for errors.

    Raises:
        InvalidWorld: naming the option, or the value, that is not legal for the kind.
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
    hint = did_you_mean(key, of)
    raise InvalidWorld(f"the lighthouse {show(name)} has no option {show(key)}; {legal}{hint}")


def values_in(placed: Any) -> dict[str, OptionValue]:
    """The options of a lighthouse whose values differ from their defaults, by their names.

    One option is included even if its value is the default: the pattern of the lighthouse ``word``.
    So the name of this kind always shows the pattern, as in ``word:12``.
    """
    kind: Any = type(placed)
    values = {key: (getattr(placed, key), option) for key, option in options_of(kind).items()}
    return {
        key: value
        for key, (value, option) in values.items()
        if value != option.default or (option.alone and type(value) is str)
    }


def ensure_legal(placed: Any) -> None:
    """Raise InvalidWorld unless the options of a lighthouse are legal."""
    kind: Any = type(placed)
    for key, option in options_of(kind).items():
        option.checked(f"lighthouse.{key}", getattr(placed, key))


def named_with(kind: Any, options: Mapping[str, OptionValue]) -> str:
    """The name of the kind of lighthouse ``kind``, with the options ``options`` in the name."""
    if kind.code is not None:
        return with_arguments(kind.code.name, options)
    of = options_of(kind)
    words = {key: (text,) for key, text in options.items() if of[key].alone and type(text) is str}
    return with_arguments(kind.kind, {**options, **words}, ":")


def with_arguments(name: str, arguments: Mapping[str, Any], mark: str = "?") -> str:
    """The text ``NAME?key=value,...``, with ``mark`` in place of the question mark.

    If an argument is a tuple of words, the words stand there with commas between, and without the
    key, as in ``told:n,m``.  If there are no arguments, the text is the name alone.
    """
    texts = [
        ",".join(value)
        if isinstance(value, tuple)
        else f"{key}={str(value).lower() if isinstance(value, bool) else value}"
        for key, value in arguments.items()
    ]
    return f"{name}{mark}{','.join(texts)}" if texts else name


@cache
def place_keys(kind: Any) -> tuple[str, ...]:
    """The keys at the top of a lighthouse's JSON object that stand for fields of its class.

    For a built-in kind these are the fields of the place and the options.  For a user's kind they
    are the fields of the place alone, because the options stand below the one key ``options``.
    """
    if kind.code is not None:
        return tuple(each.name for each in fields(kind) if each.name not in options_of(kind))
    hints = get_type_hints(kind, include_extras=True)
    notes = {key: getattr(hint, "__metadata__", ()) for key, hint in hints.items()}
    return tuple(each.name for each in fields(kind) if NOT_IN_DOCUMENT not in notes[each.name])
