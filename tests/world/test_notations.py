"""Files of worlds: what is written is read back, what cannot be told or read is refused by name."""

import gc
import io
import json
import tracemalloc
from collections import Counter
from itertools import islice
from pathlib import Path

import networkx as nx
import pytest
from hypothesis import given, settings, strategies as st

from allworlds.inputs.checks import InputError
from allworlds.maps import (
    automorphisms,
    family,
    from_cycles,
    from_rotation,
    isomorphism,
    named_map,
    unrooted_code,
)
from allworlds.maps.combinatorial import rooted_code
from allworlds.notations.objects import own_of
from allworlds.notations.table import (
    EVERY,
    NOTATIONS,
    entries,
    entry_at,
    entry_named,
    notation_in,
    written,
)
from allworlds.world.labels import Labelling
from allworlds.world.world import Entry
from small import LOLLIPOP, TORUS, all_maps

PLANTRI = Path(__file__).parents[1] / "support" / "data" / "plantri"
by_name = {notation.name: notation for notation in NOTATIONS}.__getitem__
WRITTEN = [notation.name for notation in NOTATIONS if notation.write]
SIMPLE = {"planar_code", "sage"}
ALONE = {"edges"}

# Not its own mirror image: a triangle with two rooms behind one corner, and one behind the next.
PLAN = {"hall": ["study", "bath", "closet"], "study": ["hall", "porch", "bath"]}
PLAN |= {"bath": ["study", "hall"], "closet": ["hall", "loft"], "loft": ["closet"]}
PLAN |= {"porch": ["study"]}
NAMED = Entry(from_rotation(PLAN), Labelling("plan", tuple(PLAN)))


def file_of(tmp_path, notation, *worlds):
    path = tmp_path / f"worlds{by_name(notation).suffixes[0]}"
    path.write_bytes(b"".join(written(worlds, by_name(notation))))
    return path


def notation_of(path):
    with path.open("rb") as stream:
        return notation_in(stream, str(path))


def read(path, **options):
    return [entry for _, entry in entries(path, **options)]


def seen(entry):
    """All that a map with names is, in no numbering."""
    map_, name = entry.map, entry.labels.vertex
    darts = ((rooted_code(map_.sigma, map_.alpha, d), name(map_.vertex_of[d])) for d in map_.darts)
    return entry.labels.name, Counter(darts)


