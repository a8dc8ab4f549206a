"""Explorers that never forget: what they walk world by world, and the log that they fold."""

from collections import Counter
from itertools import pairwise

import pytest
from hypothesis import given, strategies as st

from allworlds import Checkpoint, Choices, Percept
from allworlds.claims import Algorithm1
from allworlds.maps import from_cycles, rooted_code, rooted_maps
from allworlds.maps.build import dense, lattice
from allworlds.protocol.choices import policy_named
from explorers import greedy, prudent, remembering
from settled_log import SettledLog
from small import maps, slow, slowest
from testers import paper_bound
from unforgetting import Spread

OURS = [remembering, greedy, prudent]
EVENTS = {"case-1", "case-2", "empty-H", "loop", "non-loop"}
ours = pytest.mark.parametrize("explore", OURS, ids=lambda explore: explore.__name__)


def algorithm1(first):
    return Algorithm1(first, Choices()).explore()


class Run:
    """An explorer walks a map from dart 0, with the marker so many places clockwise of it."""

    def __init__(self, explore, world, bearing=0, **options):
        pointed = world.turn(0, bearing)

        def sense(dart):
            if world.vertex_of[dart] != world.vertex_of[pointed]:
                return Percept(world.degree_at[dart])
            return Percept(world.degree_at[dart], 1, world.offset(dart, pointed))

        explorer, at, answer = explore(sense(0), **options), 0, None
        self.cost, self.checkpoints = 0, []
        while True:
            try:
                message = explorer.send(answer)
            except StopIteration as stop:
                found, here = stop.value.map, stop.value.here
                break
            answer = None
            if isinstance(message, Checkpoint):
                self.checkpoints.append(message)
            else:
                at = world.alpha[world.turn(at, message.k)]
                self.cost += 1
                answer = sense(at)
        self.right = rooted_code(found.sigma, found.alpha, here) == rooted_code(
            world.sigma, world.alpha, at
        )


def every_run(edges):
    """Each rooted map with each bearing."""
    return [(world, b) for world in rooted_maps(edges) for b in range(world.degree_at[0])]


# ------------------------------------------------------------ what they walk


# Counted by another implementation of the first two; the third is as the second.
REMEMBERED = [3, 64, 1126, 19877, 370832]
GREEDY = [3, 60, 989, 16836, 308937]


@pytest.mark.parametrize(
    ("explore", "edges"),
    [
        *((explore, edges) for explore in (greedy, prudent) for edges in (1, 2, 3)),
        *(slow(greedy, 4), slowest(greedy, 5), slow(prudent, 4)),
    ],
)
def test_all_runs_together_are_as_long_as_those_of_another_implementation(explore, edges):
    assert sum(Run(explore, *run).cost for run in every_run(edges)) == GREEDY[edges - 1]


@pytest.mark.parametrize("edges", [1, 2, 3, slow(4), slowest(5)])
def test_remembering_never_walks_more_than_algorithm_1_with_the_same_choices(edges):
    compared, walked = Counter(), 0
    for run in every_run(edges):
        mine, paper = Run(remembering, *run).cost, Run(algorithm1, *run).cost
        assert mine <= paper
        compared["less" if mine < paper else "equal"] += 1
        walked += mine
    assert walked == REMEMBERED[edges - 1]
    assert compared["less"] == {1: 0, 2: 0, 3: 5, 4: 222, 5: 6278}[edges]


def test_greedy_walks_more_than_algorithm_1_in_some_worlds_and_less_in_more():
    differences = [Run(greedy, *run).cost - Run(algorithm1, *run).cost for run in every_run(3)]
    assert sum(d > 0 for d in differences) == 12
    assert sum(d < 0 for d in differences) == 71


@pytest.mark.parametrize("loops", [1, 2, 3, 4, slow(5)])
@pytest.mark.parametrize("explore", [algorithm1, *OURS], ids=lambda explore: explore.__name__)
def test_theorem_3_is_tight_over_all_bouquets_the_worst_is_2cc_plus_c(explore, loops):
    worlds = [*bouquets(loops)]
    assert len(worlds) == [1, 3, 15, 105, 945][loops - 1]
    worst = max(Run(explore, world).cost for world in worlds)
    assert worst == 2 * loops**2 + loops


def bouquets(loops):
    """Every map with v0 of degree 1 joined to a vertex with so many loops, from v0 on."""
    for pairs in matchings([*range(2 * loops)]):
        mate = {d: min(pair) for pair in pairs for d in pair}
        yield from_cycles([("stem",), ("stem", *(mate[d] for d in range(2 * loops)))])


def matchings(darts):
    """Every perfect matching."""
    if not darts:
        yield []
        return
    first, *others = darts
    for other in others:
        for rest in matchings([d for d in others if d != other]):
            yield [(first, other), *rest]


@ours
@given(maps(8), st.integers(0, 15))
def test_in_any_map_the_answer_is_right_and_the_bound_is_kept(explore, world, bearing):
    run = Run(explore, world, bearing)
    assert run.right
    assert run.cost <= paper_bound(world.vertex_count, world.edge_count)


