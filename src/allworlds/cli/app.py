"""The command line: commands, groups, help."""

import os
import shutil
import sys
import threading
import traceback
from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, fields, is_dataclass
from functools import cache, wraps
from importlib import import_module
from inspect import Parameter, Signature, signature
from itertools import pairwise
from pathlib import Path
from pkgutil import resolve_name
from typing import Annotated, Any, NoReturn, get_args, get_type_hints

import typer

from allworlds.cli.defaults import Defaults, begin, defaults_here
from allworlds.cli.output import (
    OutputGroup,
    abandon_stdout,
    answered,
    complain,
    emit,
    ensure_directory,
    output_of,
    prepare_streams,
    printable,
    say,
)
from allworlds.inputs.checks import InputError, OutOfTime, at_interrupts, keep_exit_code, show
from allworlds.inputs.requests import (
    AS_IN_PYTHON,
    PANELS,
    Argument,
    Option,
    OptionGroup,
    Rare,
    fields_of,
)
from allworlds.outcome import Exit, NoResult
from allworlds.verbs import GROUPS, VERBS, Verb

MOST = 16
"""Options that the help of a verb shows at most; the others stand behind --help-all."""

NARROW = 80
"""Columns below which the help is plain text: in the columns of its tables names would be cut."""


def made_helpful(command: Any) -> Any:
    """The command and all its subcommands with this layout of the help."""
    for below in getattr(command, "commands", {}).values():
        made_helpful(below)
    if shutil.get_terminal_size().columns < NARROW:
        command.rich_markup_mode = None
    for param in command.params:
        if param.param_type_name == "argument":
            _show_as_written(param)
        elif param.is_flag:
            param.metavar = ""
        elif not param.multiple:
            _take_once(param)
    own = command.get_help_option

    def help_option(context: Any) -> Any:
        option = own(context)
        if option is not None:
            option.metavar = ""
            option.callback = _help
        return option

    command.get_help_option = help_option
    return command


def _take_once(option: Any) -> None:
    """Refuse the option where it is given twice; by itself the last value would win."""
    consume = option.consume_value

    def add_to_parser(parser: Any, _context: Any) -> None:
        parser.add_option(option, option.opts, dest=option.name, action="append")

    def consume_value(context: Any, given: Mapping[str, Any]) -> Any:
        if option.name not in given:
            return consume(context, given)
        value, *more = given[option.name]
        if more and not context.resilient_parsing:
            raise _Refused(f"{option.opts[0]} is {show(value)} and {show(more[0])}; give it once")
        return consume(context, {**given, option.name: value})

    option.add_to_parser, option.consume_value = add_to_parser, consume_value


def _help(context: typer.Context, option: typer.CallbackParam, wanted: bool) -> None:
    if wanted and not context.resilient_parsing:
        params: Any = context.command.params if option.name == HELP_ALL else ()
        for param in params:
            param.hidden = False
        say(context.get_help)
        context.exit()


def _show_as_written(argument: Any) -> None:
    """Show the argument in the usage line by its metavar, without further brackets."""
    metavar = argument.metavar
    argument.make_metavar = lambda *_, **__: metavar
    argument.get_usage_pieces = lambda *_, **__: [metavar]


def plain_command(verb: Verb) -> Callable[..., int]:
    """The function that runs a verb on the command line: it answers, and writes."""
    function = resolve_name(verb.path)

    def command(request: Any, *, output: OutputGroup) -> int:
        from allworlds.engines.limits import WorkerOptions
        from allworlds.studies.user_corpus import CorpusOptions

        if isinstance(request, CorpusOptions):
            ensure_directory(request.corpus)
        report = answered(function, request, output)
        workers = request.workers if isinstance(request, WorkerOptions) else None
        return emit(report, output, workers)

    hints = {"request": function.request, "output": OutputGroup, "return": int}
    command.__annotations__ = hints
    command.__doc__ = f"Example: allworlds {verb.name} {verb.example}".rstrip() + f"\n\n{verb.help}"
    return command


Words = Mapping[str, Any]
"""The values that the command line was given, by the names of the parameters."""


