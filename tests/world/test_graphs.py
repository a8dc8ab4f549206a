"""A graph that is read has each room and each passage of its file; others are refused."""

import io
from collections import Counter

import pytest
from hypothesis import given, settings, strategies as st

from allworlds.inputs.checks import InputError
from allworlds.notations.table import NOTATIONS

READ = {notation.name: notation.read for notation in NOTATIONS}

PLAIN = 'xmlns="http://graphml.graphdrawing.org/xmlns"'
YED = f'{PLAIN} xmlns:y="http://www.yworks.com/xml/graphml"'
KEYS = "".join(
    f'<key id="{name}" attr.name="{name}" attr.type="string" for="all"/>'
    for name in ("x", "y", "oneway", "osmid", "geometry", "d")
)


def numbers(notation, text):
    """The numbers of rooms and passages that are read."""
    ((_, entry),) = READ[notation](io.BytesIO(text.encode()))
    return entry.map.vertex_count, entry.map.edge_count


def file(*graphs, space=PLAIN):
    return f"<graphml {space}>{KEYS}{''.join(graphs)}</graphml>"


def graph(rooms, *passages, way="undirected"):
    return f'<graph edgedefault="{way}">{rooms}{"".join(passages)}</graph>'


def rooms(*names):
    """The nodes, on a parabola."""
    place = '<data key="x">{0}</data><data key="y">{1}</data>'
    each = (f'<node id="{name}">{place}</node>'.format(i, i * i) for i, name in enumerate(names))
    return "".join(each)


def passage(v, w, drawn="", name="", **data):
    told = "".join(f'<data key="{key}">{value}</data>' for key, value in data.items())
    own = f'id="{name}"' if name else ""
    return f'<edge {own} source="{v}" target="{w}">{told}{drawn}</edge>'


def boxes(*names):
    """The nodes of yEd, in a row, with the names as labels."""
    return "".join(
        f'<node id="n{i}"><data key="d"><y:ShapeNode><y:Geometry x="{i}" y="0"/>'
        f"<y:NodeLabel>{name}</y:NodeLabel></y:ShapeNode></data></node>"
        for i, name in enumerate(names)
    )


def in_yed(drawn, kind="PolyLineEdge"):
    """Two boxes of yEd, and an edge that is drawn so."""
    edge = passage("n0", "n1", f'<data key="d"><y:{kind}>{drawn}</y:{kind}></data>')
    return file(graph(boxes("hall", "bath"), edge, way="directed"), space=YED)


def there_and_back(there, back):
    return file(
        graph(
            rooms("a", "b"), passage("a", "b", **there), passage("b", "a", **back), way="directed"
        )
    )


def in_gml(*parts, ids=(0, 1)):
    nodes = "\n".join(f"node [ id {v} x {i} y {i * i} ]" for i, v in enumerate(ids))
    return f"graph [\n{nodes}\n{' '.join(parts)}\n]"


def door(v, w, more=""):
    return f"edge [ source {v} target {w} {more} ]"


def bent(*points):
    drawn = " ".join(f"point [ x {x} y {y} ]" for x, y in points)
    return door(0, 1, f"graphics [ Line [ {drawn} ] ]")


ONE = graph(rooms("a", "b"), passage("a", "b"))
YFILES = 'Creator "yFiles"\nVersion "2.18"\n'


def group(inside, kind="group"):
    """A floor of yEd, with what is in it; of kind ``folder`` it is closed."""
    label = "<y:GroupNode><y:Geometry x='0' y='0'/><y:NodeLabel>floor\n</y:NodeLabel></y:GroupNode>"
    return (
        f'<node id="g" yfiles.foldertype="{kind}"><data key="d"><y:ProxyAutoBoundsNode>'
        f"<y:Realizers>{label}</y:Realizers></y:ProxyAutoBoundsNode></data>{graph(inside)}</node>"
    )


GROUP = group("")
TWO_POINTS, ELSEWHERE = "LINESTRING (0 0, 1 1)", "LINESTRING (0 0, 5 5, 1 2)"


