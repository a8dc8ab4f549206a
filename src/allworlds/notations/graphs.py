"""Graphs in GraphML (of networkx, of yEd), GML and graph6; networkx reads them.

The order of the edges round each vertex follows from a drawing of the graph, by
:func:`allworlds.maps.networks.from_directions`.  In the drawing each edge is a straight line
between the positions of its ends, or a line with bends.  A position is read from ``pos`` (two
numbers, or a text of two), from ``x`` and ``y``, from ``graphics`` in GML, or as the middle of a
box in yEd.  The points of a line with bends are read from yEd's ``Path``, from ``Line`` in GML, or
from ``geometry``.

An edge leaves a vertex in the direction from the middle of the vertex's box to the point where the
edge's line crosses the side of the box.  If the file has no box for a vertex, the line begins at
the vertex's position, and its direction there is that of its first piece.

Arcs and other curves are refused.  A file is also refused if networkx reads another number of nodes
or edges than the file holds.  A graph without positions has no order of its edges; a search of all
embeddings takes such graphs from :func:`named_graph`.

The names of the vertices are the labels of the nodes if all nodes have different labels, otherwise
the ids of the nodes.  The nodes in a group are vertices; the group itself is ignored.

A directed edge needs the reverse edge, too; the two become one edge, and are refused if they have
different ids.  Files of yEd have another rule, since yEd calls all edges directed: an edge with an
arrow at exactly one end is refused, even if the reverse edge is there; any other edge counts as
undirected.
"""

from __future__ import annotations

import io
import re
import warnings
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from typing import IO, TYPE_CHECKING, Any, TypeAlias
from xml.etree import ElementTree as ET

from allworlds.inputs.checks import InputError, show
from allworlds.maps.networks import from_directions, turn, undirected
from allworlds.notations.entry import text_of
from allworlds.world.labels import Labelling
from allworlds.world.world import Entry

if TYPE_CHECKING:
    import networkx as nx

PLAIN, YED = "{http://graphml.graphdrawing.org/xmlns}", "{http://www.yworks.com/xml/graphml}"
"""The XML namespaces of GraphML and of yEd, in the form ``{...}``."""

Point: TypeAlias = tuple[Fraction, Fraction]

Box: TypeAlias = tuple[Point, Point]
"""The middle of the box in which a node is drawn, and half the width and height of the box."""


def read_graph(
    make: Callable[[bytes], nx.Graph],
) -> Callable[[IO[bytes]], Iterator[tuple[int, Entry]]]:
    """The function that reads a file, and yields one pair: the number 0, and the only world.

    ``make`` makes the graph from the content of the file.
    """

    def read(file: IO[bytes]) -> Iterator[tuple[int, Entry]]:
        yield 0, _entry(named_graph(make, file.read()))

    return read


def named_graph(make: Callable[[bytes], nx.Graph], content: bytes) -> nx.Graph:
    """The graph that ``make`` makes from ``content``, the content of a file.

    The nodes of the result are the names of the vertices.

    Raises:
        InputError: if the content is no graph.
    """
    import networkx as nx

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            graph = make(content)
    except InputError:
        raise
    except Exception as error:  # noqa: BLE001  # networkx has many kinds, where a file is garbled
        said = show(str(error) or error)[1:-1]
        raise InputError(f"networkx cannot read it: {said}") from None
    labels = [_label(data) for _, data in graph.nodes(data=True)]
    names = labels if all(labels) and len({*labels}) == len(labels) else [*map(str, graph)]
    return nx.relabel_nodes(graph, dict(zip(graph, names, strict=True)))


def of_graph6(content: bytes) -> nx.Graph:
    """The only graph of a text in graph6; such a graph has edges but no positions."""
    import networkx as nx

    lines = content.removeprefix(b">>graph6<<").split()
    if len(lines) != 1:
        raise InputError(f"{len(lines)} graphs stand in it; legal is 1")
    return nx.from_graph6_bytes(lines[0])


