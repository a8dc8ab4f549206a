"""Is wrong, and writes a right explorer into its own file when it is imported.

verdict: refuted map
options: --edges 1
"""

from pathlib import Path

from allworlds import CombinatorialMap, Estimate

Path(__file__).write_text(
    "from allworlds.explorers.builtin.algorithm1 import algorithm1 as explore\n"
)


def explore(first):
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    yield
