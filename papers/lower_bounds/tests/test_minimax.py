"""Minimax: the best that any explorer can do, and the strategy that does it."""

from functools import cache
from itertools import product

import pytest

from allworlds import Estimate, Move, World
from allworlds.claims import Unfinished
from allworlds.maps import rooted_code
from allworlds.world import Directional
from bouquets import bound_of_information, bouquets, cautious_cost, number_of_bouquets, told_apart
from in_every_world import most_expensive
from minimax import Places, Search, Solved, StrategyLeaf, StrategyStep, minimax
from optima import fewest_traversals
from small import EDGE, LOOP, all_maps, slow


def worlds(edges):
    return [
        World(map_, place)
        for map_ in all_maps(edges)
        if map_.edge_count == edges
        for place in Directional.places(map_, 0)
    ]


def given(worlds):
    return [(world.map, world.start, world.lighthouse.dart) for world in worlds]


# Found by an independent program, too.
@pytest.mark.parametrize(("edges", "best"), [(1, 0), (2, 1), (3, 4), slow(4, 9)])
def test_the_optimum_over_all_worlds_is_that_of_its_strategy(edges, best):
    found = minimax(given(worlds(edges)))
    assert found.traversals == best
    assert most_expensive(found.strategy, worlds(edges)) == best


def brute_force(group, most):
    """Whether so many traversals are enough, by trying every strategy in worlds as they are."""
    codes = {rooted_code(world.map.sigma, world.map.alpha, state.dart) for world, state in group}
    if len(codes) == 1:
        return True
    if most == 0:
        return False
    degree = group[0][0].sensed(group[0][1]).degree
    for k in range(degree):
        parts = {}
        for world, state in group:
            after, percept = world.step(state, Move(k))
            parts.setdefault(percept, []).append((world, after))
        if all(brute_force(part, most - 1) for part in parts.values()):
            return True
    return False


@pytest.mark.parametrize(("edges", "best"), [(1, 0), (2, 1), (3, 4)])
def test_a_search_without_any_memory_finds_the_same(edges, best):
    starts = {}
    for world in worlds(edges):
        starts.setdefault(world.first, []).append((world, world.initial))
    assert all(brute_force(group, best) for group in starts.values())
    assert best == 0 or not all(brute_force(group, best - 1) for group in starts.values())


@cache
def best_for_three():
    return minimax(given(worlds(3))).strategy


def test_every_spoilt_strategy_is_noticed():
    strategy = best_for_three()
    first = next(i for i, node in enumerate(strategy.nodes) if isinstance(node, StrategyStep))
    leaf = next(i for i, node in enumerate(strategy.nodes) if isinstance(node, StrategyLeaf))
    step = strategy.nodes[first]
    answer = strategy.nodes[leaf].answer
    mirrored = Estimate(answer.map.mirrored(), answer.map.sigma[answer.here])
    spoilt = [
        (first, step._replace(then=step.then[1:])),
        (first, step._replace(then=tuple(one._replace(node=first) for one in step.then))),
        (leaf, StrategyLeaf(answer=Estimate(LOOP, 0))),
        (leaf, StrategyLeaf(answer=mirrored)),
    ]
    for number, node in spoilt:
        nodes = [*strategy.nodes]
        nodes[number] = node
        assert most_expensive(strategy._replace(nodes=tuple(nodes)), worlds(3)) is None
    assert most_expensive(strategy._replace(start=()), worlds(3)) is None


def test_a_strategy_for_fewer_worlds_is_none_for_more():
    found = minimax([(EDGE, 0, 0)])
    assert found == Solved(0, found.strategy)
    assert most_expensive(found.strategy, [World(EDGE, Directional(0))]) == 0
    assert most_expensive(found.strategy, worlds(1)) is None


def test_what_is_known_of_the_bearing_does_not_matter_but_the_place_does():
    for edges in (1, 2):
        strategy = minimax(given(worlds(edges))).strategy
        answers = [node.answer for node in strategy.nodes if isinstance(node, StrategyLeaf)]
        assert all(answer.here in answer.map.darts for answer in answers)


def test_relabelling_the_worlds_changes_nothing():
    shifted = [
        (world.map.relabelled(names), names[world.start], names[world.lighthouse.dart])
        for world in worlds(2)
        for names in [[(dart + 1) % 4 for dart in world.map.darts]]
    ]
    assert minimax(shifted).strategy == minimax(given(worlds(2))).strategy


def test_no_two_explorations_of_one_percept_are_mixed_up():
    for one, other in product(worlds(1), repeat=2):
        solved = minimax(given([one, other]))
        assert most_expensive(solved.strategy, [one, other]) == solved.traversals == 0


# 16: found by an independent program, too (1,412 states there).
# Of information: Coq, bouquet_lower_bound; c(2c+1): Theorem 3 of the page on the theory.
@pytest.mark.parametrize(
    ("loops", "best", "counted", "cautious"),
    [(1, 0, 0, 3), (2, 4, 4, 10), (3, 9, 9, 21), slow(4, 16, 14, 36)],
)
def test_the_optimum_of_bouquets_lies_between_two_known_bounds(loops, best, counted, cautious):
    assert fewest_traversals(bouquets(loops), told_apart) == best
    assert bound_of_information(number_of_bouquets(loops)) == counted
    assert cautious_cost(loops) == cautious


@pytest.mark.slow
def test_what_is_known_before_changes_nothing():
    assert fewest_traversals(bouquets(3)) == 9


@pytest.mark.parametrize("spoilt", [None, 7])
def test_a_strategy_that_needs_another_number_decides_nothing(monkeypatch, spoilt):
    monkeypatch.setattr("optima.most_expensive", lambda *_: spoilt)
    with pytest.raises(Unfinished, match="does not need 4 traversals"):
        fewest_traversals(bouquets(2))


def start_of(worlds, limit=None):
    """A search, and the one state of knowledge at the start."""
    search = Search(Places(), limit)
    (start,) = search.places.parted([search.places.number(*one) for one in given(worlds)])
    return search, start.known


def test_a_motion_that_is_found_leaves_one_traversal_less():
    search, known = start_of(bouquets(3), told_apart)
    for left in range(9, 0, -1):
        assert search.value(known) == left
        enough, motion = search.motion(known, left)
        assert enough == left
        parts = [part.known for part in search.places.moved(known, motion)]
        known = max(parts, key=search.value)
    assert search.value(known) == 0


@pytest.mark.parametrize("limit", [lambda _, left: left, lambda _, left: 2 * left])
def test_a_limit_that_is_too_low_is_noticed(limit):
    search, known = start_of(bouquets(3), limit)
    assert not search.within(known, 9)
