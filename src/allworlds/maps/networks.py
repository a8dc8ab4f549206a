"""Maps to and from networkx, and all embeddings of a graph."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise, permutations
from typing import TYPE_CHECKING, Any, Literal

from allworlds.inputs.checks import InputError, an_integer, integer, show
from allworlds.maps.build import from_cycles, from_rotation, map_at
from allworlds.maps.combinatorial import (
    Code,
    CombinatorialMap,
    InvalidMap,
    cycles,
    rooted_code,
)

if TYPE_CHECKING:
    import networkx as nx


def to_networkx(map_: CombinatorialMap) -> nx.MultiGraph:
    """The graph of the map; attributes hold its rotation.

    The nodes of the graph are the vertices ``0..n-1``.  The attribute ``darts`` of a node holds the
    node's darts clockwise.  The edge of darts ``d < e`` leads from the node of ``d`` to the node of
    ``e``, and has the key ``d`` and the attribute ``darts=(d, e)``.  :func:`from_networkx` is the
    inverse function.
    """
    import networkx as nx  # 'import allworlds' stays fast

    graph = nx.MultiGraph()
    graph.add_nodes_from((v, {"darts": darts}) for v, darts in enumerate(map_.vertices))
    owner = map_.vertex_of
    for d, e in map_.edges:
        graph.add_edge(owner[d], owner[e], key=d, darts=(d, e))
    return graph


def from_networkx(
    graph: nx.Graph, order: Literal["positions", "planar"] | None = None
) -> CombinatorialMap:
    """The map of a graph of networkx.

    Args:
        graph: a graph of any type; a directed graph must have both directions of each edge, and
            the two directions are one edge of the map.
        order: the source of the clockwise order of the edges round each node.

            ``"positions"``: a drawing with straight lines; the attribute ``pos`` of a node is its
            position, as in :func:`from_positions`.

            ``"planar"``: an embedding in the plane, which :func:`networkx.check_planarity` finds.

            None: the graph itself, which must have the attributes ``darts`` of a graph of
            :func:`to_networkx`, or the attributes ``cw`` and ``ccw`` of a ``PlanarEmbedding``.
            The map may then have any genus.  A graph without these attributes is refused.

    The vertices of the map are the nodes in the order of the graph.  But with the attributes
    ``darts`` they are in the order of their smallest darts.

    Raises:
        InvalidMap: naming a node whose edges have no order, an attribute with an illegal value, or
            an edge with only one direction; or if ``order`` is illegal; or if the graph is not
            connected, has no edge, or is not planar but ``order="planar"``; or if the map would not
            have exactly the nodes and edges of the graph.

    Cost: O(m log m).
    """
    import networkx as nx

    pointers = isinstance(graph, nx.PlanarEmbedding) or (
        isinstance(graph, nx.DiGraph) and any("cw" in data for *_, data in graph.edges(data=True))
    )
    if order is None and pointers:
        rotation = {v: _clockwise(v, around) for v, around in graph.adjacency()}
        return compared(from_rotation(rotation), list(graph), undirected(graph))
    plain = undirected(graph)
    if order == "positions":
        return from_positions(plain, nx.get_node_attributes(plain, "pos"))
    if order == "planar":
        _refuse_loops_and_parallels(plain)
        names = list(plain)
        # Numbers replace the names, because networkx loses edges of names such as nan.
        planar, embedding = nx.check_planarity(nx.convert_node_labels_to_integers(plain))
        if not planar:
            raise InvalidMap(f"the graph of node {show(names[0])} is not planar; {LISTS}")
        around = [[names[w] for w in embedding.neighbors_cw_order(v)] for v in range(len(names))]
        return compared(from_rotation(dict(zip(names, around, strict=True))), names, plain)
    if order is not None:
        raise InvalidMap(f"order = {show(order)}; legal is 'positions', 'planar' or None")
    if any("darts" in data for *_, data in [*plain.nodes(data=True), *plain.edges(data=True)]):
        return _from_darts(plain)
    raise InvalidMap(
        f"node {show(next(iter(plain)))} has no order of its edges; order='positions' reads the "
        f"attribute 'pos', order='planar' takes networkx's embedding in the plane, and {LISTS}"
    )


LISTS = "maps.from_rotation and maps.from_cycles take the order round each vertex as a list"


IDS = ("id", "osmid")
"""The attributes by which two directed edges are recognised as one edge."""


def undirected(graph: nx.Graph) -> nx.Graph:
    """The undirected graph of ``graph``: the two directions of each edge become one edge.

    A graph that is undirected already is returned unchanged.

    Raises:
        InvalidMap: for a value that is not a graph, or a graph without a node; naming a node
            without an edge, an edge without the reverse direction, or an edge whose two directions
            have different keys, or different values of an attribute in :data:`IDS`.
    """
    import networkx as nx

    if not isinstance(graph, nx.Graph):
        raise InvalidMap(f"{show(graph)} is no graph of networkx; {LISTS}, maps.from_faces faces")
    if not len(graph):
        raise InvalidMap("the graph has no node; a map has at least one edge")
    for v in nx.isolates(graph):
        raise InvalidMap(f"node {show(v)} has no edge; a vertex has at least one")
    if not isinstance(graph, nx.DiGraph):  # an embedding says of itself that it is not directed
        return graph
    for v, w, *key in graph.edges:
        edge, there = f"the edge from {show(v)} to {show(w)}", graph.edges[v, w, *key]
        is_one_way = str(there.get("oneway")).lower() in ("true", "yes", "1")  # as OSMnx says
        if is_one_way or graph.number_of_edges(v, w) > graph.number_of_edges(w, v):
            raise InvalidMap(
                f"{edge} leads one way only; each edge of a map leads back, as in "
                "graph.to_undirected()"
            )
        back = graph.get_edge_data(w, v, *key)
        if back is None or any(show(there.get(name)) != show(back.get(name)) for name in IDS):
            own = "keys or ids of their own, as two edges have"
            raise InvalidMap(f"{edge} and that back have {own}; legal are equal ones")
    return graph.to_undirected()


def _refuse_loops_and_parallels(graph: nx.Graph) -> None:
    for v, w, *_ in graph.edges:
        if len({v, w}) == 1 or graph.number_of_edges(v, w) > 1:
            which = f"from {show(v)} to {show(w)} is a loop, or one of several"
            raise InvalidMap(f"the edge {which}; {LISTS}, also of these")


def from_positions(graph: nx.Graph, pos: Mapping[Any, Sequence[float]]) -> CombinatorialMap:
    """The map of a drawing with straight lines, which may cross.

    The clockwise order of the lines round each node becomes the order of the darts in the map; the
    genus follows from this order.

    Args:
        graph: as in :func:`from_networkx`, without loops and parallel edges.
        pos: the two coordinates of each node, to the right and **up**.  On screens the second
            coordinate grows downward; such coordinates yield the mirror image.  Coordinates are
            compared exactly, as the printed decimals.

    Darts are numbered node by node, and at each node clockwise from the direction straight up.

    Raises:
        InvalidMap: naming a node whose position is not two finite numbers, two joined nodes with
            equal positions, two edges that leave a node in one direction, a loop or parallel edges;
            or as in :func:`from_networkx`.

    Cost: O(m log m).
    """
    plain = undirected(graph)
    _refuse_loops_and_parallels(plain)
    points = {v: _point(v, pos.get(v)) for v in plain}
    ends = [
        ((v, turn(v, w, points[v], points[w])), (w, turn(w, v, points[w], points[v])))
        for v, w, *_ in plain.edges
    ]
    return from_directions(plain, ends)


def from_directions(
    graph: nx.Graph, passages: Sequence[tuple[tuple[Any, Fraction], tuple[Any, Fraction]]]
) -> CombinatorialMap:
    """The map of a graph in which each edge leaves its ends in known directions.

    The directions of the edges at a node give the clockwise order of the edges round the node.

    Args:
        graph: an undirected graph.  The nodes in their order become the vertices.
        passages: for each edge of the graph its two ends; an end is a pair of the node and the
            direction in which the edge leaves the node, a number as :func:`turn` returns it.

    Raises:
        InvalidMap: naming two edges that leave a node in one direction; or if ``passages`` are not
            the edges of the graph.
    """
    around: dict[Any, list[tuple[Fraction, int, Any]]] = {v: [] for v in graph}
    for edge, (one, other) in enumerate(passages):
        around[one[0]].append((one[1], edge, other[0]))
        around[other[0]].append((other[1], edge, one[0]))
    for v, ends in around.items():
        ends.sort(key=lambda end: end[0])
        for (direction, _, w), (same, _, x) in pairwise(ends):
            if direction == same:
                raise InvalidMap(
                    f"the edges from {show(v)} to {show(w)} and to {show(x)} leave it in one "
                    f"direction; {LISTS}"
                )
    cycles_ = {v: [edge for _, edge, _ in ends] for v, ends in around.items()}
    return compared(from_cycles(cycles_), list(graph), graph)


def _point(v: Hashable, position: Any) -> tuple[Fraction, Fraction]:
    try:
        x, y = [Fraction(str(number)) for number in position if not isinstance(number, str)]
    except (TypeError, ValueError):
        legal = "legal are two finite numbers"
        raise InvalidMap(f"node {show(v)} has the position {show(position)}; {legal}") from None
    return x, y


def turn(v: Hashable, w: Hashable, here: Sequence[Fraction], there: Sequence[Fraction]) -> Fraction:
    """The direction from the position ``here`` to ``there``, as a number from 0 to less than 4.

    The numbers increase clockwise: 0 is up, 1 right, 2 down, 3 left.  ``v`` and ``w`` are the nodes
    at these positions, and are named in messages.

    Raises:
        InvalidMap: if the positions are equal.
    """
    right, up = (b - a for a, b in zip(here, there, strict=True))
    if not right and not up:
        raise InvalidMap(f"the nodes {show(v)} and {show(w)} are joined, but at one place")
    part = right / (abs(right) + abs(up))
    return 2 - part if up < 0 else part % 4


def embeddings(
    graph: nx.Graph, *, up_to_isomorphism: bool = True, genus: int | None = None
) -> Iterator[CombinatorialMap]:
    """Yield the maps of a graph, for all choices of cyclic orders of the edges round each vertex.

    Args:
        graph: a graph of networkx, of any type.  To exchange two parallel edges, or the two ends of
            a loop, in the order round a vertex makes another order.
        up_to_isomorphism: whether only the first map is yielded if several maps are the same up to
            the names of darts; mirror images are in general different maps.
        genus: the genus of the yielded maps; None for any genus.

    All maps have the same ``alpha``, and their vertices are the nodes in their order.  The maps
    come in the lexicographic order of their rotations; each rotation begins with the first edge of
    the vertex.

    Raises:
        InvalidMap: at once, if the graph is not connected or has no edge.
        InputError: at once, if ``genus`` is neither None nor an integer of at least 0.

    Cost: ``(d - 1)!`` cyclic orders at each vertex of degree d.  Each map costs the time O(m).  If
    ``up_to_isomorphism`` is true, each yielded map costs O(m^2) of time and memory: the codes of
    all its rootings are computed, and kept for the comparison with later maps.
    """
    if genus is not None and an_integer("genus", genus) < 0:
        raise InputError(f"genus = {genus}; legal is an integer of at least 0")
    plain = undirected(graph)
    around: dict[Any, list[int]] = {v: [] for v in plain}
    for edge, (v, w, *_) in enumerate(plain.edges):
        around[v].append(edge)
        around[w].append(edge)
    maps = _turned(from_cycles(around))
    of_genus = (map_ for map_ in maps if genus is None or map_.genus == genus)
    return _one_of_each_class(of_genus) if up_to_isomorphism else of_genus


def _turned(map_: CombinatorialMap) -> Iterator[CombinatorialMap]:
    """Yield the maps with the edges of ``map_``, for all cyclic orders of darts round vertices."""
    orders = [permutations(others) for _, *others in map_.vertices]
    chosen = [next(each) for each in orders]
    while True:
        pairs = zip(map_.vertices, chosen, strict=True)
        sigma = permutation((darts[0], *others) for darts, others in pairs)
        yield CombinatorialMap.trusted(sigma, map_.alpha)
        for v in reversed(range(len(orders))):
            following = next(orders[v], None)
            if following is not None:
                chosen[v] = following
                break
            orders[v] = permutations(map_.vertices[v][1:])
            chosen[v] = next(orders[v])
        else:
            return


def _one_of_each_class(maps: Iterable[CombinatorialMap]) -> Iterator[CombinatorialMap]:
    seen: set[Code] = set()
    for map_ in maps:
        if rooted_code(map_.sigma, map_.alpha, 0) not in seen:
            yield map_
            seen.update(rooted_code(map_.sigma, map_.alpha, root) for root in map_.darts)


def compared(map_: CombinatorialMap, nodes: Sequence[Any], graph: nx.Graph) -> CombinatorialMap:
    """Return ``map_`` itself, after a check that this map has the nodes and edges of ``graph``.

    ``nodes`` holds for each vertex of the map the node for which the vertex stands.

    Raises:
        InvalidMap: if the map and the graph have different nodes, or edges with different ends.
    """
    rank = {v: i for i, v in enumerate(graph)}
    at = [nodes[vertex] for vertex in map_.vertex_of]
    given = [tuple(sorted(ends, key=rank.__getitem__)) for ends in graph.edges()]
    made = [tuple(sorted((at[d], at[e]), key=rank.__getitem__)) for d, e in map_.edges]
    wanted, found = Counter(given), Counter(made)
    for ends in [*given, *made]:
        if wanted[ends] != found[ends]:
            v, w = map(show, ends)
            numbers = f"{wanted[ends]} in the graph, {found[ends]} in the map"
            raise InvalidMap(f"the number of edges from {v} to {w} is {numbers}")
    if map_.vertex_count != len(graph):
        raise InvalidMap(f"the graph has {len(graph)} nodes, but the map {map_.vertex_count}")
    return map_


def _from_darts(graph: nx.Graph) -> CombinatorialMap:
    """The map of a graph whose nodes and edges have the attribute ``darts`` of :func:`to_networkx`.

    Raises:
        InvalidMap: naming a node or an edge whose attribute is missing or illegal.
    """
    around = {v: _darts(f"node {show(v)}", data) for v, data in graph.nodes(data=True)}
    owner = {dart: v for v, darts in around.items() for dart in darts}
    pairs, loose = [], dict(owner)
    for v, w, data in graph.edges(data=True):
        edge = f"the edge from {show(v)} to {show(w)}"
        pair = _darts(edge, data)
        if len(pair) != 2 or Counter(loose.pop(dart, None) for dart in pair) != Counter((v, w)):
            legal = "an edge has two darts of its own, one at each end"
            raise InvalidMap(f"{edge} has the darts {show(pair)}; {legal}")
        pairs.append(pair)
    for dart, v in loose.items():
        raise InvalidMap(f"no edge has dart {dart} of node {show(v)}; each dart belongs to an edge")
    map_ = CombinatorialMap(permutation(around.values()), permutation(pairs))
    return compared(map_, [owner[first] for first, *_ in map_.vertices], graph)


def _darts(node: str, data: Mapping[str, Any]) -> list[int]:
    """The integers in the attribute ``darts`` of a node or an edge.

    ``node`` names the node or the edge in messages; ``data`` holds all its attributes.

    Raises:
        InvalidMap: if the attribute is missing, or is not a list of one integer or more.
    """
    if "darts" not in data:
        raise InvalidMap(f"{node} has no attribute 'darts'; all nodes and edges have it, or none")
    try:
        darts = [integer(dart) for dart in data["darts"]]
    except TypeError:
        darts = []
    if not darts:
        raise InvalidMap(f"{node} has darts = {show(data['darts'])}; legal is a list of integers")
    return darts


def permutation(cycles: Iterable[Sequence[int]]) -> list[int]:
    """The permutation with the cycles ``cycles``, as the list of the images of 0, 1, ...

    Raises:
        InvalidMap: unless each of 0..N-1 is in exactly one cycle.
    """
    pairs = sorted((a, b) for cycle in cycles for a, b in pairwise([*cycle, *cycle[:1]]))
    darts = [dart for dart, _ in pairs]
    if darts != list(range(len(pairs))):
        raise InvalidMap(f"the darts {show(darts)} are not 0..{len(pairs) - 1}")
    return [image for _, image in pairs]


def from_faces(faces: Sequence[Sequence[Hashable]]) -> CombinatorialMap:
    """The map of a closed surface that is glued from polygons.

    Args:
        faces: for each face its vertices, such as ``"abc"``, in the order in which a walk round the
            face meets them; the face is to the left of the walker.  The walks together must pass
            along each edge once in each direction.  Each passage along an edge becomes a dart of
            the vertex where the passage begins; the darts are numbered in the order of the
            passages.  Parallel edges and loops are refused; for maps that have them use
            :func:`~allworlds.maps.build.from_cycles`.

    Raises:
        InvalidMap: naming an edge that is not walked once in each direction; a vertex whose faces
            form more than one cycle round it, so that separate pieces of surface meet only at this
            vertex; or a vertex that cannot be reached.

    Cost: O(m).
    """
    phi: dict[tuple[Hashable, Hashable], tuple[Hashable, Hashable]] = {}
    for face in faces:
        walk = list(zip(face, [*face[1:], *face[:1]], strict=True))
        for way, after in zip(walk, [*walk[1:], *walk[:1]], strict=True):
            if way in phi or way[0] == way[1]:
                ends = f"from {show(way[0])} to {show(way[1])}"
                raise InvalidMap(
                    f"the edge {ends} is a loop or walked twice; from_cycles takes loops and "
                    "parallel edges"
                )
            phi[way] = after
    for a, b in phi:
        if (b, a) not in phi:
            raise InvalidMap(f"the edge from {show(a)} to {show(b)} is never walked back")
    number = {way: i for i, way in enumerate(phi)}
    # phi = sigma . alpha, so that sigma = phi . alpha.
    alpha = [number[b, a] for a, b in phi]
    sigma = [number[phi[b, a]] for a, b in phi]
    ways = list(phi)
    pieces = Counter(ways[around[0]][0] for around in cycles(sigma))
    for vertex, count in pieces.most_common(1):
        if count > 1:
            raise InvalidMap(f"at vertex {show(vertex)} {count} pieces of surface meet; 1 is legal")
    return map_at(sigma, alpha, [vertex for vertex, _ in ways])


def _clockwise(v: Hashable, around: Mapping[Hashable, Mapping[str, Any]]) -> list[Hashable]:
    """The neighbours of ``v`` clockwise, in the order of ``PlanarEmbedding.neighbors_cw_order``.

    ``around`` holds for each neighbour w of ``v`` the attributes of the edge from ``v`` to w:
    ``cw`` is the next neighbour after w clockwise, ``ccw``, which may be missing, the one before.

    Raises:
        InvalidMap: if these attributes do not lead once round all neighbours.
    """
    following = {w: data.get("cw") for w, data in around.items()}
    first = w = next(reversed(following), None)
    walk = []
    while w in following:
        walk.append(w)
        w = following.pop(w)
    back = all(around[b].get("ccw", a) == a for a, b in pairwise([*walk, *walk[:1]]))
    if following or w != first or not back:
        once = f"once round its neighbours {show([*around])}"
        raise InvalidMap(f"at vertex {show(v)} 'cw' and 'ccw' do not lead {once}")
    return walk
