import pytest

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.maps import MapClass, rooted_maps
from allworlds.protocol.choices import Choices, policy_named
from explorers import test_algorithm1 as quick
from explorers.test_algorithm1 import POLICIES, Run, placed


@pytest.mark.parametrize(("edges", "traversals"), list(enumerate([2, 25, 344, 5184, 86061], 1)))
def test_all_worlds_with_the_bearing_on_the_root_cost_as_much_as_counted_elsewhere(
    edges, traversals
):
    # Source of the totals and of the most expensive worlds: an independent C program.
    most_expensive = {}
    total = 0
    for world in rooted_maps(edges):
        run = Run(world)
        assert run.right
        total += run.cost
        most_expensive[world.vertex_count] = max(
            run.cost, most_expensive.get(world.vertex_count, 0)
        )
    assert total == traversals
    if edges == 5:
        assert most_expensive == {6: 19, 5: 25, 4: 32, 3: 31, 2: 37, 1: 5}


@pytest.mark.slowest
@pytest.mark.parametrize("simple", [False, True])
def test_the_witnesses_are_met_from_the_stated_size_on_and_not_earlier(simple):
    map_class = MapClass.SIMPLE if simple else MapClass.MAPS
    least = {event: size[simple] for event, size in BUILT_IN["algorithm1"].witnesses.items()}
    largest = max(size[0] for size in least.values() if size)
    met = {policy: set() for policy in POLICIES[:3]}
    for policy, sizes in met.items():
        for edges in range(1, largest + 1):
            for world, bearing in placed(edges, map_class):
                heard = set()
                choices = Choices(policy_named(policy))
                Run(world, bearing, choices=choices, notice=heard.add)
                sizes |= {(event, edges, world.vertex_count) for event in heard}

    def by_every_policy(event, edges, vertices):
        return all(
            any(e == event and m <= edges and n <= vertices for e, m, n in sizes)
            for sizes in met.values()
        )

    assert {event for sizes in met.values() for event, _, _ in sizes} == set(least)
    for event, size in least.items():
        if size is None:
            assert not by_every_policy(event, largest, largest + 1)
            continue
        edges, vertices = size
        assert by_every_policy(event, edges, vertices)
        assert not by_every_policy(event, edges - 1, edges)
        assert not by_every_policy(event, edges, vertices - 1)


@pytest.mark.parametrize("edges", [4])
@pytest.mark.parametrize("policy", POLICIES)
def test_every_world_is_mapped_pose_included_within_the_bound_under_every_policy(policy, edges):
    quick.test_every_world_is_mapped_pose_included_within_the_bound_under_every_policy(
        policy, edges
    )
