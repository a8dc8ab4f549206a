"""The verbs, and what is the same for all of them: exit codes and one line for bad input."""

from __future__ import annotations

import signal
import sys
import traceback
from collections.abc import Callable
from functools import cache
from itertools import pairwise
from typing import Annotated, NoReturn

import typer

from allworlds.cli.ambiguity import ambiguity, twins
from allworlds.cli.bench import bench
from allworlds.cli.explain import explain
from allworlds.cli.fuzz import fuzz
from allworlds.cli.mutants import mutants
from allworlds.cli.output import abandon_stdout, complain, prepare_streams, printable
from allworlds.cli.search import search
from allworlds.cli.verbs import check, count, replay, run
from allworlds.cli.worst import worst
from allworlds.errors import InputError, show

USAGE = 2
INTERNAL = 70
INTERRUPTED = 130

# Typer has its own copy of click, or uses click itself, depending on its version.
_ClickError: type[Exception] = next(
    kind for kind in typer.BadParameter.__mro__ if kind.__name__ == "ClickException"
)

app = typer.Typer(
    name="allworlds",
    help=(
        "Example: allworlds check --edges 4\n\n"
        "Try everything: run an exploration algorithm on every small embedded graph."
    ),
    add_completion=False,
    rich_markup_mode="markdown",
    pretty_exceptions_enable=False,
)
for _verb, _what in (
    (check, "Every world of a class, one explorer, a verdict: the main job."),
    (run, "One world, told step by step."),
    (fuzz, "Random worlds beyond the exhaustive bound."),
    (replay, "A finding once more: reproduced or fixed."),
    (explain, "A finding in plain words."),
    (mutants, "What the checks are known to catch."),
    (count, "How many maps there are, counted twice."),
    (worst, "Algorithm 1 at its worst and best, over every schedule."),
    (twins, "Can any motion tell two worlds apart?"),
    (search, "Worlds that no motion tells apart, by SMT."),
    (bench, "This program and others side by side."),
):
    app.command(name=_verb.__name__, short_help=_what)(_verb)
app.add_typer(ambiguity, short_help="What a robot that knows only its position cannot tell apart.")


@app.callback(invoke_without_command=True)
def _common(
    context: typer.Context,
    *,
    version: Annotated[bool, typer.Option("--version", help="Print the version and exit.")] = False,
) -> None:
    if version:
        from allworlds.version import __version__

        typer.echo(__version__)
    elif context.invoked_subcommand is None:
        typer.echo(context.get_help())


def main() -> NoReturn:
    """Run a verb and end the process with its exit code."""
    # To be terminated is to be interrupted: a report is left, and no worker.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    prepare_streams()
    sys.exit(call(sys.argv[1:]))


def call(arguments: list[str]) -> int:
    """Run a verb in this process; its exit code, whatever happens."""
    try:
        code = _verbs()(args=arguments, standalone_mode=False)
    except InputError as error:
        return _refuse(str(error))
    except _ClickError as error:
        return _refuse(_complaint(error, arguments))
    except (KeyboardInterrupt, typer.Abort):
        complain("interrupted")
        return INTERRUPTED
    except OSError as error:
        # A full disk, or a stdout that is closed or full.
        abandon_stdout()
        complain(error.strerror or str(error))
        return INTERNAL
    except Exception:  # noqa: BLE001  # the last resort: say so, and say where
        print(printable(traceback.format_exc()), end="", file=sys.stderr)
        complain("internal error; the lines above say where")
        return INTERNAL
    return int(code or 0)


@cache
def _verbs() -> Callable[..., int | None]:
    """All verbs as click sees them; Typer needs longer to make them than a small verb runs."""
    return typer.main.get_command(app)


def _complaint(error: Exception, arguments: list[str]) -> str:
    """What click says, with the value that it may have left out."""
    said: str = error.format_message() if hasattr(error, "format_message") else str(error)
    options = getattr(getattr(error, "param", None), "opts", ())
    for option, value in pairwise(arguments):
        if option in options and repr(value) not in said:
            return f"{said}, not {show(value)}"
    return said


def _refuse(message: str) -> int:
    complain(message)
    return USAGE
