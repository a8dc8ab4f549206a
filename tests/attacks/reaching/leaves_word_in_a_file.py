"""Finds the world in the frames of the first play, and leaves it in a file for the second.

That is not enough: where worlds look alike, the second play does not know for which of them the
word was left.

verdict: refuted nondeterministic or map
options: --edges 2 --lighthouse none --laws map,pose
"""

import json
import sys
from pathlib import Path

from allworlds import CombinatorialMap, Estimate
from allworlds.world import World


def explore(first):
    file = Path(f"degree-{first.degree}")
    frame = sys._getframe()
    while frame := frame.f_back:
        for value in frame.f_locals.values():
            if isinstance(value, World):
                file.write_text(json.dumps(value.map.to_json()))
    return Estimate(CombinatorialMap.from_json(json.loads(file.read_text())), 0)
    yield
