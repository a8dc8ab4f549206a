"""The adversary of corridors: its answers are true in the world that it leaves."""

from itertools import pairwise
from random import Random

import networkx as nx
import pytest

import adversary
import explorers
from adversary import Deciding, against
from allworlds import Checkpoint, Choices, Move, World, run
from allworlds.claims import Algorithm1
from allworlds.maps import family, rooted_isomorphism
from allworlds.protocol.choices import policy_named
from corridors import Shape, usual_shape
from matching import augmented
from playing import played
from small import slowest
from testers import order_exact

TESTERS = ("algorithm1", "remembering", "greedy", "prudent")


def shape_of(size):
    """The shape with F far hubs, or with F hubs of degree R."""
    return Shape(*size) if isinstance(size, tuple) else usual_shape(size)


def made(explorer, policy="fifo"):
    """The generator function of an explorer; it tells ``settled`` what it settles, if it can."""

    def explore(first, **more):
        if explorer == "algorithm1":
            return Algorithm1(first, Choices(policy_named(policy))).explore()
        if explorer == "remembering":
            more["choices"] = Choices(policy_named(policy))
        return getattr(explorers, explorer)(first, **more)

    return explore


def decided(size, explorer, seed=1, policy="fifo", kind=Deciding):
    """The adversary after a play, and the play."""
    deciding, explore = kind(shape_of(size), seed), made(explorer, policy)
    if explorer == "algorithm1":
        return deciding, played(explore, deciding, deciding.heed)
    return deciding, played(lambda first: explore(first, settled=deciding.hear), deciding)


def assert_a_bad_world(size, explorer, seed=1, policy="fifo"):
    """The theorem on testers: how many pairs they exclude, and what they walk; return the pairs."""
    deciding, walk = decided(size, explorer, seed, policy)
    world, shape = deciding.world(), shape_of(size)
    again = played(made(explorer, policy), world)
    assert again == walk
    found, state = walk.answer, world.initial
    for action in walk.actions:
        state, _ = world.step(state, action)
    assert rooted_isomorphism(found.map, found.here, world.map, state.dart)
    assert len(walk.actions) >= shape.bound_of_testers
    assert deciding.excluded >= shape.excluded_by_testers
    # Each vertex that is settled behind an undecided dart is a far hub of its own.
    assert deciding.depended == 0
    assert len(deciding.settled) <= shape.far
    return deciding.excluded


# Pairs that answers exclude: 56, 675 and 3,192 by a second program, from another matching.
@pytest.mark.parametrize("explorer", TESTERS)
@pytest.mark.parametrize(
    ("size", "excluded"), [(1, 56), (2, 675), ((1, 14), 30), ((2, 14), 99), slowest(3, 3192)]
)
def test_a_tester_walks_as_much_as_the_theorem_says_and_the_same_in_the_world_left(
    explorer, size, excluded
):
    assert assert_a_bad_world(size, explorer) == excluded


@pytest.mark.parametrize("policy", ["lifo", "nearest", "random:1", "random:2"])
@pytest.mark.parametrize("explorer", TESTERS[:2])
@pytest.mark.parametrize("size", [1, slowest(2), slowest((2, 14))])
def test_no_order_of_darts_and_hypotheses_helps_a_tester(size, explorer, policy):
    assert_a_bad_world(size, explorer, policy=policy)


@pytest.mark.parametrize("seed", range(2, 6))
@pytest.mark.parametrize("explorer", TESTERS)
def test_no_loops_and_no_first_matching_help_a_tester(explorer, seed):
    assert_a_bad_world(1, explorer, seed)


# From the formulas of the page on lower bounds, by hand for F = 1, 2, 3.
@pytest.mark.parametrize(
    ("size", "bound"),
    [
        *((1, 96), (2, 2916), (3, 20880), (4, 84840), (5, 252720), (6, 618156)),
        *(((1, 14), 24), ((2, 14), 220), ((1, 20), 144)),
    ],
)
def test_the_bound_of_testers(size, bound):
    assert shape_of(size).bound_of_testers == bound


def test_the_bound_of_testers_is_of_the_order_of_the_bound_of_the_paper():
    shares = [
        shape.bound_of_testers / (shape.edges**2 * (shape.hubs + 1))
        for far in range(1, 60)
        for degree in range(12 * far + 6, 40 * far + 60, 14)
        for shape in [Shape(far, degree)]
    ]
    assert min(shares) == shares[0] > 0.03
    assert max(shares) < 1 / 9


