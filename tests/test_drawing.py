import itertools
import random
import re

import pytest

from allworlds.drawing import draw, rotation_table
from allworlds.maps.build import from_cycles, lattice, named_map
from allworlds.maps.canonical import rooted_code
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap

NAMES = ["loop", "edge", "theta", "theta-torus", "two-loops-torus", "k4", "wheel-4", "fig1-left"]


def all_maps(edges):
    """Every pair of permutations that is a map, by brute force."""
    involutions = [
        alpha
        for alpha in itertools.permutations(range(2 * edges))
        if all(alpha[d] != d and alpha[alpha[d]] == d for d in range(2 * edges))
    ]
    for sigma, alpha in itertools.product(itertools.permutations(range(2 * edges)), involutions):
        try:
            yield CombinatorialMap(sigma, alpha)
        except InvalidMap:
            continue


def parsed(text):
    """The map and the start that a drawing shows, read from the picture alone."""
    lines = text.split("\n\n")[0].split("\n")
    bottom = next(i for i, line in enumerate(lines) if line.startswith("("))
    dart_at = {m.start(): int(m.group()) for m in re.finditer(r"\d+", lines[bottom])}
    sigma, alpha = {}, {}
    for group in re.findall(r"\(([^()]*)\)", lines[bottom]):
        darts = [int(number) for number in group.split()]
        sigma |= dict(zip(darts, darts[1:] + darts[:1], strict=True))
    for top in range(bottom):
        for left in (i for i, sign in enumerate(lines[top]) if sign == "╭"):
            right = lines[top].index("╮", left)
            assert set(lines[top][left + 1 : right]) <= set("─┼")
            for foot in (left, right):
                assert {lines[row][foot] for row in range(top + 1, bottom)} <= set("│┼")
            d, e = dart_at[left], dart_at[right]
            alpha[d], alpha[e] = e, d
    starts = [dart_at[line.index("S")] for line in lines[bottom:] if line.strip() == "S"]
    every = range(len(dart_at))
    return CombinatorialMap([sigma[d] for d in every], [alpha[d] for d in every]), starts


def parsed_table(text):
    """The map and the start that a table shows."""
    sigma, alpha, starts = {}, {}, []
    for line in text.split("\n\n")[0].split("\n"):
        entries = re.findall(r"(S?)▲?(\d+)→v\d+\.(\d+)", line)
        darts = [int(dart) for _, dart, _ in entries]
        sigma |= dict(zip(darts, darts[1:] + darts[:1], strict=True))
        alpha |= {int(dart): int(other) for _, dart, other in entries}
        starts += [int(dart) for sign, dart, _ in entries if sign]
    every = range(len(sigma))
    return CombinatorialMap([sigma[d] for d in every], [alpha[d] for d in every]), starts


def without_numbers(text):
    """The drawing with the numbers, and the brackets that follow them, wiped out."""
    return [re.sub(r"[\d)]", " ", line).rstrip() for line in text.split("\n")]


@pytest.mark.no_cover
@pytest.mark.parametrize("edges", [1, 2, 3])
def test_the_drawing_and_the_table_are_exact_for_every_small_map(edges):
    for map_ in all_maps(edges):
        start = map_.sigma[0]
        assert parsed(draw(map_, start=start)) == (map_, [start])
        assert parsed_table(rotation_table(map_, start=start)) == (map_, [start])


@pytest.mark.parametrize("name", [*NAMES, "cube", "dipole-12", "bouquet-6", "path-12", "star-11"])
def test_the_drawing_and_the_table_are_exact_from_every_start(name):
    map_ = named_map(name)
    for start in map_.darts:
        given = {"start": start, "pointed": 0, "marked": {0: 3}, "width": 999}
        assert parsed(draw(map_, **given)) == (map_, [start])
        assert parsed_table(rotation_table(map_, **given)) == (map_, [start])


