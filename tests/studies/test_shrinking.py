import pytest

import allworlds
from allworlds.documents.document import replace
from allworlds.engines.units import Scope
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass, contracted, deleted, rooted_code
from allworlds.maps.build import without
from allworlds.maps.classes import Extent
from allworlds.protocol.actions import Estimate, Move
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.fuzz.shrinking import EDGES_OF_FINE_STEPS, shrink
from allworlds.world import Directional, World
from small import slowest


@pytest.fixture(scope="module", params=[(4, 4), slowest((9, 6))])
def shrunk(request, planted):
    """An explorer whose error begins at that size, how many edges these are, and the sample."""
    edges, degree = request.param
    explore = planted(edges, degree)
    return explore, edges, fuzz(explore, edges=edges + 3, runs=60, seed=1)


def refuted(explore, map_):
    """Whether any start and any place of the marker in this map refutes the explorer."""
    kind = Directional
    return any(
        allworlds.run(explore, World(map_, lighthouse, start)).finding
        for start in map_.darts
        for lighthouse in kind.places(map_, start)
    )


def test_an_error_that_begins_at_so_many_edges_is_shrunk_to_these(shrunk):
    """No change of a world merges vertices and keeps all edges, so there may be two of them."""
    _, edges, report = shrunk
    (finding,) = report.findings
    map_ = finding.world.map
    assert finding.law == "pose"
    assert map_.edge_count == edges
    assert map_.vertex_count <= 2
    assert finding.world.start == 0
    assert finding.place == 0
    assert rooted_code(map_.sigma, map_.alpha, 0) == (map_.sigma, map_.alpha)


def test_what_is_found_is_refuted_and_nothing_with_one_edge_less_is(shrunk):
    explore, _, report = shrunk
    (finding,) = report.findings
    map_ = finding.world.map
    assert allworlds.run(explore, finding.world).finding.law == "pose"
    smaller = [change(map_, dart) for dart, _ in map_.edges for change in (deleted, contracted)]
    smaller = {rooted_code(m.sigma, m.alpha, 0): m for m in smaller if m}
    assert smaller
    assert not any(refuted(explore, other) for other in smaller.values())


class Recorder:
    """Refutes exactly the worlds with a property, and remembers what it was asked."""

    def __init__(self, finding, condition):
        self.finding, self.condition, self.asked = finding, condition, []

    def __call__(self, picked):
        worlds = [(world, place) for one in picked for world, place in one.worlds]
        self.asked += [self.found(*run).key[:4] for run in worlds]
        found = [self.found(*run) for run in worlds if self.condition(run[0])]
        return min(found, key=lambda f: f.key, default=None)

    def found(self, world, place):
        return replace(self.finding, world=world, at=place, choices=())


@pytest.fixture
def large():
    """A finding in the cube."""

    def wrong(first):
        yield from ()
        return Estimate(allworlds.CombinatorialMap((1, 0), (1, 0)), 0)

    map_ = allworlds.maps.build.named_map("cube")
    kind = Directional
    return allworlds.run(wrong, World(map_, next(kind.places(map_, 0)), 0)).finding


def smallest(large, condition, map_class="maps"):
    recorder = Recorder(large, condition)
    steps = list(shrink(large, Scope(Extent(MapClass.named(map_class), 12), Rules()), recorder))
    return steps, recorder


def test_every_step_is_smaller_and_only_smaller_worlds_are_tried(large):
    steps, recorder = smallest(large, lambda world: world.map.vertex_count >= 3)
    keys = [large.key[:4], *(step.key[:4] for step in steps)]
    assert keys == sorted(set(keys), reverse=True)
    assert max(recorder.asked) < large.key[:4]
    # The least map with three vertices: a path.
    assert keys[-1][:2] == (2, 3)


def test_in_the_simple_class_one_link_is_left(large):
    steps, _ = smallest(large, lambda world: True, "simple")
    assert steps[-1].world.map == allworlds.CombinatorialMap((0, 1), (1, 0))


def test_where_nothing_smaller_refutes_there_is_no_step(large):
    steps, recorder = smallest(large, lambda world: False)
    assert steps == []
    # Without a piece of one edge, and again where every neighbour is tried.
    assert len(set(recorder.asked)) > 0.95 * len(recorder.asked)


def test_from_large_worlds_pieces_are_taken_away_first(large):
    """From 300 edges to the smallest in a few runs: half of what can go goes at once."""
    map_ = allworlds.maps.build.lattice(12, 14)
    far = replace(large, world=World(map_, next(Directional.places(map_, 0)), 0), choices=())
    steps, recorder = smallest(far, lambda world: max(world.map.degrees) >= 4)
    assert steps[-1].key[:2] == (2, 1)
    assert [step.key[0] for step in steps][:2] <= [map_.edge_count // 2, map_.edge_count // 4 + 1]
    assert len(recorder.asked) < 600


def test_at_last_every_world_with_few_edges_is_tried(large):
    """Of the cube and of one other world, to which no step leads: it is found all the same."""
    far = allworlds.CombinatorialMap(*rooted_code((1, 2, 3, 4, 5, 0), (3, 4, 5, 0, 1, 2), 0))
    cube = large.world.map
    steps, _ = smallest(large, lambda world: world.map in (cube, far))
    assert [step.world.map for step in steps] == [far]


def test_of_what_stays_large_not_every_neighbour_is_tried(large):
    map_ = allworlds.maps.build.lattice(4, 4)
    far = replace(large, world=World(map_, next(Directional.places(map_, 0)), 0), choices=())
    steps, recorder = smallest(far, lambda world: world.map.edge_count > EDGES_OF_FINE_STEPS)
    assert steps[-1].key[0] == EDGES_OF_FINE_STEPS + 1
    assert sum(5 <= edges <= EDGES_OF_FINE_STEPS for edges, *_ in recorder.asked) < 300


def test_the_part_at_the_start_is_left_without_edges_that_are_gone():
    path = allworlds.maps.build.named_map("path-5")  # darts 0; 1, 2; 3, 4; 5, 6; 7
    assert without(path, {3, 4, 2, 5}) == allworlds.maps.build.named_map("edge")
    assert without(path, {0, 1}) is None
    loops = allworlds.CombinatorialMap((1, 2, 3, 0), (1, 0, 3, 2))
    assert without(loops, {0, 1}) == allworlds.maps.build.named_map("loop")


@pytest.mark.parametrize("breaks", ["map", "budget"])
def test_worlds_with_far_longer_walks_are_passed_over_unless_the_budget_is_broken(breaks):
    report = fuzz(walks_on if breaks == "map" else for_ever, edges=12, min_edges=9, runs=4)
    (finding,) = report.findings
    assert finding.law == breaks
    # With one edge it walks to the end of its budget, 108 traversals.
    assert finding.world.map.edge_count == (2 if breaks == "map" else 1)


def walks_on(first):
    """Answers wrongly at a vertex of degree 3 or more, and else walks for ever."""
    while first.degree < 3:
        yield Move(0)
    return Estimate(allworlds.maps.build.named_map("loop"), 0)


def for_ever(first):
    while True:
        yield Move(0)
