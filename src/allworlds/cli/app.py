"""The verbs, and what is the same for all of them: exit codes and one line for bad input."""

from __future__ import annotations

import io
import signal
import sys
import traceback
from itertools import pairwise
from typing import Annotated, NoReturn

import typer

from allworlds.cli.ambiguity import ambiguity, twins
from allworlds.cli.explain import explain
from allworlds.cli.fuzz import fuzz
from allworlds.cli.mutants import mutants
from allworlds.cli.search import search
from allworlds.cli.bench import bench
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
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
app.command(name="check")(check)
app.command(name="count")(count)
app.command(name="run")(run)
app.command(name="replay")(replay)
app.command(name="worst")(worst)
app.command(name="bench")(bench)
app.command(name="explain")(explain)
app.command(name="fuzz")(fuzz)
app.command(name="mutants")(mutants)
app.command(name="search")(search)
app.command(name="twins")(twins)
app.add_typer(ambiguity)


@app.callback(invoke_without_command=True)
def _common(
    *,
    version: Annotated[bool, typer.Option("--version", help="Print the version and exit.")] = False,
) -> None:
    if version:
        from allworlds.version import __version__

        typer.echo(__version__)
        raise typer.Exit


def main() -> NoReturn:
    """Run a verb and end the process with its exit code."""
    # To be terminated is to be interrupted: a report is left, and no worker.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    if isinstance(sys.stdout, io.TextIOWrapper):
        # A terminal that cannot show a character shows its number.
        sys.stdout.reconfigure(errors="backslashreplace")
    sys.exit(_guarded(sys.argv[1:]))


def _guarded(arguments: list[str]) -> int:
    try:
        code = app(args=arguments, standalone_mode=False)
    except InputError as error:
        return _refuse(str(error))
    except _ClickError as error:
        return _refuse(_complaint(error, arguments))
    except (KeyboardInterrupt, typer.Abort):
        print("allworlds: interrupted", file=sys.stderr)
        return INTERRUPTED
    except Exception:  # noqa: BLE001  # the last resort: say so, and say where
        traceback.print_exc()
        print("allworlds: internal error; the lines above say where", file=sys.stderr)
        return INTERNAL
    return int(code or 0)


def _complaint(error: Exception, arguments: list[str]) -> str:
    """What click says, with the value that it may have left out."""
    said: str = error.format_message() if hasattr(error, "format_message") else str(error)
    options = getattr(getattr(error, "param", None), "opts", ())
    for option, value in pairwise(arguments):
        if option in options and repr(value) not in said:
            return f"{said}, not {show(value)}"
    return said


def _refuse(message: str) -> int:
    line = " ".join(message.split())
    print(f"allworlds: {line}", file=sys.stderr)
    return USAGE
