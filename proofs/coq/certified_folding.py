"""The folding extracted from the Coq proofs, held against the package's two.

Every log of Algorithm 1 and of every mutant, in every world, is folded three times: by the
extracted program, which is proved to compute the least congruence; by the judge, which must find
the same map, dart by dart; and by the compiled judge, which names darts as the world does, and must
say the same of whether one is open.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numba import njit

from allworlds.corpus.explorers import (
    EQUIVALENT_EXPLORERS,
    WRONG_EXPLORERS,
    WrongExplorer,
)
from allworlds.engines.kernel.arrays import FOLD, LOG, WORLD
from allworlds.engines.kernel.laws import folds
from allworlds.explorers.builtin.algorithm1 import Algorithm1
from allworlds.explorers.loading import in_process_subject, load
from allworlds.judging.episode import play
from allworlds.judging.laws.bounds import paper_bound
from allworlds.judging.laws.folding import fold
from allworlds.protocol.actions import Move, Percept, Transcript
from allworlds.protocol.choices import Choices, policy_named
from allworlds.world import World, worlds
from certified_checker import agreement, answered_by

FOLDING = Path(__file__).resolve().parent / "folding"
POLICIES = ("fifo", "lifo", "nearest")


def logs(edges: int) -> Iterator[tuple[str, World, Transcript]]:
    """Every log, with its explorer's name and its world; also of runs without an answer."""
    mutants = (WrongExplorer(Algorithm1), *WRONG_EXPLORERS, *EQUIVALENT_EXPLORERS)
    players = [
        *((f"algorithm1 {name}", load("algorithm1").player(), name) for name in POLICIES),
        *(
            (mutant.name, in_process_subject(mutant.explorer()).player(), "fifo")
            for mutant in mutants
        ),
    ]
    for world in worlds(edges=edges, places="all"):
        # All that answer within their bound, and the one that then walks every edge both ways.
        m = world.map.edge_count
        budget = paper_bound(world.map.vertex_count, m) + 2 * m
        for name, player, policy in players:
            log = play(world, player, Choices(policy_named(policy)), budget).transcript
            yield name, world, log


def steps_of(log: Transcript) -> list[tuple[int, Percept]]:
    """The motions of a log, and what was sensed after each."""
    return [(action.k, percept) for action, percept in log.steps if isinstance(action, Move)]


def line_of(log: Transcript) -> str:
    """The log as the extracted program reads it."""

    def shown(percept: Percept) -> dict[str, Any]:
        return {"degree": percept.degree, "bearing": percept.bearing}

    steps = [[k, shown(percept)] for k, percept in steps_of(log)]
    return json.dumps({"first": shown(log.first), "steps": steps})


def folded_by_judge(log: Transcript) -> dict[str, Any]:
    """The judge's folding, in the extracted program's words."""
    folded = fold(log)
    return {
        "folds": folded.open_darts == 0,
        "sigma": [*folded.sigma],
        "alpha": [*folded.alpha],
        "here": folded.here,
    }


@njit
def _folds(world: Any, log: Any, fold: Any) -> bool:
    return folds(world[0], log[0], fold[0])  # type: ignore[no-any-return]  # compiled


def folds_compiled(world: World, log: Transcript) -> bool:
    """Whether the compiled judge, which knows the log's world, finds no open dart."""
    map_, steps = world.map, steps_of(log)
    laid, walked, room = (np.zeros(1, record) for record in (WORLD, LOG, FOLD))
    walked["cost"] = len(steps)
    for dart in map_.darts:
        laid["alpha"][0, dart] = map_.alpha[dart]
        laid["degree"][0, dart] = map_.degree_at[dart]
    dart = world.start
    for i, (k, percept) in enumerate(steps):
        dart = map_.alpha[map_.turn(dart, k)]
        walked["arrived"][0, i] = dart
        laid["marks"][0, dart] = percept.marks
    return bool(_folds(laid, walked, room))


def foldings_agree(edges: int) -> bool:
    """Whether all three fold every log to the same."""
    # An explorer walks in many worlds the same way: each log once.
    found = {line_of(log): (name, world, log) for name, world, log in logs(edges)}
    answers = [json.loads(line) for line in answered_by(FOLDING, [f"{log}\n" for log in found])]
    differ, open_logs = [], 0
    for (name, world, log), certified in zip(found.values(), answers, strict=True):
        open_logs += not certified["folds"]
        compiled = folds_compiled(world, log)
        if folded_by_judge(log) != certified or compiled != certified["folds"]:
            differ.append((name, log))
    print(
        f"certified folding: {len(found):,} different logs, {open_logs:,} with open darts; "
        f"{len(differ)} folded otherwise by the judge or the compiled judge"
    )
    for name, log in differ[:3]:
        print(f"  {name}: {line_of(log)}")
    tried = 0 < open_logs < len(found)
    return agreement(not differ, tried, "no log, or every log, has an open dart")
