import itertools
import random
import re

import pytest

from allworlds.maps import CombinatorialMap, from_cycles, named_map
from allworlds.maps.build import lattice
from allworlds.reports.drawing.text import draw, rotation_table
from allworlds.reports.parts import Scene

NAMES = ["loop", "edge", "theta", "theta-torus", "two-loops-torus", "k4", "wheel-4", "fig1-left"]


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
        entries = re.findall(r"▲?(S?)R?(\d+)→v\d+\.(\d+)", line)
        darts = [int(dart) for _, dart, _ in entries]
        sigma |= dict(zip(darts, darts[1:] + darts[:1], strict=True))
        alpha |= {int(dart): int(other) for _, dart, other in entries}
        starts += [int(dart) for sign, dart, _ in entries if sign]
    every = range(len(sigma))
    return CombinatorialMap([sigma[d] for d in every], [alpha[d] for d in every]), starts


def without_numbers(text):
    """The drawing with the numbers, and the brackets that follow them, wiped out."""
    return [re.sub(r"[\d)]", " ", line).rstrip() for line in text.split("\n")]


@pytest.mark.parametrize("name", [*NAMES, "cube", "dipole-12", "bouquet-6", "path-12", "star-11"])
def test_the_drawing_and_the_table_are_exact_from_every_start(name):
    map_ = named_map(name)
    for start in map_.darts:
        scene = Scene(map_, start, robot=1, marks={0: 3}, pointed=[0])
        assert parsed(draw(scene, 999)) == (map_, [start])
        assert parsed_table(rotation_table(scene)) == (map_, [start])


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
        marked = map_.vertex_of[vertex], other.vertex_of[new[vertex]]
        scenes = (
            Scene(map_, 1, 0, {marked[0]: 1}, [0, vertex], texts),
            Scene(other, new[1], new[0], {marked[1]: 1}, [new[0], new[vertex]], moved),
        )
        here, there = (draw(scene, 999) for scene in scenes)
        assert without_numbers(here) == without_numbers(there)
        label_row = next(i for i, line in enumerate(here.split("\n")) if line[0] == "(") + 1
        assert here.split("\n")[label_row] == there.split("\n")[label_row]


@pytest.mark.parametrize("name", NAMES)
def test_arcs_cross_exactly_where_their_ends_alternate(name):
    map_ = named_map(name)
    for start in map_.darts:
        drawing = draw(Scene(map_, start), 999).split("\n\n")[0]
        row = next(line for line in drawing.split("\n") if line.startswith("("))
        order = [int(number) for number in re.findall(r"\d+", row)]
        spans = [sorted((order.index(d), order.index(e))) for d, e in map_.edges]
        crossings = sum(a < c < b < d for (a, b), (c, d) in itertools.permutations(spans, 2))
        assert drawing.count("┼") == crossings


@pytest.mark.parametrize("name", ["theta", "dipole-6", "bouquet-4", "star-5", "edge", "loop"])
def test_a_dipole_a_bouquet_and_a_star_in_the_plane_are_drawn_without_crossing(name):
    assert "┼" not in draw(Scene(named_map(name)))


@pytest.mark.parametrize("name", [*NAMES, "path-12"])
@pytest.mark.parametrize("width", [1, 30, 60, 200])
def test_no_line_ends_in_a_space(name, width):
    map_ = named_map(name)
    texts = ["x" * (d % 3) for d in map_.darts]
    text = draw(Scene(map_, 1, 0, {0: 2}, [0], texts), width)
    assert all(line == line.rstrip() for line in text.split("\n"))
    assert not text.endswith("\n")


@pytest.mark.parametrize("name", NAMES)
def test_a_drawing_fits_its_width_or_is_a_table(name):
    scene = Scene(named_map(name))
    picture = draw(scene, 999).split("\n\n")[0]
    needed = max(map(len, picture.split("\n")))
    assert draw(scene, needed).startswith(picture)
    assert draw(scene, needed - 1) == rotation_table(scene, needed - 1)


def test_a_legend_keeps_to_the_width():
    scene = Scene(named_map("theta-torus"), robot=1, marks={0: 1}, pointed=[1])
    assert "R robot" in draw(scene, 40)
    assert max(map(len, draw(scene, 40).split("\n"))) <= 40


def test_the_legend_explains_the_signs_used_and_no_other():
    def legend(scene, show=draw):
        return show(scene).split("\n\n")[1]

    theta, torus = named_map("theta"), named_map("theta-torus")
    assert not set("┼▲●R") & set(legend(Scene(theta, labels=["R", "●", "▲", "┼", "→", ""])))
    full = Scene(torus, robot=2, marks={0: 1, 1: 0}, pointed=[1, 3])
    assert set("┼▲●SR(╭") <= set(legend(full))
    assert "look alike" in legend(Scene(theta, labels="abcdef"))
    table = legend(Scene(theta, pointed=[1]), rotation_table)
    assert "▲" in table
    assert "( )" not in table
    assert not set("┼●R╭") & set(table)


def test_the_torus_with_two_loops_is_drawn_like_this():
    assert draw(Scene(named_map("two-loops-torus")), 50).split("\n") == [
        "   ╭───╮",
        " ╭─┼─╮ │",
        "(0 1 2 3)",
        " v0",
        " S",
        "",
        "( ) vertex with its darts clockwise   ╭─╮ edge",
        "┼ arcs cross, no vertex   S start",
    ]


def test_signs_and_labels_stand_under_their_darts():
    # Two vertices; the start at the second, which has one marker, the first has three.
    map_ = from_cycles(["aab", "b"])
    scene = Scene(map_, 3, 0, {0: 3, 1: 1}, [1, 3], ["A", "B", "C", "DD"])
    assert draw(scene).split("\n\n")[0].split("\n") == [
        " ╭─────╮  ╭──╮",
        "(3)   (2  0  1)",
        " DD    C  A  B",
        " v1 ●  v0 ●3",
        " ▲           ▲",
        " S",
        "          R",
    ]


def test_a_table_has_a_line_for_each_vertex():
    map_ = from_cycles(["aab", "b"])
    scene = Scene(map_, 3, 0, {0: 2}, [0, 3], ["A", "B", "C", "D"])
    assert rotation_table(scene).split("\n\n")[0].split("\n") == [
        "v1     1  ▲S3[D]→v0.2",
        "v0 ●2  3  2[C]→v1.3    ▲R0[A]→v0.1  1[B]→v0.0",
    ]


def test_a_large_map_falls_back_to_a_table_that_is_exact():
    map_ = lattice(6, 6, holes=0.1, seed=2)
    text = draw(Scene(map_, 5))
    assert "→" in text
    assert parsed_table(text) == (map_, [5])


def test_of_many_darts_and_vertices_both_ends_are_shown_and_the_rest_is_counted(monkeypatch):
    monkeypatch.setattr("allworlds.reports.drawing.text.LONGEST_ROW", 6)
    star = CombinatorialMap([*range(1, 1000), 0], [*range(500, 1000), *range(500)])
    text = draw(Scene(star, 7))
    assert [int(d) for d in re.findall(r"(\d+)→", text.split("\n\n")[0])] == [7, 8, 9, 4, 5, 6]
    assert "(994 darts more)" in text
    text = draw(Scene(named_map("path-101")))
    rows = text.split("\n\n")[0].split("\n")
    assert len(rows) == 7
    # Of 101 vertices the two at the ends and four others are shown.
    assert rows[3] == "... (95 vertices more)"
    monkeypatch.undo()
    assert "vertices more" not in draw(Scene(named_map("path-40")))
