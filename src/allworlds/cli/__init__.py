"""The command line: options in, text or JSON out; every decision is made elsewhere."""

import sys
from typing import NoReturn

__all__ = ["main"]


def main() -> NoReturn:
    """Run a verb and end the process with its exit code.

    Everything else is loaded here, so that even an early interrupt is answered in one line.
    """
    try:
        from allworlds.cli import app
    except KeyboardInterrupt:
        print("allworlds: interrupted", file=sys.stderr)
        sys.exit(130)
    app.main()