@pytest.mark.parametrize(
    ("file", "rooted"), [("tri4.pl", 1), ("tri5.pl", 3), ("tri6.pl", 13), ("edge5.ec", 3)]
)
def test_files_of_plantri_hold_every_triangulation(file, rooted):
    maps = [entry.map for entry in read(PLANTRI / file)]
    assert sum(2 * map_.edge_count // automorphisms(map_) for map_ in maps) == rooted
    assert all(len(face) == 3 for map_ in maps for face in map_.faces)


def test_a_file_of_plantri_holds_every_simple_planar_map_with_5_vertices():
    rooted = Counter()
    for entry in read(PLANTRI / "poly5.pl"):
        rooted[entry.map.edge_count] += 2 * entry.map.edge_count // automorphisms(entry.map)
    # Column 5 of "allworlds count --class planar-simple --vertices 5".
    assert rooted == {4: 14, 5: 56, 6: 80, 7: 56, 8: 20, 9: 3}


def test_edge_code_and_planar_code_of_plantri_tell_one_map():
    (one,), (other,) = read(PLANTRI / "tri5.pl"), read(PLANTRI / "edge5.ec")
    assert unrooted_code(one.map) == unrooted_code(other.map)


@pytest.mark.parametrize("notation", WRITTEN)
def test_every_small_map_is_read_back(notation, tmp_path):
    maps = [m for m in all_maps(3) if notation not in SIMPLE or (m.is_simple and m.is_planar)]
    worlds = [Entry(map_) for map_ in maps]
    if notation in ALONE:
        again = [read(file_of(tmp_path, notation, world))[0] for world in worlds]
    else:
        again = read(file_of(tmp_path, notation, *worlds))
    assert len(again) == len(worlds) > 0
    for world, other in zip(worlds, again, strict=True):
        assert unrooted_code(world.map) == unrooted_code(other.map)
        if not other.labels.vertices:
            assert world.labels == other.labels


@pytest.mark.parametrize("notation", ["worlds", "lines", "rotation", "sage", "edges"])
def test_names_are_kept(notation, tmp_path):
    (again,) = read(file_of(tmp_path, notation, NAMED))
    name = "plan" if "name" in by_name(notation).keeps else ""
    assert seen(again) == (name, seen(NAMED)[1])


def test_all_that_a_world_has_is_kept_in_json(tmp_path):
    labels = Labelling("plan", tuple(PLAN), tuple((float(i), -0.5 * i) for i in range(6)))
    world = Entry(NAMED.map, labels, 3, {"kind": "directional", "dart": 2})
    other = Entry(TORUS, Labelling("torus"))
    for notation in ("worlds", "lines"):
        assert read(file_of(tmp_path, notation, world)) == [world]
        assert read(file_of(tmp_path, notation, world, other)) == [world, other]
    assert {*own_of(world)} == {"sigma", "alpha", *EVERY}


@pytest.mark.parametrize(
    ("world", "notation", "why"),
    [
        (Entry(LOLLIPOP), "planar_code", "vertex v1 has a loop"),
        (Entry(LOLLIPOP), "sage", "vertex v1 has a loop"),
        (Entry(from_cycles(["ab", "ab"])), "sage", "vertex v0 has parallel edges"),
        (Entry(family("torus:3x3")), "planar_code", "maps of genus 0, not 1"),
    ],
)
def test_what_a_notation_cannot_tell_is_refused(world, notation, why):
    with pytest.raises(InputError, match=f"world 1 is not written: .*{why}"):
        list(written([world], by_name(notation)))


@pytest.mark.parametrize("notation", ["planar_code", "edge_code"])
@pytest.mark.parametrize("size", [127, 128, 255, 256, 258])
def test_numbers_of_two_bytes_are_read_back(notation, size, tmp_path):
    worlds = [Entry(family(f"cycle:{size}")), Entry(named_map("wheel-5"))]
    path = file_of(tmp_path, notation, *worlds)
    found = list(entries(path))
    for world, (offset, other) in zip(worlds, found, strict=True):
        assert other.map.vertex_count == world.map.vertex_count
        assert isomorphism(world.map, other.map)
        assert entry_at(path, offset) == other


def test_the_header_says_which_byte_is_first(tmp_path):
    little = file_of(tmp_path, "planar_code", Entry(family("cycle:300")))
    content = little.read_bytes()
    body = content[16:]
    swapped = b"".join(body[i : i + 2][::-1] for i in range(0, len(body), 2))
    for name, rest in (("le", body), ("be", swapped)):
        path = tmp_path / f"{name}.pl"
        path.write_bytes(b">>planar_code " + name.encode() + b"<<\0" + rest)
        (entry,) = read(path)
        assert entry.map.vertex_count == 300
    (tmp_path / "x").write_bytes(b">>planar_code xe<<\0" + body)
    with pytest.raises(InputError, match="the header is"):
        read(tmp_path / "x")


@pytest.mark.parametrize(
    ("suffix", "content", "why"),
    [
        ("pl", b"\2\2\2\0\1\1\0", "byte 0: vertex 1 lists 2 twice; edge_code tells loops and p"),
        ("pl", b"\1\1\1\0", "byte 0: vertex 1 lists 1 twice"),
        ("pl", b"\2\2\0\1\0\3\2\0\1\3\0\1\0", "byte 5: edge \\(2, 3\\) has 1 ends"),
        ("pl", b"\3\2\3\0\1\0\0", "byte 0: vertex 3 has an empty list"),
        ("pl", b"\4\2\0\1\0\4\0\3\0", "byte 0: vertex 3 cannot be reached from vertex 1"),
        ("pl", b"\2\2\0\1", "byte 0: the file ends in the middle of a world"),
        ("ec", b"\3\0\xff\0\3\0\xff\1", "byte 4: edge 0 has 1 ends"),
        ("ec", b"\0\x12\4\0\0\xff\0\0", "byte 0: 4 bytes are no list of numbers of 2 bytes"),
        ("ec", b"\0\x10\4\0\0\xff\0\0", "byte 0: its numbers of edges have 0 bytes; 1 to 15"),
        ("pl", b"", "there is no world in it"),
    ],
)
def test_codes_of_no_map_are_refused_by_their_byte(suffix, content, why, tmp_path):
    path = tmp_path / f"worlds.{suffix}"
    path.write_bytes(content)
    with pytest.raises(InputError, match=f"^file '.*worlds.{suffix}': .*{why}"):
        read(path)


def test_a_file_is_known_by_its_mark_its_suffix_or_its_beginning(tmp_path):
    content = {
        "planar_code": (PLANTRI / "tri4.pl").read_bytes(),
        "edge_code": (PLANTRI / "edge5.ec").read_bytes(),
        "worlds": b' {"a": ["b"], "b": ["a"]}',
    }
    for name, some in content.items():
        (tmp_path / "plain.txt").write_bytes(some)
        assert notation_of(tmp_path / "plain.txt").name == name
        assert len(read(tmp_path / "plain.txt")) == 1
    (tmp_path / "bare.pl").write_bytes(content["planar_code"][15:])
    assert read(tmp_path / "bare.pl") == read(PLANTRI / "tri4.pl")
    (tmp_path / "plain.txt").write_bytes(b"hall kitchen")
    with pytest.raises(InputError, match="no file of worlds by its name or beginning; legal are"):
        read(tmp_path / "plain.txt")


def test_two_worlds_in_a_table_are_refused():
    with pytest.raises(InputError, match="a file of edges holds one world; name one of another"):
        list(written([Entry(NAMED.map)] * 2, by_name("edges")))


def test_every_notation_is_told():
    page = (Path(__file__).parents[2] / "docs" / "verdicts.md").read_text(encoding="utf-8")
    for notation in NOTATIONS:
        assert f"`{notation.name}`" in page
        assert all(f"`{suffix}`" in page for suffix in notation.suffixes)


# ---------------------------------------------------------------- JSON, and Python's literals

CASES = {
    '{"a": ["b"], "b": ["a"]}': [""],
    '[{"a": ["b"], "b": ["a"]}, {"sigma": [0, 1], "alpha": [1, 0], "name": "own"}]': ["", "own"],
    '{"one": {"a": ["b"], "b": ["a"]}, "two": {"a": ["b"], "b": ["a"]}}': ["one", "two"],
    '{"one": {"vertices": [[0], [1]], "edges": [[0, 1]]}}': ["one"],
    '[{"vertices": [[0], [1]], "faces": [[0, 1]]}]': [""],
}


@pytest.mark.parametrize("text", CASES)
def test_json_holds_worlds_alone_in_lists_and_by_names(text, tmp_path):
    path = tmp_path / "worlds.json"
    path.write_text(text, encoding="utf-8-sig")
    found = read(path)
    assert [entry.labels.name for entry in found] == CASES[text]
    assert {entry.map.edge_count for entry in found} == {1}


def test_a_fat_graph_is_told_by_any_two_of_its_permutations(tmp_path):
    fat = {"vertices": [[0, 3, 1], [4], [2, 5, 6, 7]], "edges": [[0, 1], [2, 3], [4, 5], [6, 7]]}
    fat["faces"] = [[0, 3, 7, 5, 4, 2], [1], [6]]
    # surface_dynamics.FatGraph, whose cycles are anticlockwise.
    path = tmp_path / "fat.json"
    found = []
    for left in ("", *fat):
        path.write_text(json.dumps({key: fat[key] for key in fat if key != left}))
        found.append(read(path, order="anticlockwise")[0])
    codes = {rooted_code(each.map.sigma, each.map.alpha, 0) for each in found}
    assert len(codes) == 1
    assert sorted(map(len, found[0].map.faces)) == [1, 1, 6]
    path.write_text(json.dumps(fat | {"faces": [[0, 7, 3, 5, 4, 2], [1], [6]]}))
    with pytest.raises(InputError, match="in faces dart 0 is followed by 7; legal is by 3"):
        read(path)
    path.write_text(json.dumps(fat | {"edges": fat["edges"][:3]}))
    with pytest.raises(InputError, match="vertices and edges and faces do not have the same darts"):
        read(path)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ('{"hall": ["bath"], "bath": []}', "vertex 'bath' has an empty list"),
        ('{"hall": ["bath"], "bath": ["hall"], "attic": ["hall"]}', "'attic' lists 'hall', but"),
        ('{"a": ["b"], "b": ["a"], "c": ["d"], "d": ["c"]}', "vertex 'c' cannot be reached from"),
        ('{"hall": ["cellar"]}', "vertex 'hall' lists 'cellar'; the vertices are \\['hall'\\]"),
        ('{"hall": 3}', "vertex 'hall' must have a clockwise list, not 3"),
        ('{"a": ["b"], "a": ["b"]}', "the key 'a' stands twice"),
        ('{"sigma": [0, 1], "alpha": [1, 0], "nam": ""}', "'nam' is no key of a world"),
        ('{"sigma": [0, 1], "alpha": [1, 0], "names": ["a"]}', "names = \\['a'\\] is no list of 2"),
        (
            '{"sigma": [0, 1], "alpha": [1, 0], "names": ["a", "a"]}',
            "names\\[1\\] = 'a' is no printable text of its own",
        ),
        (
            '{"sigma": [0, 1], "alpha": [1, 0], "names": ["", "a"]}',
            "names\\[0\\] = '' is no printable",
        ),
        ('{"sigma": [0, 1], "alpha": [1, 0], "start": 2}', "start = 2 is no dart; darts are 0..1"),
        (
            '{"sigma": [0, 1], "alpha": [1, 0], "positions": [[0, 0], [0, NaN]]}',
            "positions\\[1\\]\\[1\\] = nan",
        ),
        (
            '{"vertices": [[0], [0]], "edges": [[0, 1]]}',
            "vertices: the darts \\[0, 0\\] are not 0..1",
        ),
        (
            '{"vertices": [[0], [1]], "edges": "(0 1)"}',
            "edges: '\\(0 1\\)': expected array",
        ),
        ("[]", "there is no world in it"),
        ("[3]", "a world is an object .*, not 3"),
        ('{"plan": {"a": ["b"]}}', "world 'plan': vertex 'a' lists 'b'"),
        ('{"schema": 2, "findings": []}', "a report or a finding"),
        ("{", "not JSON"),
    ],
)
def test_json_that_is_no_world_is_refused_by_its_place(text, why, tmp_path):
    path = tmp_path / "worlds.json"
    path.write_text(text)
    with pytest.raises(InputError, match=f"^file '.*worlds.json': .*{why}"):
        read(path)


