"""A map that a figure shows is the map, and not its mirror image, in the file that is written."""

import math
import re
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from allworlds.maps import named_map

matplotlib = pytest.importorskip("matplotlib", reason="the extra figures is not installed")

from allworlds.evidence.figures import augmentation, canvas, twins  # noqa: E402
from allworlds.evidence.figures.canvas import Canvas  # noqa: E402

from allworlds import figure  # noqa: E402  # needs matplotlib

FIGURES = Path(canvas.__file__).parent
MAPS = {
    "1": lambda: [world.map for world in twins.figure_1().compared.worlds],
    "2": lambda: [augmentation.figure_2().told.world.map] * 4,
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
    drawn = Canvas.of(picture.add_subplot(), map_, 0)
    drawn.edges(dart for dart, _ in map_.edges)
    drawn.stubs(map_.darts)
    picture.savefig(tmp_path / "map.svg")
    assert is_the_map(tmp_path / "map.svg", map_, "map-0")


def test_every_figure_that_shows_maps_is_looked_at():
    showing = {
        p.stem
        for p in FIGURES.glob("*.py")
        if "import" in (t := p.read_text()) and "Canvas.of(" in t
    }
    assert showing - {"canvas"} == {"twins", "augmentation"}


@pytest.mark.no_cover
@pytest.mark.parametrize("name", MAPS)
def test_the_maps_of_a_figure_are_those_that_it_tells_of_in_the_file(name, tmp_path):
    figure(name, out=str(tmp_path / "figure.svg"))
    for number, map_ in enumerate(MAPS[name]()):
        assert is_the_map(tmp_path / "figure.svg", map_, f"map-{number}")


@pytest.mark.no_cover
@pytest.mark.parametrize(
    ("name", "drawn"), [("1", twins.TwinsFigure), ("2", augmentation.Augmentation)]
)
@pytest.mark.parametrize("turned", ["invert_yaxis", "invert_xaxis"])
def test_axes_that_are_turned_round_show_another_map(name, drawn, turned, tmp_path, monkeypatch):
    draw = drawn.draw

    def mirrored(self, picture):
        draw(self, picture)
        getattr(picture.axes[-1], turned)()

    monkeypatch.setattr(drawn, "draw", mirrored)
    figure(name, out=str(tmp_path / "figure.svg"))
    right = [
        is_the_map(tmp_path / "figure.svg", map_, f"map-{number}")
        for number, map_ in enumerate(MAPS[name]())
    ]
    assert right == [True] * (len(right) - 1) + [False]


@pytest.mark.parametrize("name", MAPS)
def test_the_figures_of_the_pages_show_these_maps(name):
    page = Path(__file__).parents[2] / "docs" / "figures" / f"figure-{name}.svg"
    for number, map_ in enumerate(MAPS[name]()):
        assert is_the_map(page, map_, f"map-{number}")