class Deaf(Deciding):
    """A mutant that does not hear what is settled."""

    def hear(self, settled):
        pass


@pytest.mark.parametrize("explorer", TESTERS[1:])
def test_an_adversary_that_does_not_hear_what_is_settled_has_to_guess(explorer):
    deciding, _ = decided(2, explorer, kind=Deaf)
    assert deciding.depended > 0


def test_what_is_shown_of_algorithm_1_is_what_it_has_settled():
    deciding, _ = decided(2, "algorithm1")
    assert (len(deciding.settled), deciding.depended) == (1, 0)
    unshown = Deciding(usual_shape(2), 1)
    played(made("algorithm1"), unshown)
    assert (len(unshown.settled), unshown.depended) == (0, 1)


@pytest.mark.parametrize(
    "shown",
    [Checkpoint((0,), (), 0), Checkpoint((1, 0), (0, 2), 0), Checkpoint((0, 1), (0, 1), -1)],
)
def test_what_is_no_partial_map_settles_nothing(shown):
    assert Deciding(usual_shape(1), 1).heed(shown) == []


def test_algorithm_1_gets_its_own_bad_world():
    told = against("algorithm1", usual_shape(1), 1)
    assert told.same
    assert told.cost == told.run.cost == 882
    assert told.run.world.map != family("corridor:1", seed=1)
    again = run("algorithm1", World.from_json(told.run.world.to_json()))
    assert again.transcript == told.run.transcript


class Generous(Deciding):
    """An adversary that excludes nothing: it makes the first pair that is asked for an edge."""

    def _exclude(self, root, wanted):
        for y in wanted:
            self._mate |= {self._mate[root]: self._mate[y], self._mate[y]: self._mate[root]}
            self._mate |= {root: y, y: root}
        return not wanted


def verdict(explorer):
    return order_exact(None, far=1, explorers=[explorer]).verdict


def test_a_tester_that_does_less_than_every_tester_must_refutes_the_claim(monkeypatch):
    assert verdict("algorithm1") == "holds"
    monkeypatch.setattr(adversary, "Deciding", Generous)
    told = against("algorithm1", usual_shape(1), 1)
    assert told.same
    assert told.deciding.excluded < usual_shape(1).excluded_by_testers == 24
    assert verdict("algorithm1") == "refuted"


def test_an_explorer_that_walks_otherwise_in_the_world_left_refutes_the_claim(monkeypatch):
    calls = []

    def changing(first, *, settled=explorers.unseen):
        calls.append(first)
        if len(calls) > 1:
            return (yield from Algorithm1(first, Choices()).explore())
        return (yield from greedy(first, settled=settled))

    greedy = explorers.greedy
    monkeypatch.setattr(explorers, "greedy", changing)
    assert not against("greedy", usual_shape(1), 1).same
    calls.clear()
    assert verdict("greedy") == "refuted"


@pytest.mark.parametrize("seed", range(4))
def test_every_answer_to_any_walk_is_true_in_the_world_left(seed):
    random = Random(seed)
    deciding = Deciding(usual_shape(1), seed)
    walk = [Move(random.choice([-5, -4, -3, 0, 1, 2, 4, 5, 6, 7, 9])) for _ in range(3000)]
    percepts = [deciding.step(deciding.initial, action)[1] for action in walk]
    world = deciding.world()
    state, seen = world.initial, []
    for action in walk:
        state, percept = world.step(state, action)
        seen.append(percept)
    assert seen == percepts
    assert deciding.excluded + deciding.forced + deciding.depended > 8


class Credulous(Deciding):
    """A mutant that excludes no pair: it always says that the robot is not at home."""

    def _exclude(self, root, wanted):
        return True


def test_an_adversary_that_excludes_no_pair_says_what_is_untrue():
    deciding = Credulous(usual_shape(1), 1)
    corridor = deciding._corridor
    said = wrong = 0
    for root in sorted(deciding._allowed):
        walk, dart = way_to(deciding, root), deciding.world().map.alpha[root]
        while dart > 1:
            hub = 2 + (corridor.shape.level(dart) - 1) * corridor.shape.degree
            motion = (hub - dart) % corridor.shape.degree
            walk.append(Move(motion))
            dart = deciding.world().map.alpha[hub]
        play_ = Credulous(usual_shape(1), 1)
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
    assert Deciding(usual_shape(2), 5).world().map == family("corridor:2", seed=5)


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