@pytest.mark.parametrize(
    ("notation", "text"),
    [
        ("graphml", file(ONE)),
        ("graphml", file(ONE, space="")),
        ("graphml", file(ONE, space='xmlns="http://graphml.graphdrawing.org/xmlns/1.0rc"')),
        ("graphml", file(graph(rooms("a", "b"), passage("a", "b", geometry=TWO_POINTS)))),
        ("graphml", there_and_back({"oneway": "False"}, {"oneway": "False"})),
        ("graphml", there_and_back({"name": "0", "osmid": "7"}, {"name": "0", "osmid": "7"})),
        ("yed", in_yed("")),
        ("yed", in_yed('<y:Path sx="0.0" sy="0.0" tx="0.0" ty="0.0"/>')),
        ("yed", in_yed('<y:Path/><y:Arrows source="none" target="none"/>', "SplineEdge")),
        ("yed", in_yed("").replace(YED, YED.removeprefix(PLAIN))),
        ("gml", in_gml(door(0, 1))),
        ("gml", in_gml(bent((0, 0), (1, 1)))),
        ("gml", in_gml(door(0, 1, 'name "edge [ ]"'), "# node [ id 7 ]\n")),
        ("gml", in_gml(door(0, 1), door(1, 0), "directed 1")),
        ("gml", in_gml(door(0, 1, "id 3"), door(1, 0, "id 3"), "directed 1")),
        ("gml", YFILES + in_gml(door(0, 1), "hierarchic 1 directed 1")),
        ("gml", YFILES + in_gml(door(0, 1, 'graphics [ arrow "both" ]'), "directed 1")),
        ("gml", in_gml(door(0, 1)).replace("edge", "node [ id 7 isGroup 1 gid 8 ] edge")),
        ("yed", file(graph(GROUP + boxes("hall", "bath"), passage("n0", "n1")), space=YED)),
        ("yed", file(graph(group(boxes("hall", "bath")), passage("n0", "n1")), space=YED)),
        (
            "yed",
            file(graph(group(boxes("hall", "bath"), "folder"), passage("n0", "n1")), space=YED),
        ),
        (
            "yed",
            file(graph(group(boxes("hall", "bath") + passage("n0", "n1"))), space=YED),
        ),
        ("graphml", file(graph('<node id="g"/>'.replace("/>", f">{ONE}</node>")))),
    ],
)
def test_two_rooms_and_a_passage_are_read(notation, text):
    assert numbers(notation, text) == (2, 1)


LEADS, OWN = "'a' to 'b' leads one way only", "edge from 'a' to 'b' and that back have keys or ids"
NOT_READ = "edge from 'hall' to 'bath' is drawn as an arc, or not from one end to the other"
ARROW = "has an arrow at one end: it leads one way"


@pytest.mark.parametrize(
    ("notation", "text", "why"),
    [
        ("graphml", file(ONE, ONE), "^2 graphs stand in it; legal is 1"),
        ("graphml", file(), "^0 graphs stand in it"),
        ("graphml", file(ONE.replace('id="b"', 'id="a"')), "^2 nodes have the id 'a'; each has"),
        ("graphml", file(graph(rooms("a", "b"), passage("a", "c"))), "ends at 'c', which is no no"),
        ("graphml", file(ONE.replace("</node>", f"{ONE}</node>", 1)), "2 nodes have the id 'a'"),
        (
            "yed",
            file(graph(group(boxes("hall")), passage("g", "n0")), space=YED),
            "the edge from 'floor' to 'hall' ends at 'floor', a group of nodes; legal is a node of",
        ),
        (
            "graphml",
            file(graph(f'<node id="g">{graph(rooms("a", "b"))}</node>', way="directed")),
            "edges are directed in one group, and undirected in another",
        ),
        ("graphml", file(f"<nodes>{rooms('c')}</nodes>", ONE), "^3 nodes and 1 edges, .* 2 and 1:"),
        ("graphml", there_and_back({"oneway": "True"}, {"oneway": "True"}), LEADS),
        ("graphml", there_and_back({"oneway": "True"}, {"oneway": "False"}), LEADS),
        ("graphml", there_and_back({"osmid": "1"}, {"osmid": "2"}), OWN),
        ("graphml", there_and_back({"name": "e"}, {"name": "f"}), OWN),
        (
            "graphml",
            file(graph(rooms("a", "b"), passage("a", "b", geometry=ELSEWHERE))),
            "the edge from 'a' to 'b' is drawn as an arc",
        ),
        ("yed", in_yed('<y:Path><y:Point x="0" y="nan"/></y:Path>'), NOT_READ),
        ("yed", in_yed('<y:Path tx="2.0"/>'), NOT_READ),
        ("yed", in_yed('<y:Path/><y:Arc height="30.0"/>', "ArcEdge"), NOT_READ),
        ("yed", in_yed('<y:Path/><y:Arrows target="standard"/>'), f"'hall' to 'bath' {ARROW}"),
        ("gml", YFILES + in_gml(door(0, 1, 'graphics [ targetArrow "delta" ]')), f"'1' {ARROW}"),
        ("gml", YFILES + in_gml(door(0, 1, 'graphics [ arrow "first" ]')), f"'0' to '1' {ARROW}"),
        ("gml", in_gml(door(0, 1), "directed 1"), "from '0' to '1' leads one way only"),
        (
            "gml",
            in_gml(bent((0, 0), (5, 5), (2, 1))),
            "edge from '0' to '1' is drawn as an arc, or",
        ),
        ("gml", in_gml(bent((0, 0))), "edge from '0' to '1' is drawn as an arc"),
        ("gml", in_gml(door(0, 1, 'geometry "POINT (0 0)"')), "'0' to '1' is drawn as an arc"),
        (
            "gml",
            in_gml(door(0, 1, 'geometry "LINESTRING (0 0, 1)"')),
            "'0' to '1' is drawn as an arc",
        ),
        (
            "gml",
            in_gml(door(0, 1, 'geometry "LINESTRING (0 0, 1 b)"')),
            "'0' to '1' is drawn as an arc",
        ),
        ("gml", in_gml(door(0, 1, "edgeAnchor [ xSource 0.5 ]")), "'0' to '1' is drawn as an arc"),
        (
            "gml",
            in_gml(door(0, 1, f'geometry "{ELSEWHERE}"')),
            "edge from '0' to '1' is drawn as an arc",
        ),
        (
            "gml",
            in_gml(door(0, 1)).replace("x 1", 'label "floor" isGroup 1'),
            "'floor', a group of",
        ),
        ("gml", in_gml(door(0, 1), ids=(0, 0)), "node id 0 is duplicated"),
        ("gml", in_gml(door(0, '"0"'), ids=(0, '"0"')), "2 nodes have the id '0'"),
        ("gml", in_gml(door(0, 2)), "undefined target 2"),
        ("gml", in_gml(door(0, 1)) * 2, "more than one graph"),
        ("gml", in_gml(door(0, 1), f"inner [ {door(0, 1)} ]"), "2 nodes and 2 edges, .* 2 and 1"),
        ("gml", in_gml(door(0, 1), '\n# 5" wide\n', door(0, 1), '\nname "a"'), "2 and 1: "),
        ("gml", in_gml(door(0, 1, "id 3"), door(1, 0, "id 4"), "directed 1"), "have keys or ids"),
        ("gml", in_gml(door(0, 1, "oneway 1"), door(1, 0, "oneway 1"), "directed 1"), "one way"),
    ],
)
def test_what_would_be_another_building_is_refused_with_the_reason(notation, text, why):
    with pytest.raises(InputError, match=why):
        numbers(notation, text)


