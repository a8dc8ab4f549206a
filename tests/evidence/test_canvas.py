"""A map drawn on axes is the map, and not its mirror image."""

import math
import re
from xml.etree import ElementTree as ET

import pytest

from allworlds.maps import named_map

matplotlib = pytest.importorskip("matplotlib", reason="the extra figures is not installed")

from allworlds.evidence.figures.canvas import Canvas  # noqa: E402  # needs matplotlib


def directions(map_, path):
    """The direction of each dart's beginning in the file of a picture, as (x, y), y downwards."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6, 6))
    canvas = Canvas.of(figure.add_subplot(), map_, 0)
    for dart in map_.darts:
        canvas.stubs([dart])
        canvas.axes.lines[-1].set_gid(f"dart-{dart}")
    figure.savefig(path)
    found = {}
    for group in ET.parse(path).iter("{http://www.w3.org/2000/svg}g"):
        if name := re.fullmatch(r"dart-(\d+)", group.get("id", "")):
            numbers = [float(x) for x in re.findall(r"-?[\d.]+", next(iter(group)).get("d"))]
            x, y, to_x, to_y = numbers[:4]
            found[int(name[1])] = (to_x - x, to_y - y)
    return found


@pytest.mark.parametrize("name", ["k4", "theta", "wheel-4", "theta-torus"])
def test_the_darts_of_a_vertex_go_clockwise_in_the_file(name, tmp_path):
    map_ = named_map(name)
    seen = directions(map_, tmp_path / "map.svg")
    assert set(seen) == {*map_.darts}
    for vertex in map_.vertices:
        # With y downwards an angle that grows goes clockwise.
        angles = [math.atan2(seen[dart][1], seen[dart][0]) for dart in vertex]
        turns = [(b - a) % math.tau for a, b in zip(angles, [*angles[1:], angles[0]], strict=True)]
        assert len(vertex) < 3 or math.isclose(sum(turns), math.tau), vertex
