"""Graphs with positions, in GraphML (of networkx, of yEd) and in GML; networkx reads them.

The edges round each vertex follow from straight lines between positions, by
:func:`allworlds.maps.networks.from_positions`.  A position stands in ``pos`` (two numbers, or a
text of two), in ``x`` and ``y``, in ``graphics`` of GML, or in the boxes of yEd, of which the
middle is taken.  An edge with a bend is refused, as is every file of which the graph would not have
each node and each edge.

Names are the labels, if each node has one of its own, else the ids.  Of directed edges both
directions must be there, which are one edge, unless they have ids of their own.  yEd calls every
edge directed; there an edge leads one way if it has an arrow at one end alone.
"""

from __future__ import annotations

import io
import re
import warnings
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from typing import IO, TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

from allworlds.inputs.checks import InputError, show
from allworlds.maps.networks import from_positions, undirected
from allworlds.notations.entry import text_of
from allworlds.world.labels import Labelling
from allworlds.world.world import Entry

if TYPE_CHECKING:
    import networkx as nx

PLAIN, YED = "{http://graphml.graphdrawing.org/xmlns}", "{http://www.yworks.com/xml/graphml}"
"""The namespaces of GraphML and of yEd."""


def read_graph(
    make: Callable[[bytes], nx.Graph],
) -> Callable[[IO[bytes]], Iterator[tuple[int, Entry]]]:
    """A reader of the world of a file, whose content is made a graph so."""

    def read(file: IO[bytes]) -> Iterator[tuple[int, Entry]]:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                graph = make(file.read())
        except InputError:
            raise
        except Exception as error:  # noqa: BLE001  # networkx has many kinds, where a file is garbled
            said = show(str(error) or error)[1:-1]
            raise InputError(f"networkx cannot read it: {said}") from None
        yield 0, _entry(graph)

    return read


def of_gml(content: bytes) -> nx.Graph:
    """The graph of a text in GML."""
    import networkx as nx

    text = text_of(content)
    graph = nx.parse_gml(text, "id")
    _ensure_differ(map(str, graph))
    for node, data in graph.nodes(data=True):
        if data.get("isGroup"):
            raise _no_vertex(_label(data) or node)
    parts = re.findall(r"\b(node|edge)\s*\[", re.sub(r'"[^"]*"|#.*', "", text))
    _ensure_whole(graph, parts.count("node"), parts.count("edge"))
    return graph


def of_graphml(content: bytes) -> nx.Graph:
    """The graph of a text in GraphML."""
    _, graph = _root_and_graph(content)
    return graph


def of_yed(content: bytes) -> nx.Graph:
    """The graph of a file of yEd."""
    import networkx as nx

    root, read = _root_and_graph(content)
    graph = nx.MultiGraph()
    graph.add_nodes_from(read.nodes(data=True))
    for node in root.iter(f"{PLAIN}node"):
        if (box := node.find(f".//{YED}Geometry")) is not None:
            keys = ("x", "width"), ("y", "height")
            place = [float(box.get(a, "nan")) + float(box.get(b, "0")) / 2 for a, b in keys]
            graph.nodes[node.get("id")]["pos"] = place
    for edge in root.iter(f"{PLAIN}edge"):
        ends = edge.get("source"), edge.get("target")
        v, w = (show(_label(graph.nodes[end]) or end) for end in ends)
        arrows = edge.find(f".//{YED}Arrows")
        heads = [] if arrows is None else [arrows.get(end) for end in ("source", "target")]
        if heads.count("none") == 1:
            raise InputError(f"the edge from {v} to {w} has an arrow at one end: it leads one way")
        if _is_bent_in_yed(edge):
            raise _not_straight(v, w)
        graph.add_edge(*ends)
    return graph


