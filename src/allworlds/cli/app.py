"""The command line: its verbs, such as ``check``, its groups of verbs, and its errors.

A verb is a command of the library click.  A group is some verbs whose names begin with the same
word, such as ``ambiguity twins`` and ``ambiguity class``.
"""

import os
import shutil
import sys
import threading
import traceback
from collections.abc import Callable
from contextvars import copy_context
from functools import cache, partial
from pathlib import Path
from pkgutil import resolve_name
from typing import Any, NoReturn, get_type_hints

import rich_click as click
from click.exceptions import Exit as Ended, NoArgsIsHelpError

from allworlds.cli.defaults import Defaults, begin, defaults_here
from allworlds.cli.output import (
    abandon_stdout,
    complain,
    output_of,
    prepare_streams,
    printable,
    respond,
    say,
)
from allworlds.cli.parameters import parameters_of, printing, request_of
from allworlds.inputs.checks import InputError, OutOfTime, at_interrupts, keep_exit_code, show
from allworlds.inputs.requests import PANELS
from allworlds.outcome import Exit, NoResult
from allworlds.verbs import GROUPS, ROOT, VERBS, Group, Verb
from allworlds.version import __version__

COMPLETION = "_ALLWORLDS_COMPLETE"
"""The environment variable by which a shell asks how a command line can be completed."""


NARROW = 80
"""The least number of columns with which the help has a column for the values of options.

With fewer columns the names of options would be cut.
"""


class _Verb(click.RichCommand):
    """A verb or a group of verbs as a click command, with its help in the form of this program.

    The argument ``listed`` is the entry of the verb or group in the table ``allworlds.verbs``;
    ``settings`` are further arguments of the click command.
    """

    def __init__(self, name: str, listed: Verb | Group, **settings: Any) -> None:
        layout: dict[str, Any] = {"padding_helptext_first_line": (0, 0, 1, 0)}
        if shutil.get_terminal_size().columns < NARROW:
            layout["theme"] = "default-nu"  # the values stand below what is told of options
        settings |= {"short_help": listed.summary, "panel": listed.panel or None}
        settings |= {"context_settings": {"rich_help_config": layout}, "add_help_option": False}
        super().__init__(name, **settings)
        arguments = click.RichOptionPanel("Arguments", column_types=["opt_long", "help"])
        self.panels = [arguments, *map(click.RichOptionPanel, ("Options", *PANELS))]
        help_ = printing(["--help", "-h"], "Show this message and exit.", click.Context.get_help)
        self.params.append(help_)


class _Group(_Verb, click.RichGroup):  # type: ignore[misc]  # as rich-click's own classes
    """A group of verbs as a click command; if the user names no verb, the help is shown."""

    def __init__(self, name: str, group: Group, **settings: Any) -> None:
        help_ = f"Example: {group.example}\n\n{group.summary}"
        super().__init__(name, group, help=help_, **settings)

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002  # they are always all
        """The names of the verbs, in the order in which they were added, not alphabetically."""
        return [*self.commands]


@cache
def command_line(first: str | None = None) -> click.RichGroup:
    """The command ``allworlds``, an object of the library click that holds all verbs.

    Args:
        first: the first word after ``allworlds``.  Only the verb with this name, or the verbs of
            the group with this name, get their options, since making options takes long.  None:
            every verb gets its options.
    """
    version = printing(["--version"], "Print the version and exit.", lambda _: __version__)
    root = _Group("allworlds", ROOT, params=[version])
    groups = {name: _Group(name, group) for name, group in GROUPS.items()}
    for verb in VERBS:
        meant = first is None or first == verb.name.partition(" ")[0]
        home = groups.get(verb.group, root)
        home.add_command(_command(verb) if meant else _listed(verb))
    for group in groups.values():
        root.add_command(group)
    return root


def _listed(verb: Verb, **settings: Any) -> _Verb:
    """The click command of a verb.

    ``settings`` are further arguments of the click command, such as its options.  Without them the
    command has no options; its name and summary are enough for a list of all verbs.
    """
    return _Verb(verb.name.rpartition(" ")[2], verb, **settings)


