from itertools import permutations, product

import networkx as nx
import pytest
from hypothesis import assume, given, strategies as st

import bruteforce
from allworlds.maps import (
    CombinatorialMap,
    automorphisms,
    from_cycles,
    from_rotation,
    isomorphism,
    named_map,
    rooted_code,
    rooted_isomorphism,
    unrooted_code,
)
from allworlds.maps.build import cycle, dense, lattice
from allworlds.maps.combinatorial import carries, numbering
from small import LOOP, joined, maps

# Symmetric maps: of each the number of rotations that carry it into itself.  A solid has two
# for each edge; a cycle of n in the plane turns and turns over; the path of two edges turns
# round its middle; n loops side by side turn round their vertex; two loops that cross turn
# on the torus by quarters; three edges between two vertices turn and turn over, in the plane
# and on the torus.
SYMMETRIC = [
    (named_map("edge"), 2),
    (named_map("loop"), 2),
    (from_cycles(["a", "ab", "b"]), 2),
    (named_map("k4"), 12),
    (named_map("cube"), 24),
    (named_map("cube").dual(), 24),
    (named_map("theta"), 6),
    (named_map("theta-torus"), 6),
    (named_map("two-loops-torus"), 4),
    (from_cycles(["aabb"]), 2),
    (from_cycles(["aabbcc"]), 3),
    (cycle(3), 6),
    (cycle(7), 14),
    (from_cycles(["abc", "a", "b", "c"]), 3),
    (lattice(2, 3), 2),
    (lattice(3, 3), 4),
]


def renamed(map_, names):
    """The two permutations after renaming, from their definition."""
    return tuple(
        tuple(name for _, name in sorted((names[d], names[e]) for d, e in enumerate(p)))
        for p in (map_.sigma, map_.alpha)
    )


def is_witness(w, a, b):
    return (
        sorted(w) == list(a.darts) == list(b.darts)
        and all(w[a.sigma[d]] == b.sigma[w[d]] for d in a.darts)
        and all(w[a.alpha[d]] == b.alpha[w[d]] for d in a.darts)
    )


def codes(map_):
    return [rooted_code(map_.sigma, map_.alpha, root) for root in map_.darts]


def small_maps(edges):
    """Every labelled map whose edges are 01, 23, ..."""
    alpha = [d ^ 1 for d in range(2 * edges)]
    for sigma in permutations(range(2 * edges)):
        if nx.is_connected(joined(sigma, alpha)):
            yield CombinatorialMap(sigma, alpha)


# ---------------------------------------------------------------- rooted codes


@given(maps(), st.data())
def test_relabelling_the_darts_keeps_the_rooted_code(map_, data):
    names = data.draw(st.permutations(map_.darts))
    root = data.draw(st.sampled_from(map_.darts))
    other = map_.relabelled(names)
    code = rooted_code(map_.sigma, map_.alpha, root)
    assert code == rooted_code(other.sigma, other.alpha, names[root])
    order = numbering(map_.sigma, map_.alpha, root)
    assert [names[d] for d in order] == numbering(other.sigma, other.alpha, names[root])


@given(maps(), st.data())
def test_a_rooted_code_is_the_map_itself_in_canonical_numbers(map_, data):
    root = data.draw(st.sampled_from(map_.darts))
    order = numbering(map_.sigma, map_.alpha, root)
    assert order[0] == root
    assert sorted(order) == list(map_.darts)
    met = [root]
    for d in order:
        met = list(dict.fromkeys([*met, map_.sigma[d], map_.alpha[d]]))
        assert met == order[: len(met)]
    code = rooted_code(map_.sigma, map_.alpha, root)
    assert code == renamed(map_, [order.index(d) for d in map_.darts])
    assert code == rooted_code(*code, 0)


