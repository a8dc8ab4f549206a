"""The command line, which reads options and prints text or JSON.

Other packages compute the results.
"""

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

    All other modules are loaded inside this function.  So the user who interrupts the command while
    modules are loaded also sees one line, and no traceback.
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
    """Raise KeyboardInterrupt, after dropping further output to terminals that were closed.

    This function is the handler of the signals that interrupt the command.
    """
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
    """Handle an exception that Python has dropped because it was raised in a finalizer.

    If the exception is an interrupt, the command is interrupted again after 0.01 seconds; any other
    exception is printed, as Python does by default.

    Args:
        dropped: the data that Python gives to ``sys.unraisablehook``.
    """
    if issubclass(dropped.exc_type, KeyboardInterrupt):
        signal.signal(signal.SIGALRM, _interrupt)
        signal.setitimer(signal.ITIMER_REAL, 0.01)
    else:
        sys.__unraisablehook__(dropped)
