from fractions import Fraction

import networkx as nx
import pytest
from hypothesis import given, strategies as st

from allworlds.explorers.builtin.algorithm1 import PartialMap, algorithm1, simple_path
from allworlds.maps import (
    CombinatorialMap,
    MapClass,
    from_cycles,
    from_rotation,
    rooted_code,
    rooted_maps,
)
from allworlds.maps.build import cycle, dense, lattice
from allworlds.protocol.actions import Checkpoint, Move, Percept
from allworlds.protocol.choices import Choices, policy_named
from schedules import schedules
from small import EDGE, LOOP, maps

POLICIES = ["fifo", "lifo", "nearest", "random:0", "random:1"]
FOUND_TWO = ["empty-H", "non-loop"] * 2


class Run:
    """Algorithm 1 walks a map from a dart, with the marker so many places clockwise of it."""

    def __init__(self, world, bearing=0, start=0, reply=None, **options):
        self.motions, self.checkpoints = [], []
        pointed = world.turn(start, bearing)
        at = start

        def sense(dart):
            if world.vertex_of[dart] != world.vertex_of[pointed]:
                return Percept(world.degree_at[dart])
            return Percept(world.degree_at[dart], 1, world.offset(dart, pointed))

        explorer = algorithm1(sense(start), **options)
        answer = None
        while True:
            try:
                message = explorer.send(answer)
            except StopIteration as stop:
                self.estimate = stop.value
                break
            if isinstance(message, Checkpoint):
                self.checkpoints.append(message)
                answer = reply
                continue
            assert isinstance(message, Move)
            self.motions.append(message.k % world.degree_at[at])
            at = world.alpha[world.turn(at, message.k)]
            answer = sense(at)
        found, here = self.estimate.map, self.estimate.here
        self.right = rooted_code(found.sigma, found.alpha, here) == rooted_code(
            world.sigma, world.alpha, at
        )

    @property
    def cost(self):
        return len(self.motions)


def placed(edges, map_class=MapClass.MAPS):
    """Every rooted map with every bearing at its root."""
    for world in rooted_maps(edges, map_class):
        for bearing in range(world.degree_at[0]):
            yield world, bearing


def bound(m, n):
    """The sum (1) + (2) of Section VI, expanded."""
    return (
        2 * m**2 * n
        - 2 * m * n**2
        + Fraction(2, 3) * n**3
        - 2 * m**2
        + 5 * m * n
        - Fraction(5, 2) * n**2
        - 2 * m
        + Fraction(11, 6) * n
    )


# ---------------------------------------------------------------- right, and how dear


@pytest.mark.parametrize("edges", [1, 2, 3])
@pytest.mark.parametrize("policy", POLICIES)
def test_every_world_is_mapped_pose_included_within_the_bound_under_every_policy(policy, edges):
    for index, (world, bearing) in enumerate(placed(edges)):
        run = Run(world, bearing, choices=Choices(policy_named(policy, str(index))))
        assert run.right
        assert edges <= run.cost <= bound(edges, world.vertex_count)


# The most expensive schedule of the most expensive world: from an independent program.
@pytest.mark.parametrize(("edges", "worst"), [(1, 1), (2, 4)])
def test_every_schedule_of_every_world_is_right_and_the_worst_costs_what_is_known(edges, worst):
    costs = set()
    for world, bearing in placed(edges):
        for choices in schedules():
            run = Run(world, bearing, choices=choices)
            assert run.right
            costs.add(run.cost)
    assert max(costs) == worst


@given(maps(most=8), st.data(), st.integers(0, 99))
def test_random_worlds_are_mapped_whatever_is_chosen(world, data, seed):
    start = data.draw(st.sampled_from(world.darts))
    bearing = data.draw(st.integers(0, world.degree_at[start] - 1))
    run = Run(world, bearing, start, choices=Choices(policy_named(f"random:{seed}")))
    assert run.right
    assert run.cost <= bound(world.edge_count, world.vertex_count)


# ---------------------------------------------------------------- what must not matter


@given(maps(), st.data())
def test_the_names_of_the_worlds_darts_do_not_matter(world, data):
    names = data.draw(st.permutations(world.darts))
    run, renamed = Run(world), Run(world.relabelled(names), start=names[0])
    assert (run.motions, run.estimate) == (renamed.motions, renamed.estimate)


def told(world, bearing=0, **options):
    run = Run(world, bearing, **options)
    return run.motions, run.checkpoints, run.estimate


@pytest.mark.parametrize("edges", [1, 2, 3])
def test_a_listener_changes_nothing(edges):
    for world, bearing in placed(edges):
        heard = []
        assert told(world, bearing) == told(world, bearing, notice=heard.append)
        # One augmentation for each edge, of which n - 1 lead to new vertices.
        assert heard.count("non-loop") == world.vertex_count - 1
        assert heard.count("loop") == edges - world.vertex_count + 1


@pytest.mark.parametrize("edges", [1, 2, 3])
def test_whatever_a_checkpoint_is_answered_changes_nothing(edges):
    for world, bearing in placed(edges):
        silent = told(world, bearing)
        assert told(world, bearing, reply=Percept(99, 5, 7)) == silent


