"""An edge never vanishes: a graph of networkx becomes a map with its edges, or is refused."""

import re
from collections import Counter
from itertools import islice

import networkx as nx
import pytest
from hypothesis import Phase, find, given, settings
from hypothesis.strategies import (
    booleans,
    composite,
    floats,
    frozensets,
    integers,
    just,
    lists,
    none,
    one_of,
    permutations,
    sampled_from,
    text,
    tuples,
)

from allworlds.maps import (
    InvalidMap,
    embeddings,
    from_networkx,
    from_positions,
    to_networkx,
    unrooted_code,
)


class Odd:
    """A name whose text has two lines."""

    def __repr__(self):
        return "odd\nname"


NAMES = one_of(
    text(max_size=4),
    integers(-2, 2),
    integers().map(lambda n: n * 10**50),
    sampled_from(["küche", "🚪", "a\nb", "'", "x" * 300, "10", "None", 1.5, float("nan"), True]),
    tuples(integers(0, 1), text(max_size=1)),
    frozensets(integers(0, 1)),
    just(Odd()),
)
TYPES = [nx.Graph, nx.MultiGraph, nx.DiGraph, nx.MultiDiGraph]
PLACES = one_of(
    tuples(integers(-2, 2), integers(-2, 2)),
    tuples(floats(), floats()),
    none() | text(max_size=2) | lists(integers(0, 3), max_size=3),
)
ORDERS = ["positions", "planar", None]
KINDS = [*TYPES, nx.PlanarEmbedding]


@composite
def graphs(draw, types=TYPES):
    """A graph of any type: mostly connected, with good places and both directions of its edges."""
    names = draw(lists(NAMES, min_size=1, max_size=6, unique=True))
    graph = draw(sampled_from(types))()
    good = draw(booleans())
    if good or draw(booleans()):
        graph.add_nodes_from(names)
    ends = [(v, draw(sampled_from(names[:i]))) for i, v in enumerate(names) if i] if good else []
    more = draw(lists(tuples(*[sampled_from(names)] * 2), max_size=4))
    joined = {frozenset(pair) for pair in ends}
    if not good:
        ends += more
    else:  # no loop, and no parallel edge
        new = {frozenset(pair): pair for pair in more if len({*pair}) == 2}
        ends += [pair for both, pair in new.items() if both not in joined]
    graph.add_edges_from(ends)
    if good or draw(booleans()):
        graph.add_edges_from([(w, v) for v, w in ends if isinstance(graph, nx.DiGraph)])
    for v in graph:
        if good or draw(sampled_from([True, True, False])):
            graph.nodes[v]["pos"] = draw(PLACES)
    if good:
        places = draw(permutations([(x, x * x) for x in range(len(graph))]))
        nx.set_node_attributes(graph, dict(zip(graph, places, strict=True)), "pos")
    return graph


@composite
def pointers(draw):
    """An embedding of any genus, often with a wrong pointer or half an edge less."""
    graph = nx.Graph(draw(graphs()))
    embedding = nx.PlanarEmbedding()
    embedding.set_data({v: draw(permutations(sorted(graph[v], key=repr))) for v in graph})
    halves = list(embedding.edges)
    if halves and draw(booleans()):
        half = draw(sampled_from(halves))
        if draw(booleans()):
            embedding.edges[half][draw(sampled_from(["cw", "ccw"]))] = draw(sampled_from([*graph]))
        else:
            nx.DiGraph.remove_edge(embedding, *half)
    return embedding


def edges_of(graph):
    """How many edges join any two nodes by their places; both directions are one edge."""
    place = {v: i for i, v in enumerate(graph)}
    one_way = isinstance(graph, nx.DiGraph)
    named = {(frozenset((place[v], place[w])), *key) for v, w, *key in graph.edges}
    assert one_way or len(named) == graph.number_of_edges()
    return Counter(ends for ends, *_ in named)


def edges_of_map(map_):
    """How many edges join any two vertices."""
    at = map_.vertex_of
    return Counter(frozenset((at[d], at[e])) for d, e in map_.edges)


def tried(make, graph, *options):
    """The result; None if the graph is refused in one line that names a place in it."""
    try:
        return make(graph, *options)
    except InvalidMap as error:
        said = str(error)
    assert len(said.splitlines()) == 1
    assert not graph or re.search(r"(node|nodes|vertex|from|join) \S", said)
    return None


@given(graphs() | pointers(), sampled_from(ORDERS))
def test_a_graph_comes_back_with_its_edges_or_is_refused_by_a_place(graph, order):
    before = edges_of(graph)
    map_ = tried(from_networkx, graph, order)
    assert map_ is None or edges_of_map(map_) == before
    assert edges_of(graph) == before  # and is as it was


@given(graphs())
def test_every_embedding_has_the_edges_and_is_read_as_a_graph_until_an_edge_comes(graph):
    every = tried(embeddings, graph) or ()
    for map_ in islice(every, 3):
        assert edges_of_map(map_) == edges_of(graph)
        again = to_networkx(map_)
        assert from_networkx(again) == map_
        again.add_edge(0, map_.vertex_count - 1)
        assert tried(from_networkx, again) is None


@pytest.mark.parametrize("type_", KINDS)
@pytest.mark.parametrize("wanted", [True, False])
def test_graphs_of_each_type_are_drawn_that_are_read_and_that_are_refused(type_, wanted):
    drawn, order = graphs([type_]), "positions"
    if type_ is nx.PlanarEmbedding:
        drawn, order = pointers(), None
    find(
        drawn,
        lambda graph: len(graph) > 2 and bool(tried(from_networkx, graph, order)) is wanted,
        settings=settings(phases=[Phase.generate], max_examples=100),
    )


@given(lists(tuples(integers(-2, 2), integers(-2, 2)), min_size=2, max_size=6, unique=True))
def test_a_drawing_that_is_turned_has_the_same_map(places):
    graph = nx.star_graph(len(places))
    pos = [(0, 0), *places]
    turned = [(y, -x) for x, y in pos]
    maps = [tried(from_positions, graph, dict(enumerate(drawing))) for drawing in (pos, turned)]
    codes = [map_ and unrooted_code(map_) for map_ in maps]
    assert codes[0] == codes[1]