@given(maps(7), st.sampled_from(["lifo", "nearest", "random:1", "random:2"]))
def test_remembering_is_right_within_the_bound_whatever_is_chosen(world, policy):
    choices = Choices(policy_named(policy))
    run = Run(remembering, world, choices=choices)
    assert run.right
    assert run.cost <= paper_bound(world.vertex_count, world.edge_count)


def test_in_a_round_world_prudent_walks_as_greedy_does_and_not_in_a_long_one():
    assert Run(prudent, dense(6)).cost == Run(greedy, dense(6)).cost
    assert Run(prudent, prism(20)).cost != Run(greedy, prism(20)).cost


def prism(length):
    """A ladder bent to a ring, with two of its rungs crossed."""
    rungs = {i: (i, length + i) for i in range(length)}
    half = length // 2
    rungs[half], rungs[half - 1] = (half, length + half - 1), (half - 1, length + half)
    rung = {v: f"r{i}" for i, ends in rungs.items() for v in ends}
    sides = []
    for side in (0, length):
        for i in range(length):
            sides.append((f"{side}-{(i - 1) % length}", f"{side}-{i}", rung[side + i]))
    return from_cycles(sides)


@ours
def test_a_lattice_is_explored_with_a_fraction_of_the_walk_of_algorithm_1(explore):
    world = lattice(7, 7)
    assert 2 * Run(explore, world).cost < Run(algorithm1, world).cost


# ------------------------------------------------------------ what they say


@ours
@given(maps(6))
def test_what_is_published_grows_and_ends_with_the_whole_map(explore, world):
    explored = [
        sum(d != e for d, e in enumerate(shown.alpha)) for shown in Run(explore, world).checkpoints
    ]
    assert all(earlier < later for earlier, later in pairwise([0, *explored]))
    assert explored[-1] == 2 * world.edge_count


@ours
def test_events_are_told_to_who_listens(explore):
    seen = []
    Run(explore, lattice(3, 3), notice=seen.append)
    assert set(seen) <= EVENTS
    assert seen.count("non-loop") == 8
    assert "loop" in seen


@ours
def test_percepts_that_no_world_shows_are_refused(explore):
    # The one dart of v0 would lead to both darts of the next vertex.
    explorer = explore(Percept(1, 1, 0))
    next(explorer)
    assert isinstance(explorer.send(Percept(2)), Checkpoint)
    next(explorer)
    with pytest.raises(ValueError, match="contradict"):
        explorer.send(Percept(1, 1, 0))


# ------------------------------------------------------------ the folded log


def supposed(log, one, another):
    """Whether two darts can be one, by joining sets of darts until nothing follows any more."""
    darts = [d for d in range(len(log.node)) if log.canonical(d) == d]
    klass = {d: {d} for d in darts}

    def join(a, b):
        if klass[a] is klass[b]:
            return False
        both = klass[a] | klass[b]
        for d in both:
            klass[d] = both
        return True

    join(one, another)
    changed = True
    while changed:
        changed = False
        for d in darts:
            for e in klass[d] - {d}:
                if log.degree[log.node[d]] != log.degree[log.node[e]]:
                    return False
                changed |= join(log.turn(d, 1), log.turn(e, 1))
                if log.beyond(d) >= 0 and log.beyond(e) >= 0:
                    changed |= join(log.beyond(d), log.beyond(e))
    for members in klass.values():
        nodes = [log.node[d] for d in members]
        if len(set(nodes)) < len(nodes) or (0 in nodes and len(nodes) > 1):
            return False
        if sum(log.settled[v] for v in nodes) > 1:
            return False
    return True


@pytest.fixture
def compared(monkeypatch):
    """How often two darts could be one or not, wherever an explorer asks of any two."""
    found, contradicts = Counter(), SettledLog.contradicts

    def ask(log, one, another):
        canonical = [d for d in range(len(log.node)) if log.canonical(d) == d]
        lost = [d for d in canonical if not log.settled[log.node[d]]]
        for a in lost[:6]:
            for b in canonical:
                told = contradicts(log, a, b)
                assert told is not supposed(log, a, b)
                found[told] += 1
        return contradicts(log, one, another)

    monkeypatch.setattr(SettledLog, "contradicts", ask)
    return found


@ours
@pytest.mark.parametrize("edges", [2, slow(3)])
def test_a_contradiction_is_where_joining_sets_of_darts_finds_one(explore, edges, compared):
    for run in every_run(edges):
        Run(explore, *run)
    assert min(compared[True], compared[False]) > 0


@pytest.mark.parametrize("world", [prism(3), lattice(2, 4)], ids=["prism", "lattice"])
def test_a_contradiction_is_found_in_larger_worlds_too(world, compared):
    Run(greedy, world)
    assert min(compared[True], compared[False]) > 0


def test_a_spread_reaches_nodes_by_shortest_ways():
    log = SettledLog(Percept(2, 1, 0))
    middle = log.arrive(0, Percept(2))
    end = log.arrive(log.turn(middle, 1), Percept(1))
    spread = Spread(log, 0)
    assert spread.way_to(log.node[end]) == [0, log.turn(middle, 1)]
    assert spread.way_to(0) == []
    assert 0 in spread
