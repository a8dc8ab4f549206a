"""The shield extracted from the Coq proofs, held against the package's.

The certified shield walks all that its proof speaks of: each turn from the start, and back by
undoing the motions.  Here the same walk is made by Python, run by run, and compared; and the
package's shield, which walks nothing that its log knows, must never walk more.

Inside is an explorer that stops at once, one that moves on for ever, one that zigzags, and
Algorithm 1, last in first out.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from itertools import count
from pathlib import Path
from typing import Any

from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.builtin.folding import FoldedLog, Shield, estimate, has_open_dart
from allworlds.explorers.loading import load
from allworlds.judging.episode import Answered, EpisodeEnding, play
from allworlds.judging.laws.bounds import paper_bound
from allworlds.maps import rooted_code
from allworlds.maps.combinatorial import Code
from allworlds.protocol.actions import Checkpoint, Estimate, Move, Percept, Player
from allworlds.protocol.choices import Choices, policy_named
from allworlds.world import worlds
from certified_checker import agreement, not_lost

EXPLORER = Path(__file__).resolve().parent / "explorer"

Explore = Callable[[Percept], Generator[Any, Any, Any]]


def stops(_first: Percept) -> Generator[Any, Any, None]:
    """Stop at once."""
    return
    yield


def spins(_first: Percept) -> Generator[Any, Any, None]:
    """Take the next dart, for ever."""
    while True:
        yield Move(1)


def zigzags(_first: Percept) -> Generator[Any, Any, None]:
    """Take the first, the fourth, the ninth dart, and so on, modulo 7."""
    for k in count(1):
        yield Move(k * k % 7)


def last_first(first: Percept) -> Generator[Any, Any, Estimate]:
    """Algorithm 1, last in first out."""
    return (yield from algorithm1(first, choices=Choices(policy_named("lifo"))))


INSIDE: dict[str, Explore] = {
    "stop": stops,
    "spin": spins,
    "zigzag": zigzags,
    "algorithm1": last_first,
}
"""The explorers inside, by the names that the certified shield has for them."""


def walks_all(explorer: Explore) -> Explore:
    """The shield as its proof speaks of it."""

    def explore(first: Percept) -> Generator[Any, Any, Estimate]:
        log = FoldedLog(first)
        here = log.turn(0, -(first.bearing or 0))
        due = 0
        for turn in count():
            made: list[tuple[int, int]] = []
            walk, seen = (explorer, algorithm1)[turn % 2](first), None
            degree = first.degree
            while len(made) < 2**turn:
                try:
                    message = walk.send(seen)
                except StopIteration:
                    break
                seen = None
                if isinstance(message, Checkpoint):
                    continue
                made.append((message.k, degree))
                leaving = log.turn(here, due + message.k)
                seen = yield Move(due + message.k)
                here, due, degree = log.arrive(leaving, seen), 0, seen.degree
                if not has_open_dart(log):
                    return estimate(log, here)
            for k, size in reversed(made):
                leaving = log.turn(here, due)
                here = log.arrive(leaving, (yield Move(due)))
                due = -k % size
        raise AssertionError("turns have no end")

    return explore


def _player(explorer: Explore) -> Player:
    return lambda first, _choices, _told: explorer(first)


def _code(ending: EpisodeEnding) -> Code | None:
    """The map of an answer, with the robot in it, whatever its darts are called."""
    answer = ending.answer if isinstance(ending, Answered) else None
    if not isinstance(answer, Estimate):
        return None
    return rooted_code(answer.map.sigma, answer.map.alpha, answer.here)


def shields_agree(edges: int) -> bool:
    """Whether the certified shield walks as proved, and the package's never more."""
    agree = tried = True
    for name, explorer in INSIDE.items():
        certified = load(f"exec:{EXPLORER} fifo shield:{name}")
        players = [certified.player(), _player(walks_all(explorer)), _player(Shield(explorer))]
        runs, differ, more, walked, saved = 0, 0, 0, 0, 0
        with certified.running():
            for world in worlds(edges=edges, places="all"):
                bound = 9 * paper_bound(world.map.vertex_count, world.map.edge_count)
                proved, same, ours = (play(world, p, Choices(), bound) for p in players)
                runs += 1
                not_lost(f"the certified shield of {name}", proved.ending)
                code = _code(proved.ending)
                differ += (
                    code is None
                    or code != _code(same.ending)
                    or proved.transcript != same.transcript
                )
                more += ours.transcript.cost > proved.transcript.cost
                walked += proved.transcript.cost
                saved += proved.transcript.cost - ours.transcript.cost
        print(
            f"certified shield of {name}: {runs:,} runs, {differ} of them walked or answered "
            f"otherwise; {walked:,} traversals, of which the package's saves {saved:,}, and walks "
            f"more in {more}"
        )
        agree = agree and not differ and not more
        tried = tried and saved > 0
    return agreement(agree, tried, "the package's shield has saved nothing")
