"""Three oblivious robots that explore a ring for ever, never two at one vertex or across an edge.

Source: Blin, Milani, Potop-Butucaru, Tixeuil, Exclusive Perpetual Ring Exploration without
Chirality, DISC 2010; its fault: Berard, Lafourcade, Millet, Potop-Butucaru, Thierry-Mieg, Tixeuil,
Formal Verification of Mobile Robot Protocols, Distributed Computing 29 (2016).  The rules are those
that Millet prints (thesis, UPMC 2015), see ``examples/robots/perpetual.py``.  With stop: Flocchini,
Ilcinkas, Pelc, Santoro, Computing without Communicating: Ring Exploration by Asynchronous Oblivious
Robots, Algorithmica 65 (2013).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import perpetual
from allworlds import Automaton, CombinatorialMap, Do, Wait
from allworlds.claims import Found, Means, truth
from allworlds.robots import QUIET, Liveness, SearchOutcome, search
from check import Event, explores, fewest_steps, replayed, turned_onto_itself
from lazy_rules import Unruled, some_rules
from worlds import arrangements, gaps_of, named, placements, places_of, ring, steps_by

EXPLORING = "snapshot:goal=explore,exclusive=true,crossing=false"


def runs(
    program: Automaton, vertices: int, scheduler: Any, starts: Sequence[tuple[int, ...]] = ()
) -> Iterator[tuple[tuple[int, ...], SearchOutcome]]:
    """The search of each start of three robots, or of these starts."""
    map_, model = ring(vertices), named(EXPLORING)
    for start in starts or placements(vertices, 3):
        yield start, search(map_, start, model, [program] * len(start), scheduler)


def as_steps(outcome: SearchOutcome) -> list[Event]:
    """The events of a run, as ``check.py`` has them."""
    events: list[Event] = []
    for event in outcome.events:
        steps: list[tuple[int, int | None]] = []
        for turn in event.turns:
            due = event.state.due[turn.robot]
            decided = 0 if due is None else 1 - 2 * (due % 2)
            steps.append((turn.robot, None if turn.sensed is None else decided))
        events.append(steps)
    return events


def collisions(vertices: int) -> list[tuple[tuple[int, ...], SearchOutcome]]:
    """The starts from which the old rules lead to a collision in async, with a shortest run."""
    return [each for each in runs(perpetual.old, vertices, "async") if each[1].law == "never"]


def fewest_in(vertices: int, program: Automaton) -> int | None:
    """The fewest steps of single robots to a collision from any start, by another search."""
    starts = [places_of(start) for start in placements(vertices, 3)]
    return fewest_steps(vertices, starts, steps_by(program))


def perpetual_old(_: Means, *, others: list[int]) -> Found:
    """Search the collision at n = 10, replay it, count its steps by another search; others."""
    found = collisions(10)
    safe = sum(not collisions(n) and fewest_in(n, perpetual.old) is None for n in others)
    witnesses = {"starts with a collision": len(found), "rings without": safe}
    if not found:
        return Found("holds", witnesses)
    start, shortest = min(found, key=lambda each: len(each[1].events))
    events = as_steps(shortest)
    steps = sum(map(len, events))
    real = replayed(10, places_of(start), events, steps_by(perpetual.old))
    fewest = fewest_in(10, perpetual.old)
    gaps = {tuple(sorted(gaps_of(places_of(each), 10))) for each, _ in found}
    figures = {
        "events": len(events),
        "steps": steps,
        "fewest steps one at a time": fewest or 0,
        "gaps of the starts": [*min(gaps)],
    }
    refuted = real and fewest == steps and safe == len(others) and len(gaps) == 1
    return Found(truth(not refuted), witnesses, figures, told="three side by side, async")


def perpetual_schedulers(_: Means, *, vertices: int) -> Found:
    """Search the old rules where Look and Move are one step, each start in two ways."""
    right = searched = 0
    for scheduler in ("fsync", "ssync", "central"):
        for start, outcome in runs(perpetual.old, vertices, scheduler):
            searched += 1
            safe = explores(places_of(start), vertices, steps_by(perpetual.old), scheduler)
            right += outcome.holds and safe
    return Found(truth(right == searched), {"searches": searched})


def perpetual_new(_: Means, *, rings: list[int]) -> Found:
    """Search the corrected rules in async from all starts, in two ways."""
    configurations, right = [], True
    for n in rings:
        met: set[Any] = set()
        for _start, outcome in runs(perpetual.new, n, "async"):
            right = right and outcome.holds
            met |= {*outcome.search.states}
        configurations.append(len(met))
        rule = steps_by(perpetual.new)
        checked = (explores(places_of(each), n, rule, "async") for each in arrangements(n, 3))
        right = right and all(checked)
    return Found(truth(right), {"rings": len(rings)}, {"configurations": configurations})


def perpetual_twelve(_: Means) -> Found:
    """Search the corrected rules on the ring of 12: at equal gaps nobody ever moves."""
    starts = arrangements(12, 3)
    stuck = [start for start, found in runs(perpetual.new, 12, "async", starts) if not found.holds]
    rule = steps_by(perpetual.new)
    checked = [start for start in starts if not explores(places_of(start), 12, rule, "async")]
    equal = [start for start in starts if gaps_of(places_of(start), 12) == (4, 4, 4)]
    witnesses = {"arrangements": len(starts), "stuck": len(stuck)}
    return Found(truth(stuck == checked == equal), witnesses)


Attempt = Callable[[Automaton], bool]
"""Whether a program is right; it raises Unruled where a rule is missing that is needed."""


def searched_from(start: tuple[int, ...], vertices: int) -> Attempt:
    """The search of a program in ssync from a start."""

    def attempt(program: Automaton) -> bool:
        ((_, found),) = runs(program, vertices, "ssync", [start])
        if found.law == "crash":
            raise Unruled
        return found.holds

    return attempt


def checked_from(start: tuple[int, ...], vertices: int) -> Attempt:
    """The same by the program that shares nothing with the search."""
    return lambda program: explores(places_of(start), vertices, steps_by(program), "ssync")


def perpetual_none(_: Means, *, one: int, two: int, three: int) -> Found:
    """Try all rule sets of one, two and three robots from each start, on rings up to these."""
    begun, searched, right = [0, 0, 0], 0, 0
    for robots, most in ((1, one), (2, two), (3, three)):
        for n in range(max(3, robots + 1), most + 1):
            for start in arrangements(n, robots):
                number, found = some_rules(searched_from(start, n))
                begun[robots - 1] += number
                searched += 1
                right += found or some_rules(checked_from(start, n))[1]
    return Found(truth(not right), {"starts": searched}, {"rule sets begun": begun})


@dataclass(frozen=True)
class Stopping(type(named("snapshot"))):  # type: ignore[misc]  # the model of that name
    """Robots that see the whole map, and shall stop."""

    def progress(self, map_: CombinatorialMap) -> Iterator[Liveness]:  # noqa: ARG002  # anywhere
        """At last nobody moves."""
        yield QUIET


def always(action: Any) -> Automaton:
    """The robot that does the same in every view."""
    return Automaton(None, lambda memory, _views: (memory, action))


stays, goes = always(Wait()), always(Do("first"))
"""Both rules for the view of robots at equal distances: it is the same to both sides."""


def stopping(_: Means, *, cases: list[list[int]]) -> Found:
    """Search both rules: who stays does not explore, and who goes does not stop."""
    exploring, told = named("snapshot:goal=explore"), set[str]()
    refuted = alike = 0
    for vertices, robots in cases:
        places = range(0, vertices, vertices // robots)
        map_, start = ring(vertices), [2 * place for place in places]
        (state,) = exploring.initial(map_, start)
        views = [exploring.sensed(map_, state, robot) for robot in range(robots)]
        sides = [side for both in views for side in both]
        alike += all(side == sides[0] for side in sides) and turned_onto_itself(places, vertices)
        for model, program in ((exploring, stays), (Stopping(), goes)):
            found = search(map_, start, model, [program] * robots, "fsync")
            refuted += found.law == "progress" and found.loop > 0
            told.add(found.seen)
    holds = refuted == 2 * len(cases) and alike == len(cases)
    return Found(truth(holds), {"branches": refuted, "rings": alike}, {"broken": sorted(told)})