PRINTED = {
    "FatGraph('(0,3,1)(4)(2,5,6,7)', '(0,1)(2,3)(4,5)(6,7)', '(0,3,7,5,4,2)(1)(6)')": 3,
    "FatGraph('(0,3,1)(4)(2,5,6,7)', '(0,3,7,5,4,2)(1)(6)')": 3,
    "FatGraph('(0,2,1,3)', '(0,1)(2,3)', '(0,2,1,3)')": 1,
}


def test_worlds_of_sage_may_stand_in_several_lines_and_be_printed_fat_graphs(tmp_path):
    path = tmp_path / "worlds.sage"
    plan = "{'a (old': ['b', 'c'],\n\n 'b': ['c', 'a (old'],\n 'c': ['a (old', 'b']}\n"
    path.write_text("\n".join([plan, *PRINTED, "  ", "{0: [1], 1: [0]}"]))
    worlds = read(path)
    assert [len(world.map.vertices) for world in worlds] == [3, *PRINTED.values(), 2]
    assert worlds[0].labels.vertices == ("a (old", "b", "c")
    assert worlds[1].map == worlds[2].map
    assert [entry_at(path, offset) for offset, _ in entries(path)] == worlds


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("{0: [1], 1: [0]}\n\n{0: [1], 1: [2]}", "line 3: vertex 0 lists 1, but 1 does"),
        ("{0: [1], 1: [0]}\n0: [1]", "line 2: '0: \\[1\\]' is no literal; legal is a dictionary"),
        ("{0: [1], 1: [0], 0: [1]}", "line 1: a key stands twice"),
        ("{0: [1], '0': [1], 1: [0, 0]}", "line 1: "),
        ("{0: [1],\n1: [0]}\n\n{0: [1],\n\n 1: [2]}", "line 4: vertex 0 lists 1, but 1 does"),
        ("{0: [1],\n1: [0]\n", "line 1: '{0: .* is no literal"),
        ("FatGraph('(0)(1)', '(0,1)', '(0)(1)')", "line 1: in faces dart 0 is followed by 0"),
        ("FatGraph('(0)(1)', '(0,)')", "line 1: .* is no literal; legal is .*, or FatGraph"),
    ],
)
def test_a_line_of_sage_is_refused_by_its_number(text, why, tmp_path):
    path = tmp_path / "worlds.sage"
    path.write_text(text)
    with pytest.raises(InputError, match=why):
        read(path)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "the header is ''; legal is from,to,from_rank,to_rank"),
        ("from,to,from_rank,to_rank\n", "there is no world|2m darts"),
        ("from,to,from_rank,to_rank\na,b,0\n", "line 2: 3 cells; the header has 4"),
        ("from,to,from_rank,to_rank\na,b,0,0\na,c,0,0\n", "line 3: two edges at vertex 'a' have"),
        ('from,to,from_rank,to_rank\na,b,0,0\n"a"c,b,1,1\n', "line 3: ',' expected after '\"'"),
        ("from,to,from_rank,to_rank\na,b,first,0\n", "line 2: rank 'first' is not a number"),
        ("from,to,from_rank,to_rank\na,b,0,0\nc,d,0,0\n", "'c' cannot be reached from"),
        ("from,to,from_rank,to_rank\n,b,0,0\n", "names\\[0\\] = '' is no printable"),
    ],
)
def test_a_table_of_edges_is_refused_by_its_line(text, why, tmp_path):
    path = tmp_path / "worlds.csv"
    path.write_text(text)
    with pytest.raises(InputError, match=why):
        read(path)


