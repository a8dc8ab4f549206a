"""Requests on the command line: an option or an argument for each field.

From the values of the options and arguments the request is made again.
"""

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import MISSING
from functools import partial
from typing import Any

import rich_click as click
from click.shell_completion import CompletionItem

from allworlds.cli.output import say
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import (
    AS_IN_PYTHON,
    Argument,
    Field,
    Option,
    OptionGroup,
    Rare,
    fields_of,
)

MOST = 16
"""Options that the help of a verb shows at most; the others stand behind --help-all."""


def parameters_of(parts: Collection[type]) -> list[click.Parameter]:
    """The arguments and options of a verb that takes these parts of requests."""
    fields = [field for part in parts for field in _words_of(part)]
    rare = len(fields) >= MOST  # with --help
    more = [printing(["--help-all"], "Show every option.", _whole_help)] if rare else []
    return [*(_parameter(field, rare=rare) for field in fields), *more]


def _words_of(part: type) -> Iterator[Field]:
    """The fields that the command line gives by one option each, also those of groups."""
    for field in fields_of(part):
        if isinstance(field.asked, OptionGroup):
            yield from _words_of(field.asked.words)
        elif isinstance(field.asked, Option):
            yield field


def request_of(part: type, given: Mapping[str, Any]) -> Any:
    """Make the part of a request of these values, by the names of fields; others are as in Python.

    An option may have a default that means something else in Python.
    """
    found = {}
    for field in fields_of(part):
        asked = field.asked
        if isinstance(asked, OptionGroup):
            found[field.name] = request_of(asked.words, given).value()
        elif isinstance(asked, Option) and field.name in given:
            found[field.name] = given[field.name]
        elif isinstance(asked, Option) and asked.default is not AS_IN_PYTHON:
            found[field.name] = asked.parse(asked.default)
    return part(**found)


def _parameter(field: Field, *, rare: bool) -> click.Parameter:
    """The option or the argument of a field; rare ones may be hidden."""
    asked: Any = field.asked
    names, help_ = [field.name], asked.help
    default = field.default if asked.default is AS_IN_PYTHON else asked.default
    if default is not None and default is not MISSING:
        help_ += f" [default: {default}]"
    settings: dict[str, Any] = {
        "help": help_,
        "metavar": asked.metavar,
        "shell_complete": _complete,
    }
    settings |= {"required": default is MISSING, "callback": partial(_read, asked)}
    if isinstance(asked, Argument):
        argument = click.RichArgument(names, nargs=-1 if asked.repeated else 1, **settings)
        argument.opts = [asked.metavar.replace("[", "").replace("]", "")]  # as the help has it
        return argument
    if asked.name or field.type is bool or not asked.short:  # a letter may be the only name
        names.append("--" + (asked.name or field.name.replace("_", "-")))
    if asked.short:
        names.append("-" + asked.short)
    shown: dict[str, Any] = {
        "panel": str(asked.panel),
        "hidden": rare and isinstance(asked.panel, Rare),
    }
    if field.type is bool:
        return click.RichOption(names, help=asked.help, is_flag=True, **shown)
    return click.RichOption(names, multiple=True, **settings, **shown)


def _complete(_context: object, _parameter: object, begun: str) -> list[CompletionItem]:
    """Let a shell complete paths: most values are files, or free."""
    return [CompletionItem(begun, type="file")]


def _read(asked: Option, _context: click.Context, parameter: click.Parameter, given: Any) -> Any:
    """Read the texts that an option was given; there is one, unless the field has a list."""
    name, texts = parameter.opts[0], [given] if isinstance(given, str) else [*(given or ())]
    if asked.repeated:
        return [_read_one(asked, name, text) for text in texts]
    if len(texts) > 1:
        raise InputError(f"{name} is {show(texts[0])} and {show(texts[1])}; give it once")
    return _read_one(asked, name, texts[0]) if texts else None


def _read_one(asked: Option, name: str, text: str) -> Any:
    try:
        return asked.parse(text)
    except ValueError as error:
        said = str(error) if show(text) in str(error) else f"{error}, not {show(text)}"
        if not isinstance(error, InputError):  # which names the option
            said = f"Invalid value for '{name}': {said}"
        raise InputError(said) from None


def printing(names: list[str], help_: str, text: Callable[[click.Context], str]) -> click.Option:
    """An option with which a command prints a text, and does nothing else."""

    def act(context: click.Context, _option: click.Parameter, wanted: bool) -> None:
        if wanted and not context.resilient_parsing:
            say(lambda: text(context))
            context.exit()

    return click.RichOption(
        names, help=help_, is_flag=True, is_eager=True, expose_value=False, callback=act
    )


def _whole_help(context: click.Context) -> str:
    options: list[Any] = context.command.params
    for option in options:
        option.hidden = False
    return context.get_help()
