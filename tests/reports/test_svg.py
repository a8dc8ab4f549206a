"""The pictures of maps, read back from the SVG."""

import re
from cmath import phase
from importlib import import_module
from itertools import combinations, pairwise
from math import pi
from xml.etree import ElementTree as ET

import pytest

from allworlds import worlds
from allworlds.maps import CombinatorialMap, family, named_map
from allworlds.reports.drawing.planar import planar
from allworlds.reports.drawing.svg import _clockwise, drawing, in_words, picture
from allworlds.reports.parts import Scene
from curves import flat, points

layouts = import_module("allworlds.reports.drawing.layout")
NS = "{http://www.w3.org/2000/svg}"
SMALL = [world.map for world in worlds(edges=3)]
FEW = [*SMALL[:12], *SMALL[12::5]]  # all with one or two edges, and some with three
NAMED = [named_map(name) for name in ("k4-torus", "theta-torus", "cube", "fig1-left")]
# One vertex and four loops, each opposite to itself: genus 2.
GENUS_2 = CombinatorialMap((1, 2, 3, 4, 5, 6, 7, 0), (4, 5, 6, 7, 0, 1, 2, 3))
MAPS = [*FEW, *NAMED, GENUS_2, family("random:12", holes=0, seed=1)]


def drawn(map_, **shown):
    return ET.fromstring(ET.tostring(picture(Scene(map_, 0, 0, **shown), "p", "a map")))


def stubs(svg):
    """For each dart the ends of its straight beginning."""
    found = {}
    for stub in svg.iter(f"{NS}path"):
        if stub.get("class") == "stub":
            dart = int(stub.get("data-stub"))
            assert dart not in found
            found[dart] = points(stub.get("d"))
    return found


def edges(svg):
    for path in svg.iter(f"{NS}path"):
        if "data-darts" in path.attrib:
            yield [int(dart) for dart in path.get("data-darts").split()], points(path.get("d"))


def clockwise(darts, beginnings):
    """The darts by growing angle; y grows downwards, so that is clockwise."""
    return sorted(darts, key=lambda d: phase(beginnings[d][1] - beginnings[d][0]))


@pytest.fixture
def plain(monkeypatch):
    """Every map is drawn in the plain way."""
    monkeypatch.setattr(layouts, "MOST_DARTS", 0)
    layouts.layout.cache_clear()
    yield
    layouts.layout.cache_clear()


def going_round_gives_sigma(map_):
    beginnings = stubs(drawn(map_))
    assert set(beginnings) == set(map_.darts)
    places = {beginnings[v[0]][0] for v in map_.vertices}
    assert len(places) == map_.vertex_count
    for vertex in map_.vertices:
        assert len({beginnings[dart][0] for dart in vertex}) == 1
        around = clockwise(vertex, beginnings)
        for dart, after in zip(around, [*around[1:], around[0]], strict=True):
            assert map_.sigma[dart] == after


def test_so_it_does_in_the_plain_way(plain):
    for map_ in MAPS:
        going_round_gives_sigma(map_)


def test_in_the_plain_way_the_darts_of_a_vertex_are_evenly_spread(plain):
    beginnings = stubs(drawn(GENUS_2))
    angles = sorted(phase(beginnings[dart][1] - beginnings[dart][0]) for dart in range(8))
    assert [b - a for a, b in pairwise(angles)] == pytest.approx([pi / 4] * 7, abs=0.02)


def test_a_map_is_drawn_with_care_up_to_a_number_of_darts(monkeypatch):
    map_ = named_map("cube")
    for most, plain in ((24, False), (23, True)):
        monkeypatch.setattr(layouts, "MOST_DARTS", most)
        layouts.layout.cache_clear()
        drawn_ = layouts.layout(map_, 0)
        assert ([*drawn_.ways[0]] == [*_on_a_circle(map_).ways[0]]) == plain
    layouts.layout.cache_clear()


@pytest.mark.parametrize(("most", "plain"), [(32, False), (31, True)])
def test_a_map_with_many_crossings_is_drawn_in_the_plain_way(most, plain, monkeypatch):
    """Four loops, each two of which cross: 8 darts, and 4 at each of the 6 crossings."""
    map_ = CombinatorialMap((1, 2, 3, 4, 5, 6, 7, 0), (4, 5, 6, 7, 0, 1, 2, 3))
    monkeypatch.setattr(layouts, "MOST_DARTS", most)
    for kept in (layouts.layout, layouts._ways):
        kept.cache_clear()
    drawn_ = layouts.layout(map_, 0)
    assert ([*drawn_.ways[0]] == [*_on_a_circle(map_).ways[0]]) == plain
    for kept in (layouts.layout, layouts._ways):
        kept.cache_clear()


