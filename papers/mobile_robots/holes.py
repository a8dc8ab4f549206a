"""A black hole in a ring, whose size is known.

Source: Dobrev, Flocchini, Prencipe, Santoro, Mobile Search for a Black Hole in an Anonymous Ring,
Algorithmica 48 (2007), for asynchronous agents with whiteboards: two are necessary and enough.
Balamohan, Flocchini, Miri, Santoro, Time Optimal Algorithms for Black Hole Search in Rings, COCOA
2010: any number needs 2(n - 2) units of time.  Here are rounds, or Look-Compute-Move: other models.
"""

from __future__ import annotations

from typing import Any

import black_holes
from allworlds import Automaton, Do, Move, Percept
from allworlds.claims import Found, Means, truth
from allworlds.robots import SearchOutcome, search
from check import Decision, leaves_home, swallowed
from small_automata import by_table, tables
from worlds import named, ring


def hole(
    vertices: int, program: Any, scheduler: Any, options: str = "", robots: int = 2
) -> SearchOutcome:
    """The search of robots in a ring, with the hole at every vertex."""
    model = named(f"black-hole{options}")
    return search(ring(vertices), [0] * robots, model, [program] * robots, scheduler)


def of_degree(program: Automaton) -> Automaton:
    """The program, for a percept whose first part is the degree."""
    return Automaton(0, lambda state, percept: program.step(state, Percept(percept[0])))


def hole_one(_: Means, *, vertices: int) -> Found:
    """One robot: each automaton of two states falls in, or never answers."""
    laws: dict[str, int] = {"never": 0, "progress": 0}
    searched = wrong = 0
    for n in range(3, vertices + 1):
        for table in tables([2]):
            found = hole(n, of_degree(by_table(table)), "fsync", robots=1)
            said = "never" if leaves_home(table) else "progress"
            laws[said] += 1
            searched, wrong = searched + 1, wrong + (found.law != said)
    figures = {"lost": laws["never"], "without an answer": laws["progress"]}
    return Found(truth(not wrong), {"searches": searched}, figures)


def hole_two(_: Means, *, vertices: int) -> Found:
    """The cautious walk in pairs: right in rounds, its worst time; both are lost in central."""
    worst, bound, right, lost = [], [], True, []
    for n in range(3, vertices + 1):
        rounds = hole(n, black_holes.cautious, "fsync")
        right = right and rounds.holds
        worst.append(rounds.longest)
        bound.append(2 * (n - 2))
        alone = hole(n, black_holes.cautious, "central")
        walks = [black_holes.cautious(None, told=(n, robot)) for robot in range(2)]
        begun = [(walk, False) for walk in walks]
        right = right and alone.law == "never"
        right = right and both_swallowed(n, alone, begun, cautiously, whole=True)
        lost.append(len(alone.events))
    figures = {"worst rounds": worst, "2(n - 2)": bound, "events until both are lost": lost}
    return Found(truth(right), {"rings": len(worst)}, figures)


def cautiously(memory: Any, percept: Any) -> Decision:
    """A step of the cautious walk, as ``check.py`` has it: it is told nothing at first."""
    walk, told = memory
    action = walk.send(percept if told else None)
    return (walk, True), None, action.k if isinstance(action, Move) else None


def by_halves(memory: Any, percept: Any) -> Decision:
    """A step of the program with the list at home, as ``check.py`` has it."""
    after, action = black_holes.halves.step(memory, percept)
    if isinstance(action, Move):
        return after, None, action.k
    return after, action.value["write"] if isinstance(action, Do) else None, None


def both_swallowed(
    vertices: int, found: SearchOutcome, memories: list[Any], decide: Any, *, whole: bool = False
) -> bool:
    """Whether both are lost when the run is made anew."""
    steps = [[turn.robot for turn in event.turns] for event in found.events]
    at = found.events[-1].state.hole
    return swallowed(vertices, at, memories, decide, steps, whole=whole) == 2


def hole_lost_update(_: Means, *, vertices: int) -> Found:
    """A list at home that is read, and written later: lost in async, safe if that is one step."""
    lost, right = [], True
    for n in range(4, vertices + 1):
        for scheduler in ("fsync", "ssync", "central"):
            right = right and hole(n, black_holes.halves, scheduler).holds
        found = hole(n, black_holes.halves, "async")
        begun = [black_holes.halves.begun([n, robot]) for robot in range(2)]
        right = right and found.law == "never" and both_swallowed(n, found, begun, by_halves)
        lost.append(len(found.events))
        right = right and hole(n, black_holes.halves, "async", ":at_once=true").holds
    return Found(truth(right), {"rings": len(lost)}, {"events until both are lost": lost})
