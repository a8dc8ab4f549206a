"""A program behind ``--exec``: walks one edge, and takes the world for it."""

import json
import sys

for line in sys.stdin:
    if "episode" in json.loads(line):
        sys.stdout.write(json.dumps({"move": 0}) + "\n")
        sys.stdout.flush()
    else:
        estimate = {"sigma": [0, 1], "alpha": [1, 0], "here": 1}
        sys.stdout.write(json.dumps({"estimate": estimate}) + "\n")
        sys.stdout.flush()