@pytest.mark.no_cover
def test_without_the_numbers_two_drawings_agree_exactly_for_the_same_rooted_map():
    # 10 + 74 rooted maps of 2 and 3 edges: Arques and Beraud, Discrete Math. 215 (2000).
    for edges, count in ((1, 2), (2, 10), (3, 74)):
        pictures = {}
        for map_ in all_maps(edges):
            code = rooted_code(map_.sigma, map_.alpha, 0)
            pictures.setdefault(code, set()).add(tuple(without_numbers(draw(map_, start=0))))
        assert len(pictures) == count
        assert all(len(drawn) == 1 for drawn in pictures.values())
        assert len(set.union(*pictures.values())) == count


@pytest.mark.parametrize("name", NAMES)
def test_relabelling_the_darts_changes_only_the_numbers(name):
    map_, rng = named_map(name), random.Random(name)
    for _ in range(20):
        new = list(map_.darts)
        rng.shuffle(new)
        other = map_.relabelled(new)
        vertex = map_.vertices[-1][0]
        texts = [str(rng.randrange(100)) for _ in new]
        moved = [texts[new.index(d)] for d in map_.darts]
        here = draw(
            map_, start=1, pointed=0, marked={map_.vertex_of[vertex]: 1}, labels=texts, width=999
        )
        there = draw(
            other,
            start=new[1],
            pointed=new[0],
            marked={other.vertex_of[new[vertex]]: 1},
            labels=moved,
            width=999,
        )
        assert without_numbers(here) == without_numbers(there)
        label_row = next(i for i, line in enumerate(here.split("\n")) if line[0] == "(") + 1
        assert here.split("\n")[label_row] == there.split("\n")[label_row]


@pytest.mark.parametrize("name", NAMES)
def test_arcs_cross_exactly_where_their_ends_alternate(name):
    map_ = named_map(name)
    for start in map_.darts:
        drawing = draw(map_, start=start, width=999).split("\n\n")[0]
        row = next(line for line in drawing.split("\n") if line.startswith("("))
        order = [int(number) for number in re.findall(r"\d+", row)]
        spans = [sorted((order.index(d), order.index(e))) for d, e in map_.edges]
        crossings = sum(a < c < b < d for (a, b), (c, d) in itertools.permutations(spans, 2))
        assert drawing.count("┼") == crossings


@pytest.mark.parametrize("name", ["theta", "dipole-6", "bouquet-4", "star-5", "edge", "loop"])
def test_a_dipole_a_bouquet_and_a_star_in_the_plane_are_drawn_without_crossing(name):
    assert "┼" not in draw(named_map(name))


@pytest.mark.parametrize("name", [*NAMES, "path-12"])
@pytest.mark.parametrize("width", [1, 30, 60, 200])
def test_no_line_ends_in_a_space(name, width):
    map_ = named_map(name)
    texts = ["x" * (d % 3) for d in map_.darts]
    text = draw(map_, start=1, pointed=0, marked={0: 2}, labels=texts, width=width)
    assert all(line == line.rstrip() for line in text.split("\n"))
    assert not text.endswith("\n")


@pytest.mark.parametrize("name", NAMES)
def test_a_drawing_fits_its_width_or_is_a_table(name):
    map_ = named_map(name)
    picture = draw(map_, start=0, width=999).split("\n\n")[0]
    needed = max(map(len, picture.split("\n")))
    assert draw(map_, start=0, width=needed).startswith(picture)
    assert draw(map_, start=0, width=needed - 1) == rotation_table(map_, start=0, width=needed - 1)


def test_a_legend_keeps_to_the_width():
    legend = draw(named_map("theta-torus"), start=0, pointed=1, marked={0: 1}, width=40)
    assert max(map(len, legend.split("\n"))) <= 40


