import sys
from itertools import combinations, combinations_with_replacement, product

import pytest

from allworlds.inputs.checks import InputError
from allworlds.maps import named_map, rooted_maps
from allworlds.outcome import Disagreement
from allworlds.protocol.actions import Move
from allworlds.reports.formats import text
from allworlds.studies.ambiguity import class_of, twins
from allworlds.studies.ambiguity.members import replayed, separation
from allworlds.world import LIGHTHOUSES, Compass, Directional, Nothing, Position, World
from allworlds.world.bisimulation import flaw
from allworlds.world.world import at_place
from models import HEARD
from small import stepped

twins_module = sys.modules["allworlds.studies.ambiguity.members"]
KINDS = [Nothing, Position, Compass, Directional]


def worlds(kind, largest):
    return [
        World(map_, place)
        for m in range(1, largest + 1)
        for map_ in rooted_maps(m)
        for place in kind.places(map_, 0)
    ]


def named(name, kind="position", start=0):
    map_ = named_map(name)
    return World.from_json({**map_.to_json(), "start": start}, missing=kind)


def walked(world, motions):
    dart, seen = world.start, [world.first]
    for k in motions:
        dart, percept = stepped(world, dart, Move(k))
        seen.append(percept)
    return tuple(seen)


def naive_separation(a, b, longest):
    """All words of motions by length, then in lexicographic order, until one separates."""
    if a.first != b.first:
        return ()
    most = max(p.degree for w in (a, b) for p in w.percepts)
    for length in range(1, longest + 1):
        for motions in product(range(most), repeat=length):
            one, other = walked(a, motions), walked(b, motions)
            if one != other:
                return motions
    return None


def test_worlds_may_be_named_as_on_the_command_line():
    assert twins("k4", "k4", lighthouse="none") == twins(named("k4", "none"), named("k4", "none"))
    assert twins("cycle-3", "cycle-4", lighthouse="none").twins
    assert not twins("cycle-3", "cycle-4").twins
    assert class_of("k4") == class_of(named("k4"))


@pytest.mark.parametrize("kind", KINDS)
def test_the_separating_motions_are_the_shortest_and_then_the_first(kind):
    some = worlds(kind, 2)
    for a, b in combinations_with_replacement(some[::2], 2):
        found = twins(a, b)
        # Two worlds with at most 8 darts in all differ within 7 motions if they differ.
        longest = len(found.motions) if found.distinguishable else 4
        expected = naive_separation(a, b, longest)
        if expected is None:
            assert flaw((a, b), found.bisimulation) is None
        else:
            assert found.motions == expected
            assert found.percepts == (walked(a, expected), walked(b, expected))


@pytest.mark.parametrize("kind", KINDS)
def test_the_same_world_under_other_names_is_the_same(kind):
    for world in worlds(kind, 3)[::5]:
        other = world.relabelled([*reversed(world.map.darts)])
        found = twins(world, other)
        assert (found.relation, found.distinguishable, found.twins) == ("same", False, False)


# ------------------------------------------------------------------------ known results


def test_the_fig1_pair_cannot_be_told_apart_and_the_caption_holds_on_both():
    # Fig. 1 (III): motions 1, 1, 2, 2, 1 give [3,A] four times and [4,P], from every start.
    for start in range(4):
        left, right = named("fig1-left", start=start), named("fig1-right", start=start)
        found = twins(left, right)
        assert found.twins
        assert flaw((left, right), found.bisimulation) is None
        for world in (left, right):
            seen = [(p.degree, p.marks) for p in walked(world, (1, 1, 2, 2, 1))]
            assert seen == [(4, 1), (3, 0), (3, 0), (3, 0), (3, 0), (4, 1)]


@pytest.mark.parametrize("kind", ["none", "compass"])
def test_cycles_of_any_lengths_are_twins_without_position(kind):
    # Section III: a robot on a cycle of length three or four; with global orientation too.
    for n, m in ((3, 4), (3, 7), (1, 2), (5, 50)):
        assert twins(named(f"cycle-{n}", kind), named(f"cycle-{m}", kind)).twins


def test_cycles_of_different_lengths_are_told_apart_by_position_after_going_round_the_shorter():
    # Section III: 'the robot can easily distinguish graphs such as different sized cycles'.
    for n, m in ((1, 2), (3, 4), (3, 9), (12, 5)):
        found = twins(named(f"cycle-{n}"), named(f"cycle-{m}"))
        # Motion 0 takes the way of the dart one faces; then 1 goes on.
        assert found.motions == (0, *[1] * (min(n, m) - 1))
        assert [seen[-1].marks for seen in found.percepts] == [int(n < m), int(m < n)]


