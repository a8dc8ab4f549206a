"""The command line: options in, text or JSON out; every decision is made elsewhere."""

import sys
from typing import NoReturn

__all__ = ["main"]


def main() -> NoReturn:
    """Run a verb and end the process with its exit code.

    All else is loaded here, so that who interrupts at once is told no more than that.
    """
    try:
        from allworlds.cli import app
    except KeyboardInterrupt:
        print("allworlds: interrupted", file=sys.stderr)
        sys.exit(130)
    app.main()
