"""The rows of the table of the field: programs, models, worlds, schedulers, and what is right.

The programs stand in ``examples/robots``.
"""

import importlib.util
from itertools import product
from pathlib import Path

import pytest

from allworlds.maps import CombinatorialMap, MapClass, rooted_maps
from allworlds.maps.combinatorial import distances
from allworlds.maps.families import family
from allworlds.robots.model import SCHEDULERS
from allworlds.robots.models.goals import are_apart
from allworlds.robots.models.table import model_of
from allworlds.robots.single_search import search
from small import EDGE, LOOP, all_maps, slowest

EXAMPLES = Path(__file__).parents[2] / "examples" / "robots"


def load(name):
    spec = importlib.util.spec_from_file_location(f"robots_{name}", EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


black_holes = load("black_holes")
dynamic_ring = load("dynamic_ring")
gathering = load("gathering")
handshake = load("handshake")
hidden = load("hidden_marker")
perpetual = load("perpetual")
rendezvous = load("rendezvous")
two_mappers = load("two_mappers")

P4 = CombinatorialMap((0, 2, 1, 4, 3, 5), (1, 0, 3, 2, 5, 4))


def named(text):
    return model_of(text)[0]


def searches(maps, model, team, scheduler, **limits):
    """The search of each map with each start."""
    for map_ in maps:
        for starts in model.starts(map_, len(team)):
            yield search(map_, starts, model, team, scheduler, **limits)


# ---------------------------------------------------------------- oblivious robots on rings

EXPLORING = "snapshot:goal=explore,exclusive=true,crossing=false"


def placements(model, map_):
    """The starts, in which robots 1 and 2 come in one order: they are anonymous."""
    return [start for start in model.starts(map_, 3) if start[1] < start[2]]


def ring_searches(program, scheduler, *, turned=True):
    """The search of each placement; unless ``turned``, of one of those that are turned alike."""
    model, map_ = named(EXPLORING), family("cycle:10")
    for start in placements(model, map_):
        gaps = gaps_of(start, 10)
        if turned or gaps == min(gaps[k:] + gaps[:k] for k in range(3)):
            yield start, search(map_, start, model, [program] * 3, scheduler)


def gaps_of(start, vertices):
    """From each robot to the next one."""
    at = [dart // 2 for dart in start]
    return [(b - a) % vertices for a, b in zip(at, [*at[1:], at[0]], strict=True)]


@pytest.mark.parametrize("scheduler", ["fsync", "ssync", "central"])
def test_the_old_rule_is_safe_if_look_and_move_are_one_step(scheduler):
    laws = {found.law for _, found in ring_searches(perpetual.old, scheduler, turned=False)}
    assert laws == {""}


def test_the_old_rule_leads_two_to_one_vertex_in_async():
    """From three robots side by side alone; a shortest run has 12 events."""
    found = {start: each for start, each in ring_searches(perpetual.old, "async") if each.law}
    assert {tuple(sorted(gaps_of(start, 10))) for start in found} == {(1, 1, 8)}
    assert {(each.law, each.seen) for each in found.values()} == {
        ("never", "two are at one vertex")
    }
    shortest = min(found.values(), key=lambda each: len(each.events))
    assert len(shortest.events) == 12
    assert sum(len(event.turns) for event in shortest.events) == 16


def test_the_new_rule_explores_for_ever_in_async():
    """With 427 configurations from all starts."""
    met = set()
    for _, found in ring_searches(perpetual.new, "async"):
        assert found.holds
        met |= {*found.search.states}
    assert len(met) == 427


def right_rules(every, scheduler):
    model, map_ = named("snapshot"), family("cycle:5")
    starts = placements(model, map_)
    for rules in every:
        team = [gathering.by_rules(rules)] * 3
        if all(search(map_, start, model, team, scheduler).holds for start in starts):
            yield rules


def test_of_36_rule_sets_13_and_4_and_2_gather():
    """The rules with a tower are fixed: the third robot walks to it, and the pair stays."""
    tower, pairs = gathering.to_the_tower(5), gathering.pairs(5, (1, 1, 1))
    left = [{**rules, **tower} for rules in gathering.every_rule_set(pairs)]
    numbers = [len(left)]
    for scheduler in ("fsync", "ssync", "async"):
        left = [*right_rules(left, scheduler)]
        numbers.append(len(left))
    assert numbers == [36, 13, 4, 2]
    model, map_ = named("snapshot"), family("cycle:5")
    for found in searches([map_], model, [gathering.explore] * 3, "async"):
        assert found.holds


@pytest.mark.slowest
def test_of_all_2916_rule_sets_407_and_14_and_10_gather():
    pairs = gathering.pairs(5, (1, 1, 1)) + gathering.pairs(5, (1, 2))
    left = [*gathering.every_rule_set(pairs)]
    numbers = [len(left)]
    for scheduler in ("fsync", "ssync", "async"):
        left = [*right_rules(left, scheduler)]
        numbers.append(len(left))
    assert numbers == [2916, 407, 14, 10]


# ---------------------------------------------------------------- to meet


@pytest.mark.parametrize(
    ("scheduler", "law"), [("fsync", "progress"), ("central", ""), ("async", "progress")]
)
def test_on_an_edge_each_goes_to_the_other(scheduler, law):
    team = [rendezvous.to_the_other] * 2
    found = search(EDGE, (0, 1), named("meeting"), team, scheduler)
    assert (found.law, bool(found.loop)) == (law, bool(law))


def shrink(map_, one, other):
    """The least distance to which one word of moves leads both; None if their views differ."""
    met, queue = {(one, other)}, [(one, other)]
    for a, b in queue:
        if map_.degree_at[a] != map_.degree_at[b]:
            return None
        for k in range(map_.degree_at[a]):
            after = map_.move(a, k), map_.move(b, k)
            if after not in met:
                met.add(after)
                queue.append(after)
    return min(distance(map_, a, b) for a, b in queue)


def distance(map_, one, other):
    return distances(map_, map_.vertex_of[one])[map_.vertex_of[other]]


@pytest.mark.parametrize(
    ("map_", "numbers"),
    [(family("cycle:4"), {0: 4, 1: 16, 2: 4}), (P4, {None: 10, 1: 3})],
)
def test_anonymous_robots_never_meet_where_a_word_of_moves_leaves_them_apart(map_, numbers):
    model, counted = named("meeting"), {}
    for one, other in product(map_.darts, repeat=2):
        if one >= other or not are_apart(map_, (one, other)):
            continue
        least = shrink(map_, one, other)
        counted[least] = counted.get(least, 0) + 1
        for program in (rendezvous.walk, rendezvous.zigzag, rendezvous.tree):
            found = search(map_, (one, other), model, [program] * 2, "fsync", budget=40)
            assert not (least and found.holds)
            assert not found.law
    assert counted == numbers


@pytest.mark.parametrize("edges", [3, slowest(5)])
@pytest.mark.parametrize(
    ("scheduler", "number"), [("fsync", 969), ("central", 1629), ("async", 2591)]
)
def test_who_waits_is_found(scheduler, number, edges):
    """From 488 starts in maps with 3 edges, 87,756 with 5."""
    model = named("meeting:labels=true,apart=false")
    every = [*searches(all_maps(edges), model, [rendezvous.mommy] * 2, scheduler)]
    assert all(found.holds for found in every)
    assert len(every) == {3: 488, 5: 87_756}[edges]
    assert edges == 5 or sum(found.configurations for found in every) == number


@pytest.mark.parametrize("edges", [4, slowest(5)])
@pytest.mark.parametrize("scheduler", SCHEDULERS)
def test_two_robots_draw_the_map_of_each_simple_world(scheduler, edges):
    """140 worlds with 5 edges."""
    maps = [m for size in range(1, edges + 1) for m in rooted_maps(size, MapClass.SIMPLE)]
    assert len(maps) == {4: 32, 5: 140}[edges]
    team = [two_mappers.leader, two_mappers.follower]
    assert all(found.holds for found in searches(maps, named("face-to-face"), team, scheduler))


# ---------------------------------------------------------------- edges that are missing


def rounds_hold(vertices, rounds, options):
    model, map_ = named(f"one-interval{options}"), family(f"cycle:{vertices}")
    team = [dynamic_ring.catch_and_bounce(lambda _: rounds)] * 2
    return all(found.holds for found in searches([map_], model, team, "fsync"))


@pytest.mark.parametrize("vertices", [3, 4, 5, slowest(6)])
def test_catch_and_bounce_takes_3n_minus_6_rounds_from_two_vertices(vertices):
    assert rounds_hold(vertices, 3 * vertices - 6, ":one_face=true")
    assert not rounds_hold(vertices, 3 * vertices - 7, ":one_face=true")
    assert rounds_hold(vertices, 3 * vertices - 5, ":one_face=true,apart=false")
    assert not rounds_hold(vertices, 3 * vertices - 6, ":one_face=true,apart=false")
    for more in (0, 5):
        assert not rounds_hold(vertices, 3 * vertices + more, "")


def test_two_on_one_port_move_as_one():
    assert not rounds_hold(3, 12, ":one_face=true,apart=false,exclusive=false")


def test_one_robot_is_starved():
    model = named("one-interval:ends=true")
    for found in searches([family("cycle:3")], model, [dynamic_ring.onward], "fsync"):
        assert (found.law, found.loop) == ("progress", 1)
        assert "is missing" in found.events[-1].world


# ---------------------------------------------------------------- black holes, faults


def hole(vertices, program, scheduler, options=""):
    (found,) = searches(
        [family(f"cycle:{vertices}")], named(f"black-hole{options}"), [program] * 2, scheduler
    )
    return found


@pytest.mark.parametrize("vertices", range(3, 9))
def test_a_cautious_walk_needs_rounds(vertices):
    assert hole(vertices, black_holes.cautious, "fsync").holds
    found = hole(vertices, black_holes.cautious, "central")
    assert (found.law, found.seen, len(found.events)) == ("never", "nobody is left", 4)


@pytest.mark.parametrize("vertices", range(3, 9))
def test_a_list_that_is_read_and_written_in_two_steps_is_lost_in_async(vertices):
    found = hole(vertices, black_holes.halves, "async")
    assert found.law == ("never" if vertices > 3 else "")
    for scheduler in ("fsync", "ssync", "central"):
        assert hole(vertices, black_holes.halves, scheduler).holds


@pytest.mark.parametrize("vertices", range(3, 7))
def test_a_list_that_is_read_and_written_in_one_step_is_safe_in_async(vertices):
    assert hole(vertices, black_holes.halves, "async", ":at_once=true").holds


def test_what_a_program_has_forgotten_is_no_configuration_of_an_automaton():
    assert len(hole(5, black_holes.halves, "central").search) == 220
    assert len(hole(5, black_holes.halves_remembered, "central").search) == 3664


def test_careless_robots_are_both_lost():
    found = hole(4, black_holes.careless, "central")
    assert (found.law, len(found.events)) == ("never", 8)


def test_one_hidden_marker_is_enough_for_a_wrong_map():
    model = named("hidden:1+lighthouse:directional")
    wrong = {}
    for map_ in all_maps(2):
        found = search(map_, (0,), model, [hidden.mapper], "fsync", budget=120)
        if found.law:
            wrong[map_.edge_count] = found.seen, len(found.events)
    assert wrong == {2: ("a wrong map", 14)}


@pytest.mark.parametrize("scheduler", SCHEDULERS)
def test_a_handshake_by_watching_holds_and_by_polling_is_unfinished(scheduler):
    model = named("shared-whiteboard:goal=agree,labels=true,apart=false")
    assert search(LOOP, (0, 0), model, [handshake.watching] * 2, scheduler).holds
    for budget in (4, 9):
        found = search(LOOP, (0, 0), model, [handshake.polling] * 2, scheduler, budget=budget)
        assert not found.law
        assert bool(found.unfinished) == (scheduler != "fsync")
