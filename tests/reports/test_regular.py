"""Pictures of lattices, tori, wheels, stars, rings and paths, read back from the SVG."""

from cmath import phase
from itertools import pairwise, product
from math import tau
from xml.etree import ElementTree as ET

import pytest

from allworlds import run
from allworlds.maps import CombinatorialMap, family, from_rotation, named_map, rooted_maps
from allworlds.reports.content.single_run import known
from allworlds.reports.drawing.layout import layout, layout_like
from allworlds.reports.drawing.regular import lattice, wheel
from allworlds.reports.drawing.svg import picture
from allworlds.reports.formats import file_of
from allworlds.reports.parts import Scene
from allworlds.world import Directional, World
from curves import crossings, flat, points
from html_tree import read

NS = "{http://www.w3.org/2000/svg}"


def renamed(map_):
    """Return the map with other names of its darts, which say nothing of its form."""
    size = len(map_.sigma)
    names = [(size - 1 - 3 * d) % size if size % 3 else size - 1 - d for d in range(size)]
    return map_.relabelled(names)


class Seen:
    """A picture, read back."""

    def __init__(self, map_, start=0):
        self.map = map_
        self.svg = ET.fromstring(ET.tostring(picture(Scene(map_, start), "p", "a map")))
        self.spots = {
            int(group.get("data-vertex")): points(group.get("transform"))[0]
            for group in self.svg.iter(f"{NS}g")
            if "data-vertex" in group.attrib
        }
        self.edges = [
            ([*map(int, path.get("data-darts").split())], points(path.get("d")))
            for path in self.svg.iter(f"{NS}path")
            if "data-darts" in path.attrib
        ]
        pairs = [pair for pair, _ in self.edges]
        self.cut = [pair for pair in pairs if pairs.count(pair) > 1]
        self.stubs = {
            int(path.get("data-stub")): points(path.get("d"))
            for path in self.svg.iter(f"{NS}path")
            if "data-stub" in path.attrib
        }

    def is_the_map(self):
        """Darts leave clockwise as in sigma, edges join the vertices of their darts."""
        for (dart, other), way in self.edges:
            begin, end = (self.spots[self.map.vertex_of[d]] for d in (dart, other))
            whole = [dart, other] not in self.cut
            assert (way[0] == begin) + (way[-1] == end) == 1 + whole
        for vertex in self.map.vertices:
            angles = [phase(b - a) for a, b in (self.stubs[d] for d in (*vertex, vertex[0]))]
            turns = [(b - a) % tau or tau for a, b in pairwise(angles)]
            assert sum(turns) == pytest.approx(tau, abs=0.05)
        assert not [*crossings([flat(way) for _, way in self.edges])]
        return True


def grid(seen, rows, columns):
    """Vertices lie on the points of an upright grid, as far from each other as the longest edge."""
    places = seen.spots.values()
    xs, ys = (sorted({*values}) for values in ([p.real for p in places], [p.imag for p in places]))
    steps = [b - a for values in (xs, ys) for a, b in pairwise(values)]
    assert max(steps, default=1) - min(steps, default=1) < 0.21
    assert (len(ys), len(xs)) == (rows, columns)
    assert len({*seen.spots.values()}) == rows * columns
    return min(steps)


@pytest.mark.parametrize("size", [(2, 2), (3, 3), (4, 4), (2, 5), (1, 3)])
def test_a_torus_is_its_lattice_and_a_letter_stands_at_both_halves_of_an_edge_that_is_cut(size):
    rows, columns = size
    for numbers in size, size[::-1]:
        seen = Seen(renamed(family("torus:{}x{}".format(*numbers))))
        assert seen.is_the_map()
        step = grid(seen, rows, columns)
        cut = seen.cut
        assert len(cut) == 2 * (rows + columns)
        letters = [g for g in seen.svg.iter(f"{NS}g") if "data-cut" in g.attrib]
        texts = [(g.get("data-cut"), g[0].text) for g in letters]
        assert len(texts) == len(cut)
        assert len({*texts}) == len({text for _, text in texts}) == rows + columns
        for group in letters:
            spot = points(group.get("transform"))[0]
            assert min(abs(spot - v) for v in seen.spots.values()) > step / 2
            assert min(abs(spot - end) for _, way in seen.edges for end in way) > 6
        for (dart, other), way in seen.edges:
            at = [seen.spots[seen.map.vertex_of[d]] for d in (dart, other)]
            assert abs(at[0] - at[1]) == pytest.approx(step, abs=0.3) or [dart, other] in cut
            assert min(abs(way[-1] - way[0]).real, step) <= step + 0.3


def test_opposite_letters_of_a_torus_are_the_same():
    seen = Seen(family("torus:3x4"))
    letters = {}
    for group in seen.svg.iter(f"{NS}g"):
        if "data-cut" in group.attrib:
            letters.setdefault(group[0].text, []).append(points(group.get("transform"))[0])
    for one, other in letters.values():
        assert one.real == other.real or one.imag == other.imag


def test_a_twisted_torus_and_one_with_many_letters_are_drawn_too():
    # Five vertices in a row; up leads two to the right.
    sigma = [d - d % 4 + (d + 1) % 4 for d in range(20)]
    alpha = [0] * 20
    for v in range(5):
        for k, other in ((0, v + 1), (1, v + 2)):
            alpha[4 * v + k], alpha[other % 5 * 4 + k + 2] = other % 5 * 4 + k + 2, 4 * v + k
    assert Seen(CombinatorialMap(sigma, alpha)).is_the_map()
    _, letters = lattice(family("torus:13x14"), 0)
    assert len({*letters.values()}) == 27
    assert "aa" in letters.values()