def grouped(verb: Callable[..., int], name: str) -> Callable[..., int]:
    """The verb with the signature that typer reads: an option for each field of its requests.

    A parameter of the verb is a request, that is a dataclass, or one option by itself; in place
    of :class:`OutputGroup` stands that of the verb of that name.
    """
    hints = get_type_hints(verb, include_extras=True)
    hints = {key: output_of(name) if hint is OutputGroup else hint for key, hint in hints.items()}
    taken = signature(verb).parameters.values()
    seen = [shown for each in taken for shown in _shown(each.name, hints[each.name], each.default)]
    seen.sort(key=_panel)
    rare = [told for each in seen for told in each.annotation.__metadata__ if told.hidden]
    if len(seen) + 1 > MOST:  # with --help
        seen.append(_help_all())
    else:
        for told in rare:
            told.hidden = False

    @wraps(verb)
    def command(**words: Any) -> int:
        from allworlds.engines.limits import deadline_after, models_bounded

        with models_bounded(deadline_after(words.get("time_limit"))):
            given = {each.name: _value(each.name, hints[each.name], words) for each in taken}
        return verb(**given)

    command.__signature__ = Signature(seen)  # type: ignore[attr-defined]  # for typer
    return command


def _shown(name: str, hint: Any, default: Any) -> Iterator[Parameter]:
    """The options and arguments by which a value is given."""
    if is_dataclass(hint):
        defaults = {field.name: field.default for field in fields(hint)}
        for field in fields_of(hint):  # type: ignore[arg-type]  # a class
            yield from _shown(field.name, Annotated[field.type, field.asked], defaults[field.name])
        return
    kind, asked = get_args(hint)
    if isinstance(asked, OptionGroup):
        yield from _shown(name, asked.words, default)
    elif isinstance(asked, Option):
        yield _parameter(name, kind, asked, default)


def _value(name: str, hint: Any, words: Words) -> Any:
    """The value of the field that these options give."""
    if is_dataclass(hint):
        told = [field for field in fields_of(hint) if isinstance(field.asked, Option | OptionGroup)]  # type: ignore[arg-type]
        return hint(**{f.name: _value(f.name, Annotated[f.type, f.asked], words) for f in told})  # type: ignore[operator]
    _, asked = get_args(hint)
    if isinstance(asked, OptionGroup):
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
        # Without its name a flag would get an opposite, such as --no-estimate.
        own = asked.name or (name.replace("_", "-") if kind is bool else "")
        names = [f"--{own}"] if own else []
        names += [f"-{asked.short}"] if asked.short else []
        rare = isinstance(asked.panel, Rare)
        option = typer.Option(*names, rich_help_panel=str(asked.panel), hidden=rare, **told)
    seen: Any = bool if kind is bool else list[str] if asked.repeated else str
    if default is None:
        seen |= None
    return Parameter(
        name,
        Parameter.KEYWORD_ONLY,
        default=Parameter.empty if default in (MISSING, Parameter.empty) else default,
        annotation=Annotated[seen, option],
    )


HELP_ALL = "help_all"


def _help_all() -> Parameter:
    """The option that shows those of rare use, too."""
    option = typer.Option("--help-all", help="Show every option.", is_eager=True, callback=_help)
    kind = Annotated[bool, option]
    return Parameter(HELP_ALL, Parameter.KEYWORD_ONLY, default=False, annotation=kind)


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


# Typer has its own copy of click, or uses click itself, depending on its version.
_ClickError: type[Exception] = next(
    kind for kind in typer.BadParameter.__mro__ if kind.__name__ == "ClickException"
)

COMPLETION = "_ALLWORLDS_COMPLETE"
"""The variable by which a shell asks how a command line can go on."""

HELP = {"help_option_names": ["-h", "--help"]}
"""Settings of every verb and group."""


@cache
def command_line(first: str | None = None) -> Any:
    """All verbs, as click sees them.

    Args:
        first: the first word after ``allworlds``: only the verb, or the group, of that name gets
            its options, since making them takes long; by default every verb gets them.
    """
    app = typer.Typer(
        name="allworlds",
        help=(
            "Example: allworlds check --edges 4\n\n"
            "Run an exploration algorithm on every small embedded graph."
        ),
        context_settings=HELP,
        rich_markup_mode="markdown",
        pretty_exceptions_enable=False,
    )
    app.callback(invoke_without_command=True)(_common)
    groups = {}
    for name, known in GROUPS.items():
        help_ = f"Example: {known.example}\n\n{known.summary}"
        groups[name] = typer.Typer(
            name=name, help=help_, short_help=known.summary, context_settings=HELP
        )
        groups[name].callback(invoke_without_command=True)(_group_help)
    for verb in VERBS:
        home = groups[verb.group] if verb.group else app
        name = verb.name.rpartition(" ")[2]
        panel = verb.panel or None
        meant = first is None or first == verb.name.partition(" ")[0]
        home.command(name, short_help=verb.summary, context_settings=HELP, rich_help_panel=panel)(
            _command(verb) if meant else _unasked
        )
    for name, group in groups.items():
        app.add_typer(group, rich_help_panel=GROUPS[name].panel)
    return made_helpful(typer.main.get_command(app))


