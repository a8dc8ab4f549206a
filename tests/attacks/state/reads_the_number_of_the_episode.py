"""A program that takes the number of the episode for the number of its world.

as: exec
verdict: refuted nondeterministic or map
options: --edges 2 --lighthouse none --laws map,pose
"""

import json
import sys

from allworlds.maps import rooted_maps

WORLDS = [map_ for edges in (1, 2) for map_ in rooted_maps(edges)]

for line in sys.stdin:
    told = {**WORLDS[json.loads(line)["episode"] % len(WORLDS)].to_json(), "here": 0}
    print(json.dumps({"estimate": told}), flush=True)