@pytest.mark.parametrize("edges", [1, 2, 3])
def test_two_rooted_maps_have_one_code_exactly_if_a_renaming_carries_one_into_the_other(edges):
    # The yardstick: the least of all renamings that give the root the name 0.
    namings = [(0, *rest) for rest in permutations(range(1, 2 * edges))]
    pairs = {
        (rooted_code(map_.sigma, map_.alpha, 0), min(renamed(map_, n) for n in namings))
        for map_ in small_maps(edges)
    }
    by_code, by_trial = zip(*pairs, strict=True)
    # OEIS A000698: 2, 10, 74 rooted maps.
    assert len(pairs) == len(set(by_code)) == len(set(by_trial)) == [2, 10, 74][edges - 1]


# ---------------------------------------------------------------- unrooted codes


@given(maps(most=9), st.data())
def test_the_unrooted_code_is_the_least_rooted_code_and_knows_no_names(map_, data):
    assert unrooted_code(map_) == min(codes(map_))
    names = data.draw(st.permutations(map_.darts))
    assert unrooted_code(map_.relabelled(names)) == unrooted_code(map_)


@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_all_small_maps_have_the_least_rooted_code(edges):
    for map_ in bruteforce.rooted_maps_by_permutations(edges):
        assert unrooted_code(map_) == min(codes(map_))


@given(st.sampled_from(SYMMETRIC), st.data())
def test_symmetric_maps_have_the_least_rooted_code_whatever_the_darts_are_called(known, data):
    map_, _ = known
    other = map_.relabelled(data.draw(st.permutations(map_.darts)))
    assert unrooted_code(other) == min(codes(map_))


# ---------------------------------------------------------------- automorphisms


@pytest.mark.parametrize(("map_", "expected"), SYMMETRIC)
def test_symmetric_maps_have_the_rotations_that_one_sees(map_, expected):
    assert automorphisms(map_) == expected


@given(st.one_of(maps(), st.sampled_from([map_ for map_, _ in SYMMETRIC])))
def test_automorphisms_times_distinct_rootings_is_the_number_of_darts(map_):
    assert automorphisms(map_) * len(set(codes(map_))) == 2 * map_.edge_count


@pytest.mark.parametrize("edges", [1, 2, 3])
def test_automorphisms_are_the_renamings_that_change_nothing(edges):
    for map_ in bruteforce.unrooted_maps(edges):
        trials = permutations(map_.darts)
        assert automorphisms(map_) == sum(is_witness(w, map_, map_) for w in trials)


@given(maps(most=4), maps(most=4), st.data())
def test_a_dart_carries_the_map_exactly_if_the_rooted_codes_agree(a, b, data):
    b = data.draw(st.sampled_from([b, a.relabelled(data.draw(st.permutations(a.darts)))]))
    assume(a.edge_count == b.edge_count)
    root = data.draw(st.sampled_from(a.darts))
    image = data.draw(st.sampled_from(b.darts))
    order = numbering(a.sigma, a.alpha, root)
    same = rooted_code(a.sigma, a.alpha, root) == rooted_code(b.sigma, b.alpha, image)
    assert carries(a.sigma, a.alpha, order, b.sigma, b.alpha, image) == same


# ---------------------------------------------------------------- isomorphism


@given(maps(), st.data())
def test_a_relabelled_map_is_the_same_and_the_witness_proves_it(map_, data):
    other = map_.relabelled(data.draw(st.permutations(map_.darts)))
    w = isomorphism(map_, other)
    assert w
    assert is_witness(w, map_, other)
    code = rooted_code(map_.sigma, map_.alpha, 0)
    images = [d for d, rooted in enumerate(codes(other)) if rooted == code]
    assert w[0] == min(images)


@pytest.mark.parametrize("edges", [1, 2, 3])
def test_small_maps_are_the_same_exactly_if_their_unrooted_codes_are(edges):
    known = [(a, unrooted_code(a)) for a in bruteforce.rooted_maps_by_permutations(edges)]
    for (a, code), (b, other) in product(known, repeat=2):
        answer = isomorphism(a, b)
        assert bool(answer) == (code == other)
        assert is_witness(answer, a, b) if answer else answer is None