def _command(verb: Verb) -> Callable[..., int]:
    """The function that runs a verb: its own on the command line, else the plain one."""
    return grouped(_own_command(verb.name) or plain_command(verb), verb.name)


_HOMES = {
    "check": "check",
    "convert": "convert",
    "explain": "explain",
    "play": "run",
    "replay": "run",
    "run": "run",
}
"""The modules of the verbs that do more than answer a request, and write."""


def _own_command(name: str) -> Callable[..., int] | None:
    """The function of a verb in its module; None of a verb without one."""
    home = _HOMES.get(name)
    return getattr(import_module(f"allworlds.cli.{home}"), name) if home else None


def _unasked() -> None:
    """Stand for a verb that is listed, and not called."""


def _group_help(context: typer.Context) -> None:
    if context.invoked_subcommand is None:
        say(context.get_help)


def _common(
    context: typer.Context,
    *,
    version: Annotated[bool, typer.Option("--version", help="Print the version and exit.")] = False,
) -> None:
    if version:
        from allworlds.version import __version__

        say(lambda: __version__)
    elif context.invoked_subcommand is None:
        say(context.get_help)


def main() -> NoReturn:
    """Run a verb and end the process with its exit code."""
    prepare_streams()
    if os.name != "posix":
        sys.exit(_refuse(f"{sys.platform} is not supported, but Linux is (macOS was not tried)"))
    if COMPLETION in os.environ:
        command_line().main(prog_name="allworlds")  # which exits
    code = call(sys.argv[1:])
    # All is said; nothing is left to be told of an interrupt.
    at_interrupts(lambda *_: os._exit(Exit.INTERRUPTED))
    if threading.active_count() > 1:
        # A thread that could not be given up, such as a compiler's, is not waited for.
        sys.stdout.flush()
        os._exit(code)
    keep_exit_code()  # models may be called at the exit, too
    sys.exit(code)


def call(arguments: list[str]) -> int:
    """Run a verb in this process and return its exit code; no exception leaves it."""
    defaults = Defaults()
    try:
        if any(not word.startswith("-") for word in arguments):
            defaults = defaults_here()
        begin(arguments, defaults)
        return _invoked(arguments, defaults)
    except InputError as error:
        return _refuse(str(error), defaults)
    except NoResult as error:
        complain(str(error))
        return error.exit
    except _ClickError as error:
        return _refuse(_complaint(error, arguments), defaults)
    except OutOfTime as up:
        complain(f"the time limit was reached{up}")
        return Exit.INCONCLUSIVE
    except KeyboardInterrupt:
        complain("interrupted")
        return Exit.INTERRUPTED
    except OSError as error:
        if not _somewhere():
            return _refuse("the current directory has been removed: change to one that exists")
        # A full disk, or a stdout that is closed or full.
        abandon_stdout()
        complain(error.strerror or str(error))
        return Exit.INTERNAL
    except Exception:  # noqa: BLE001  # the last resort: say so, and say where
        print(printable(traceback.format_exc()), end="", file=sys.stderr)
        complain("internal error; the lines above say where")
        return Exit.INTERNAL


def _somewhere() -> bool:
    """Whether there is a current directory."""
    try:
        Path.cwd()
    except FileNotFoundError:
        return False
    return True


def _invoked(arguments: list[str], defaults: Defaults) -> int:
    """The exit code of the verb.

    Click's own ``main`` is left out: it makes an exit code of 1 of every broken pipe, which is
    no verdict, and keeps interrupts to itself.
    """
    first = next((word for word in arguments if not word.startswith("-")), "")
    # A file's defaults are compared with the options of every verb.
    verbs = command_line(None if defaults.options else first)
    known = defaults.map_for(verbs, arguments)
    try:
        with verbs.make_context("allworlds", [*arguments], default_map=known) as context:
            return int(verbs.invoke(context) or 0)
    except typer.Exit as end:
        return end.exit_code


def _complaint(error: Exception, arguments: list[str]) -> str:
    """Click's message, with the value where click leaves it out."""
    said: str = error.format_message() if hasattr(error, "format_message") else str(error)
    options = getattr(getattr(error, "param", None), "opts", ())
    for option, value in pairwise(arguments):
        if option in options and show(value) not in said:
            return f"{said}, not {show(value)}"
    return said


def _refuse(message: str, defaults: Defaults | None = None) -> int:
    used = defaults.used.items() if defaults else ()
    named = [f"{key} = {show(value)}" for key, value in used if show(value) in message]
    if defaults and named:
        message += f" ({', '.join(named)} stands in {show(defaults.file)})"
    complain(message)
    return Exit.USAGE