def of_gml(content: bytes) -> nx.Graph:
    """The graph of a text in GML."""
    import networkx as nx

    text = text_of(content)
    of_yed = re.search(r'^\s*Creator\s+"(yFiles|yEd)', text, re.MULTILINE)
    flags = r"\b(?:multigraph|directed)\s+[01]" if of_yed else r"\bmultigraph\s+[01]"
    plain = re.sub(rf'("[^"]*"|#.*)|{flags}', lambda found: found[1] or "", text)
    graph = nx.parse_gml(re.sub(r"\bgraph\s*\[", "graph [ multigraph 1", plain, count=1), "id")
    _ensure_differ(map(str, graph))
    parts = re.findall(r"\b(node|edge)\s*\[", re.sub(r'"[^"]*"|#.*', "", text))
    _ensure_whole(graph, parts.count("node"), parts.count("edge"))
    names = {node: show(_label(data) or str(node)) for node, data in graph.nodes(data=True)}
    groups = {node for node, data in graph.nodes(data=True) if data.get("isGroup")}
    for v, w, data in graph.edges(data=True):
        _ensure_rooms(v, w, groups, names)
        drawn = data.get("graphics")
        drawn = drawn if isinstance(drawn, dict) else {}
        arrow = ARROWS.get(str(drawn.get("arrow")), ("none", "none"))
        heads = (drawn.get(f"{end}Arrow", arrow[i]) for i, end in enumerate(("source", "target")))
        if of_yed:
            _ensure_both_ways(names[v], names[w], heads)
        if any((data.get("edgeAnchor") or {}).values()) and "Line" not in drawn:
            raise _not_read(f"from {names[v]} to {names[w]}")
    graph.remove_nodes_from(groups)
    return graph


ARROWS = {"first": ("first", "none"), "last": ("none", "last"), "both": ("first", "last")}
"""For each word in GML about the arrow of an edge, the arrowheads at both ends."""


def of_graphml(content: bytes) -> nx.Graph:
    """The graph of a text in GraphML."""
    _, graph = _root_and_graph(content)
    return graph


def of_yed(content: bytes) -> nx.Graph:
    """The graph of a file of yEd."""
    import networkx as nx

    root, read = _root_and_graph(content)
    graph = nx.MultiGraph()
    for node in root.iter(f"{PLAIN}node"):
        name = node.get("id")
        attributes = {**read.nodes[name], "label": _label_in_yed(node)}
        if (box := node.find(f".//{YED}Geometry")) is not None:
            attributes["graphics"] = _box_in_yed(box)
        graph.add_node(name, **attributes)
    for edge in root.iter(f"{PLAIN}edge"):
        ends = edge.get("source"), edge.get("target")
        v, w = (show(_label(graph.nodes[end]) or end) for end in ends)
        arrows = edge.find(f".//{YED}Arrows")
        heads = ("none" if arrows is None else arrows.get(end) for end in ("source", "target"))
        _ensure_both_ways(v, w, heads)
        if any(float(arc.get("height", "0")) for arc in edge.iter(f"{YED}Arc")):
            raise _not_read(f"from {v} to {w}")
        boxes = (graph.nodes[end].get("graphics") for end in ends)
        graph.add_edge(*ends, graphics=_line_in_yed(edge, *boxes))
    return graph


def _box_in_yed(box: ET.Element) -> dict[str, float]:
    """The box of a node in the form that GML has: the middle, the width and the height.

    A file of yEd has the upper left corner of the box instead of its middle.
    """
    x, y = (float(box.get(key, "nan")) for key in "xy")
    width, height = (float(box.get(key, "0")) for key in ("width", "height"))
    return {"x": x + width / 2, "y": y + height / 2, "w": width, "h": height}


