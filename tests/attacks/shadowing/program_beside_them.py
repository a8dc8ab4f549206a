"""A program that is right in the smallest worlds, in such a directory.

as: exec
verdict: holds
options: --edges 1
beside: json re enum types random allworlds subprocess select shlex
"""

import json
import sys

for line in sys.stdin:
    degree = json.loads(line)["percept"]["degree"]
    print(json.dumps({"move": 1 if degree == 2 else 0}), flush=True)
    sys.stdin.readline()
    sigma = [1, 0] if degree == 2 else [0, 1]
    told = {"sigma": sigma, "alpha": [1, 0], "here": 0 if degree == 2 else 1}
    print(json.dumps({"estimate": told}), flush=True)
