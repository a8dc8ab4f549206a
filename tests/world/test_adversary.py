"""The adversary of corridors: its answers are true in the world that it leaves."""

from itertools import pairwise
from random import Random

import networkx as nx
import pytest

from allworlds.explorers import built_in
from allworlds.inputs import InputError
from allworlds.judging import Answered, play
from allworlds.maps import augmented, bound_of_testers, family, rooted_isomorphism
from allworlds.protocol import Choices, Drop, Move
from allworlds.world import Adversary, Deciding, IllegalAction, adversary_named

TESTERS = ("algorithm1", "remembering", "greedy", "prudent")


def played(far, explorer, seed=1):
    """The adversary after a play, the play, and that of the explorer in the world that is left."""
    deciding = Deciding(Adversary(far, seed))
    budget = 1_000_000
    first = play(deciding, built_in(explorer).player(), Choices(), budget)
    world = deciding.world()
    return deciding, first, play(world, built_in(explorer).player(), Choices(), budget)


def assert_a_bad_world(far, explorer, excluded):
    deciding, first, again = played(far, explorer)
    world = deciding.world()
    assert again == first
    assert isinstance(first.ending, Answered)
    assert rooted_isomorphism(first.ending.estimate.map, first.ending.estimate.here, world.map, 0)
    assert first.transcript.cost >= bound_of_testers(far)
    assert deciding.excluded == excluded
    assert deciding.settled < far


# Pairs that answers exclude: docs/theory.md, 'Lower bounds'; 56, 675 and 3,192 by a second program.
@pytest.mark.parametrize("explorer", TESTERS)
def test_a_tester_walks_as_much_as_the_theorem_says_and_the_same_in_the_world_left(explorer):
    assert_a_bad_world(1, explorer, 56)
    assert_a_bad_world(2, explorer, 675)


@pytest.mark.slow
@pytest.mark.parametrize("explorer", TESTERS[:3])
def test_a_tester_with_three_far_hubs(explorer):
    assert_a_bad_world(3, explorer, 3192)


def test_the_bound_of_testers():
    assert [bound_of_testers(far) for far in (1, 2, 3, 4, 5, 6)] == [
        96,
        2916,
        20880,
        84840,
        252720,
        618156,
    ]


@pytest.mark.parametrize("seed", range(4))
def test_every_answer_to_any_walk_is_true_in_the_world_left(seed):
    random = Random(seed)
    deciding = Deciding(Adversary(1, seed))
    walk = [Move(random.choice([-5, -4, -3, 0, 1, 2, 4, 5, 6, 7, 9])) for _ in range(3000)]
    percepts = [deciding.step(deciding.initial, action)[1] for action in walk]
    world = deciding.world()
    state, seen = world.initial, []
    for action in walk:
        state, percept = world.step(state, action)
        seen.append(percept)
    assert seen == percepts
    assert deciding.excluded + deciding.forced + deciding.settled > 8


class Credulous(Deciding):
    """A mutant that excludes no pair: it always says that the robot is not at home."""

    def _exclude(self, root, wanted):
        return True


def test_an_adversary_that_excludes_no_pair_says_what_is_untrue():
    deciding = Credulous(Adversary(1, 1))
    # Read at a root, this word leads home if the root is open dart 10 of the first far hub.
    corridor = deciding._corridor
    said = wrong = 0
    for root in sorted(deciding._allowed):
        walk, dart = way_to(deciding, root), deciding.world().map.alpha[root]
        while dart > 1:
            hub = 2 + (corridor.level(dart) - 1) * corridor.degree
            motion = (hub - dart) % corridor.degree
            walk.append(Move(motion))
            dart = deciding.world().map.alpha[hub]
        play_ = Credulous(Adversary(1, 1))
        percepts = [play_.step(play_.initial, action)[1] for action in walk]
        said += 1
        wrong += percepts[-1].marks == 0
    assert wrong == said == 16


def way_to(deciding, leaving):
    """The motions from the start out by an open dart."""
    map_, start = deciding.world().map, 0
    graph = nx.DiGraph()
    for d in range(len(map_.sigma)):
        for k in range(map_.degree_at[d]):
            out = map_.turn(d, k)
            if out not in deciding._allowed:
                graph.add_edge(d, map_.alpha[out], motion=k)
    at = next(
        d
        for d in map_.vertices[map_.vertex_of[leaving]]
        if d not in deciding._allowed and graph.has_node(d) and nx.has_path(graph, start, d)
    )
    path = nx.shortest_path(graph, start, at)
    walk = [Move(graph.edges[edge]["motion"]) for edge in pairwise(path)]
    return [*walk, Move(map_.offset(at, leaving))]


def test_at_first_the_world_is_that_of_the_family_with_the_same_seed():
    assert Adversary(2, 5).at_first.map == family("corridor:2", seed=5)


def test_a_corridor_has_no_markers():
    deciding = Deciding(Adversary(1))
    with pytest.raises(IllegalAction, match="Move"):
        deciding.step(deciding.initial, Drop())


@pytest.mark.parametrize("text", ["adversary:", "adversary:corridor:0", "adversary:lattice:2x2"])
def test_another_text_is_no_adversary(text):
    with pytest.raises(InputError, match=r"adversary:corridor:F with 1 <= F <= 20"):
        adversary_named(text)


def test_matchings_grow_to_the_size_that_networkx_finds():
    random, odd = Random(3), 0
    for _ in range(150):
        n = random.randrange(2, 15)
        graph = nx.gnm_random_graph(n, random.randrange(1, 2 * n), seed=random.randrange(10**6))
        allowed, mate = {v: {*graph[v]} for v in graph}, {}
        for root in range(n):
            if root not in mate:
                mate = augmented(allowed, mate, root) or mate
        assert all(mate[mate[v]] == v and mate[v] in allowed[v] for v in mate)
        assert len(mate) == 2 * len(nx.max_weight_matching(graph, maxcardinality=True))
        odd += any(n.bit_count() and len(c) % 2 for c in nx.cycle_basis(graph))
    assert odd > 50