# ---------------------------------------------------------------- which way round


def test_an_order_against_the_clock_is_the_mirror_image(tmp_path):
    assert unrooted_code(NAMED.map) != unrooted_code(NAMED.map.mirrored())
    plan = Entry(NAMED.map, Labelling(vertices=NAMED.labels.vertices))
    path = file_of(tmp_path, "rotation", plan)
    (plain,), (turned,) = read(path), read(path, order="anticlockwise")
    assert plain == plan
    assert turned == Entry(NAMED.map.mirrored(), plan.labels)
    with pytest.raises(InputError, match="order 'left' is not one of clockwise, anticlockwise"):
        read(path, order="left")
    with pytest.raises(InputError, match="y down has no effect on rotation"):
        read(path, y="down")


# The plan on paper, with the y axis upward: the order of PLAN is clockwise.
PLACES = {"hall": (0, 0), "study": (0, 2), "bath": (2, 0), "closet": (-1, -1), "loft": (-2, -1)}
PLACES |= {"porch": (1, 3)}
DRAWN = nx.Graph((v, w) for v, ws in PLAN.items() for w in ws)


def yed(down=1, arrow="none"):
    """The plan as yEd saves it: boxes with their upper left corners, directed edges, labels."""
    ids = {name: f"n{i}" for i, name in enumerate(PLACES)}
    nodes = "".join(
        f'<node id="{ids[name]}"><data key="d0"><y:ShapeNode><y:Geometry height="{2 * i}" '
        f'width="{i}" x="{x - i / 2}" y="{-down * y - i}"/><y:NodeLabel>{name}\n</y:NodeLabel>'
        "</y:ShapeNode></data></node>"
        for i, (name, (x, y)) in enumerate(PLACES.items())
    )
    edges = "".join(
        f'<edge source="{ids[v]}" target="{ids[w]}"><data key="d1"><y:PolyLineEdge>'
        f'<y:Arrows source="none" target="{arrow if v == "hall" else "none"}"/>'
        "</y:PolyLineEdge></data></edge>"
        for v, w in DRAWN.edges()
    )
    return (
        '<?xml version="1.0" encoding="UTF-8"?><graphml '
        'xmlns="http://graphml.graphdrawing.org/xmlns" '
        'xmlns:y="http://www.yworks.com/xml/graphml">'
        '<key for="node" id="d0" yfiles.type="nodegraphics"/>'
        '<key for="edge" id="d1" yfiles.type="edgegraphics"/>'
        f'<graph edgedefault="directed" id="G">{nodes}{edges}</graph></graphml>'
    )