@pytest.mark.parametrize(
    ("a", "b"),
    [
        (cycle(3), cycle(4)),
        (cycle(2), from_cycles(["a", "ab", "b"])),
        (named_map("two-loops-plane"), named_map("two-loops-torus")),
        (
            from_rotation([[1], [0, 2], [1, 3], [2]]),
            from_rotation([[1, 2, 3], [0], [0], [0]]),
        ),
        # A vertex with legs of 1, 2 and 3 edges, clockwise and anticlockwise.
        (
            from_cycles(["abc", "a", "bd", "d", "ce", "ef", "f"]),
            from_cycles(["acb", "a", "bd", "d", "ce", "ef", "f"]),
        ),
    ],
)
def test_maps_that_differ_are_told_apart(a, b):
    assert isomorphism(a, b) is None
    assert isomorphism(b, a) is None


@pytest.mark.parametrize("edges", [2, 3, 4])
def test_a_chiral_map_is_not_its_mirror_image_though_all_numbers_agree(edges):
    for map_ in bruteforce.unrooted_maps(edges):
        mirrored = map_.mirrored()
        same = unrooted_code(map_) == unrooted_code(mirrored)
        assert bool(isomorphism(map_, mirrored)) == same


def test_planar_maps_up_to_mirror_images_are_the_published_numbers():
    # OEIS A006385: 2, 4, 14, 52 planar maps with 1, 2, 3, 4 edges up to reflection; without
    # reflection A006384 has 57 with 4 edges, so five pairs of them are chiral.
    for edges, published in enumerate([2, 4, 14, 52], 1):
        unsensed = {
            min(unrooted_code(map_), unrooted_code(map_.mirrored()))
            for map_ in bruteforce.unrooted_maps(edges, "planar")
        }
        assert len(unsensed) == published


@given(maps())
def test_mirror_images_have_as_many_automorphisms_and_mirroring_keeps_sameness(map_):
    mirrored = map_.mirrored()
    assert automorphisms(mirrored) == automorphisms(map_)
    assert unrooted_code(mirrored.mirrored()) == unrooted_code(map_)


@given(maps())
def test_the_dual_of_the_dual_is_the_same_map_and_faces_and_vertices_are_swapped(map_):
    dual = map_.dual()
    assert is_witness(isomorphism(map_, dual.dual()), map_, dual.dual())
    assert (dual.vertex_count, len(dual.faces)) == (len(map_.faces), map_.vertex_count)
    assert automorphisms(dual) == automorphisms(map_)


def test_the_dual_of_the_cube_is_the_octahedron_and_the_tetrahedron_is_its_own():
    octahedron = named_map("cube").dual()
    assert (octahedron.vertex_count, len(octahedron.faces)) == (6, 8)
    assert octahedron.degrees == (4,) * 6
    assert octahedron.is_simple
    assert isomorphism(named_map("k4"), named_map("k4").dual())
    assert not isomorphism(named_map("k4"), dense(4))


# ---------------------------------------------------------------- rooted isomorphism


@given(maps(most=4), maps(most=4), st.data())
def test_two_rooted_maps_are_the_same_exactly_if_their_codes_are(a, b, data):
    b = data.draw(st.sampled_from([b, a.relabelled(data.draw(st.permutations(a.darts)))]))
    root = data.draw(st.sampled_from(a.darts))
    other = data.draw(st.sampled_from(b.darts))
    answer = rooted_isomorphism(a, root, b, other)
    if rooted_code(a.sigma, a.alpha, root) == rooted_code(b.sigma, b.alpha, other):
        assert is_witness(answer, a, b)
        assert answer[root] == other
    else:
        assert not answer


def test_walks_that_meet_other_degrees_or_close_at_other_times_are_no_isomorphism():
    assert rooted_isomorphism(named_map("edge"), 0, LOOP, 1) is None
    a, b = from_cycles(["a", "ab", "b"]), from_cycles(["a", "ab", "bc", "c"])
    assert rooted_isomorphism(a, 0, b, 0) is None
    # Both are one vertex of degree 2 as far as percepts go; the loop closes after one edge.
    assert rooted_isomorphism(LOOP, 0, cycle(3), 0) is None
    assert rooted_isomorphism(cycle(3), 0, LOOP, 0) is None
