"""Is wrong everywhere, and replaces every judge that it can import.  It judges nobody.

verdict: refuted map
quick: 2
"""

import sys

import allworlds.engines.isolation.referee

import allworlds.engines.python.examiner
from allworlds import CombinatorialMap, Estimate

for name, module in [*sys.modules.items()]:
    if name.startswith("allworlds"):
        for attribute in ("judge", "difference_of", "overruled", "the_same"):
            if hasattr(module, attribute):
                setattr(module, attribute, lambda *_: None)
allworlds.engines.python.examiner.Referee.verdict = lambda *_: None


def explore(first):
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    yield
