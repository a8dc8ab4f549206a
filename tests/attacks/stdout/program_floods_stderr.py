"""A program that is right in the smallest worlds, and writes 32 MB to stderr in each.

as: exec
verdict: holds
options: --edges 1
"""

import json
import sys

for line in sys.stdin:
    for _ in range(32):
        sys.stderr.write("!" * (1 << 20))
    degree = json.loads(line)["percept"]["degree"]
    print(json.dumps({"move": 1 if degree == 2 else 0}), flush=True)
    sys.stdin.readline()
    sigma = [1, 0] if degree == 2 else [0, 1]
    told = {"sigma": sigma, "alpha": [1, 0], "here": 0 if degree == 2 else 1}
    print(json.dumps({"estimate": told}), flush=True)
