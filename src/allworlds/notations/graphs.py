"""Graphs with positions, in GraphML (of networkx, of yEd) and in GML; networkx reads them.

The edges round each vertex follow from straight lines between positions, by
:func:`allworlds.maps.networks.from_positions`.  A position stands in ``pos`` (two numbers, or a
text of two), in ``x`` and ``y``, in ``graphics`` of GML, or in the boxes of yEd, of which the
middle is taken.

Names are the labels, if each node has one of its own, else the ids.  Of directed edges both
directions must be there, which are one edge.  yEd calls every edge directed; there an edge leads
one way if it has an arrow at one end alone.
"""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Callable, Iterator
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

    return nx.parse_gml(text_of(content), "id")


def of_graphml(content: bytes) -> nx.Graph:
    """The graph of a text in GraphML."""
    import networkx as nx

    graph, root = nx.read_graphml(io.BytesIO(content)), ET.fromstring(content)  # noqa: S314
    edges, read = len(root.findall(f".//{PLAIN}edge")), graph.number_of_edges()
    if edges != read:
        raise InputError(f"{edges} edges, of which networkx reads {read}: ids must differ")
    return graph


def of_yed(content: bytes) -> nx.Graph:
    """The graph of a file of yEd."""
    import networkx as nx

    root, graph = ET.fromstring(content), nx.MultiGraph()  # noqa: S314  # networkx reads it, too
    graph.add_nodes_from(nx.read_graphml(io.BytesIO(content)).nodes(data=True))
    for node in root.iter(f"{PLAIN}node"):
        if (box := node.find(f".//{YED}Geometry")) is not None:
            keys = ("x", "width"), ("y", "height")
            place = [float(box.get(a, "nan")) + float(box.get(b, "0")) / 2 for a, b in keys]
            graph.nodes[node.get("id")]["pos"] = place
    for edge in root.iter(f"{PLAIN}edge"):
        ends = edge.get("source"), edge.get("target")
        arrows = edge.find(f".//{YED}Arrows")
        heads = [] if arrows is None else [arrows.get(end) for end in ("source", "target")]
        if heads.count("none") == 1:
            v, w = (show(_label(graph.nodes[end]) or end) for end in ends)
            raise InputError(f"the edge from {v} to {w} has an arrow at one end: it leads one way")
        graph.add_edge(*ends)
    return graph


def _label(data: dict[str, Any]) -> str:
    """The label of a node; empty if it has none."""
    return " ".join(str(data.get("label") or "").split())


def _entry(graph: nx.Graph) -> Entry:
    """The world of a graph whose nodes have positions."""
    import networkx as nx

    labels = [_label(data) for _, data in graph.nodes(data=True)]
    names = labels if all(labels) and len({*labels}) == len(labels) else [*map(str, graph)]
    graph = undirected(nx.relabel_nodes(graph, dict(zip(graph, names, strict=True))))
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