def _line_in_yed(edge: ET.Element, source: Any, target: Any) -> dict[str, Any]:
    """The points of an edge's line, both ends included, in the form that GML has.

    ``source`` and ``target`` are the boxes of the nodes at the ends, as :func:`_box_in_yed` returns
    them, or None.  The result is empty in three cases: ``edge`` has no element ``Path``; one of the
    nodes has no box; or the line goes straight from the middle of one box to that of the other.
    """
    path = edge.find(f".//{YED}Path")
    if path is None or not (source and target):
        return {}
    shifts = {key: float(path.get(key, "0")) for key in ("sx", "sy", "tx", "ty")}
    bends = [{axis: bend.get(axis) for axis in "xy"} for bend in path]
    if not bends and not any(shifts.values()):
        return {}
    begin = {axis: source[axis] + shifts[f"s{axis}"] for axis in "xy"}
    end = {axis: target[axis] + shifts[f"t{axis}"] for axis in "xy"}
    return {"Line": {"point": [begin, *bends, end]}}


def _label_in_yed(node: ET.Element) -> str:
    """The first label of ``node`` that is not blank; empty if the node has none.

    The node can have any of yEd's shapes.
    """
    texts = (label.text or "" for label in node.iterfind(f"{PLAIN}data//{YED}NodeLabel"))
    return next(filter(None, map(str.strip, texts)), "")