def _on_a_circle(map_):
    return layouts._finished(map_, 0, layouts._round_a_circle(map_))


def test_another_cyclic_order_would_be_seen():
    beginnings = stubs(drawn(GENUS_2))
    beginnings[0], beginnings[1] = beginnings[1], beginnings[0]
    around = clockwise(range(8), beginnings)
    assert any(GENUS_2.sigma[a] != b for a, b in pairwise(around))


def meet(a, b, c, d):
    """The segments ab and cd cross."""

    def side(p, q, r):
        return ((q - p).conjugate() * (r - p)).imag

    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


def crossings(map_):
    curves = [flat(way) for _, way in edges(drawn(map_))]
    return sum(
        meet(a, b, c, d)
        for one, other in combinations(curves, 2)
        for a, b in pairwise(one)
        for c, d in pairwise(other)
    )


def test_planar_maps_are_drawn_without_crossings():
    flat_ones = [map_ for map_ in MAPS if map_.genus == 0]
    assert len(flat_ones) > 20
    assert [map_ for map_ in flat_ones if crossings(map_)] == []


@pytest.mark.parametrize("map_", [*NAMED, GENUS_2], ids=str)
def test_a_drawing_with_its_crossings_is_planar_and_keeps_sigma(map_):
    plane = planar(map_)
    assert CombinatorialMap(plane.sigma, plane.alpha).genus == 0
    assert plane.sigma[: plane.own] == map_.sigma
    for dart, other in map_.edges:
        assert plane.way(dart)[-1] == other
        assert plane.way(dart) == plane.way(other)[::-1]


def test_everything_drawn_lies_in_the_box():
    for map_ in MAPS:
        svg = drawn(map_)
        left, top, width, height = map(int, svg.get("viewBox").split())
        for _, way in edges(svg):
            for point in flat(way):
                assert left <= point.real <= left + width
                assert top <= point.imag <= top + height


def test_a_picture_has_a_name_and_words_for_those_who_do_not_see_it():
    map_ = named_map("theta-torus")
    svg = drawn(map_)
    named = {element.get("id"): element.text for element in svg}
    title, words = (named[name] for name in svg.get("aria-labelledby").split())
    assert (svg.get("role"), title, words) == ("img", "a map", in_words(Scene(map_, 0, 0)))
    for dart, other in enumerate(map_.alpha):
        assert f"{dart} to dart {other} of v{map_.vertex_of[other]}" in words


def moved(group):
    """Where the group's origin is put."""
    return points(group.get("transform"))[0]


def vertices(svg):
    """Each vertex's group, with what in it keeps its size, by its number."""
    for group in svg.iter(f"{NS}g"):
        if "data-vertex" in group.attrib:
            (fixed,) = group
            assert fixed.get("class") == "fixed"
            yield int(group.get("data-vertex")), group, fixed


def test_the_marker_points_along_its_dart():
    svg = drawn(named_map("k4"), pointed=[2], marks={0: 1, 1: 2})
    flags = [
        (vertex, path)
        for vertex, _, fixed in vertices(svg)
        for path in fixed.iter(f"{NS}path")
        if path.get("class") == "flag"
    ]
    ((vertex, flag),) = flags
    start, stub = stubs(svg)[2]
    assert vertex == 0
    assert abs(phase(points(flag.get("d"))[0] / (stub - start))) < 0.02
    marked = [(v, fixed) for v, group, fixed in vertices(svg) if "marked" in group.get("class")]
    assert [v for v, _ in marked] == [0, 1]
    assert [t.text for t in marked[1][1] if t.get("class") == "marks"] == [
        "\N{MULTIPLICATION SIGN}2"
    ]


@pytest.mark.parametrize("map_", MAPS, ids=str)
def test_a_darts_number_stands_beside_its_vertex_in_the_darts_direction(map_):
    svg = drawn(map_)
    beginnings, seen = stubs(svg), []
    for vertex, group, fixed in vertices(svg):
        for number in fixed.iter(f"{NS}g"):
            if "data-dart" in number.attrib:
                dart, at = int(number.get("data-dart")), moved(number)
                start, stub = beginnings[dart]
                assert map_.vertex_of[dart] == vertex
                assert abs(moved(group) - start) < 0.2
                assert 18 < abs(at) < 50
                assert abs(phase(at / (stub - start))) < 0.06
                seen.append(dart)
    assert sorted(seen) == list(map_.darts)


