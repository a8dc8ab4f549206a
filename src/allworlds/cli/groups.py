"""Command lines from requests: each field of a verb's request becomes an option.

Typer makes the options from a signature that is made here. Other programs and people know its
messages and its help, so no other library takes its place.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, fields, is_dataclass
from functools import wraps
from inspect import Parameter, Signature, signature
from typing import Annotated, Any, get_args, get_type_hints

import typer

from allworlds.cli.files import Files, files_of
from allworlds.inputs import AS_IN_PYTHON, PANELS, Argument, InputError, Named, Option, fields_of

Words = Mapping[str, Any]
"""The values that the command line was given, by the names of the parameters."""


def grouped(verb: Callable[..., int], name: str) -> Callable[..., int]:
    """The verb with the signature that typer reads: an option for each field of its requests.

    A parameter of the verb is a request, that is a dataclass, or one option by itself; in place
    of :class:`Files` stand those that the verb of that name can write.
    """
    hints = get_type_hints(verb, include_extras=True)
    hints = {key: files_of(name) if hint is Files else hint for key, hint in hints.items()}
    taken = signature(verb).parameters.values()
    seen = [shown for each in taken for shown in _shown(each.name, hints[each.name], each.default)]
    seen.sort(key=_panel)

    @wraps(verb)
    def command(**words: Any) -> int:
        return verb(**{each.name: _value(each.name, hints[each.name], words) for each in taken})

    command.__signature__ = Signature(seen)  # type: ignore[attr-defined]  # for typer
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in seen}
    return command


def _shown(name: str, hint: Any, default: Any) -> Iterator[Parameter]:
    """The options and arguments by which a value is given."""
    if is_dataclass(hint):
        defaults = {field.name: field.default for field in fields(hint)}
        for field in fields_of(hint):  # type: ignore[arg-type]  # a class
            yield from _shown(field.name, Annotated[field.type, field.asked], defaults[field.name])
        return
    kind, asked = get_args(hint)
    if isinstance(asked, Named):
        yield from _shown(name, asked.words, default)
    elif isinstance(asked, Option):
        yield _parameter(name, kind, asked, default)


def _value(name: str, hint: Any, words: Words) -> Any:
    """The value of the field that these options give."""
    if is_dataclass(hint):
        told = [field for field in fields_of(hint) if isinstance(field.asked, Option | Named)]  # type: ignore[arg-type]
        return hint(**{f.name: _value(f.name, Annotated[f.type, f.asked], words) for f in told})  # type: ignore[operator]
    _, asked = get_args(hint)
    if isinstance(asked, Named):
        return _value(name, asked.words, words).value()
    return words[name]


def _parameter(name: str, kind: Any, asked: Option, default: Any) -> Parameter:
    """One option or argument, as a parameter that typer reads."""
    told: dict[str, Any] = {"metavar": asked.metavar, "help": asked.help}
    if asked.parse is not str:
        told["parser"] = _read_by(asked.parse)
    if asked.default is not AS_IN_PYTHON:
        default = asked.default
    if isinstance(asked, Argument):
        option = typer.Argument(**told)
    else:
        # Without its name a flag would get an opposite, such as --no-watch.
        own = asked.name or (name.replace("_", "-") if kind is bool else "")
        names = [f"--{own}"] if own else []
        names += [f"-{asked.short}"] if asked.short else []
        option = typer.Option(*names, rich_help_panel=asked.panel, **told)
    seen: Any = bool if kind is bool else list[str] if asked.repeated else str
    if default is None:
        seen |= None
    return Parameter(
        name,
        Parameter.KEYWORD_ONLY,
        default=Parameter.empty if default in (MISSING, Parameter.empty) else default,
        annotation=Annotated[seen, option],
    )


def _panel(parameter: Parameter) -> int:
    """Where the panel of an option stands; arguments have none, and come first."""
    (option,) = parameter.annotation.__metadata__
    return ("", *PANELS).index(option.rich_help_panel or "")


class _Refused(typer.BadParameter):
    """A line about bad input that names the option itself."""

    def format_message(self) -> str:
        return self.message


def _read_by(parse: Callable[[str], Any]) -> Callable[[Any], Any]:
    """A parser for typer. Typer also calls it with defaults, which may be values already."""

    def read(text: Any) -> Any:
        try:
            return parse(text) if isinstance(text, str) else text
        except InputError as error:
            raise _Refused(str(error)) from None
        except ValueError as error:
            raise typer.BadParameter(str(error)) from None

    return read
