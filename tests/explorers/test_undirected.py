"""Algorithm 1 without a direction: from a marker cluster, and from a natural lighthouse."""

from collections import Counter

import pytest
from hypothesis import given, strategies as st

from allworlds.explorers.builtin.algorithm1 import algorithm1_cluster, algorithm1_natural
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.maps import MapClass, from_cycles, from_rotation, rooted_code, rooted_maps
from allworlds.maps.build import cycle
from allworlds.protocol.actions import Checkpoint, Move, Percept
from allworlds.protocol.choices import Choices, policy_named
from allworlds.strategies import maps
from schedules import schedules
from small import EDGE


class Lost(Exception):
    """The explorer has walked further than any that is right."""


class Run:
    """An explorer walks a map from dart 0; the dart ``towards`` leads to v1."""

    def __init__(self, world, towards, natural=False, budget=10_000, **options):
        self.motions, self.checkpoints, self.events = [], [], []
        v0, v1 = (world.vertex_of[d] for d in (0, world.alpha[towards]))
        marks = {} if natural else {v1: 2, v0: 1}
        sensed = [
            Percept(degree, marks.get(vertex, 0))
            for degree, vertex in zip(world.degree_at, world.vertex_of, strict=True)
        ]
        options["notice"] = self.events.append
        if natural:
            options["told"] = world.degree_at[world.alpha[towards]]
        explorer = (algorithm1_natural if natural else algorithm1_cluster)(sensed[0], **options)
        at, answer = 0, None
        while True:
            try:
                message = explorer.send(answer)
            except StopIteration as stop:
                found, here = stop.value.map, stop.value.here
                break
            if isinstance(message, Checkpoint):
                self.checkpoints.append((message, at))
                answer = None
                continue
            assert isinstance(message, Move)
            if len(self.motions) == budget:
                raise Lost
            self.motions.append(message.k % world.degree_at[at])
            at = world.alpha[world.turn(at, message.k)]
            answer = sensed[at]
        self.right = rooted_code(found.sigma, found.alpha, here) == rooted_code(
            world.sigma, world.alpha, at
        )


def beyond(world):
    """For each dart of v0 the vertex that it leads to."""
    return {d: world.vertex_of[world.alpha[d]] for d in world.vertices[world.vertex_of[0]]}


def single(world):
    """The darts from v0 to vertices that one edge joins to it."""
    times = Counter(beyond(world).values())
    return [d for d, v in beyond(world).items() if times[v] == 1 and v != world.vertex_of[0]]


def natural(world):
    """For each neighbour with a degree of its own one dart to it, if v0 has one of its own."""
    times = Counter(world.degrees)
    if times[world.degree_at[0]] > 1:
        return []
    alone = {v: d for d, v in beyond(world).items() if times[world.degrees[v]] == 1}
    return [d for v, d in alone.items() if v != world.vertex_of[0]]


def bound(world):
    """(1) + (2), two traversals a test, and the search, each summed as it is read."""
    n, m, degree = world.vertex_count, world.edge_count, world.degree_at[0]
    first = sum(s + 2 * (s - 1) * (2 * m - 2 * (s - 1)) for s in range(1, n))
    loops = range(1, m - n + 2)
    second = sum(n + 2 * (n - 1) * (2 * m - 2 * (n - 1) - 2 * (i - 1)) for i in loops)
    return first + second + sum(2 * (2 * m - 2 * p - 1) for p in range(m)) + 2 * degree


# ---------------------------------------------------------------- right, and how dear


@pytest.mark.parametrize("edges", [1, 2])
def test_every_schedule_of_every_world_is_right(edges):
    for world in rooted_maps(edges):
        for towards in single(world):
            for choices in schedules():
                assert Run(world, towards, choices=choices).right


@given(maps(min_edges=5, max_edges=9), st.integers(0, 99))
def test_larger_worlds_are_mapped_whatever_is_chosen(world, seed):
    for towards in single(world):
        run = Run(world, towards, choices=Choices(policy_named(f"random:{seed}")))
        assert run.right
        assert len(run.motions) <= bound(world)
        for checkpoint, at in run.checkpoints:
            # S is part of the world with the robot where it is: I-1 at its simplest.
            assert len(checkpoint.sigma) <= len(world.sigma)
            assert checkpoint.sigma[checkpoint.here] != checkpoint.here or world.sigma[at] == at


# ---------------------------------------------------------------- worlds by hand


