"""The adversary of corridors: its answers are true in the world that it leaves."""

from itertools import pairwise
from random import Random

import networkx as nx
import pytest

from allworlds.explorers import built_in
from allworlds.inputs import InputError
from allworlds.judging import Answered, play
from allworlds.maps import CorridorShape, augmented, family, rooted_isomorphism
from allworlds.protocol import Checkpoint, Choices, Drop, Move, policy_named
from allworlds.world import Deciding, IllegalAction, adversary_named
from small import long

TESTERS = ("algorithm1", "remembering", "greedy", "prudent")


def named(size, seed=1):
    return adversary_named(f"adversary:corridor:{size}", seed)


def fresh(policy):
    return Choices(policy_named(policy))


def played(size, explorer, seed=1, policy="fifo"):
    """The adversary after a play, the play, and that of the explorer in the world that is left."""
    deciding, budget = Deciding(named(size, seed)), 1_000_000
    player = built_in(explorer).player(settled=deciding.hear)
    first = play(deciding, player, fresh(policy), budget, watch=deciding.heed)
    left = deciding.world()
    return deciding, first, play(left, built_in(explorer).player(), fresh(policy), budget)


def assert_a_bad_world(size, explorer, seed=1, policy="fifo"):
    """The theorem on testers: how many pairs they exclude, and what they walk; return the pairs."""
    deciding, first, again = played(size, explorer, seed, policy)
    world, shape = deciding.world(), named(size).shape
    assert again == first
    assert isinstance(first.ending, Answered)
    found, state = first.ending.estimate, world.initial
    for action in first.transcript.actions:
        state, _ = world.step(state, action)
    assert rooted_isomorphism(found.map, found.here, world.map, state.dart)
    assert first.transcript.cost >= shape.bound_of_testers
    assert deciding.excluded >= shape.excluded_by_testers
    # Each vertex that is settled behind an undecided dart is a far hub of its own.
    assert deciding.depended == 0
    assert len(deciding.settled) <= shape.far
    return deciding.excluded


# Pairs that answers exclude: 56, 675 and 3,192 by a second program, from another matching.
@pytest.mark.no_cover
@pytest.mark.parametrize("explorer", TESTERS)
@pytest.mark.parametrize(
    ("size", "excluded"), [("1", 56), ("2", 675), ("1x14", 30), ("2x14", 99), long("3", 3192)]
)
def test_a_tester_walks_as_much_as_the_theorem_says_and_the_same_in_the_world_left(
    explorer, size, excluded
):
    assert assert_a_bad_world(size, explorer) == excluded


@pytest.mark.parametrize("policy", ["lifo", "nearest", "random:1", "random:2"])
@pytest.mark.parametrize("explorer", TESTERS[:2])
@pytest.mark.parametrize("size", ["1", long("2"), long("2x14")])
def test_no_order_of_darts_and_hypotheses_helps_a_tester(size, explorer, policy):
    assert_a_bad_world(size, explorer, policy=policy)


@pytest.mark.parametrize("seed", range(2, 6))
@pytest.mark.parametrize("explorer", TESTERS)
def test_no_loops_and_no_first_matching_help_a_tester(explorer, seed):
    assert_a_bad_world("1", explorer, seed)


# From the formulas of docs/theory.md, by hand for F = 1, 2, 3.
@pytest.mark.parametrize(
    ("size", "bound"),
    [
        *(("1", 96), ("2", 2916), ("3", 20880), ("4", 84840), ("5", 252720), ("6", 618156)),
        *(("1x14", 24), ("2x14", 220), ("1x20", 144)),
    ],
)
def test_the_bound_of_testers(size, bound):
    assert named(size).shape.bound_of_testers == bound


def test_the_bound_of_testers_is_of_the_order_of_the_bound_of_the_paper():
    shares = [
        shape.bound_of_testers / (shape.edges**2 * (shape.hubs + 1))
        for far in range(1, 60)
        for degree in range(12 * far + 6, 40 * far + 60, 14)
        for shape in [CorridorShape(far, degree)]
    ]
    assert min(shares) == shares[0] > 0.03
    assert max(shares) < 1 / 9


class Deaf(Deciding):
    """A mutant that does not hear what is settled."""

    def hear(self, settled):
        pass


@pytest.mark.no_cover
@pytest.mark.parametrize("explorer", TESTERS[1:])
def test_an_adversary_that_does_not_hear_what_is_settled_has_to_guess(explorer):
    deciding = Deaf(named("2"))
    play(deciding, built_in(explorer).player(settled=deciding.hear), Choices(), 100_000)
    assert deciding.depended > 0


def test_what_is_shown_of_algorithm_1_is_what_it_has_settled():
    deciding = Deciding(named("2"))
    play(deciding, built_in("algorithm1").player(), Choices(), 100_000, watch=deciding.heed)
    assert (len(deciding.settled), deciding.depended) == (1, 0)
    unshown = Deciding(named("2"))
    play(unshown, built_in("algorithm1").player(), Choices(), 100_000)
    assert (len(unshown.settled), unshown.depended) == (0, 1)


@pytest.mark.parametrize(
    "shown",
    [Checkpoint((0,), (), 0), Checkpoint((1, 0), (0, 2), 0), Checkpoint((0, 1), (0, 1), -1)],
)
def test_what_is_no_partial_map_settles_nothing(shown):
    assert Deciding(named("1")).heed(shown) == []


@pytest.mark.no_cover
def test_a_play_can_be_repeated_from_its_actions_and_what_was_settled():
    deciding, first, _ = played("2", "greedy")
    again = Deciding(named("2"))
    again.repeat(first.transcript.actions, deciding.settled)
    assert again.world() == deciding.world()
    assert (again.excluded, again.forced) == (deciding.excluded, deciding.forced)
    other = Deciding(named("2"))
    other.repeat(first.transcript.actions, [])
    assert other.depended > 0


@pytest.mark.parametrize("seed", range(4))
def test_every_answer_to_any_walk_is_true_in_the_world_left(seed):
    random = Random(seed)
    deciding = Deciding(named(1, seed))
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
    deciding = Credulous(named(1))
    corridor = deciding._corridor
    said = wrong = 0
    for root in sorted(deciding._allowed):
        walk, dart = way_to(deciding, root), deciding.world().map.alpha[root]
        while dart > 1:
            hub = 2 + (corridor.level(dart) - 1) * corridor.shape.degree
            motion = (hub - dart) % corridor.shape.degree
            walk.append(Move(motion))
            dart = deciding.world().map.alpha[hub]
        play_ = Credulous(named(1))
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
    assert named(2, 5).at_first.map == family("corridor:2", seed=5)


def test_a_corridor_has_no_markers():
    deciding = Deciding(named(1))
    with pytest.raises(IllegalAction, match="Move"):
        deciding.step(deciding.initial, Drop())


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("adversary:", "is not adversary:corridor:F or adversary:corridor:FxR"),
        ("adversary:lattice:2x2", "is not adversary:corridor:F or adversary:corridor:FxR"),
        ("adversary:corridor:0", "F is at least 1"),
        ("adversary:corridor:2x13", "R even and at least 14"),
        ("adversary:corridor:24", "10,585 edges, more than 10,000"),
    ],
)
def test_another_text_is_no_adversary(text, said):
    with pytest.raises(InputError, match=said):
        adversary_named(text)


@pytest.mark.parametrize("size", ["1", "3", "1x14", "3x14"])
def test_an_adversary_is_named_as_it_is_written(size):
    assert str(named(size)) == f"adversary:corridor:{size}"


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