def test_numbers_round_a_vertex_do_not_touch():
    few = [map_ for map_ in MAPS if max(map(len, map_.vertices)) <= 8]
    assert len(few) > 20
    for map_ in few:
        for _, _, fixed in vertices(drawn(map_)):
            places = [moved(g) for g in fixed.iter(f"{NS}g") if "data-dart" in g.attrib]
            for a, b in combinations(places, 2):
                assert abs(a - b) >= 13


@pytest.mark.parametrize("last_bits", [1e-15, -1e-15, 1e-11, -1e-11])
def test_of_equal_gaps_the_same_has_the_arrow_whatever_the_last_bits_are(last_bits):
    left = complex(-1, last_bits), complex(-1, -last_bits)
    arrows = {ET.tostring(_clockwise([direction, 1 + 0j])) for direction in left}
    assert len(arrows) == 1


@pytest.mark.parametrize("map_", [*NAMED, GENUS_2, named_map("edge")], ids=str)
def test_an_arrow_at_every_vertex_turns_clockwise_between_two_darts(map_):
    svg = drawn(map_)
    for vertex, _, fixed in vertices(svg):
        (arrow,) = [g for g in fixed if g.get("class") == "clockwise"]
        arc, head = arrow
        numbers = [float(x) for x in re.findall(r"-?[0-9.]+", arc.get("d"))]
        start, end = complex(*numbers[:2]), complex(*numbers[-2:])
        # Clockwise: by a growing angle, for y grows downwards; and no dart lies between.
        turn = phase(end / start)
        assert 0 < turn < 2
        assert " 0 0 1 " in arc.get("d")
        for dart in map_.vertices[vertex]:
            a, b = stubs(svg)[dart]
            assert not 0 < phase((b - a) / start) < turn
        assert (points(head.get("d"))[0] / end).imag > 0


def test_the_lower_edge_leaves_a_gap_where_it_is_crossed():
    for map_ in [*NAMED, GENUS_2]:
        svg = drawn(map_)
        bridges = [path for path in svg.iter(f"{NS}path") if path.get("class") == "bridge"]
        # Each of two edges that cross has a gap made for it; that below is hidden by the other.
        assert 2 * len(bridges) == planar(map_).unbent - planar(map_).own
        curves = [flat(way) for _, way in edges(svg)]
        for bridge in bridges:
            at = sum(points(bridge.get("d"))) / 2
            near = sorted(min(abs(at - p) for p in curve) for curve in curves)
            assert near[0] < 12


@pytest.mark.parametrize("name", ["loop", "two-loops-plane", "bouquet-3"])
def test_loops_have_round_ends(name):
    for _, way in edges(drawn(named_map(name))):
        curve = flat(way)
        length = sum(abs(b - a) for a, b in pairwise(curve))
        area = abs(sum((a.conjugate() * b).imag for a, b in pairwise(curve))) / 2
        # That of a circle is 1, of a square 0.79, and of a triangle at most 0.6.
        assert 4 * pi * area / length**2 > 0.8


def test_the_longest_face_lies_outside_whatever_bends_its_loops_have():
    # An edge to a vertex with two loops, one in the other: its end lies in the face of 4 darts.
    map_ = CombinatorialMap((0, 2, 3, 4, 5, 1), (1, 0, 5, 4, 3, 2))
    ways = [*edges(drawn(map_))]
    leaf = ways[0][1][0]
    assert all(leaf.real <= point.real for _, way in ways for point in flat(way))


def test_letters_names_and_a_ring_are_drawn_and_told():
    map_ = named_map("edge")
    names = {"darts": ("x", "y"), "vertices": ("here", "there")}
    scene = Scene(map_, 0, 0, labels=("a", "b"), ringed=1, **names)
    svg = ET.fromstring(ET.tostring(picture(scene, "p", "a map")))
    texts = ["".join(text.itertext()) for text in svg.iter(f"{NS}text")]
    assert sorted(texts) == ["here", "there", "xa", "yb"]
    rings = [g for g in svg.iter(f"{NS}g") for c in g if c.get("class") == "ring"]
    assert [g.get("data-dart") for g in rings] == ["1"]
    colours = {g.get("data-dart"): g.get("class") for g in svg.iter(f"{NS}g") if g.get("data-dart")}
    assert colours == {"0": "dart start class-0 here", "1": "dart class-1"}
    assert "Clockwise round there its darts lead: y to dart x of here." in in_words(scene)
    assert "Ringed is dart y." in in_words(scene)
    assert "x a, y b" in in_words(scene)


def test_by_itself_a_picture_has_its_style_before_all_that_is_drawn():
    root = ET.fromstring(drawing(Scene(named_map("theta-torus"), 0, 0), "a map").svg)
    assert [element.tag.rpartition("}")[2] for element in root[:3]] == ["title", "desc", "style"]
