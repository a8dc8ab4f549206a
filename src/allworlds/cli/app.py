"""The verbs, and what is the same for all of them: exit codes and one line for bad input."""

from __future__ import annotations

import os
import sys
import traceback
from typing import Annotated, NoReturn

import typer

from allworlds.cli.verbs import check, count, replay, run
from allworlds.errors import InputError

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
    sys.exit(_guarded(sys.argv[1:]))


def _guarded(arguments: list[str]) -> int:
    try:
        code = app(args=arguments, standalone_mode=False)
        sys.stdout.flush()
    except InputError as error:
        return _refuse(str(error))
    except _ClickError as error:
        # What click says may have several lines and end with a full stop.
        return _refuse(error.format_message() if hasattr(error, "format_message") else str(error))
    except (KeyboardInterrupt, typer.Abort):
        print("allworlds: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # The reader of our output has gone; what is still buffered has nowhere to go.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return INTERNAL
    except Exception:  # noqa: BLE001  # the last resort: say so, and say where
        traceback.print_exc()
        print("allworlds: internal error; the lines above say where", file=sys.stderr)
        return INTERNAL
    return int(code or 0)


def _refuse(message: str) -> int:
    line = " ".join(message.split())
    print(f"allworlds: {line}", file=sys.stderr)
    return USAGE