@pytest.mark.parametrize("size", [(3, 3), (2, 4), (3, 5)])
def test_a_lattice_is_a_lattice_from_wherever_it_is_seen(size):
    map_ = renamed(family("lattice:{}x{}".format(*size)))
    for start in (0, len(map_.sigma) // 2, len(map_.sigma) - 1):
        seen = Seen(map_, start)
        assert seen.is_the_map()
        assert len(seen.edges) == map_.edge_count
        rows, columns = size
        try:
            grid(seen, rows, columns)
        except AssertionError:
            grid(seen, columns, rows)


def test_a_lattice_with_holes_is_one_only_if_every_vertex_has_its_darts_in_order():
    rotation = {}
    for y, x in product(range(7), repeat=2):
        around = [(y - 1, x), (y, x + 1), (y + 1, x), (y, x - 1)]
        rotation[y, x] = [(v, u) for v, u in around if 0 <= v < 7 and 0 <= u < 7]
    # No square is left at the vertex in the middle, and it has three darts.
    for one, other in (((3, 3), (2, 3)), ((4, 3), (4, 2)), ((4, 3), (4, 4))):
        rotation[one].remove(other)
        rotation[other].remove(one)
    map_ = from_rotation(rotation)
    assert lattice(map_, 0)[0]
    seen = Seen(map_)
    assert seen.is_the_map()
    grid(seen, 7, 7)
    rotation[3, 3].reverse()
    assert not lattice(from_rotation(rotation), 0)[0]


@pytest.mark.parametrize("count", [2, 3, 9])
def test_a_path_is_straight(count):
    seen = Seen(renamed(named_map(f"path-{count}")))
    assert seen.is_the_map()
    assert {round(point.imag, 1) for _, way in seen.edges for point in way} == {0.0}


@pytest.mark.parametrize("name", ["wheel-3", "wheel-4", "wheel-9", "star-5", "star-12"])
def test_a_hub_is_in_the_middle_of_its_ring(name):
    map_ = renamed(named_map(name))
    hub = max(range(map_.vertex_count), key=lambda v: len(map_.vertices[v]))
    seen = Seen(map_)
    assert seen.is_the_map()
    rays = [seen.spots[v] - seen.spots[hub] for v in seen.spots if v != hub]
    radius = abs(rays[0])
    assert max(map(abs, rays)) - min(map(abs, rays)) < 0.3
    angles = sorted(map(phase, rays))
    steps = [(b - a) % tau for a, b in pairwise([*angles, angles[0]])]
    assert max(steps) - min(steps) < 0.02
    for (dart, other), way in seen.edges:
        if hub not in (map_.vertex_of[dart], map_.vertex_of[other]):
            far = [abs(point - seen.spots[hub]) for point in flat(way)]
            assert 0.95 * radius < min(far) <= max(far) < 1.08 * radius


@pytest.mark.parametrize("count", [1, 2, 3, 4, 7, 30])
def test_a_ring_is_round(count):
    seen = Seen(renamed(named_map(f"cycle-{count}")))
    assert seen.is_the_map() or count == 1
    curve = [point for _, way in seen.edges for point in flat(way)]
    left, right = (pick(p.real for p in curve) for pick in (min, max))
    top, bottom = (pick(p.imag for p in curve) for pick in (min, max))
    middle = complex(left + right, top + bottom) / 2
    far = [abs(point - middle) for point in curve]
    assert min(far) > 0.88 * max(far)
    assert 'class="bridge"' not in ET.tostring(seen.svg, "unicode")


def test_what_only_resembles_a_wheel_or_a_lattice_is_not_drawn_as_one():
    recognised = 0
    for map_ in rooted_maps(4):
        ways, letters = lattice(map_, 0)
        if wheel(map_) or ways:
            recognised += 1
            seen = Seen(map_)
            assert seen.is_the_map()
            assert bool(letters) == (len(seen.edges) > map_.edge_count) == bool(map_.genus)
    assert recognised == 10
    assert [wheel(named_map(name)) for name in ("k4-torus", "cube")] == [[], []]
    assert not any(wheel(m) or lattice(m, 0)[0] for m in map(named_map, ("cube", "fig1-left")))


def test_a_torus_that_is_drawn_like_another_has_its_letters():
    map_ = family("torus:2x3")
    drawn = layout(map_, 0)
    ties = {d: (d + 4) % 24 for d in map_.darts}
    other = map_.relabelled([ties[d] for d in map_.darts])
    like = layout_like({new: old for old, new in ties.items()}, other, 0, map_, drawn)
    assert like.letters == {ties[d]: letter for d, letter in drawn.letters.items()}


def test_in_what_an_explorer_knows_the_letters_appear_with_their_edge():
    told = run("algorithm1", World(family("torus:1x2"), Directional(0)))
    seen = known(told)
    page = file_of("html", told)
    assert "genus 1; edges go on at the same letter" in page
    figure = read(page).one(id="walk-1-known")
    letters = [g.attributes for g in figure.all("g") if "data-cut" in g.attributes]
    assert len(letters) == 6
    for letter in letters:
        assert int(letter["data-since"]) == seen.edges[int(letter["data-cut"].split()[0])] > 0
