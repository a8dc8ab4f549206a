"""A program that is right in the smallest worlds, and is killed from outside once.

as: exec
verdict: holds
options: --edges 1
"""

import json
import os
import signal
import sys
from pathlib import Path

for line in sys.stdin:
    if not Path("killed").exists():
        Path("killed").touch()
        os.kill(os.getpid(), signal.SIGKILL)
    degree = json.loads(line)["percept"]["degree"]
    print(json.dumps({"move": 1 if degree == 2 else 0}), flush=True)
    sys.stdin.readline()
    sigma = [1, 0] if degree == 2 else [0, 1]
    told = {"sigma": sigma, "alpha": [1, 0], "here": 0 if degree == 2 else 1}
    print(json.dumps({"estimate": told}), flush=True)
