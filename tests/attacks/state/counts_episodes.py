"""A program that walks nowhere, and answers by the number of its episodes, each world twice.

as: exec
verdict: refuted nondeterministic or map
options: --edges 3 --lighthouse none --laws map,pose
quick: 1
"""

import json
import sys

from allworlds.maps import rooted_maps

WORLDS = [map_ for edges in (1, 2, 3) for map_ in rooted_maps(edges)]

for turn, _ in enumerate(sys.stdin):
    told = {**WORLDS[turn // 2 % len(WORLDS)].to_json(), "here": 0}
    print(json.dumps({"estimate": told}), flush=True)
