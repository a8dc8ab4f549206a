"""The verbs, their common exit codes, and the one line for bad input."""

from __future__ import annotations

import os
import signal
import sys
import threading
import traceback
from collections.abc import Callable
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from itertools import pairwise
from keyword import iskeyword
from pathlib import Path
from typing import Annotated, Any, NoReturn

import typer

from allworlds import engines
from allworlds.cli.groups import grouped
from allworlds.cli.helping import made_helpful
from allworlds.cli.made_by import beginning
from allworlds.cli.output import abandon_stdout, complain, prepare_streams, printable, say
from allworlds.cli.plain_command import plain_command
from allworlds.inputs import InputError, keep_exit_code, show
from allworlds.outcome import Exit
from allworlds.verbs import GROUPS, VERBS, Verb

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
        groups[name].callback(invoke_without_command=True)(_help)
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
    """The function that runs a verb: one in the module of its name or group, else the plain one."""
    home = f"allworlds.cli.{verb.group or verb.name}"
    module = import_module(home) if find_spec(home) else None
    name = verb.name.rpartition(" ")[2]
    own = getattr(module, f"{name}_" if iskeyword(name) else name, None)
    return grouped(own or plain_command(verb), verb.name)


def _unasked() -> None:
    """Stand for a verb that is listed, and not called."""


def _help(context: typer.Context) -> None:
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
    # To be terminated, or left by the terminal, is to be interrupted: a report is left, and no
    # process.  What is to be ignored (nohup) stays so.
    for number in (signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, signal.default_int_handler)
    code = call(sys.argv[1:])
    if threading.active_count() > 1:
        # A thread that could not be given up, such as a compiler's, is not waited for.
        sys.stdout.flush()
        os._exit(code)
    keep_exit_code()  # models may be called at the exit, too
    sys.exit(code)


def call(arguments: list[str]) -> int:
    """Run a verb in this process and return its exit code; no exception leaves it."""
    try:
        with beginning(arguments):
            code = _invoked(arguments)
    except InputError as error:
        return _refuse(str(error))
    except engines.Gap as error:  # loaded when there is an error
        complain(str(error))
        return Exit.INCOMPLETE
    except (engines.ClusterLost, engines.Unsettled) as error:
        complain(str(error))
        return Exit.INCONCLUSIVE
    except _ClickError as error:
        return _refuse(_complaint(error, arguments))
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
    return code


def _somewhere() -> bool:
    """Whether there is a current directory."""
    try:
        Path.cwd()
    except FileNotFoundError:
        return False
    return True


def _invoked(arguments: list[str]) -> int:
    """The exit code of the verb.

    Click's own ``main`` is left out: it makes an exit code of 1 of every broken pipe, which is
    no verdict, and keeps interrupts to itself.
    """
    first = next((word for word in arguments if not word.startswith("-")), "")
    verbs = command_line(first)
    try:
        with verbs.make_context("allworlds", [*arguments]) as context:
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


def _refuse(message: str) -> int:
    complain(message)
    return Exit.USAGE
