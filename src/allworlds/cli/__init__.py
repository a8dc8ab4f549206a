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
    """Run the verb that the command line names, and end the process with the verb's exit code.

    All other modules are loaded inside this function, where an interrupt is caught.  So an
    interrupt prints the one line ``allworlds: interrupted``, and no traceback, even if modules are
    still being loaded.
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
    """Call :func:`drop_closed_terminals`, then raise KeyboardInterrupt.

    This function is the handler of the signals that interrupt the command.  It does not use the
    arguments of a handler, which are the number of the signal and a stack frame.
    """
    drop_closed_terminals()
    raise KeyboardInterrupt


def drop_closed_terminals() -> None:
    """Redirect stdout to the null device if stdout is a closed terminal; the same for stderr.

    So output that is written later is dropped, and causes no error.
    """
    for stream in (1, 2):
        terminal = select.poll()
        terminal.register(stream, select.POLLHUP)
        if any(event & select.POLLHUP for _, event in terminal.poll(0)):
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream)


def _interrupt_again(dropped: Any) -> None:
    """Handle an exception that Python has dropped, because it was raised in a finalizer.

    If the exception is a KeyboardInterrupt, the command is interrupted again after 0.01 seconds;
    any other exception is printed, as Python does by default.

    Args:
        dropped: the exception and its traceback, as Python gives them to ``sys.unraisablehook``.
    """
    if issubclass(dropped.exc_type, KeyboardInterrupt):
        signal.signal(signal.SIGALRM, _interrupt)
        signal.setitimer(signal.ITIMER_REAL, 0.01)
    else:
        sys.__unraisablehook__(dropped)