@pytest.mark.parametrize("edges", [1, 2, 3])
def test_without_choices_the_first_is_always_chosen(edges):
    for world, bearing in placed(edges):
        choices = Choices()
        assert told(world, bearing) == told(world, bearing, choices=choices)
        assert set(choices.record) == {0}


@given(maps(), st.integers(0, 99))
def test_the_record_of_the_choices_replays_the_run(world, seed):
    choices = Choices(policy_named(f"random:{seed}"))
    run = told(world, choices=choices)
    assert told(world, choices=Choices(script=choices.record)) == run


@given(maps())
def test_after_each_pass_s_has_one_edge_more_and_the_last_is_the_estimate(world):
    run = Run(world)
    explored = [
        sum(d < e for d, e in enumerate(checkpoint.alpha)) for checkpoint in run.checkpoints
    ]
    assert explored == list(range(1, world.edge_count + 1))
    last = run.checkpoints[-1]
    assert run.estimate.map == CombinatorialMap(last.sigma, last.alpha)
    assert run.estimate.here == last.here


# ---------------------------------------------------------------- worlds by hand


@pytest.mark.parametrize(
    ("world", "bearing", "policy", "motions", "events"),
    [
        # Nothing to compare the far end with.
        (EDGE, 0, "fifo", [0], ["empty-H", "non-loop"]),
        # Back at v0 by the other dart: the bearing is the whole test.
        (LOOP, 0, "fifo", [0], ["v0-hypothesis", "case-3", "loop"]),
        (LOOP, 1, "fifo", [0], ["v0-hypothesis", "case-3", "loop"]),
        # A path from its end: the only open dart is the one explored.
        (
            from_cycles(["a", "ab", "b"]),
            0,
            "fifo",
            [0, 1],
            ["empty-H", "non-loop", "empty-H", "non-loop"],
        ),
        # The triangle v0 a b.  v0 to a.  Back to v0 and on to b, of degree 2 like a; if this
        # were a's open dart the next dart would lead to v0, but it leads to a: back again.
        # From b by v0 to a and by the third edge to b: its open dart, which v0 confirms.
        (
            cycle(3),
            0,
            "fifo",
            [0, 0, 1, 1, 0, 1, 1, 1, 1],
            ["empty-H", "non-loop", "case-2", "non-loop", "case-3", "loop"],
        ),
        # The same, but the newest dart first: round the triangle, and v0 is met by its open
        # dart, where the bearing is the whole test.
        (
            cycle(3),
            0,
            "lifo",
            None,
            ["empty-H", "non-loop", "empty-H", "non-loop", "v0-hypothesis", "case-3", "loop"],
        ),
        # A path, leaf c v0 a b leaf.  v0 to a, a to b: found.  b to a to v0 to c, of degree 2
        # like b.  If c were b's open dart the next dart would lead to a, of degree 2, but it
        # leads to a leaf: a mismatch before the end of the path; back again.
        (
            from_rotation([[3, 1], [0, 2], [1, 5], [0, 4], [3], [2]]),
            0,
            None,
            [1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 1, 1],
            [*FOUND_TWO, "case-1", "non-loop", *FOUND_TWO],
        ),
    ],
)
def test_worlds_made_by_hand_are_walked_as_by_hand(world, bearing, policy, motions, events):
    heard = []
    # Without a policy: newest dart first until b is known, then the oldest one.
    choices = Choices(policy_named(policy)) if policy else Choices(script=[1, 1, 0])
    run = Run(world, bearing, choices=choices, notice=heard.append)
    assert run.right
    assert heard == events
    assert motions is None or run.motions == motions


def test_the_most_expensive_edge_is_no_dearer_than_an_edge():
    assert Run(EDGE).cost == Run(LOOP).cost == 1


# ---------------------------------------------------------------- which events are met when


# ---------------------------------------------------------------- the options


class Seen(Choices):
    """Choices that check what they are asked before they answer."""

    def __init__(self, policy):
        super().__init__(policy)
        self.kinds = set()

    def pick(self, options, of, cost=None):
        first = options[0]
        ranked = list(options)
        assert first == ranked[0]
        assert ranked == [options[i] for i in range(len(options))]
        assert len(set(ranked)) == len(ranked) >= 1
        assert cost is not None
        assert len(cost) == len(ranked)
        assert list(cost) == list(cost[:])
        if of in ("path", "transit"):
            assert list(cost) == sorted(cost)
            assert sorted(zip(cost, ranked, strict=True)) == list(zip(cost, ranked, strict=True))
        self.kinds.add(of)
        return super().pick(options, of, cost)


@given(maps(most=7), st.integers(0, 99))
def test_the_first_option_is_the_first_of_the_ranked_ones_and_each_has_its_cost(world, seed):
    assert Run(world, choices=Seen(policy_named(f"random:{seed}"))).right