def _root_and_graph(content: bytes) -> tuple[ET.Element, nx.Graph]:
    """The root of a text in GraphML, in the usual namespace, and the graph in it.

    Raises:
        InputError: naming a node or an edge of the text that the graph would lack.
    """
    import networkx as nx

    root = ET.fromstring(content)  # noqa: S314  # networkx reads it, too
    given = root.tag.rpartition("}")[0]  # some programs write another namespace, or none
    for each in root.iter():
        namespace, _, name = each.tag.rpartition("}")
        if namespace == given:
            each.tag = PLAIN + name
    if (graphs := len(root.findall(f"{PLAIN}graph"))) != 1:
        raise InputError(f"{graphs} graphs stand in it; legal is 1")
    nodes, edges = ([*root.iter(PLAIN + what)] for what in ("node", "edge"))
    for node in nodes:
        if node.find(f"{PLAIN}graph") is not None:
            label = node.findtext(f"{PLAIN}data//{YED}NodeLabel", "").strip()
            raise _no_vertex(label or node.get("id"))
    ids = [node.get("id") for node in nodes]
    _ensure_differ(ids)
    graph = nx.read_graphml(io.BytesIO(ET.tostring(root)))
    for end in set(graph).difference(ids):
        raise InputError(f"an edge ends at {show(end)}, which is no node")
    _ensure_whole(graph, len(nodes), len(edges))
    return root, graph


def _no_vertex(group: object) -> InputError:
    return InputError(f"the node {show(group)} is a group of nodes, and no vertex; ungroup it")


def _not_straight(v: str, w: str) -> InputError:
    how = "has a bend, or an end beside the middle of a box; legal are straight lines"
    return InputError(f"the edge from {v} to {w} {how}")


def _ensure_differ(ids: Iterable[object]) -> None:
    """Refuse nodes that have one id."""
    for each, number in Counter(ids).items():
        if number > 1:
            raise InputError(f"{number} nodes have the id {show(each)}; each has one of its own")


def _ensure_whole(graph: nx.Graph, nodes: int, edges: int) -> None:
    """Refuse a graph that networkx has read with other numbers of nodes or edges."""
    n, m = graph.number_of_nodes(), graph.number_of_edges()
    if (n, m) != (nodes, edges):
        read = f"{nodes} nodes and {edges} edges, of which networkx reads {n} and {m}"
        raise InputError(f"{read}: one has the id of another, is nested, or follows a lone '\"'")


def _is_bent_in_yed(edge: ET.Element) -> bool:
    """Whether an edge of yEd is no straight line from the middle of a box to that of another."""
    drawn = [*edge.iter(f"{YED}Path"), *edge.iter(f"{YED}Arc")]
    shifts = [each.get(key, "0") for each in drawn for key in ("sx", "sy", "tx", "ty", "height")]
    return any(map(len, drawn)) or any(map(float, shifts))


def _is_bent(data: dict[str, Any]) -> bool:
    """Whether an edge is drawn with a bend: by ``Line`` of GML, or ``geometry`` of OSMnx."""
    found: Any = data.get("graphics")
    for key in ("Line", "point"):
        found = found.get(key) if isinstance(found, dict) else None
    bends = isinstance(found, list) and len(found) > 2
    return bends or str(data.get("geometry", "")).count(",") > 1  # LINESTRING (0 0, 1 2, 3 4)


def _label(data: dict[str, Any]) -> str:
    """The label of a node; empty if it has none."""
    return " ".join(str(data.get("label") or "").split())


def _entry(graph: nx.Graph) -> Entry:
    """The world of a graph whose nodes have positions."""
    import networkx as nx

    labels = [_label(data) for _, data in graph.nodes(data=True)]
    names = labels if all(labels) and len({*labels}) == len(labels) else [*map(str, graph)]
    graph = undirected(nx.relabel_nodes(graph, dict(zip(graph, names, strict=True))))
    for v, w, data in graph.edges(data=True):
        if _is_bent(data):
            raise _not_straight(show(v), show(w))
    places = {name: _place(name, graph.nodes[name]) for name in names}
    map_ = from_positions(graph, places)
    return Entry(map_, Labelling("", tuple(names), tuple(places.values())))


def _place(name: str, data: dict[str, Any]) -> Any:
    """The two coordinates of a node, wherever they stand."""
    graphics = data.get("graphics")
    told = graphics if isinstance(graphics, dict) else data
    pos = data.get("pos") or [told.get("x"), told.get("y")]
    pos = re.split(r"[\s,]+", pos.strip("()[]! ")) if isinstance(pos, str) else pos
    try:
        return [float(each) for each in pos]
    except (TypeError, ValueError):
        ways = "pos, x and y, or graphics [ x y ]"
        raise InputError(f"vertex {show(name)} is at {show(pos)}; legal are {ways}") from None
