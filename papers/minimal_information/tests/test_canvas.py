"""A map that a figure shows is the map, and not its mirror image, in the file that is written."""

import math
import re
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from allworlds.maps import named_map

matplotlib = pytest.importorskip("matplotlib", reason="the extra figures is not installed")

import drawn  # noqa: E402  # it needs matplotlib
from canvas import Canvas  # noqa: E402
from figure_1 import TwinsFigure, figure_1  # noqa: E402
from figure_2 import Augmentation, figure_2  # noqa: E402
from figures import FIGURES  # noqa: E402

PAPER = Path(__file__).parents[1]
MAPS = {
    "1": lambda: [world.map for world in figure_1().compared.worlds],
    "2": lambda: [figure_2().told.world.map] * 4,
}
"""The maps that a figure shows, in the order of its axes."""


def beginnings(path, map_, name):
    """The directions in which darts leave their vertices in a file, as (x, y), y downwards.

    A dart that is drawn more than once, as the end of an edge and by itself, has several.
    """
    found = {}
    for group in ET.parse(path).iter("{http://www.w3.org/2000/svg}g"):
        if named := re.fullmatch(rf"{name}-(edge|dart)-(\d+)", group.get("id", "")):
            kind, dart = named[1], int(named[2])
            numbers = [float(x) for x in re.findall(r"-?[\d.]+", next(iter(group)).get("d"))]
            points = list(zip(numbers[::2], numbers[1::2], strict=True))
            ends = [(dart, points)]
            if kind == "edge":
                ends.append((map_.alpha[dart], points[::-1]))
            for end, ((x, y), (to_x, to_y), *_) in ends:
                found.setdefault(end, []).append((to_x - x, to_y - y))
    return found


def is_the_map(path, map_, name):
    """Whether the darts of each vertex stand clockwise in the file, in the order of sigma."""
    seen = beginnings(path, map_, name)
    assert set(seen) == {*map_.darts}
    # With y downwards an angle that grows goes clockwise.
    angles = {dart: [math.atan2(y, x) for x, y in seen[dart]] for dart in seen}
    for one, *others in angles.values():
        assert all(math.isclose(one, other, abs_tol=1e-3) for other in others)
    for vertex in map_.vertices:
        around = [angles[dart][0] for dart in (*vertex, vertex[0])]
        turns = [(b - a) % math.tau for a, b in pairwise(around)]
        if len(vertex) >= 3 and not math.isclose(sum(turns), math.tau):
            return False
    return True


@pytest.mark.parametrize("name", ["k4", "theta", "wheel-4", "theta-torus"])
def test_the_darts_of_a_vertex_go_clockwise_in_the_file(name, tmp_path):
    from matplotlib.figure import Figure

    map_ = named_map(name)
    picture = Figure(figsize=(6, 6))
    canvas = Canvas.of(picture.add_subplot(), map_, 0)
    canvas.edges(dart for dart, _ in map_.edges)
    canvas.stubs(map_.darts)
    picture.savefig(tmp_path / "map.svg")
    assert is_the_map(tmp_path / "map.svg", map_, "map-0")


def test_every_figure_that_shows_maps_is_looked_at():
    programs = (path for path in PAPER.glob("*.py") if path.stem != "canvas")
    showing = {path.stem for path in programs if "Canvas.of(" in path.read_text(encoding="utf-8")}
    assert showing == {"figure_1", "figure_2"}


@pytest.mark.parametrize("name", MAPS)
def test_the_maps_of_a_figure_are_those_that_it_tells_of_in_the_file(name, tmp_path):
    drawn.write(FIGURES[name](), tmp_path / "figure.svg")
    for number, map_ in enumerate(MAPS[name]()):
        assert is_the_map(tmp_path / "figure.svg", map_, f"map-{number}")


@pytest.mark.parametrize(("name", "kind"), [("1", TwinsFigure), ("2", Augmentation)])
@pytest.mark.parametrize("turned", ["invert_yaxis", "invert_xaxis"])
def test_axes_that_are_turned_round_show_another_map(name, kind, turned, tmp_path, monkeypatch):
    draw = kind.draw

    def mirrored(self, picture):
        draw(self, picture)
        getattr(picture.axes[-1], turned)()

    monkeypatch.setattr(kind, "draw", mirrored)
    drawn.write(FIGURES[name](), tmp_path / "figure.svg")
    right = [
        is_the_map(tmp_path / "figure.svg", map_, f"map-{number}")
        for number, map_ in enumerate(MAPS[name]())
    ]
    assert right == [True] * (len(right) - 1) + [False]


@pytest.mark.parametrize("name", MAPS)
def test_the_figures_that_are_kept_show_these_maps(name):
    for number, map_ in enumerate(MAPS[name]()):
        assert is_the_map(PAPER / "figures" / f"figure-{name}.svg", map_, f"map-{number}")
