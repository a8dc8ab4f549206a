"""Graphs with positions, in GraphML (of networkx, of yEd) and in GML; networkx reads them.

The edges round each vertex follow from straight lines between positions, by
:func:`allworlds.maps.networks.from_positions`.  A position stands in ``pos`` (two numbers, or a
text of two), in ``x`` and ``y``, in ``graphics`` of GML, or in the boxes of yEd, of which the
middle is taken.  If each node has ``rotation``, a JSON list of its neighbours as in a rotation
(:mod:`~allworlds.notations.objects`), that is the order, and positions are not read.

Names are the labels, if each node has one of its own, else the ids.  Of directed edges both
directions must be there, which are one edge.  yEd calls every edge directed; there an edge leads
one way if it has an arrow at one end alone.
"""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Iterator
from typing import IO, TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

from allworlds.inputs.checks import InputError, parse_json, show
from allworlds.maps.networks import compared, from_positions, undirected
from allworlds.notations.entry import Entry, text_of
from allworlds.notations.objects import entry_of_rotation
from allworlds.world.labels import Labelling

if TYPE_CHECKING:
    import networkx as nx

PLAIN, YED = "{http://graphml.graphdrawing.org/xmlns}", "{http://www.yworks.com/xml/graphml}"
"""The namespaces of GraphML and of yEd."""


def read_graphml(file: IO[bytes]) -> Iterator[tuple[int, Entry]]:
    """The world of a file in GraphML."""
    import networkx as nx

    content = file.read()
    graph, root = _read(nx.read_graphml, content), ET.fromstring(content)  # noqa: S314  # networkx has read it
    edges = len(root.findall(f".//{PLAIN}edge"))
    if edges != graph.number_of_edges():
        read = graph.number_of_edges()
        raise InputError(f"{edges} edges, of which networkx reads {read}: ids must differ")
    yield 0, _entry(graph)


def read_yed(file: IO[bytes]) -> Iterator[tuple[int, Entry]]:
    """The world of a file of yEd."""
    import networkx as nx

    content = file.read()
    graph, root = _read(nx.read_graphml, content), ET.fromstring(content)  # noqa: S314  # networkx has read it
    for node in root.iter(f"{PLAIN}node"):
        if (box := node.find(f".//{YED}Geometry")) is not None:
            keys = ("x", "width"), ("y", "height")
            place = [float(box.get(a, "nan")) + float(box.get(b, "0")) / 2 for a, b in keys]
            graph.nodes[node.get("id")]["pos"] = place
    both = nx.MultiGraph()
    both.add_nodes_from(graph.nodes(data=True))
    for edge in root.iter(f"{PLAIN}edge"):
        ends = edge.get("source"), edge.get("target")
        arrows = edge.find(f".//{YED}Arrows")
        if arrows is not None and (arrows.get("source") == "none") != (
            arrows.get("target") == "none"
        ):
            v, w = (show(graph.nodes[end].get("label", end).strip()) for end in ends)
            raise InputError(f"the edge from {v} to {w} has an arrow at one end: it leads one way")
        both.add_edge(*ends)
    yield 0, _entry(both)


def read_gml(file: IO[bytes]) -> Iterator[tuple[int, Entry]]:
    """The world of a file in GML."""
    import networkx as nx

    content = text_of(file.read())
    yield 0, _entry(_read(lambda text: nx.parse_gml(text, label="id"), content))


def _read(read: Any, content: str | bytes) -> nx.Graph:
    """The graph that networkx reads."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return read(io.BytesIO(content) if isinstance(content, bytes) else content)
    except Exception as error:  # noqa: BLE001  # of many kinds, where a file is garbled
        raise InputError(f"networkx cannot read it: {show(str(error) or error)[1:-1]}") from None


def _entry(graph: nx.Graph) -> Entry:
    """The world of a graph whose nodes have positions, or rotations."""
    import networkx as nx

    labels = [" ".join(str(label).split()) for _, label in graph.nodes("label", "")]
    names = labels if all(labels) and len({*labels}) == len(labels) else [*map(str, graph)]
    graph = undirected(nx.relabel_nodes(graph, dict(zip(graph, names, strict=True))))
    if any("rotation" in data for _, data in graph.nodes(data=True)):
        texts = (str(graph.nodes[name].get("rotation", "[]")) for name in names)
        entry = entry_of_rotation(dict(zip(names, map(parse_json, texts), strict=True)))
        compared(entry.map, names, graph)
        return entry
    places = {name: _place(name, graph.nodes[name]) for name in names}
    map_ = from_positions(graph, places)
    return Entry(map_, Labelling("", tuple(names), tuple(places.values())))


def _place(name: str, data: dict[str, Any]) -> Any:
    """The two coordinates of a node, wherever they stand."""
    told = data.get("graphics", data)
    pos = data.get("pos") or [told.get("x"), told.get("y")]
    pos = re.split(r"[\s,]+", pos.strip("()[]! ")) if isinstance(pos, str) else pos
    try:
        return [float(each) for each in pos]
    except (TypeError, ValueError):
        ways = "pos, x and y, graphics [ x y ], or rotation"
        raise InputError(f"vertex {show(name)} is at {show(pos)}; legal are {ways}") from None