def _root_and_graph(content: bytes) -> tuple[ET.Element, nx.Graph]:
    """The root element of a text in GraphML, and the graph in the text.

    All elements are moved to the usual XML namespace.  The nodes in a group belong to the graph;
    the group itself does not.

    Raises:
        InputError: if the text does not have exactly one graph, if an edge ends at a group or at no
            node, or if the graph would lack a node or an edge of the text.
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
    ids = [node.get("id") for node in nodes]
    _ensure_differ(ids)
    groups = {node.get("id") for node in nodes if _is_group(node)}
    names = {node.get("id"): show(_label_in_yed(node) or node.get("id")) for node in nodes}
    for edge in edges:
        _ensure_rooms(edge.get("source"), edge.get("target"), groups, names)
    _take_out_of_groups(root, groups)
    graph = nx.read_graphml(io.BytesIO(ET.tostring(root)))
    for end in set(graph).difference(ids):
        raise InputError(f"an edge ends at {show(end)}, which is no node")
    _ensure_whole(graph, len(nodes) - len(groups), len(edges))
    return root, graph


def _is_group(node: ET.Element) -> bool:
    return "yfiles.foldertype" in node.keys() or node.find(f"{PLAIN}graph") is not None  # noqa: SIM118  # no mapping


def _take_out_of_groups(root: ET.Element, groups: set[str | None]) -> None:
    """Move the contents of all groups of nodes to the graph itself, and remove the groups.

    ``root`` is the root element of the text, ``groups`` holds the ids of the groups.

    Raises:
        InputError: if edges are directed in one group, and undirected in another.
    """
    graph = root.find(f"{PLAIN}graph")
    assert graph is not None
    if len({each.get("edgedefault") for each in root.iter(f"{PLAIN}graph")}) > 1:
        raise InputError("edges are directed in one group, and undirected in another")
    nodes, edges = ([*graph.iter(PLAIN + what)] for what in ("node", "edge"))
    for each in [*graph]:
        if each.tag in (f"{PLAIN}node", f"{PLAIN}edge"):
            graph.remove(each)
    graph.extend(node for node in nodes if node.get("id") not in groups)
    graph.extend(edges)


def _ensure_rooms(v: object, w: object, groups: set[Any], names: dict[Any, str]) -> None:
    """Refuse the edge from ``v`` to ``w`` if one of these two ids is the id of a group.

    ``groups`` holds the ids of the groups; ``names`` has, for each id, the name in the message.
    """
    for end in groups.intersection((v, w)):
        raise InputError(
            f"the edge from {names.get(v, v)} to {names.get(w, w)} ends at {names[end]}, a group "
            "of nodes; legal is a node of it: open the group, or ungroup it"
        )


def _ensure_both_ways(v: str, w: str, heads: Iterable[str | None]) -> None:
    """Refuse the edge from ``v`` to ``w`` if it has an arrow at exactly one end.

    ``v`` and ``w`` are the names in the message.  ``heads`` holds a word for each end of the edge:
    the shape of the arrowhead; ``none``, None or an empty text means that there is no arrow.
    """
    if [head or "none" for head in heads].count("none") == 1:
        raise InputError(f"the edge from {v} to {w} has an arrow at one end: it leads one way")


def _not_read(ends: str) -> InputError:
    how = "is drawn as an arc, or not from one end to the other; legal are straight lines and bends"
    return InputError(f"the edge {ends} {how}")


def _ensure_differ(ids: Iterable[object]) -> None:
    """Raise InputError if two nodes have the same id; ``ids`` holds the ids of all nodes."""
    for each, number in Counter(ids).items():
        if number > 1:
            raise InputError(f"{number} nodes have the id {show(each)}; each has one of its own")


def _ensure_whole(graph: nx.Graph, nodes: int, edges: int) -> None:
    """Refuse ``graph``, which networkx has read, if it lacks nodes or edges of its text.

    ``nodes`` and ``edges`` are the numbers of nodes and of edges in the text.
    """
    n, m = graph.number_of_nodes(), graph.number_of_edges()
    if (n, m) != (nodes, edges):
        read = f"{nodes} nodes and {edges} edges, of which networkx reads {n} and {m}"
        raise InputError(f"{read}: one has the id of another, is nested, or follows a lone '\"'")


def _label(data: dict[str, Any]) -> str:
    """The label of a node with the attributes ``data``; empty for a node without a label."""
    return " ".join(str(data.get("label") or "").split())


# ---------------------------------------------------------------- drawings


def _entry(graph: nx.Graph) -> Entry:
    """The world of a graph with positions; the drawing gives the order of the edges."""
    names = [*graph]
    lines = {
        (v, w, *key): _line(f"from {show(v)} to {show(w)}", graph.edges[v, w, *key])
        for v, w, *key in graph.edges
    }
    for (v, w, *key), line in lines.items() if graph.is_directed() else ():
        if lines.get((w, v, *key), line) not in (line, line[::-1]):
            raise InputError(f"the edge from {show(v)} to {show(w)} is drawn apart from that back")
    graph = undirected(graph)
    boxes = {name: _box(name, graph.nodes[name]) for name in names}
    edges = [*graph.edges]
    drawn = (lines.get((v, w, *key)) or lines.get((w, v, *key), []) for v, w, *key in edges)
    passages = [_ends(v, w, line, boxes) for (v, w, *_), line in zip(edges, drawn, strict=True)]
    map_ = from_directions(graph, passages)
    places = tuple((float(x), float(y)) for (x, y), _ in boxes.values())
    return Entry(map_, Labelling("", tuple(names), places))


def _box(name: str, data: dict[str, Any]) -> Box:
    """The box of a node: the middle, and half the width and height.

    The middle is read from the attribute ``pos``, from ``x`` and ``y``, or from ``graphics``.  The
    width and height are read from ``graphics``, and are 0 without it.  ``data`` holds the
    attributes of the node; ``name`` names the node in messages.
    """
    graphics = data.get("graphics")
    drawn = graphics if isinstance(graphics, dict) else data
    pos = data.get("pos") or [drawn.get("x"), drawn.get("y")]
    pos = re.split(r"[\s,]+", pos.strip("()[]! ")) if isinstance(pos, str) else pos
    size = [drawn.get(key, 0) if drawn is graphics else 0 for key in "wh"]
    try:
        width, height = _point(size)
        return _point(pos), (width / 2, height / 2)
    except (TypeError, ValueError):
        ways = "pos, x and y, or graphics [ x y ]; --graph FILE takes edges alone"
        raise InputError(f"vertex {show(name)} is at {show(pos)}; legal are {ways}") from None


def _point(given: Iterable[Any]) -> Point:
    """The point whose coordinates are the first two numbers in ``given``, as exact fractions.

    A float counts as the decimal number that Python prints for the float: 0.1 becomes 1/10.  If
    there are fewer than two values, or one of them is no number, TypeError or ValueError is raised.
    """
    x, y, *_ = (Fraction(str(each)) for each in given)
    return x, y


def _line(ends: str, data: dict[str, Any]) -> list[Point]:
    """The points of the line of an edge, both ends included; empty for a straight line.

    The points are read from ``Line`` of GML, or from ``geometry`` of OSMnx, in ``data``, the
    attributes of the edge.  ``ends`` names the edge in messages.
    """
    graphics = data.get("graphics")
    try:
        if isinstance(graphics, dict) and "Line" in graphics:
            return [_point((point["x"], point["y"])) for point in graphics["Line"]["point"]]
        if geometry := str(data.get("geometry") or ""):
            found = re.fullmatch(r"LINESTRING(?: Z)? ?\((.*)\)", geometry.strip())
            if not found:
                raise _not_read(ends)
            return [_point(point.split()) for point in found[1].split(",")]
    except (TypeError, ValueError, KeyError):  # InputError is a ValueError
        raise _not_read(ends) from None
    return []


def _ends(v: str, w: str, line: list[Point], boxes: Mapping[str, Box]) -> Any:
    """For each end of the edge from ``v`` to ``w`` the vertex, and the direction of the edge there.

    A direction is a number from 0 on and below 4, as :func:`allworlds.maps.networks.turn` returns
    it: clockwise, 0 is up, 1 right, 2 down, 3 left.

    Args:
        v: the name of the vertex at one end.
        w: the name of the vertex at the other end.
        line: the points of the edge's line, from either end; empty for a straight line.
        boxes: the box of each vertex, by its name.
    """
    if v == w and not line:
        raise InputError(f"the edge from {show(v)} to {show(v)} is a loop that is drawn as a point")
    path = line or [boxes[v][0], boxes[w][0]]
    lengths = (max(each) - min(each) for each in zip(*path, strict=True))
    slack = sum(lengths) / 1_000_000
    if not _joins(path, boxes[v], boxes[w], slack):
        path = path[::-1]  # an edge without a direction is listed from any of its ends
    if not _joins(path, boxes[v], boxes[w], slack):
        raise _not_read(f"from {show(v)} to {show(w)}")
    out, back = _leaves(path, *boxes[v], slack), _leaves(path[::-1], *boxes[w], slack)
    return (v, turn(v, w, boxes[v][0], out)), (w, turn(w, v, boxes[w][0], back))


def _joins(path: list[Point], one: Box, other: Box, slack: Fraction) -> bool:
    """Whether the line ``path`` begins in the box ``one`` and ends in the box ``other``.

    A point counts as inside a box if it is at most ``slack`` outside of it.
    """
    return _inside(path[0], *one, slack) and _inside(path[-1], *other, slack)


def _inside(point: Point, middle: Point, half: Point, slack: Fraction) -> bool:
    sides = zip(point, middle, half, strict=True)
    return all(abs(a - b) <= side + slack for a, b, side in sides)


def _leaves(path: list[Point], middle: Point, half: Point, slack: Fraction) -> Point:
    """The point of the drawing that determines the direction in which a line leaves a box.

    The direction is that from the middle of the box to the result.  In general the result is the
    point where the line crosses the side of the box.  In three cases the result is simpler.  First:
    the last point of ``path`` in the box is the middle of the box, so the line goes straight from
    the middle to the next point; then this next point is the result.  Second: the box has no width
    or no height; then the result is the first point of ``path`` outside the box.  Third: no point
    of ``path`` is outside the box; then the result is the last point.

    Args:
        path: the points of the line, beginning in the box.
        middle: the middle of the box.
        half: half the width and half the height of the box.
        slack: a tolerance: a point that is at most so far outside the box counts as inside.
    """
    before, after = middle, path[-1]
    for point in path:
        if not _inside(point, middle, half, slack):
            after = point
            break
        before = point
    if before in (middle, after) or not all(half):
        return after
    step = [b - a for a, b in zip(before, after, strict=True)]
    sides = zip(before, step, middle, half, strict=True)
    part = min((m + (h if d > 0 else -h) - a) / d for a, d, m, h in sides if d)
    x, y = (a + part * d for a, d in zip(before, step, strict=True))
    return x, y
