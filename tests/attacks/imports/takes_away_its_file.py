"""Is wrong, and renames its own file when it is imported, so that nobody finds it again.

verdict: refuted map
options: --edges 1
quick: 1
"""

from pathlib import Path

from allworlds import CombinatorialMap, Estimate

if Path(__file__).exists():
    Path(__file__).rename("gone.py")


def explore(first):
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    yield