IDS = {"none": lambda _i, _back: "", "own": lambda i, back: f"{i}{back}", "one": lambda i, _b: i}


@settings(deadline=None, max_examples=150)
@given(st.data())
def test_a_multigraph_is_read_with_all_its_rooms_and_passages_or_refused(data):
    n = data.draw(st.integers(2, 5))
    ends = st.tuples(*[st.integers(0, n - 1)] * 2)
    tree = [(i, data.draw(st.integers(0, i - 1))) for i in range(1, n)]
    joined = tree + data.draw(st.lists(ends, max_size=2))
    directed, name = data.draw(st.booleans()), IDS[data.draw(st.sampled_from([*IDS]))]
    each = [(v, w, name(i, "+")) for i, (v, w) in enumerate(joined, 1)]
    if directed:
        each += [(w, v, name(i, "-")) for i, (v, w) in enumerate(joined, 1)]
    each = data.draw(st.permutations(each))
    plain = Counter(frozenset(pair) for pair in joined)
    simple = all(len(pair) == 2 for pair in plain) and {*plain.values()} == {1}
    paired = not directed or name is not IDS["own"]
    notation = data.draw(st.sampled_from(["graphml", "gml"]))
    if notation == "gml":
        doors = [door(v, w, f'id "{own}"' if own else "") for v, w, own in each]
        flags = f"directed {int(directed)} multigraph {data.draw(st.integers(0, 1))}"
        text = in_gml(flags, *doors, ids=range(n))
    else:
        doors = [passage(v, w, name=own) for v, w, own in each]
        text = file(graph(rooms(*range(n)), *doors, way=directed * "directed" or "undirected"))
    try:
        found = numbers(notation, text)
    except InputError:
        assert not (simple and paired)
    else:
        assert found == (n, len(joined))
        assert paired


def ways(notation, text):
    """Of each room the rooms behind its doors, clockwise."""
    ((_, entry),) = READ[notation](io.BytesIO(text.encode()))
    map_, name = entry.map, entry.labels.vertex
    at = map_.vertex_of
    return {
        name(v): [name(at[map_.alpha[dart]]) for dart in darts]
        for v, darts in enumerate(map_.vertices)
    }


PLACES = {"hall": (0, 0), "up": (0, 100), "right": (100, 0), "down": (0, -100)}
ROUND = [(-50, 0), (-50, -200), (100, -200)]
"""Where the passage to the right leaves the hall to the left, and comes in from below."""


