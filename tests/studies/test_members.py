import pytest

from allworlds.inputs.checks import InputError
from allworlds.maps import automorphisms, class_size, isomorphism, named_map, rooted_maps
from allworlds.maps.build import lattice
from allworlds.maps.quotient import pose_count
from allworlds.outcome import Disagreement
from allworlds.studies.ambiguity import class_of, members, projection_of, twins
from allworlds.world import Compass, Directional, Nothing, Position, World
from small import is_least_rooting


def world(name, start=0):
    return World(named_map(name), Position(start), start)


def ambiguous(edges):
    for map_ in rooted_maps(edges):
        if is_least_rooting(map_):
            found = class_of(World(map_, Position(0)))
            if found.size > 1:
                yield found


def test_members_have_equally_many_vertices_edges_and_the_same_degrees():
    for edges in (2, 3, 4):
        for found in ambiguous(edges):
            assert len({tuple(sorted(one.map.degrees)) for one in found.worlds}) == 1


# ------------------------------------------------------------------------ known results


def test_the_smallest_ambiguous_maps_are_one_vertex_with_two_loops_plane_and_torus():
    # One vertex with two loops can be drawn in two ways; nothing with one edge is ambiguous.
    assert not list(ambiguous(1))
    found = list(ambiguous(2))
    assert {w.map.genus for f in found for w in f.worlds} == {0, 1}
    for f in found:
        names = ("two-loops-plane", "two-loops-torus")
        assert all(any(isomorphism(w.map, named_map(n)) for n in names) for w in f.worlds)
        assert f.size == 2


def test_simple_k4_in_the_plane_has_one_simple_twin_on_the_torus():
    found = class_of(world("k4"), map_class="simple")
    assert [w.map.genus for w in found.worlds] == [0, 1]
    # Any simple map with four vertices of degree 3 is a drawing of K4.
    assert all(w.map.degrees == (3, 3, 3, 3) and w.map.is_simple for w in found.worlds)
    assert (found.size, class_of(world("k4")).size) == (2, 4)


def test_the_fig1_pair_is_one_planar_class():
    # The caption of Fig. 1 (III): marked vertex of degree 4, all others of degree 3.
    left, right = (
        class_of(world(f"fig1-{side}"), map_class="planar") for side in ("left", "right")
    )
    assert {w.map for w in left.worlds} == {w.map for w in right.worlds}
    assert (left.size, left.poses, left.sheets) == (2, 4, 4)
    assert class_of(world("fig1-left"), map_class="planar-simple").size == 2


def test_the_class_of_the_wheel_with_four_spokes():
    # k = 4, beta1 = 1, no semi-edge, other cone index 1: P = 4! (4 darts over each class);
    # conjugacy of S4 under a 4-cycle: (24 + 8 + 4 + 4) / 4 = 10 orbits (Burnside).
    found = class_of(world("wheel-4"))
    assert (found.size, found.poses, found.sheets) == (10, 24, 4)


def test_a_tree_is_alone_in_its_class():
    found = class_of(world("star-5"))
    assert (found.size, found.poses, len(found.worlds)) == (1, 1, 1)
    assert found.to_json()["ambiguous"] is False


# ------------------------------------------------------------------------ the limit


def test_past_the_limit_the_size_is_exact_and_a_notice_says_what_is_left_out():
    whole = class_of(world("bouquet-4"))
    assert whole.notice is None
    assert whole.size == len(whole.worlds) == 18
    for limit in range(1, 19):
        cut = class_of(world("bouquet-4"), limit=limit)
        assert (cut.size, cut.poses) == (whole.size, whole.poses)
        assert len(cut.worlds) == limit
        assert {w.map for w in cut.worlds} <= {w.map for w in whole.worlds}
        assert cut.worlds[0] == whole.worlds[0]
        assert (cut.notice is None) == (limit == 18)
    assert "1 of 18 worlds are listed" in class_of(world("bouquet-4"), limit=1).notice


def test_the_given_world_is_listed_whichever_member_it_is():
    for given in class_of(world("bouquet-3")).worlds:
        for limit in (1, 2, 3):
            assert class_of(given, limit=limit).worlds[0].map == given.map


