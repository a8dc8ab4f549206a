"""Rings of which one edge may be missing in each round, and robots that visit all vertices.

Source: Di Luna, Dobrev, Flocchini, Santoro, Distributed Exploration of Dynamic Rings, Distributed
Computing 33 (2020), of which the abstract alone was read: two robots that know n and have no
chirality are said to need 3n - 6 rounds.  The program here is ours and has one orientation.
"""

from __future__ import annotations

import re

import dynamic_ring
from allworlds import Move
from allworlds.claims import Found, Means, truth
from allworlds.robots import SearchOutcome
from check import Round, left_out
from worlds import named, ring, searches


def outcomes(vertices: int, rounds: int, options: str) -> list[SearchOutcome]:
    """The searches of two that end after so many rounds, from every start."""
    team = [dynamic_ring.catch_and_bounce(lambda _n: rounds)] * 2
    model = named(f"one-interval:{options}")
    return [*searches([ring(vertices)], model, team, "fsync")]


def rounds_of(found: SearchOutcome) -> list[Round]:
    """The rounds of a run as ``check.py`` has them, from the words of the adversary."""
    rounds = []
    for event in found.events:
        turns = {turn.robot: turn.did.k for turn in event.turns if isinstance(turn.did, Move)}
        missing = re.search(r"edge (\d+) is missing", event.world)
        ports = re.search(r"on their ports are \[(.*)\]", event.world)
        first = [int(each) for each in ports[1].split(", ")] if ports else [*turns]
        waiting = [robot for robot in turns if robot not in first]
        rounds.append((turns, int(missing[1]) if missing else None, waiting))
    return rounds


def really_fails(vertices: int, found: SearchOutcome) -> bool:
    """Whether a run that leaves vertices out does so when it is walked anew."""
    return found.law == "answer" and left_out(vertices, found.search.starts, rounds_of(found)) > 0


def fewest_rounds(vertices: int, options: str, most: int) -> int:
    """The fewest rounds that are enough from every start; more than ``most``: none up to that."""
    for rounds in range(most + 1):
        failing = [found for found in outcomes(vertices, rounds, options) if not found.holds]
        if not failing:
            return rounds
        assert all(really_fails(vertices, found) for found in failing)
    return most + 1


APART, ANYWHERE = "one_face=true", "one_face=true,apart=false"


def dynamic_one(_: Means, *, vertices: int) -> Found:
    """One robot that walks on is kept at its port for ever."""
    model, starved, total = named("one-interval:ends=true"), 0, 0
    for n in range(3, vertices + 1):
        for found in searches([ring(n)], model, [dynamic_ring.onward], "fsync"):
            total += 1
            starts = found.search.starts
            held = {event.state.darts for event in found.events} == {tuple(starts)}
            held = held and left_out(n, starts, rounds_of(found)) == n - 1
            starved += found.law == "progress" and held
    return Found(truth(starved == total), {"searches": total})


def dynamic_two(_: Means, *, vertices: int) -> Found:
    """The fewest rounds that are enough: from different vertices, and from any."""
    sizes = range(3, vertices + 1)
    apart = [fewest_rounds(n, APART, 3 * n) for n in sizes]
    anywhere = [fewest_rounds(n, ANYWHERE, 3 * n) for n in sizes]
    right = apart == [3 * n - 6 for n in sizes] and anywhere == [3 * n - 5 for n in sizes]
    return Found(truth(right), {"rings": len(sizes)}, {"apart": apart, "anywhere": anywhere})


def dynamic_facing(_: Means, *, vertices: int) -> Found:
    """Without one orientation, or with ports for two, our program fails after 4n rounds too."""
    failing, shortest = 0, []
    for n in range(3, vertices + 1):
        for options in ("apart=true", "one_face=true,apart=false,exclusive=false"):
            broken = [each for each in outcomes(n, 4 * n, options) if really_fails(n, each)]
            failing += bool(broken)
            shortest.append(min((len(each.events) for each in broken), default=0))
    return Found(truth(failing == len(shortest)), {"rings": failing}, {"events": shortest})
