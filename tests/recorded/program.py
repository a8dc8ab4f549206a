"""A program behind ``--exec``: walks one edge, and takes the world for it."""

import json
import sys

for line in sys.stdin:
    if "episode" in json.loads(line):
        print(json.dumps({"move": 0}), flush=True)
    else:
        estimate = {"sigma": [0, 1], "alpha": [1, 0], "here": 1}
        print(json.dumps({"estimate": estimate}), flush=True)
