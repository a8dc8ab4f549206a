from itertools import combinations, permutations

import pytest

from allworlds.maps import CombinatorialMap
from bruteforce import rooted_maps_by_permutations as rooted_maps, unrooted_maps

CLASSES = ["maps", "simple", "planar", "planar-simple"]

# By edges m = 1, 2, 3, 4.
# maps: OEIS A000698 (1, 2, 10, 74, 706, ...); planar: A000168, Tutte's 2 3^m (2m)!/(m! (m+2)!).
# simple: the rooted plane trees, 1, 2, 5, 14 (A000108), with the triangle (1 rooting) for
# m = 3 and the square (1) and the triangle with a tail (8, no symmetry) for m = 4.  No simple
# graph with fewer than 5 edges has two independent cycles, so all of these are planar.
ROOTED = {
    "maps": [2, 10, 74, 706],
    "simple": [1, 2, 6, 23],
    "planar": [2, 9, 54, 378],
    "planar-simple": [1, 2, 6, 23],
}
# maps: OEIS A170946; planar: A006384.  simple: the plane trees 1, 1, 2, 3 (A002995) with the
# triangle, and with the square and the triangle with a tail.
UNROOTED = {
    "maps": [2, 5, 20, 107],
    "simple": [1, 1, 3, 5],
    "planar": [2, 4, 14, 57],
    "planar-simple": [1, 1, 3, 5],
}


def commutes(names, source, target):
    """Whether renaming ``source``'s darts by ``names`` gives ``target``."""
    return all(
        names[source.sigma[d]] == target.sigma[names[d]]
        and names[source.alpha[d]] == target.alpha[names[d]]
        for d in range(len(names))
    )


def walked(source, root, target, image):
    """The one renaming that may take root to image, found by walking; None if there is none."""
    names = {root: image}
    todo = [root]
    for d in todo:
        for p, q in ((source.sigma, target.sigma), (source.alpha, target.alpha)):
            if names.setdefault(p[d], q[names[d]]) != q[names[d]]:
                return None
            if p[d] not in todo:
                todo.append(p[d])
    return names if len(set(names.values())) == len(names) else None


@pytest.mark.parametrize("map_class", CLASSES)
def test_there_are_as_many_rooted_maps_as_published(map_class):
    assert [len(rooted_maps(m, map_class)) for m in (1, 2, 3, 4)] == ROOTED[map_class]


@pytest.mark.parametrize("map_class", CLASSES)
def test_there_are_as_many_unrooted_maps_as_published(map_class):
    assert [len(unrooted_maps(m, map_class)) for m in (1, 2, 3, 4)] == UNROOTED[map_class]


@pytest.mark.parametrize("map_class", CLASSES)
@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_every_map_has_2m_rootings_shared_by_its_automorphisms(edges, map_class):
    weight = 0
    for a in unrooted_maps(edges, map_class):
        symmetries = sum(walked(a, 0, a, d) is not None for d in a.darts)
        assert 2 * edges % symmetries == 0
        weight += 2 * edges // symmetries
    assert weight == len(rooted_maps(edges, map_class))


@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_the_darts_are_numbered_sigma_first_then_alpha_oldest_dart_first(edges):
    for a in rooted_maps(edges):
        seen = [0]
        for d in range(2 * edges):
            seen = list(dict.fromkeys([*seen, a.sigma[d], a.alpha[d]]))
            assert seen == list(range(len(seen)))
        assert len(seen) == 2 * edges


@pytest.mark.parametrize("edges", [1, 2, 3])
def test_no_two_rooted_maps_are_the_same(edges):
    for a, b in combinations(rooted_maps(edges), 2):
        assert walked(a, 0, b, 0) is None


@pytest.mark.parametrize("edges", [1, 2, 3])
def test_no_two_unrooted_maps_are_the_same(edges):
    for a, b in combinations(unrooted_maps(edges), 2):
        assert not any(walked(a, 0, b, d) for d in b.darts)


@pytest.mark.parametrize("edges", [1, 2])
def test_every_pair_of_permutations_is_one_of_the_rooted_maps(edges):
    found = rooted_maps(edges)
    darts = range(2 * edges)
    pairings = [p for p in permutations(darts) if all(p[d] != d and p[p[d]] == d for d in darts)]
    for alpha in pairings:
        for sigma in permutations(darts):
            try:
                a = CombinatorialMap(sigma, alpha)
            except ValueError:
                continue
            rooted = [names for names in permutations(darts) if names[0] == 0]
            assert sum(any(commutes(n, a, b) for n in rooted) for b in found) == 1


@pytest.mark.parametrize("of", [rooted_maps, unrooted_maps])
def test_the_maps_come_in_the_order_of_their_codes(of):
    codes = [(a.sigma, a.alpha) for a in of(4)]
    assert codes == sorted(set(codes))


@pytest.mark.parametrize("of", [rooted_maps, unrooted_maps])
@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_the_classes_agree_with_the_properties_of_the_map(edges, of):
    everything = of(edges)
    assert of(edges, "simple") == tuple(a for a in everything if a.is_simple)
    assert of(edges, "planar") == tuple(a for a in everything if a.is_planar)
    assert of(edges, "planar-simple") == tuple(a for a in everything if a.is_simple and a.is_planar)


def test_more_than_five_edges_are_refused_for_their_cost():
    with pytest.raises(ValueError, match=r"\(2m\)! = 479001600"):
        rooted_maps(6)
    with pytest.raises(ValueError, match=r"\(2m\)!"):
        unrooted_maps(7, "simple")


def test_a_map_without_edges_is_refused():
    with pytest.raises(ValueError, match="at least 1 edge, not 0"):
        rooted_maps(0)


def test_an_unknown_class_is_refused_with_the_known_ones():
    with pytest.raises(
        ValueError, match="'toroidal' is no class of maps; classes are maps, simple"
    ):
        unrooted_maps(2, "toroidal")
