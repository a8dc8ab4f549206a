"""Right, and writes what a CI service would take for commands, wherever it can.

verdict: holds
"""

import os
import sys

from allworlds.explorers.builtin.algorithm1 import algorithm1

print("::error::at import")


def explore(first):
    print("::error title=allworlds::in an episode")
    sys.stderr.write("begun, ")
    sys.stderr.write("and ended\n \t::warning::after blanks\n:")
    sys.stderr.write(":notice::in two parts\n")
    os.write(2, b"\n::stop-commands::x\n##[error]of the older form\n")
    return (yield from algorithm1(first))