def test_all_four_kinds_of_choices_are_asked():
    seen = Seen(policy_named("fifo"))
    Run(cycle(3), choices=seen)
    assert seen.kinds == {"edge", "hypothesis", "path", "transit"}


def partial(world, edges, seed):
    """S after the first so many passes, by an explorer who chooses at random."""
    run = Run(world, choices=Choices(policy_named(f"random:{seed}")))
    checkpoint = run.checkpoints[min(edges, world.edge_count) - 1]
    s = PartialMap(Percept(world.degree_at[0], 1, 0))
    s.sigma, s.alpha = list(checkpoint.sigma), list(checkpoint.alpha)
    known = CombinatorialMap.trusted(s.sigma, s.alpha)
    s.vertex = list(known.vertex_of)
    s.first = [vertex[0] for vertex in known.vertices]
    s.expected = [Percept(degree) for degree in known.degree_at]
    s.unexplored = [d for d, e in enumerate(s.alpha) if d == e]
    return s


def graph(s):
    explored = nx.MultiGraph()
    explored.add_nodes_from(s.vertex)
    for d, e in enumerate(s.alpha):
        if d < e:
            explored.add_edge(s.vertex[d], s.vertex[e], key=d)
    return explored


def leaving(s, path):
    """The darts by which a path of networkx's leaves its vertices."""
    return tuple(d if s.vertex[d] == u else s.alpha[d] for u, _, d in path)


S = [
    *((cycle(3), 3), (cycle(2), 2), (from_cycles(["abcd", "abcd"]), 4), (lattice(2, 3), 7)),
    *((dense(4), 6), (dense(4), 4), (dense(5), 10), (lattice(3, 3), 12), (lattice(3, 3), 9)),
    *((from_cycles(["aabcd", "bce", "dffe"]), 6), (from_cycles(["aab", "bcc"]), 3)),
]


@pytest.mark.parametrize(("world", "edges"), S)
@pytest.mark.parametrize("kind", ["path", "transit"])
def test_every_simple_path_in_s_is_one_sequence_of_answers_and_first_answers_a_shortest(
    world, edges, kind
):
    s = partial(world, edges, seed=1)
    explored = graph(s)
    pairs = [(u, v) for u in explored for v in explored]
    for start, goal in pairs if len(pairs) <= 25 else pairs[::7]:
        walked = [tuple(simple_path(s, start, goal, choices, kind)) for choices in schedules()]
        if start == goal:
            assert walked == [()]
            continue
        expected = [leaving(s, path) for path in nx.all_simple_edge_paths(explored, start, goal)]
        assert sorted(walked) == sorted(expected)
        assert len(set(walked)) == len(walked)
        assert len(walked[0]) == nx.shortest_path_length(explored, start, goal)


@given(maps(most=7), st.integers(1, 7), st.integers(0, 9), st.data())
def test_the_cost_of_an_option_is_the_shortest_way_to_go_without_entering_a_vertex_twice(
    world, edges, seed, data
):
    s = partial(world, edges, seed)
    start = data.draw(st.sampled_from(s.vertex))
    goal = data.draw(st.sampled_from(s.vertex))
    entered = [start]

    class Checked(Choices):
        def pick(self, options, of, cost=None):
            rest = graph(s)
            rest.remove_nodes_from(entered)
            costs = {}
            for dart, other in s.ways(entered[-1]):
                if other in rest and nx.has_path(rest, other, goal):
                    costs[dart] = 1 + nx.shortest_path_length(rest, other, goal)
            assert dict(zip(options, cost, strict=True)) == costs
            picked = super().pick(options, of, cost)
            entered.append(s.vertex[s.alpha[picked]])
            return picked

    choices = Checked(policy_named(f"random:{seed}"))
    path = list(simple_path(s, start, goal, choices, "path"))
    assert len(path) == len(entered) - 1
    assert len(set(entered)) == len(entered)
    assert entered[-1] == goal


class Costs(Choices):
    """First in, first out; keeps kind, options and costs of every choice."""

    def __init__(self):
        super().__init__()
        self.asked = []

    def pick(self, options, of, cost=None):
        self.asked.append((of, list(options), list(cost)))
        return super().pick(options, of, cost)


def test_edges_cost_the_walk_from_the_robot_and_hypotheses_the_way_to_v0():
    # v0 in the middle of a path of five vertices: its two neighbours look the same.
    world = from_rotation([[1, 2], [0, 3], [0, 4], [1], [2]])
    choices = Costs()
    assert Run(world, choices=choices).right
    # S: v0 has darts 0 and 1, its neighbours 2, 3 and 4, 5.
    assert choices.asked == [
        ("edge", [0, 1], [0, 0]),
        ("edge", [1, 3], [1, 0]),
        ("transit", [2], [1]),
        ("hypothesis", [3], [1]),
        ("path", [2], [1]),
        ("edge", [3, 5], [2, 0]),
        ("transit", [4], [2]),
        ("transit", [0], [1]),
        ("edge", [5], [3]),
        ("transit", [6], [3]),
        ("transit", [2], [2]),
        ("transit", [1], [1]),
    ]
