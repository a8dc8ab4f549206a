"""A command that a signal reaches at a drawn call of a function: its words follow what was drawn.

    python signalled.py SIGNAL BEGIN CALLS IGNORED ALL WORD...

Calls are counted in the first process, from the first one of a function that is called BEGIN on.
IGNORED: whether SIGINT is ignored when the command begins; ALL: whether every process of the
command gets the signal, as from a service's manager.
"""

import os
import signal
import sys
from contextlib import suppress

import processes

HEEDS = "at_interrupts"
"""The function after which signals are heeded: what comes before it is Python's."""


def signal_at_call(number, begin, calls, to_all):
    """Send a signal at so many calls after the first one of that function."""
    left, own, begun = calls, os.getpid(), []

    def count(frame, event, _argument):
        nonlocal left
        if not begun:
            if frame.f_code.co_name != begin or event != ("return" if begin == HEEDS else "call"):
                return
            begun.append(begin)
        left -= 1
        if left == 0 and os.getpid() == own:
            sys.setprofile(None)
            for process in [*(processes.workers_of(own) if to_all else ()), own]:
                with suppress(ProcessLookupError):  # a worker may have ended by itself
                    os.kill(process, number)

    sys.setprofile(count)


def heed_all():
    """Let signals act that this process was started to ignore."""
    for each in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(each, signal.SIG_DFL)


def main():
    """Run the command."""
    number, begin, calls, ignored, to_all = sys.argv[1:6]
    del sys.argv[1:6]
    heed_all()
    signal.signal(signal.SIGINT, signal.SIG_IGN if int(ignored) else signal.default_int_handler)
    from allworlds import cli

    signal_at_call(int(number), begin, int(calls), int(to_all))
    cli.main()


if __name__ == "__main__":
    main()