def graphml(graph=DRAWN, **attributes):
    graph = graph.copy()
    for name, values in attributes.items():
        nx.set_node_attributes(graph, values, name)
    return "\n".join(nx.generate_graphml(graph))


def gml(down=1):
    graph = DRAWN.copy()
    told = {name: {"x": float(x), "y": float(-down * y)} for name, (x, y) in PLACES.items()}
    nx.set_node_attributes(graph, told, "graphics")
    return "\n".join(nx.generate_gml(graph))


X, Y = ({name: float(place[i]) for name, place in PLACES.items()} for i in (0, 1))
TEXTS = {name: f"({x}, {y})" for name, (x, y) in PLACES.items()}


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("xy.graphml", graphml(x=X, y=Y)),
        ("pos.graphml", graphml(pos=TEXTS)),
        ("ways.graphml", graphml(DRAWN.to_directed(), pos=TEXTS)),
        ("yed.graphml", yed()),
        ("plan.gml", gml()),
    ],
)
def test_positions_of_a_plan_are_read_the_right_way_up(name, content, tmp_path):
    path = tmp_path / name
    path.write_text(content)
    (entry,) = read(path)
    assert seen(entry)[1] == seen(NAMED)[1]
    assert dict(zip(entry.labels.vertices, entry.labels.positions, strict=True)) == PLACES
    usual = notation_of(path).y
    assert usual == ("up" if notation_of(path).name == "graphml" else "down")
    (turned,) = read(path, y={"up": "down", "down": "up"}[usual])
    assert turned.map == entry.map.mirrored()
    assert turned.labels.positions == tuple((x, -y) for x, y in entry.labels.positions)
    with pytest.raises(InputError, match="order anticlockwise has no effect on positions; y up"):
        read(path, order="anticlockwise")


