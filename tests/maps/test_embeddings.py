"""Every embedding of a graph, against numbers that others have found and against a slow count."""

from collections import Counter
from itertools import islice, permutations, product
from math import factorial, prod

import networkx as nx
import pytest

from allworlds.inputs.checks import InputError
from allworlds.maps import (
    InvalidMap,
    automorphisms,
    embeddings,
    from_cycles,
    isomorphism,
    rooted_code,
    to_networkx,
)

GRAPHS = {
    "k4": nx.complete_graph(4),
    "k33": nx.complete_bipartite_graph(3, 3),
    "k5": nx.complete_graph(5),
    "petersen": nx.petersen_graph(),
    "loops": nx.MultiGraph([("a", "a"), ("a", "a"), ("a", "b")]),
    "dipole": nx.MultiGraph([(0, 1)] * 4),
    "bouquet": nx.MultiGraph([(0, 0)] * 3),
}


def by_genus(maps):
    found = Counter(map_.genus for map_ in maps)
    return [found[genus] for genus in range(max(found) + 1)]


# Genus distributions: of bouquets J. L. Gross, D. P. Robbins, T. W. Tucker, Genus distributions for
# bouquets of circles (1989); the others are those of the textbooks on topological graph theory.
@pytest.mark.parametrize(
    ("name", "numbers"),
    [
        ("k4", [2, 14]),
        ("k33", [0, 40, 24]),
        ("k5", [0, 462, 4974, 2340]),
        ("petersen", [0, 40, 664, 320]),
        ("bouquet", [40, 80]),
    ],
)
def test_all_rotations_have_the_known_numbers_by_genus(name, numbers):
    graph = GRAPHS[name]
    assert by_genus(embeddings(graph, up_to_isomorphism=False)) == numbers
    assert sum(numbers) == prod(factorial(degree - 1) for _, degree in graph.degree)


