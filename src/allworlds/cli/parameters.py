"""Requests on the command line: each field of a request is an option or an argument.

A *request* holds all values that the user gives to a verb; see ``inputs.requests``.  On the command
line a request consists of one or more *parts*.  A part is an object of a dataclass, and each of its
fields is an option or an argument.  This module makes click's options and arguments from the
classes of the parts, and makes the parts from the values that the user gives.
"""

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import MISSING, dataclass
from typing import Any

import rich_click as click
from click.shell_completion import CompletionItem

from allworlds.cli.output import say
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import (
    Argument,
    Field,
    Option,
    OptionGroup,
    Rare,
    fields_of,
)

MOST = 16
"""The most options of a verb for which ``--help`` shows all of them.

If a verb has more options, ``--help`` leaves out rare ones, and ``--help-all`` shows all.
"""


def parameters_of(parts: Collection[type]) -> list[click.Parameter]:
    """The arguments and options of a verb; ``parts`` are the classes of the parts of its request.

    If there are many options, the option ``--help-all`` is added.
    """
    fields = [field for part in parts for field in _words_of(part)]
    rare = len(fields) >= MOST  # with --help
    more = [printing(["--help-all"], "Show every option.", _whole_help)] if rare else []
    return [*(_parameter(field, rare=rare) for field in fields), *more]


def _words_of(part: type) -> Iterator[Field]:
    """Yield the fields of a part of a request that are options or arguments on the command line.

    ``part`` is the class of the part.  If the annotation of a field is an :class:`OptionGroup`, the
    command line has several options for the field; they are yielded in its place.
    """
    for field in fields_of(part):
        if isinstance(field.asked, OptionGroup):
            yield from _words_of(field.asked.words)
        elif isinstance(field.asked, Option):
            yield field


def request_of(part: type, given: Mapping[str, Any]) -> Any:
    """Make a part of a request from the values of its fields.

    Args:
        part: the class of the part.
        given: the values by the names of the fields.  A field whose value is None, or missing, gets
            the default of the class.
    """
    found = {}
    for field in fields_of(part):
        if isinstance(field.asked, OptionGroup):
            found[field.name] = request_of(field.asked.words, given).value()
        elif given.get(field.name) is not None:
            found[field.name] = given[field.name]
    return part(**found)


def _parameter(field: Field, *, rare: bool) -> click.Parameter:
    """The click option or argument for a field of a request.

    Args:
        field: the field.
        rare: whether the verb has so many options that ``--help`` hides those that are rarely
            needed.  An option is rarely needed if its panel (its group in the help) is of the class
            :class:`Rare`.
    """
    asked: Any = field.asked
    names, help_ = [field.name], asked.help
    default = asked.default or field.default
    if default is not None and default is not MISSING:
        help_ += f" [default: {default}]"
    settings: dict[str, Any] = {"help": help_, "metavar": asked.metavar, "callback": Reader(asked)}
    settings |= {"required": default is MISSING, "shell_complete": _complete}
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
    missing = [asked.default] if asked.default else None
    return click.RichOption(names, multiple=True, default=missing, **settings, **shown)


def _complete(_context: object, _parameter: object, begun: str) -> list[CompletionItem]:
    """The reply to a shell that completes the word ``begun``: complete this word as a path.

    Most values of options are paths or free texts.
    """
    return [CompletionItem(begun, type="file")]


@dataclass(frozen=True, slots=True)
class Reader:
    """A function that turns the texts given on the command line for a field into its value.

    Attributes:
        asked: the description of the field's option, which says how a text is parsed, and whether
            the option may be repeated.
    """

    asked: Option

    def __call__(self, _context: click.Context, parameter: click.Parameter, given: Any) -> Any:
        """The value of the field; click calls this function.

        For an option that may be repeated the result is a list with the value of each text.  If no
        text is given, the result is None.

        Args:
            parameter: click's option or argument for the field, whose name is used in errors.
            given: the user's text, or all texts if the option was repeated; None for no text.

        Raises:
            InputError: naming a text that is no legal value, or an option that is given twice.
        """
        name, texts = parameter.opts[0], [given] if isinstance(given, str) else [*(given or ())]
        if len(texts) > 1 and not self.asked.repeated:
            raise InputError(f"{name} is {show(texts[0])} and {show(texts[1])}; give it once")
        values = [_read_one(self.asked, name, text) for text in texts] or None
        return values[0] if values and not self.asked.repeated else values


def _read_one(asked: Option, name: str, text: str) -> Any:
    try:
        return asked.parse(text)
    except ValueError as error:
        said = str(error) if show(text) in str(error) else f"{error}, not {show(text)}"
        if not isinstance(error, InputError):  # which names the option
            said = f"Invalid value for '{name}': {said}"
        raise InputError(said) from None


def printing(names: list[str], help_: str, text: Callable[[click.Context], str]) -> click.Option:
    """A click option such as ``--help``: if it is given, the command prints a text and ends.

    Args:
        names: the names of the option, with dashes.
        help_: the description of the option in the help.
        text: the function that returns the text for the context of a command.
    """

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