@pytest.mark.parametrize(
    ("name", "content", "why"),
    [
        ("a.graphml", graphml(), "vertex 'hall' is at \\[None, None\\]; legal are pos, x and y,"),
        ("a.graphml", graphml(pos={"hall": "here"}), "vertex 'hall' is at \\['here'\\]"),
        ("a.graphml", graphml(pos=TEXTS | {"hall": "2, 0"}), "'hall' and 'bath' are joined, but"),
        ("a.graphml", graphml(pos=TEXTS | {"bath": "0, 9"}), "'hall' to 'study' and to 'bath' le"),
        ("a.graphml", graphml(nx.DiGraph([("a", "b")]), x={"a": 0}), "from 'a' to 'b' leads one w"),
        ("a.graphml", yed(arrow="standard"), "from 'hall' to 'study' has an arrow at one end"),
        ("a.graphml", graphml(nx.Graph([("a", "b"), ("c", "d")]), pos=TEXTS), "'a' is at"),
        (
            "a.graphml",
            graphml(nx.Graph([("hall", "bath"), ("loft", "porch")]), pos=TEXTS),
            "vertex 'loft' cannot be reached from vertex 'hall'",
        ),
        (
            "a.graphml",
            graphml(pos=TEXTS).replace("<edge ", '<edge id="e" ').replace('"study"', '"hall"'),
            "2 nodes have the id 'hall'",
        ),
        ("a.graphml", "<graphml", "networkx cannot read it"),
        ("a.gml", "graph [ node [ id 0 ] ", "networkx cannot read it"),
        ("a.gml", "graph [ node [ id 0 ] edge [ source 0 target 0 ] ]", "vertex '0' is at"),
    ],
)
def test_a_graph_that_is_no_plan_is_refused_by_its_rooms(name, content, why, tmp_path):
    path = tmp_path / name
    path.write_text(content)
    with pytest.raises(InputError, match=f"^file .*{why}"):
        read(path)


