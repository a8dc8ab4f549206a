import networkx as nx
import pytest

from allworlds.maps import CombinatorialMap
from second_opinion import same_map, same_pose, verdict


def drawn(*vertices):
    """A map from the letters of the edges clockwise round each vertex; darts in reading order."""
    letters = "".join(vertices)
    sigma = []
    for vertex in vertices:
        first = len(sigma)
        sigma += [first + (i + 1) % len(vertex) for i in range(len(vertex))]
    alpha = [
        next(e for e, other in enumerate(letters) if other == letter and e != d)
        for d, letter in enumerate(letters)
    ]
    return CombinatorialMap(sigma, alpha)


def graph(a):
    result = nx.MultiGraph()
    result.add_edges_from((a.vertex_of[d], a.vertex_of[e]) for d, e in a.edges)
    return result


# A theta is three edges a, b, c from one vertex to another; t is the tail.  Reflection in the
# middle edge b keeps the first two; in the third it takes the divided edge a to c.
THETA_WITH_TAIL = drawn("abct", "cba", "t")
MIDDLE_EDGE_DIVIDED = drawn("abct", "cda", "t", "bd")
OUTER_EDGE_DIVIDED = drawn("abct", "cbd", "t", "ad")


@pytest.mark.parametrize(
    "chiral", [OUTER_EDGE_DIVIDED, drawn("abc", "a", "bd", "d", "ce", "ef", "f")]
)
def test_the_mirror_image_of_a_chiral_map_is_another_map_of_the_same_graph(chiral):
    mirrored = chiral.mirrored()
    assert nx.is_isomorphic(graph(chiral), graph(mirrored))
    assert not same_map(chiral, mirrored)
    assert verdict(chiral, 0, mirrored, 0) == "map"


@pytest.mark.parametrize("achiral", [THETA_WITH_TAIL, MIDDLE_EDGE_DIVIDED])
def test_a_map_with_a_reflection_is_its_mirror_image(achiral):
    assert same_map(achiral, achiral.mirrored())


@pytest.mark.parametrize(
    ("a", "b"),
    [
        (drawn("aabb"), drawn("abab")),  # two loops in the plane, and on the torus
        (drawn("abc", "cba"), drawn("abc", "abc")),  # theta in the plane, and on the torus
        (drawn("abct", "cba", "t"), drawn("abct", "abc", "t")),
    ],
)
def test_two_embeddings_of_one_graph_are_two_maps(a, b):
    assert nx.is_isomorphic(graph(a), graph(b))
    assert verdict(a, 0, b, 0) == "map"


@pytest.mark.parametrize(
    ("a", "b"),
    [
        (drawn("a", "a"), drawn("ab", "a", "b")),
        (drawn("abc", "a", "b", "c"), drawn("ab", "bc", "a", "c")),
        (drawn("ab", "ab"), drawn("aab", "b")),
    ],
)
def test_maps_of_different_graphs_are_different(a, b):
    assert verdict(a, 0, b, 0) == "map"
    assert verdict(b, 0, a, 0) == "map"


def test_turning_at_a_vertex_without_symmetry_is_another_pose():
    # Darts 0, 1, 2 at the middle lead to two leaves and to the longer leg.
    star = drawn("abc", "a", "b", "cd", "d")
    assert verdict(star, 0, star, 0) == "right"
    assert verdict(star, 0, star, 1) == "pose"
    assert verdict(star, 0, star, 2) == "pose"


def test_turning_by_an_automorphism_is_the_same_pose():
    star = drawn("abc", "a", "b", "c")
    assert [verdict(star, 0, star, here) for here in star.darts] == ["right"] * 3 + ["pose"] * 3


def test_the_other_end_of_a_loop_is_the_same_pose_only_by_symmetry():
    alone = drawn("aa")
    assert verdict(alone, 0, alone, 1) == "right"
    with_tail = drawn("aab", "b")
    assert verdict(with_tail, 0, with_tail, 1) == "pose"


def test_a_graph_automorphism_that_breaks_the_rotation_moves_no_pose():
    # Swapping the two leaves is an automorphism of the graph, and a reflection of the map.
    star = drawn("abc", "a", "b", "cd", "d")
    leaf_a, leaf_b = 3, 4
    assert not same_pose(star, leaf_a, star, leaf_b)
    assert same_pose(star, leaf_a, star.mirrored(), leaf_b)


@pytest.mark.parametrize(("here_a", "here_b"), [(0, 2), (2, 0), (-1, 0)])
def test_a_pose_that_is_no_dart_is_refused(here_a, here_b):
    edge = drawn("a", "a")
    with pytest.raises(ValueError, match=r"(2|-1) is no dart; darts are 0\.\.1"):
        same_pose(edge, here_a, edge, here_b)
    with pytest.raises(ValueError, match="is no dart"):
        verdict(edge, here_a, edge, here_b)
