"""The command line: it reads options, and prints text or JSON; other packages decide."""

import atexit
import gc
import os
import select
import signal
import sys
from typing import Any, NoReturn

__all__ = ["main"]


def main() -> NoReturn:
    """Run a verb and end the process with its exit code.

    All other modules are loaded here, so that even an early interrupt is answered in one line.
    """
    gc.set_threshold(10_000)  # much is made that stays, and nearly nothing in circles
    try:
        from allworlds.inputs.checks import at_interrupts

        # To be terminated, or left by the terminal, is to be interrupted: a report is left, and no
        # process.
        at_interrupts(_interrupt)
        sys.unraisablehook = _interrupt_again
        atexit.register(at_interrupts, signal.SIG_IGN)  # which is called last
        from allworlds.cli import app

        app.main()
    except KeyboardInterrupt:
        print("allworlds: interrupted", file=sys.stderr)
        sys.exit(130)


def _interrupt(*_: object) -> NoReturn:
    """Interrupt the command."""
    drop_closed_terminals()
    raise KeyboardInterrupt


def drop_closed_terminals() -> None:
    """Drop all further output to stdout and to stderr, if they are terminals that were closed."""
    for stream in (1, 2):
        terminal = select.poll()
        terminal.register(stream, select.POLLHUP)
        if any(event & select.POLLHUP for _, event in terminal.poll(0)):
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream)


def _interrupt_again(dropped: Any) -> None:
    """Interrupt the command again, soon, if Python has dropped an interrupt.

    Python drops an exception that is raised in a finalizer.
    """
    if issubclass(dropped.exc_type, KeyboardInterrupt):
        signal.signal(signal.SIGALRM, _interrupt)
        signal.setitimer(signal.ITIMER_REAL, 0.01)
    else:
        sys.__unraisablehook__(dropped)