def test_an_edge_that_networkx_drops_is_missed(tmp_path):
    path = tmp_path / "plan.graphml"
    twice = '<edge id="e" source="hall" target="bath"/>'
    path.write_text(graphml(pos=TEXTS).replace("</graph>", f"{twice}{twice}</graph>"))
    with pytest.raises(InputError, match="6 nodes and 8 edges, of which networkx reads 6 and 7"):
        read(path)


# ---------------------------------------------------------------- one of many


def test_a_world_is_found_by_its_name_or_number(tmp_path):
    worlds = [Entry(NAMED.map, Labelling(name)) for name in ("tower", "", "1", "barn", "", "gate")]
    path = file_of(tmp_path, "lines", *worlds)
    assert entry_named(path, "barn") == worlds[3]
    assert entry_named(path, "5") == worlds[4]
    assert entry_named(path, "1") == worlds[2]  # a name goes before a number
    first = "one of 'tower', '2', '1', 'barn', '5', \\.\\.\\.$"
    with pytest.raises(InputError, match=f"has more than one world; @FILE:NAME names {first}"):
        entry_named(path, "")
    with pytest.raises(InputError, match=f"has no world 'house'; @FILE:NAME names {first}"):
        entry_named(path, "house")
    assert entry_named(file_of(tmp_path, "sage", Entry(NAMED.map)), "").map == NAMED.map


def test_a_file_that_does_not_stream_is_read_once_until_it_changes(tmp_path, monkeypatch):
    path = file_of(tmp_path, "worlds", NAMED, Entry(TORUS))
    assert [entry_at(path, offset) for offset, _ in entries(path)] == read(path)
    path.write_bytes(b"".join(written([Entry(TORUS)], by_name("worlds"))))
    assert entry_at(path, 0) == Entry(TORUS)
    with pytest.raises(InputError, match="no world at 1 any more"):
        entry_at(path, 1)


STREAMS = [notation.name for notation in NOTATIONS if notation.streams]


def growth(notation, tmp_path, few, many, every=50):
    """The bytes that reading many worlds needs more than reading few, as a part of the file."""
    some = Entry(named_map("wheel-5"))
    path = tmp_path / f"worlds{by_name(notation).suffixes[0]}"
    peaks = []
    gc.collect()
    gc.freeze()
    for count in (few, few, many):
        with path.open("wb") as file:
            file.writelines(written((some for _ in range(count)), by_name(notation)))
        tracemalloc.start()
        for number, _ in enumerate(entries(path), 1):
            if number % every == 0:
                gc.collect()
        assert number == count
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    gc.unfreeze()
    return (peaks[2] - peaks[1]) / path.stat().st_size


# ---------------------------------------------------------------- garbled files


def valid(notation):
    """The content of a good file."""
    if notation in WRITTEN:
        return b"".join(written([NAMED], by_name(notation)))
    return GRAPHS[notation]


GRAPHS = {"graph6": nx.to_graph6_bytes(nx.path_graph(4))}
GRAPHS |= {"graphml": graphml(pos=TEXTS).encode(), "yed": yed().encode(), "gml": gml().encode()}


@pytest.mark.parametrize("notation", [*WRITTEN, *GRAPHS])
@settings(max_examples=25, deadline=None)
@given(data=st.data())
def test_a_garbled_file_is_read_or_refused_in_one_line(notation, data):
    content = valid(notation)
    place = data.draw(st.integers(0, len(content) - 1))
    byte = data.draw(st.none() | st.integers(0, 255))
    tried(notation, garbled(content, place, byte))


def garbled(content, place, byte):
    """The content up to a place, or with another byte there."""
    return content[:place] + (b"" if byte is None else bytes([byte]) + content[place + 1 :])


def tried(notation, content):
    """Read it; what is refused is refused in one line."""
    try:
        for _ in islice(by_name(notation).read(io.BytesIO(content)), 10):
            pass
    except InputError as error:
        refusal = str(error)
        assert len(refusal.splitlines()) == 1


def test_a_name_behind_those_that_a_refusal_lists_is_found(tmp_path, monkeypatch):
    monkeypatch.setattr("allworlds.notations.table.SHOWN", 1)
    path = file_of(tmp_path, "lines", *(Entry(NAMED.map) for _ in range(3)))
    assert entry_named(path, "3").map == NAMED.map
