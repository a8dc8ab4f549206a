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


def bent(points):
    drawn = " ".join(f"point [ x {i} y 0 ]" for i in range(points))
    return door(0, 1, f"graphics [ Line [ {drawn} ] ]")


ONE = graph(rooms("a", "b"), passage("a", "b"))
GROUP = (
    '<node id="g"><data key="d"><y:GroupNode><y:Geometry x="0" y="0"/><y:NodeLabel>floor\n'
    f"</y:NodeLabel></y:GroupNode></data>{graph(boxes('hall'))}</node>"
)
TWO_POINTS, THREE_POINTS = "LINESTRING (0 0, 1 1)", "LINESTRING (0 0, 5 5, 1 1)"


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
        ("gml", in_gml(bent(2))),
        ("gml", in_gml(door(0, 1, 'name "edge [ ]"'), "# node [ id 7 ]\n")),
        ("gml", in_gml(door(0, 1), door(1, 0), "directed 1")),
        ("gml", in_gml(door(0, 1, "id 3"), door(1, 0, "id 3"), "directed 1")),
    ],
)
def test_two_rooms_and_a_passage_are_read(notation, text):
    assert numbers(notation, text) == (2, 1)


LEADS, OWN = "'a' to 'b' leads one way only", "edge from 'a' to 'b' and that back have keys or ids"
BEND = "edge from 'hall' to 'bath' has a bend"


@pytest.mark.parametrize(
    ("notation", "text", "why"),
    [
        ("graphml", file(ONE, ONE), "^2 graphs stand in it; legal is 1"),
        ("graphml", file(), "^0 graphs stand in it"),
        ("graphml", file(ONE.replace('id="b"', 'id="a"')), "^2 nodes have the id 'a'; each has"),
        ("graphml", file(graph(rooms("a", "b"), passage("a", "c"))), "ends at 'c', which is no no"),
        ("graphml", file(ONE.replace("</node>", f"{ONE}</node>", 1)), "node 'a' is a group of"),
        ("yed", file(graph(GROUP, way="directed"), space=YED), "node 'floor' is a group of nodes"),
        ("graphml", file(f"<nodes>{rooms('c')}</nodes>", ONE), "^3 nodes and 1 edges, .* 2 and 1:"),
        ("graphml", there_and_back({"oneway": "True"}, {"oneway": "True"}), LEADS),
        ("graphml", there_and_back({"oneway": "True"}, {"oneway": "False"}), LEADS),
        ("graphml", there_and_back({"osmid": "1"}, {"osmid": "2"}), OWN),
        ("graphml", there_and_back({"name": "e"}, {"name": "f"}), OWN),
        (
            "graphml",
            file(graph(rooms("a", "b"), passage("a", "b", geometry=THREE_POINTS))),
            "the edge from 'a' to 'b' has a bend",
        ),
        ("yed", in_yed('<y:Path><y:Point x="0" y="9"/></y:Path>'), BEND),
        ("yed", in_yed('<y:Path tx="2.0"/>'), BEND),
        ("yed", in_yed('<y:Path/><y:Arc height="30.0"/>', "ArcEdge"), BEND),
        ("gml", in_gml(bent(3)), "edge from '0' to '1' has a bend"),
        (
            "gml",
            in_gml(door(0, 1, f'geometry "{THREE_POINTS}"')),
            "edge from '0' to '1' has a bend",
        ),
        ("gml", in_gml(door(0, 1)).replace("x 1", 'label "floor" isGroup 1'), "'floor' is a group"),
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
