"""An explorer of the package behind JSON lines, to be judged from outside.

    python proofs/coq/explorer_server.py NAME [POLICY]

NAME: a built-in explorer, or a wrong one of ``corpus/explorers.py`` (``no-retracing``).
POLICY answers the choices of a built-in explorer: fifo (default), lifo or nearest.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Generator
from typing import Any

from allworlds.corpus.explorers import EQUIVALENT_EXPLORERS, WRONG_EXPLORERS
from allworlds.explorers.loading import load
from allworlds.protocol.actions import Checkpoint, Drop, Estimate, Move, Percept
from allworlds.protocol.choices import Choices, policy_named

Begin = Callable[[Percept, int | None], Generator[Any, Any, Any]]


def explorer_named(name: str, policy: str) -> Begin:
    """A function that begins an episode from its first percept and the number told, if any."""
    for mutant in (*WRONG_EXPLORERS, *EQUIVALENT_EXPLORERS):
        if mutant.name == name:
            explore = mutant.explorer()
            return lambda first, _told: explore(first)
    player = load(name).player()
    return lambda first, told: player(first, Choices(policy_named(policy)), told)


def say(action: object) -> dict[str, Any]:
    """An action or a checkpoint as a line."""
    match action:
        case Move(k=k):
            return {"move": int(k)}
        case Checkpoint(sigma=sigma, alpha=alpha, here=here):
            return {"checkpoint": {"sigma": [*sigma], "alpha": [*alpha], "here": here}}
        case Drop():
            return {"drop": True}
    return {"unknown": repr(action)}


def answer(estimate: object) -> dict[str, Any]:
    """The explorer's answer as a line; null for anything but an estimate."""
    if not isinstance(estimate, Estimate):
        return {"estimate": None}
    return {"estimate": {**estimate.map.to_json(), "here": estimate.here}}


def serve(begin: Begin) -> None:
    """Answer each line on stdin until there is none."""
    walk: Generator[Any, Any, Any] | None = None
    for line in sys.stdin:
        message = json.loads(line)
        told = message["percept"]
        percept = Percept(told["degree"], told["marks"], told["bearing"])
        reply: Percept | None = percept
        if "episode" in message:
            walk, reply = begin(percept, message.get("told")), None
        assert walk is not None, "an episode begins with an episode line"
        try:
            while isinstance(action := walk.send(reply), Checkpoint):
                print(json.dumps(say(action)))
                reply = None
        except StopIteration as stop:
            print(json.dumps(answer(stop.value)), flush=True)
        else:
            print(json.dumps(say(action)), flush=True)


if __name__ == "__main__":
    serve(explorer_named(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "fifo"))