def test_a_world_entered_at_a_dart_that_looks_alike_is_the_same_map():
    a = named("wheel-4")
    b = World(a.map, Position(1), 1)
    assert twins(a, b).relation == "same"  # the wheel turns
    left = named("fig1-left")
    found = twins(left, World(left.map, Position(1), 1))
    assert (found.relation, found.twins) == ("same-map", False)


def test_one_map_with_its_marker_at_two_vertices_is_two_worlds():
    a = named("path-4")
    b = World(a.map, Position(1), 1)
    found = twins(a, b)
    assert (found.relation, found.motions) == ("different", ())


# ------------------------------------------------------------------------ the documents


def test_the_document_has_motions_and_percepts_or_a_bisimulation():
    apart = twins(named("cycle-1"), named("cycle-2")).to_json()
    assert (apart["distinguishable"], apart["motions"]) == (True, [0])
    assert [seen[0] for seen in apart["percepts"]] == [
        {"degree": 2, "marks": 1, "bearing": None}
    ] * 2
    assert "bisimulation" not in apart
    alike = twins(named("two-loops-plane"), named("two-loops-torus")).to_json()
    assert (alike["distinguishable"], alike["twins"]) == (False, True)
    assert alike["bisimulation"] == [[0] * 4, [0] * 4]
    assert "motions" not in alike


def test_worlds_of_which_different_things_are_told_are_told_apart_by_no_motion_at_all():
    # Without a word, no motion tells how long a cycle is.
    assert twins("cycle:3", "cycle:4", lighthouse="none").twins
    one, other = (named(f"cycle-{n}", "told:n") for n in (3, 4))
    found = twins(one, other)
    assert (found.distinguishable, found.motions, found.told) == (True, (), ({"n": 3}, {"n": 4}))
    assert found.to_json()["percepts"] == [[one.first.to_json()], [other.first.to_json()]]
    assert "by 0 motions: before the start the robot is told {'n': 3} in A" in text(found, 100)
    assert "told" not in twins(one, one).to_json()


def test_lighthouses_that_differ_in_what_is_told_alone_are_two_places(tmp_path, monkeypatch):
    (tmp_path / "heard.py").write_text(HEARD)
    monkeypatch.chdir(tmp_path)
    one = World(named_map("k4"), "heard.py:Words")
    other = at_place(one, 1)
    assert one.percepts == other.percepts
    assert twins(one, other).relation == "different"
    assert twins(one, one).relation == "same"


def test_worlds_of_different_lighthouses_are_not_compared():
    with pytest.raises(InputError, match="the lighthouses position and none"):
        twins(named("k4"), named("k4", "none"))


# ------------------------------------------------------------------------ self-checks


def test_a_walk_is_walked_again_before_it_is_believed():
    a, b = named("cycle-3"), named("cycle-4")
    good = separation(a, b)
    assert good == twins(a, b).motions
    assert replayed(a, b, good) is None
    assert replayed(a, b, good[:-1]) == "the last percepts are equal"
    longer = (*good, 1)  # now the other world is at its marker
    assert replayed(a, b, longer) == "a part of the motions is enough"


def test_a_wrong_proof_is_an_internal_fault(monkeypatch):
    a, b = named("cycle-3"), named("cycle-4")
    monkeypatch.setattr(twins_module, "replayed", lambda *_: "so it is")
    with pytest.raises(Disagreement, match="so it is"):
        twins(a, b)
    with pytest.raises(Disagreement, match="no motion tells"):
        separation(a, a)


@pytest.mark.parametrize(("kind", "fewest"), [("cluster", 3)])
def test_worlds_look_alike_under_a_cluster_from_3_edges_on_and_under_a_natural_from_4(kind, fewest):
    # docs/protocol.md says so.
    by_first = {}
    for world in worlds(LIGHTHOUSES[kind], fewest):
        by_first.setdefault((world.first, world.told), []).append(world)
    pairs = [pair for alike in by_first.values() for pair in combinations(alike, 2)]
    least = min(
        max(one.map.edge_count, two.map.edge_count)
        for one, two in pairs
        if {*one.percepts} == {*two.percepts} and twins(one, two).twins
    )
    assert least == fewest


def test_every_kind_of_lighthouse_can_be_compared():
    for name in ("none", "position", "compass", "directional"):
        assert name in LIGHTHOUSES
        assert twins(named("k4", name), named("k4", name)).relation == "same"