@pytest.mark.parametrize(
    ("world", "towards", "script", "motions", "events"),
    [
        # There and back for the search, then the edge.
        (EDGE, 0, [], [0, 0, 0], ["empty-H", "non-loop"]),
        # v0 has the edge to v1 and, clockwise, a loop a b.  The search succeeds at once.  To v1;
        # back to v0 and along a: at b.  Is it b?  The next dart must lead to v1, and does.
        (
            from_cycles(["abb", "a"]),
            0,
            [],
            [0, 0, 0, 0, 1, 1, 0],
            ["empty-H", "non-loop", "v0-hypothesis", "case-3", "loop"],
        ),
        # The same, but facing a: the search goes round the loop and back, twice.  Then a is
        # explored, and taken for the far end of the edge to v1 first: leaving by the dart
        # arrived by the robot sees v0, and goes back.  Then b, as above, and the edge.
        (
            from_cycles(["bba", "a"]),
            2,
            [0, 1],
            [0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 0, 0],
            ["v0-hypothesis", "case-2", "v0-hypothesis", "case-3", "loop", "empty-H", "non-loop"],
        ),
        # The triangle v0 a b, where a is v1: as with a directional lighthouse, but for the search
        # and for the last test, which ends with the query.
        (
            cycle(3),
            0,
            [],
            [0, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 1, 0],
            ["empty-H", "non-loop", "case-2", "non-loop", "case-3", "loop"],
        ),
        # v0 has an edge p to v1, edges c d to a, and g h to b, which looks like a.  By p and c,
        # then by g to b.  Is it a?  The next dart leads to v0, as it must, but by h and not by c:
        # the query, four darts on, goes to b; back to v0, back along h, and b is new.  Then d, h.
        (
            from_cycles(["pcdgh", "p", "cd", "gh"]),
            0,
            [0, 0, 0, 1],
            [0, 0, 0, 0, 1, 0, 2, 1, 4, 0, 1, 1, 4, 1, 4, 0, 4, 1, 2, 0],
            [*["empty-H", "non-loop"] * 2, "case-2", "non-loop", *["case-3", "loop"] * 2],
        ),
    ],
)
def test_worlds_made_by_hand_are_walked_as_by_hand(world, towards, script, motions, events):
    run = Run(world, towards, choices=Choices(script=script))
    assert run.right
    assert run.motions == motions
    assert run.events == events


def test_after_each_test_the_robot_is_where_s_says():
    # Nothing but the pose tells where the walk goes on: every later pass would go astray.
    for world in rooted_maps(4):
        for towards in single(world):
            run = Run(world, towards)
            *_, (last, at) = run.checkpoints
            code = rooted_code(tuple(last.sigma), tuple(last.alpha), last.here)
            assert code == rooted_code(world.sigma, world.alpha, at)


def test_a_cluster_and_a_natural_lighthouse_at_one_place_are_walked_alike():
    compared = 0
    for edges in range(1, 7):
        for world in rooted_maps(edges, MapClass.SIMPLE):
            for towards in natural(world):
                markers, degrees = (Run(world, towards, natural=kind) for kind in (False, True))
                assert markers.motions == degrees.motions
                compared += 1
    assert compared


# ---------------------------------------------------------------- what is promised and not so


def test_with_two_edges_between_v0_and_v1_the_query_is_deceived():
    wrong = set()
    for world in rooted_maps(3):
        for towards, vertex in beyond(world).items():
            if vertex == world.vertex_of[0] or towards in single(world):
                continue
            try:
                right = Run(world, towards, budget=500).right
            except Lost:
                right = False
            if not right:
                wrong.add(world.vertex_count)
    assert wrong == {2}


# ---------------------------------------------------------------- which events are met when


# For each event that is required a world in which every sequence of choices meets it.
TAILED = from_rotation([[1], [0, 2, 3], [1, 3], [1, 2]])  # a triangle behind v0
ROUND = from_cycles(["a", "aff"])  # a loop behind v0
FORCED = {
    ("algorithm1-cluster", "case-1", False): from_cycles(["a", "ab", "bcd", "cde", "e"]),
    ("algorithm1-cluster", "case-2", False): from_cycles(["ab", "acd", "bdc"]),
    ("algorithm1-cluster", "case-3", False): ROUND,
    ("algorithm1-cluster", "empty-H", False): EDGE,
    ("algorithm1-cluster", "loop", False): ROUND,
    ("algorithm1-cluster", "non-loop", False): EDGE,
    ("algorithm1-cluster", "v0-hypothesis", False): from_cycles(["abb", "a"]),
    ("algorithm1-cluster", "case-1", True): from_rotation(
        [[1], [0, 2, 7], [1, 3, 4], [2, 5], [2, 5], [3, 4, 6], [5], [1]]
    ),
    ("algorithm1-cluster", "case-2", True): from_rotation(
        [[1], [0, 2, 3], [1, 3, 4], [1, 4, 2], [3, 2]]
    ),
    ("algorithm1-cluster", "case-3", True): cycle(3),
    ("algorithm1-cluster", "empty-H", True): EDGE,
    ("algorithm1-cluster", "loop", True): cycle(3),
    ("algorithm1-cluster", "non-loop", True): EDGE,
    ("algorithm1-natural", "case-3", False): ROUND,
    ("algorithm1-natural", "empty-H", False): ROUND,
    ("algorithm1-natural", "loop", False): ROUND,
    ("algorithm1-natural", "non-loop", False): ROUND,
    ("algorithm1-natural", "v0-hypothesis", False): from_cycles(["abb", "a"]),
    ("algorithm1-natural", "case-3", True): TAILED,
    ("algorithm1-natural", "empty-H", True): TAILED,
    ("algorithm1-natural", "loop", True): TAILED,
    ("algorithm1-natural", "non-loop", True): TAILED,
}


def test_every_witness_has_such_a_world():
    required = {
        (name, event, simple)
        for name in ("algorithm1-cluster", "algorithm1-natural")
        for event, sizes in BUILT_IN[name].witnesses.items()
        for simple in (False, True)
        if sizes[simple] is not None
    }
    assert required == set(FORCED)