def by_hand(graph):
    """The numbers of rotations of a simple graph by genus, its faces walked in neighbours."""
    found = Counter()
    cyclic = [[(w, *more) for more in permutations(ws)] for w, *ws in graph.adj.values()]
    for orders in product(*cyclic):
        after = {(v, w): order[i - len(order) + 1]
                 for v, order in zip(graph, orders, strict=True)
                 for i, w in enumerate(order)}  # fmt: skip
        left, faces = set(after), 0
        while left:
            v, w = way = next(iter(left))
            faces += 1
            while way in left:
                left.remove(way)
                v, w = way = (w, after[w, v])
        found[(2 - len(graph) + graph.size() - faces) // 2] += 1
    return [found[genus] for genus in range(max(found) + 1)]


@pytest.mark.parametrize("name", ["k4", "k33", "petersen"])
def test_a_count_by_hand_finds_as_many(name):
    assert by_hand(GRAPHS[name]) == by_genus(embeddings(GRAPHS[name], up_to_isomorphism=False))


# B. P. Mull, R. G. Rieper, A. T. White, Enumerating 2-cell imbeddings of connected graphs (1988),
# by Burnside's lemma: 3 and 78.  A. Gagarin, W. L. Kocay, Embedding K3,3 and K5 on the double torus
# (arXiv 2203.01150), by construction: 1 there that is its mirror image; 14 that are not, and 17.
def test_classes_have_the_known_numbers():
    assert len([*embeddings(GRAPHS["k4"])]) == 3
    every = [*embeddings(GRAPHS["k5"])]
    assert len(every) == 78
    [double] = embeddings(GRAPHS["k33"], genus=2)
    assert isomorphism(double, double.mirrored())
    double = [map_ for map_ in every if map_.genus == 2]
    own_image = [map_ for map_ in double if isomorphism(map_, map_.mirrored())]
    assert len(own_image) == 17
    assert len(double) == 17 + 2 * 14


SYMMETRIES = {
    "k4": 24,
    "k33": 72,
    "k5": 120,
    "petersen": 120,
    "loops": 2**2 * 2,
    "dipole": 24 * 2,
    "bouquet": 2**3 * 6,
}
"""Of each graph the automorphisms, as permutations of the ends of its edges."""


@pytest.mark.parametrize("name", GRAPHS)
def test_the_orbits_of_the_classes_are_all_rotations(name):
    graph = GRAPHS[name]
    orbits = [SYMMETRIES[name] // automorphisms(map_) for map_ in embeddings(graph)]
    assert sum(orbits) == prod(factorial(degree - 1) for _, degree in graph.degree)


@pytest.mark.parametrize(("name", "number"), [("k4", 8), ("k33", 16), ("loops", None)])
def test_rooted_maps_are_rotations_times_darts_by_automorphisms(name, number):
    graph = GRAPHS[name]
    every = [*embeddings(graph, up_to_isomorphism=False)]
    rooted = {rooted_code(map_.sigma, map_.alpha, root) for map_ in every for root in map_.darts}
    assert len(rooted) == len(every) * 2 * graph.size() // SYMMETRIES[name]
    assert number in (None, len(rooted))


@pytest.mark.parametrize("name", ["k4", "loops", "dipole", "bouquet"])
def test_each_class_comes_once_by_its_first_rotation(name):
    every = [*embeddings(GRAPHS[name], up_to_isomorphism=False)]
    assert len(set(every)) == len(every)
    assert [map_.vertices for map_ in every] == sorted(map_.vertices for map_ in every)
    first = []
    for map_ in every:
        if not any(isomorphism(map_, other) for other in first):
            first.append(map_)
    assert [*embeddings(GRAPHS[name])] == first


@pytest.mark.parametrize("name", GRAPHS)
def test_an_embedding_has_the_graph_and_its_nodes_in_their_order(name):
    graph = GRAPHS[name]
    nodes = list(graph)
    wanted = Counter(frozenset(ends) for ends in graph.edges())
    for map_ in islice(embeddings(graph, up_to_isomorphism=False), 50):
        at = [nodes[v] for v in map_.vertex_of]
        assert Counter(frozenset((at[d], at[e])) for d, e in map_.edges) == wanted


def test_the_first_embedding_has_the_edges_in_their_order():
    assert next(embeddings(GRAPHS["loops"])) == from_cycles(["aabbc", "c"])
    assert next(embeddings(nx.Graph(["xy", "yz", "zx"]))) == from_cycles(["ab", "ac", "bc"])


def test_one_genus_alone_is_that_part():
    graph = GRAPHS["petersen"]
    assert [*embeddings(graph, genus=0)] == []
    assert by_genus(embeddings(graph)) == [0, 1, 7, 4]
    [torus] = embeddings(graph, genus=1)
    assert sorted(map(len, torus.faces)) == [5, 5, 5, 6, 9]


def test_both_directions_of_an_edge_are_one_edge_of_an_embedding():
    assert len([*embeddings(GRAPHS["k4"].to_directed())]) == 3
    assert len([*embeddings(to_networkx(next(embeddings(GRAPHS["k4"]))))]) == 3


@pytest.mark.timeout(60)  # for ever, if all orders of one vertex were made first
def test_the_first_embeddings_of_a_large_graph_come_at_once():
    assert len([*islice(embeddings(nx.star_graph(30), up_to_isomorphism=False), 3)]) == 3
    assert next(embeddings(nx.path_graph(3000))).edge_count == 2999


@pytest.mark.parametrize(
    ("graph", "said"),
    [
        (nx.Graph(), "the graph has no node; a map has at least one edge"),
        (nx.Graph([("a", "b"), ("c", "d")]), "vertex 'c' cannot be reached from vertex 'a'"),
        (nx.empty_graph(1), "node 0 has no edge"),
        (nx.DiGraph([("a", "b")]), "the edge from 'a' to 'b' leads one way only"),
        ("k4", "'k4' is no graph of networkx"),
    ],
)
def test_what_has_no_embedding_is_refused_at_once(graph, said):
    with pytest.raises(InvalidMap, match=said):
        embeddings(graph)


@pytest.mark.parametrize("genus", [-1, 1.0, True, "1"])
def test_a_genus_that_is_none_is_refused_at_once(genus):
    with pytest.raises(InputError, match=f"genus = {genus!r}"):
        embeddings(GRAPHS["k4"], genus=genus)


@pytest.mark.parametrize(("genus", "count"), [(0, 1), (1, 1), (2, 0)])
def test_embeddings_have_a_genus_of_at_least_0(genus, count):
    """Three parallel edges have two embeddings up to isomorphism: in the plane and on the torus."""
    theta = nx.MultiGraph([(0, 1)] * 3)
    assert len([*embeddings(theta, genus=genus)]) == count
    with pytest.raises(InputError, match=r"^genus = -1; legal is an integer of at least 0$"):
        embeddings(theta, genus=-1)