def test_a_huge_class_is_answered_at_once():
    found = class_of(world("bouquet-12"), limit=2)
    assert found.size > 10**10
    assert len(found.worlds) == 2


@pytest.mark.parametrize("name", ["path-3000", "star-300", "bouquet-40", "wheel-60"])
def test_a_large_world_is_no_harder_in_kind(name):
    found = class_of(world(name), limit=1)
    assert found.worlds[0].map.degree_at[0] == world(name).map.degree_at[0]
    assert (found.size == 1) == (name in ("path-3000", "star-300"))


def test_a_quotient_with_thousands_of_vertices_and_cycles_is_lifted():
    found = class_of(World(lattice(40, 40), Position(0)))
    assert (found.size, found.sheets) == (1, 1)


def test_a_restricted_class_needs_all_members():
    with pytest.raises(InputError, match=r"limit 3 is too small: 4 worlds .* simple"):
        class_of(world("k4"), limit=3, map_class="simple")


# ------------------------------------------------------------------------ other input


def test_the_document_has_the_promised_parts():
    document = class_of(world("k4"), map_class="simple").to_json()
    assert document["quotient"] == {
        # v0: one class, the other way round three; rim: spoke, and two classes that meet.
        "sigma": [0, 2, 3, 1],
        "alpha": [1, 0, 3, 2],
        "degree": [3, 3, 3, 3],
        "marks": [1, 0, 0, 0],
    }
    assert (document["size"], document["poses"], document["listed"]) == (2, 2, 2)
    assert [World.from_json(w).map.genus for w in document["worlds"]] == [0, 1]
    assert document["class"] == "simple"


def test_a_directional_marker_leaves_a_world_alone():
    for edges in (1, 2, 3):
        for map_ in rooted_maps(edges):
            for place in Directional.places(map_, 0):
                found = class_of(World(map_, place))
                assert (found.size, found.poses) == (1, 1)
                assert twins(found.world, found.worlds[0]).relation == "same"


@pytest.mark.parametrize("kind", [Nothing, Compass])
def test_where_classes_can_be_infinite_none_is_made(kind):
    (place,) = kind.places(named_map("star-4"), 0)
    with pytest.raises(InputError, match=f"not {kind.kind}: a class may have no end"):
        class_of(World(named_map("star-4"), place))


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"limit": 0}, "limit 0"),
        ({"map_class": "round"}, "'round' is not one of maps, simple"),
        ({"map_class": "simple"}, "the world itself is not simple"),
    ],
)
def test_bad_options_are_named(options, named):
    with pytest.raises(InputError, match=named):
        class_of(world("theta"), **options)


# ------------------------------------------------------------------------ self-checks


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("is_ambiguous", lambda quotient: False),
        ("class_size", lambda quotient: class_size(quotient) + 1),
        ("pose_count", lambda quotient: pose_count(quotient) + 1),
        ("lifts", lambda quotient: iter([named_map("theta")])),
    ],
)
def test_a_fault_in_one_of_the_counts_is_noticed(monkeypatch, name, wrong):
    monkeypatch.setattr(members, name, wrong)
    with pytest.raises(Disagreement):
        class_of(world("theta"))


def test_a_class_without_the_given_world_is_noticed(monkeypatch):
    given = world("theta")
    alien = class_of(given).worlds[1]
    own = members.least_rooting(alien.map, range(3))
    found = {own.code: own}
    quotient = projection_of(given).quotient
    monkeypatch.setattr(members, "class_size", lambda quotient: 1)
    monkeypatch.setattr(members, "pose_count", lambda quotient: members._poses(quotient, found))
    missing = members.least_rooting(given.map, [0, 1, 2])
    with pytest.raises(Disagreement):
        members._check_complete(quotient, found, missing)
    members._check_complete(quotient, found, own)


def test_poses_weigh_a_member_by_its_symmetries():
    # Three parallel edges: each of the two members has all three rotations about v0.
    assert [automorphisms(w.map) for w in class_of(world("theta")).worlds] == [6, 6]
    assert class_of(world("theta")).poses == 2


def test_a_limit_of_one_lists_the_world_itself():
    found = class_of(world("bouquet-2"), limit=1)
    assert len(found.worlds) == 1