def drawn_in(notation, *passages, size=0):
    """The four rooms in a notation, and passages (from, to, points between the rooms)."""
    flip = -1 if notation in ("yed", "gml") else 1  # as they are read from a file, y is not turned
    places = {name: (x, flip * y) for name, (x, y) in PLACES.items()}
    doors = [(v, w, [(x, flip * y) for x, y in bends]) for v, w, bends in passages]
    if notation == "yed":
        nodes = "".join(
            f'<node id="{name}"><data key="d"><y:ImageNode><y:Geometry x="{x - size / 2}" '
            f'y="{y - size / 2}" width="{size}" height="{size}"/><y:NodeLabel/><y:NodeLabel>{name}'
            "<y:LabelModel/></y:NodeLabel></y:ImageNode></data></node>"
            for name, (x, y) in places.items()
        )
        lines = [
            (v, w, "".join(f'<y:Point x="{x}" y="{y}"/>' for x, y in bends))
            for v, w, bends in doors
        ]
        each = [
            passage(
                v, w, f'<data key="d"><y:GenericEdge><y:Path>{b}</y:Path></y:GenericEdge></data>'
            )
            for v, w, b in lines
        ]
        return file(graph(nodes, *each, way="directed"), space=YED)
    lines = [(v, w, [places[v], *bends, places[w]] if bends else []) for v, w, bends in doors]
    if notation == "gml":
        nodes = "\n".join(
            f'node [ id {i} label "{name}" graphics [ x {x} y {y} w {size} h {size} ] ]'
            for i, (name, (x, y)) in enumerate(places.items())
        )
        at = [*places].index
        each = [
            door(at(v), at(w), f"graphics [ Line [ {points_in_gml(line)} ] ]" if line else "")
            for v, w, line in lines
        ]
        return "graph [\n" + nodes + "\n".join(each) + "\n]"
    nodes = "".join(
        f'<node id="{name}"><data key="x">{x}</data><data key="y">{y}</data></node>'
        for name, (x, y) in places.items()
    )
    each = [
        passage(
            v, w, geometry=f"LINESTRING ({', '.join(f'{x} {y}' for x, y in line)})" if line else ""
        )
        for v, w, line in lines
    ]
    return file(graph(nodes, *each))


def points_in_gml(line):
    return " ".join(f"point [ x {x} y {y} ]" for x, y in line)


STAR = ("hall", "up", []), ("hall", "right", ROUND), ("hall", "down", [])
DRAWN = ["yed", "gml", "graphml"]


@pytest.mark.parametrize("notation", DRAWN)
def test_a_passage_with_bends_leaves_a_room_where_it_is_drawn(notation):
    against = -1 if notation in ("yed", "gml") else 1  # y is turned after the reader
    expected = ["up", "down", "right"]
    found = ways(notation, drawn_in(notation, *STAR))["hall"]
    assert found in turned(expected[::against])
    back = ("right", "hall", ROUND[::-1])
    assert ways(notation, drawn_in(notation, STAR[0], back, STAR[2]))["hall"] == found


def turned(around):
    return [around[i:] + around[:i] for i in range(len(around))]


@pytest.mark.parametrize("notation", DRAWN)
def test_loops_and_parallel_passages_are_told_apart_by_their_bends(notation):
    loop = "hall", "hall", [(50, 10), (10, 50)]
    found = ways(notation, drawn_in(notation, *STAR, loop, ("right", "hall", [(50, -20)])))
    assert sorted(found["hall"]) == ["down", "hall", "hall", "right", "right", "up"]
    around = found["hall"] if notation == "graphml" else found["hall"][::-1]
    assert around in turned(["up", "hall", "hall", "right", "down", "right"])


def test_a_passage_of_yed_leaves_a_box_where_it_crosses_its_side():
    beside = [(30, -90)]  # from the middle it crosses the side at 7, that of the door at 15
    text = drawn_in("yed", STAR[0], ("hall", "down", beside), ("hall", "right", []), size=40)
    door_, last = '<y:Path sx="15" sy="0"><y:Point x="15" y="90"/>', text.rindex("<y:Path>")
    moved = text[:last] + text[last:].replace("<y:Path>", door_)
    assert ways("yed", moved)["hall"] in turned(["down", "right", "up"])


def test_a_passage_that_is_drawn_apart_from_its_way_back_is_refused():
    line = "LINESTRING (0 0, {0} 5, 1 1)"
    alike = there_and_back({"geometry": line.format(3)}, {"geometry": "LINESTRING (1 1, 3 5, 0 0)"})
    assert numbers("graphml", alike) == (2, 1)
    apart = there_and_back({"geometry": line.format(3)}, {"geometry": line.format(4)})
    with pytest.raises(InputError, match="from 'a' to 'b' is drawn apart from that back"):
        numbers("graphml", apart)
