"""A program whose answer is spoiled by the place where an object of its lies in memory.

as: exec
verdict: refuted nondeterministic or no-estimate
options: --edges 4 --laws map,pose
"""

import json
import sys

from allworlds import Checkpoint, Percept
from allworlds.explorers import algorithm1

SPOILT = id(algorithm1) >> 21 & 3

for line in sys.stdin:
    message = json.loads(line)
    percept = Percept(**message["percept"])
    try:
        if "episode" in message:
            run = algorithm1(percept)
            action = next(run)
        else:
            action = run.send(percept)
        while isinstance(action, Checkpoint):
            action = run.send(None)
        said = {"move": action.k}
    except StopIteration as stop:
        said = {"estimate": 7 if SPOILT else {**stop.value.map.to_json(), "here": stop.value.here}}
    print(json.dumps(said), flush=True)