def _command(verb: Verb) -> _Verb:
    """The click command of a verb, with all its options and the function that runs the verb.

    For each parameter of that function, :func:`_function_of` names a class; the fields of the class
    are options and arguments of the command.  From the user's words the command makes an object of
    each class, and calls the function with these objects.  The class of the parameter ``output`` is
    always the subclass of :class:`OutputGroup` that :func:`output_of` makes for this verb.
    """
    function, parts, help_ = _function_of(verb)
    parts["output"] = output_of(verb.name)

    def command(**words: Any) -> int:
        from allworlds.engines.limits import deadline_after, models_bounded

        with models_bounded(deadline_after(words.get("time_limit"))):
            requests = {name: request_of(part, words) for name, part in parts.items()}
        return function(**requests)

    params = parameters_of(parts.values())
    return _listed(verb, params=params, help=help_, callback=command)


def _function_of(verb: Verb) -> tuple[Callable[..., int], dict[str, Any], str]:
    """A triple: the function that runs a verb, the classes of its parameters, and the verb's help.

    The classes are in a dictionary by the names of the parameters.  The fields of each class are
    options and arguments of the verb.  Most verbs only answer a request and write the answer; for
    these verbs the function is :func:`respond`.  A verb that does more has a function of its own in
    this package, and the docstring of this function is the verb's help.
    """
    if verb.help:
        answers = resolve_name(verb.path)
        help_ = f"Example: allworlds {verb.name} {verb.example}".rstrip() + f"\n\n{verb.help}"
        return partial(respond, answers), {"request": answers.request}, help_
    home = {"play": "run", "replay": "run"}.get(verb.name, verb.name)
    own = resolve_name(f"allworlds.cli.{home}:{verb.name}")
    parts = get_type_hints(own)
    del parts["return"]
    return own, parts, own.__doc__


def main() -> NoReturn:
    """Run the verb that the command line names, and end the process with the verb's exit code."""
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
    """Run a verb in this process and return its exit code; this function raises no exception.

    If the verb fails, a message is printed on stderr, and the exit code tells its kind.
    While the verb runs, context variables hold facts about the command, for example the options
    that the user's file sets; they are reset when the verb ends.

    Args:
        arguments: the words of the command, without the program's name.
    """
    return copy_context().run(_called, arguments)


def _called(arguments: list[str]) -> int:
    defaults = Defaults()
    try:
        if any(not word.startswith("-") for word in arguments):
            defaults = defaults_here()
        begin(arguments, defaults)
        return _invoked(arguments, defaults)
    except NoResult as error:
        complain(str(error))
        return error.exit
    except NoArgsIsHelpError as alone:
        say(alone.format_message)
        return Exit.HOLDS
    except (InputError, click.ClickException) as error:
        return _refuse(_complaint(error), defaults)
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
    """Whether the current directory exists."""
    try:
        Path.cwd()
    except FileNotFoundError:
        return False
    return True


def _invoked(arguments: list[str], defaults: Defaults) -> int:
    """Run the verb that ``arguments`` name, and return its exit code.

    ``arguments`` are the words of the command, without the program's name; ``defaults`` are the
    defaults from the user's file.  Click's own ``main`` is not used, because at a broken pipe and
    at an interrupt it exits with 1, which means ``refuted`` in this program.
    """
    first = next((word for word in arguments if not word.startswith("-")), "")
    # A file's defaults are compared with the options of every verb.
    verbs = command_line(None if defaults.options else first)
    known = defaults.map_for(verbs, arguments)
    try:
        with verbs.make_context("allworlds", [*arguments], default_map=known) as context:
            return int(verbs.invoke(context) or 0)
    except Ended as end:
        return int(end.exit_code)


def _complaint(error: Exception) -> str:
    """The message about a command line that is refused because of this error.

    For an unknown option the message is shorter than click's own message.
    """
    if isinstance(error, click.NoSuchOption):
        like = f" (Possible options: {', '.join(sorted(error.possibilities or ()))})"
        return f"No such option: {error.option_name}{like if error.possibilities else ''}"
    return error.format_message() if isinstance(error, click.ClickException) else str(error)


def _refuse(message: str, defaults: Defaults | None = None) -> int:
    used = defaults.used.items() if defaults else ()
    named = [f"{key} = {show(value)}" for key, value in used if show(value) in message]
    if defaults and named:
        message += f" ({', '.join(named)} stands in {show(defaults.file)})"
    complain(message)
    return Exit.USAGE