def test_the_legend_explains_the_signs_used_and_no_other():
    map_ = named_map("theta")
    signs = "┼▲●S"
    plain = draw(map_, labels=["S", "●", "▲", "┼", "→", "S"])
    assert not set(signs) & set(plain.split("\n\n")[1])
    full = draw(named_map("theta-torus"), start=0, pointed=1, marked={0: 1, 1: 0})
    assert set(signs) <= set(full.split("\n\n")[1])
    table = rotation_table(map_, pointed=1).split("\n\n")[1]
    assert "▲" in table
    assert not set("┼●S╭(") & set(table)


def test_the_torus_with_two_loops_is_drawn_like_this():
    assert draw(named_map("two-loops-torus"), width=50).split("\n") == [
        "   ╭───╮",
        " ╭─┼─╮ │",
        "(0 1 2 3)",
        " v0",
        "",
        "( ) vertex with its darts clockwise   ╭─╮ edge",
        "┼ arcs cross, no vertex",
    ]


def test_signs_and_labels_stand_under_their_darts():
    # Two vertices; the start at the second, which has one marker, the first has three.
    map_ = from_cycles(["aab", "b"])
    drawing = draw(map_, start=3, pointed=1, marked={0: 3, 1: 1}, labels=["A", "B", "C", "DD"])
    assert drawing.split("\n\n")[0].split("\n") == [
        " ╭─────╮  ╭──╮",
        "(3)   (2  0  1)",
        " DD    C  A  B",
        " v1 ●  v0 ●3",
        "             ▲",
        " S",
    ]


def test_a_table_has_a_line_for_each_vertex():
    map_ = from_cycles(["aab", "b"])
    table = rotation_table(map_, start=3, pointed=0, marked={0: 2}, labels=["A", "B", "C", "D"])
    assert table.split("\n\n")[0].split("\n") == [
        "v1     1  S3[D]→v0.2",
        "v0 ●2  3  2[C]→v1.3   ▲0[A]→v0.1  1[B]→v0.0",
    ]


def test_the_picture_begins_at_dart_0_without_a_start():
    map_ = named_map("k4")
    picture = draw(map_).split("\n\n")[0]
    assert picture == draw(map_, start=0).split("\n\n")[0].removesuffix("\n S")


@pytest.mark.parametrize("show", [draw, rotation_table])
@pytest.mark.parametrize(
    ("given", "named"),
    [
        ({"start": 6}, r"start = 6 is no dart; darts are 0\.\.5"),
        ({"pointed": -1}, r"pointed = -1 is no dart; darts are 0\.\.5"),
        ({"marked": {2: 1}}, r"marked vertex 2 does not exist; vertices are 0\.\.1"),
        ({"marked": {1: -1}}, "vertex 1 cannot have -1 markers"),
        ({"labels": ["a"]}, "1 labels for 6 darts"),
    ],
)
def test_what_the_map_does_not_have_is_not_drawn(show, given, named):
    with pytest.raises(ValueError, match=named):
        show(named_map("theta"), **given)


def test_a_large_map_falls_back_to_a_table_that_is_exact():
    map_ = lattice(6, 6, holes=0.1, seed=2)
    text = draw(map_, start=5)
    assert "→" in text
    assert parsed_table(text) == (map_, [5])


def test_of_many_darts_and_vertices_both_ends_are_shown_and_the_rest_is_counted():
    star = CombinatorialMap([*range(1, 1000), 0], [*range(500, 1000), *range(500)])
    text = draw(star, start=7, most=6)
    assert [int(d) for d in re.findall(r"(\d+)→", text.split("\n\n")[0])] == [7, 8, 9, 4, 5, 6]
    assert "(994 darts more)" in text
    text = draw(named_map("path-101"), most=6)
    rows = text.split("\n\n")[0].split("\n")
    assert len(rows) == 7
    # 101 vertices with 200 darts, of which the two at the ends and four others are shown.
    assert rows[3] == "... (95 vertices more, with 190 darts)"
    assert parsed_table(draw(named_map("path-101"), start=0, most=101))[1] == [0]
