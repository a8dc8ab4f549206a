from itertools import product
from random import Random

import pytest

from allworlds.judging.laws.folding import Contradiction, fold
from allworlds.maps import CombinatorialMap, rooted_code, rooted_maps
from allworlds.protocol.actions import Percept
from allworlds.world import Directional, World
from judging.test_folding import agree, embedding, explored, log_of, random_walk, walk, worlds


@pytest.mark.parametrize("m", [1, 2, 3, 4])
def test_the_log_of_algorithm_1_folds_to_the_world(m):
    for world in (w for w in worlds(m) if w.map.edge_count == m):
        log, dart = explored(world)
        folded = fold(log)
        assert folded.open_darts == 0
        code = rooted_code(world.map.sigma, world.map.alpha, dart)
        assert rooted_code(folded.sigma, folded.alpha, folded.here) == code
        # The darts of v0 stand first, from the dart faced at the start.
        start = rooted_code(world.map.sigma, world.map.alpha, world.start)
        assert rooted_code(folded.sigma, folded.alpha, 0) == start
        assert embedding(folded, world)[folded.here] == dart


@pytest.mark.parametrize("seed", range(12))
def test_the_fold_of_any_walk_is_a_part_of_the_world(seed):
    random = Random(seed)
    for world in worlds(3):
        log, dart = random_walk(world, random)
        image = embedding(fold(log), world)
        assert image[fold(log).here] == dart


def test_the_fold_of_walks_in_larger_worlds_is_a_part_of_them():
    random = Random(7)
    for map_ in rooted_maps(4):
        world = World(map_, Directional(map_.turn(0, random.randrange(9))))
        log, dart = random_walk(world, random, 60)
        assert embedding(fold(log), world)[fold(log).here] == dart


@pytest.mark.parametrize("seed", range(6))
def test_two_ways_of_folding_agree_on_random_walks(seed):
    random = Random(seed)
    for world in worlds(3):
        agree(random_walk(world, random)[0])


def completed(folded, bearing):
    """A world with this fold as a part: a leaf at the end of every open dart."""
    sigma, alpha = list(folded.sigma), list(folded.alpha)
    for d, e in enumerate(folded.alpha):
        if d == e:
            leaf = len(sigma)
            sigma.append(leaf)
            alpha.append(d)
            alpha[d] = leaf
    map_ = CombinatorialMap(sigma, alpha)
    return World(map_, Directional(map_.turn(0, bearing)))


def all_logs(length):
    """Every log of this length with degrees up to 2, right or contradictory."""
    percepts = [Percept(1), Percept(2), Percept(1, 1, 0), Percept(2, 1, 0), Percept(2, 1, 1)]
    for first in percepts[2:]:
        for seen in product(percepts, repeat=length):
            degrees = [p.degree for p in (first, *seen[:-1])]
            for motions in product(*map(range, degrees)):
                yield log_of(first, *zip(motions, seen, strict=True))


@pytest.mark.parametrize("length", [1, 2, 3, 4])
def test_a_log_is_folded_exactly_where_some_world_has_it(length):
    possible = {
        walk(world, motions)[0]
        for world in worlds(3)
        for motions in product(range(2), repeat=length)
    }
    folded, refused, wrong = 0, 0, []
    for log in all_logs(length):
        try:
            found = fold(log)
        except Contradiction:
            assert log not in possible
            refused += 1
            continue
        folded += 1
        try:
            world = completed(found, log.first.bearing)
            agrees = walk(world, [action.k for action, _ in log.steps])[0] == log
        except ValueError:
            agrees = False
        if not agrees:
            wrong.append(log)
    assert folded
    assert refused
    assert not wrong, f"{len(wrong)} logs of no world were folded, for example {wrong[0]}"
