"""Algorithm 1 without a direction: from a marker cluster, and from a natural lighthouse."""

import pytest

from allworlds.explorers.builtin.algorithm1 import algorithm1_natural
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.maps import MapClass, rooted_maps
from allworlds.protocol.actions import Move, Percept
from allworlds.protocol.choices import Choices, policy_named
from explorers.test_undirected import FORCED, Run, bound, natural, single
from schedules import schedules

POLICIES = ["fifo", "lifo", "nearest", "random:0", "random:1"]


@pytest.mark.parametrize("policy", POLICIES)
def test_from_a_cluster_every_world_is_mapped_within_the_bound_where_one_edge_joins_v0_and_v1(
    policy,
):
    runs = 0
    for edges in (1, 2, 3, 4):
        for world in rooted_maps(edges):
            for towards in single(world):
                choices = Choices(policy_named(policy, str(runs)))
                run = Run(world, towards, choices=choices)
                runs += 1
                assert run.right
                assert edges < len(run.motions) <= bound(world)
    # As many as there are (rooted map, simple link of the root's vertex): 1, 7, 59, 601.
    assert runs == 668


@pytest.mark.parametrize("policy", POLICIES)
def test_from_a_natural_lighthouse_every_simple_world_is_mapped_within_the_bound(policy):
    runs = 0
    for edges in range(1, 7):
        for world in rooted_maps(edges, MapClass.SIMPLE):
            for towards in natural(world):
                choices = Choices(policy_named(policy, str(runs)))
                run = Run(world, towards, natural=True, choices=choices)
                runs += 1
                assert run.right
                assert edges < len(run.motions) <= bound(world)
    assert runs == 217


def test_where_v1_is_nowhere_the_explorer_ends_or_is_stopped():
    for edges in (1, 2, 3):
        for world in rooted_maps(edges):
            explorer = algorithm1_natural(Percept(world.degree_at[0]), told=99)
            at, answer, estimate = 0, None, None
            for _ in range(500):
                try:
                    message = explorer.send(answer)
                except StopIteration as stop:
                    estimate = stop.value
                    break
                if isinstance(message, Move):
                    at = world.alpha[world.turn(at, message.k)]
                    answer = Percept(world.degree_at[at])
                else:
                    answer = None
            assert estimate is None or estimate.here in estimate.map.darts


@pytest.mark.parametrize(("name", "event", "simple"), FORCED)
def test_no_policy_can_miss_a_witness_in_worlds_of_the_stated_size(name, event, simple):
    world = FORCED[name, event, simple]
    assert BUILT_IN[name].witnesses[event][simple] == (world.edge_count, world.vertex_count)
    assert world.is_planar
    assert world.is_simple or not simple
    kind = name.endswith("natural")
    towards = (natural(world) if kind else single(world))[0]
    for choices in schedules():
        assert event in Run(world, towards, natural=kind, choices=choices).events
