"""A robot in place of a marker, a marker that fails; two robots with labels, and with lights.

Source: Dudek, Jenkin, Milios, Wilkes, Robotic Exploration as Graph Construction (1991), for a
marker.  Lights: Viglietta, Rendezvous of Two Robots with Visible Bits, ALGOSENSORS 2013; Defago,
Heriban, Tixeuil, Wada, Using Model Checking to Formally Verify Rendezvous Algorithms, SRDS 2020.
"""

from __future__ import annotations

from typing import Any

import hidden_marker
import lights as lit
import rendezvous
import two_mappers
from allworlds import CombinatorialMap, Do, End, Move, World, run
from allworlds.claims import Found, Means, Picture, truth
from allworlds.maps import rooted_maps
from allworlds.robots import search
from check import apart_for_ever, gathers
from worlds import EDGE, SCHEDULERS, named, searches, simple_worlds


def second_robot(_: Means, *, edges: int) -> Found:
    """Two robots draw the map of each simple world, under every scheduler; and what they walk."""
    model, team = named("face-to-face"), [two_mappers.leader, two_mappers.follower]
    worlds, right, walked, cost = [*simple_worlds(edges)], 0, [0, 0], 0
    for map_ in worlds:
        right += all(search(map_, (0, 0), model, team, each).holds for each in SCHEDULERS)
        for robot, steps in enumerate(moves_of_both(map_)):
            walked[robot] += steps
        cost += run("dudek91", World(map_, "movable")).cost
    same = walked[0] == cost
    figures = {"steps of the leader": walked[0], "of the follower": walked[1], "of dudek91": cost}
    return Found(truth(right == len(worlds) and same), {"worlds": right}, figures)


def moves_of_both(map_: CombinatorialMap) -> list[int]:
    """The steps of each robot, one round after another."""
    model, team = named("face-to-face"), [two_mappers.leader, two_mappers.follower]
    (state,) = model.initial(map_, (0, 0))
    memories, steps = [robot.begun(number) for number, robot in enumerate(team)], [0, 0]
    while True:
        acts: dict[int, Any] = {}
        for robot, program in enumerate(team):
            percept = model.sensed(map_, state, robot)
            memories[robot], action = program.step(memories[robot], percept)
            if isinstance(action, End):
                return steps
            steps[robot] += isinstance(action, Move)
            if isinstance(action, Move | Do):
                acts[robot] = action
        ((state, _words),) = model.step(map_, state, acts)


def hidden_once(_: Means, *, edges: int) -> Found:
    """Algorithm 1, whose marker is not seen once: the smallest wrong answer."""
    model, by_law, worlds, first = named("hidden:1+lighthouse:directional"), dict[str, int](), 0, []
    for size in range(1, edges + 1):
        for map_ in rooted_maps(size):
            worlds += 1
            found = search(map_, (0,), model, [hidden_marker.mapper], "fsync", budget=120)
            name = found.law or ("unfinished" if found.unfinished else "right")
            by_law[name] = by_law.get(name, 0) + 1
            if found.law == "answer" and not first:
                first = [size, len(found.events)]
                picture = Picture(
                    "the smallest world with a wrong answer", World(map_, "directional")
                )
    figures = {"edges and events of the first": first, **by_law}
    pictures = (picture,) if first else ()
    return Found(truth("answer" not in by_law), {"worlds": worlds}, figures, pictures)


def labels(_: Means, *, edges: int) -> Found:
    """Robot 0 waits, robot 1 looks for it: they meet in every world, from any start."""
    model, starts, right = named("meeting:labels=true,apart=false"), [], 0
    team = [rendezvous.mommy] * 2
    for scheduler in SCHEDULERS:
        maps = [map_ for size in range(1, edges + 1) for map_ in rooted_maps(size)]
        found = [*searches(maps, model, team, scheduler)]
        starts.append(len(found))
        right += sum(each.holds for each in found)
    return Found(truth(right == sum(starts)), {"searches": right}, {"starts": starts[0]})


def across(ahead: tuple[int, ...]) -> tuple[int]:
    """The rule of a robot on one edge, a ring of two vertices: go to the other one."""
    return (1,) if ahead[0] == 1 else (0,)


def to_the_other(_: Means) -> Found:
    """Two on one edge, each of which goes to the other one; and by ``check.py``."""
    laws, loops = [], 0
    for scheduler in SCHEDULERS:
        found = search(EDGE, (0, 1), named("meeting"), [rendezvous.to_the_other] * 2, scheduler)
        laws.append(f"{scheduler}: {found.law or 'they meet'}")
        loops += found.loop > 0
    meets = ["they meet" in law for law in laws]
    right = meets == [gathers((0, 1), 2, across, scheduler) for scheduler in SCHEDULERS]
    right = right and meets == [False, False, True, False]
    return Found(truth(right and loops == 3), {"cycles": loops}, {"verdicts": laws})


def lights(_: Means) -> Found:
    """Search the rules under each scheduler, the light changing with the look or with the move."""
    figures: dict[str, list[str]] = {"with the look": [], "with the move": []}
    configurations, loop, checked = 0, 0, False
    for late, laws in enumerate(figures.values()):
        for scheduler in SCHEDULERS:
            model, team = lit.Lights(bool(late)), [lit.two_colours] * 2
            found = search(EDGE, (0, 1), model, team, scheduler)
            laws.append(f"{scheduler}: {found.law or 'one point'}")
            configurations += found.configurations
            if found.loop:
                loop = found.loop
                events = [[turn.robot for turn in event.turns] for event in found.events]
                checked = apart_for_ever(lit.RULES, events, lit.BLACK)
    right = [f"{scheduler}: one point" for scheduler in SCHEDULERS]
    expected = [right, [*right[:-1], "async: progress"]]
    holds = checked and [*figures.values()] == expected
    witnesses = {"configurations": configurations, "events of the cycle": loop}
    return Found(truth(holds), witnesses, figures)
