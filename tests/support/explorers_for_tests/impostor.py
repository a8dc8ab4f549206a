"""The package's own explorers behind JSON lines, in the place of the certified ones.

Usage: impostor.py HOW POLICY LIGHTHOUSE.  HOW: honest; lifo: whatever policy it is told; pose: the
robot one place clockwise; mirrored: as if clockwise were anticlockwise, so that it walks another
way, but over all worlds exactly as far; renamed: its map with other names of the darts.
"""

import json
import sys

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.protocol.actions import Checkpoint, Percept
from allworlds.protocol.choices import Choices, policy_named

HOW, POLICY, LIGHTHOUSE = sys.argv[1:]
NAMES = {
    "directional": "algorithm1",
    "cluster": "algorithm1-cluster",
    "natural": "algorithm1-natural",
}
if HOW == "lifo":
    POLICY = "lifo"


def heard(percept):
    bearing = percept["bearing"]
    if HOW == "mirrored" and bearing is not None:
        bearing = -bearing % percept["degree"]
    return Percept(percept["degree"], percept["marks"], bearing)


def say(**message):
    sys.stdout.write(json.dumps(message) + "\n")
    sys.stdout.flush()


def answered(estimate):
    sigma, alpha, here = list(estimate.map.sigma), list(estimate.map.alpha), estimate.here
    darts = range(len(sigma))
    if HOW == "mirrored":
        sigma = [sigma.index(d) for d in darts]
    if HOW == "pose":
        here = sigma[here]
    if HOW == "renamed":
        last = len(sigma) - 1
        sigma = [last - sigma[last - d] for d in darts]
        alpha = [last - alpha[last - d] for d in darts]
        here = last - here
    return {"sigma": sigma, "alpha": alpha, "here": here}


explorer = None
for line in sys.stdin:
    message = json.loads(line)
    percept = heard(message["percept"])
    if "episode" in message:
        told = {"told": message["told"]} if "told" in message else {}
        explore = BUILT_IN[NAMES[LIGHTHOUSE]].explore
        explorer = explore(percept, choices=Choices(policy_named(POLICY)), **told)
        percept = None
    try:
        action = explorer.send(percept)
        while isinstance(action, Checkpoint):
            action = next(explorer)
        say(move=-action.k if HOW == "mirrored" else action.k)
    except StopIteration as stop:
        say(estimate=answered(stop.value))
