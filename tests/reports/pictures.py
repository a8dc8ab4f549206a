"""Pictures of varied maps, whole, as files.

``RENEW=1 pytest tests/reports/test_whole_pictures.py`` writes the files anew; what then differs is
to be meant, and told in the commit.
"""

import re
from pathlib import Path
from xml.etree import ElementTree as ET

from allworlds.maps import family, from_cycles, named_map
from allworlds.reports.drawing import layout as layouts
from allworlds.reports.drawing.plot import plot
from allworlds.reports.drawing.svg import drawing, picture
from allworlds.reports.drawing.text import draw as in_characters, rotation_table
from allworlds.reports.parts import Curve, Scene, scene_of
from allworlds.world import Directional, Labelling, World, world_named
from recorded_texts import Texts

PICTURES = Texts(Path(__file__).parent / "whole_pictures")
case = PICTURES.case


def whole(name):
    """The text of a case, with a line for each element."""
    return "\n".join(text.rstrip("\n") for text in PICTURES.cases[name]()) + "\n"


NUMBER = re.compile(r"-?\d+\.\d+")

CLOSE = 0.15
"""By how much a coordinate may differ, in pixels: the last bits are another machine's own."""


def alike(made, recorded):
    """Whether two texts are equal, but for the last digit of numbers with a fraction."""
    if NUMBER.split(made) != NUMBER.split(recorded):
        return False
    pairs = zip(NUMBER.findall(made), NUMBER.findall(recorded), strict=True)
    return all(abs(float(a) - float(b)) < CLOSE for a, b in pairs)


def drawn(scene, layout=None):
    """A picture as on a page, and the same in characters."""
    yield ET.tostring(picture(scene, "p", "a map", layout), "unicode")
    for width in (79, 30):
        yield f"<!--\n{in_characters(scene, width)}\n-->"


# Three vertices; a loop, two parallel edges, a leaf.
LOOPED = from_cycles([[*"llab"], [*"abc"], [*"cd"], ["d"]])
# One vertex and three loops, one inside another, and an edge to a second vertex.
NESTED = from_cycles([[*"xyzzyxe"], [*"eww"]])
TORUS = named_map("theta-torus")
# Two vertices; its surface has two handles.
GENUS_2 = from_cycles([[*"abcabde"], [*"cde"]])


@case
def planar():
    yield from drawn(Scene(LOOPED, 0))
    yield from drawn(Scene(NESTED, 3, 1))
    yield from drawn(Scene(named_map("theta"), 0, 5, ringed=2))


@case
def crossed():
    yield from drawn(Scene(TORUS, 1))
    yield from drawn(Scene(GENUS_2, 0))


@case
def regular():
    for name in ("edge", "path-4", "star-5", "wheel-3", "wheel-5"):
        yield from drawn(Scene(named_map(name), 1))
    yield from drawn(Scene(family("lattice:2x3"), 0))
    yield from drawn(Scene(family("torus:2x3"), 5))


@case
def rings():
    for count in (*range(1, 8), 12):
        yield from drawn(Scene(named_map(f"cycle-{count}")))


@case
def round_a_circle():
    for map_ in (LOOPED, TORUS):
        ways = layouts._round_a_circle(map_)
        yield from drawn(Scene(map_, 1), layouts._finished(map_, 1, ways))


@case
def scenes():
    yield from drawn(scene_of(world_named("k4", "cluster")))
    yield from drawn(scene_of(world_named("theta", "directional")))
    yield from drawn(
        Scene(
            LOOPED,
            4,
            6,
            marks={0: 3, 2: 1},
            pointed=[1, 7],
            labels=[*"bacabdcefg"][: len(LOOPED.darts)],
            walked={3, 5},
            ringed=7,
            vertices=["here", "a kitchen", "of a long name that is written below it", "E1"],
        )
    )
    yield from drawn(
        Scene(
            named_map("path-4"),
            None,
            2,
            darts=[f"d{d}" for d in range(6)],
            vertices=["abc", "abcd", "abcde", "abcdef"],
            letters={1: 2, 4: 1},
        )
    )
    yield from drawn(Scene(named_map("path-3"), 0, labels=["b", "a", "c", "b"]))
    many = named_map("star-9")
    yield from drawn(Scene(many, 0, pointed=[2], labels=[f"w{d:02}" for d in many.darts]))
    yield drawing(Scene(named_map("edge"), 0, 0), "an edge").svg


@case
def positions():
    flat = ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (-2.0, 0.3))
    map_ = from_cycles([[*"abllcpqx"], [*"cbay"], [*"yx"], [*"qp"]])
    for start in (0, 9):
        world = World(map_, Directional(start), start, labels=Labelling("", (), flat))
        yield from drawn(scene_of(world))
    wide = tuple((3 * x, y) for x, y in flat)
    yield from drawn(scene_of(World(map_, Directional(0), labels=Labelling("", (), wide))))


@case
def tables():
    for size in (39, 40, 41):
        star = named_map(f"star-{size}")
        yield f"<!--\n{rotation_table(Scene(star, 0), 60)}\n-->"
    scene = scene_of(world_named("k4", "cluster"))
    for width in (20, 59, 60, 61):
        yield f"<!--\n{in_characters(scene, width)}\n-->"


@case
def curves():
    few = [(x, 3.0 * x, 2.5 * x, 4.0 * x) for x in (1, 2, 4)]
    yield ET.tostring(plot(Curve("costs", "edges", [("mine", few)])), "unicode")
    long = [(x, float(x * x), float(x), float(x**3)) for x in (*range(1, 13), 40, 400)]
    yield ET.tostring(
        plot(Curve("", "edges", [(f"no {i}", long[i : i + 7]) for i in range(8)])), "unicode"
    )
    yield ET.tostring(plot(Curve("one", "x", [("a", [(7, 1.0, 1.0, 1.0)])])), "unicode")
    for most in (6, 7, 100, 10**4, 10**7):
        line = [(x, float(x), float(x), float(x)) for x in sorted({*range(1, 8), most})]
        yield ET.tostring(plot(Curve("some", "x", [("a", line)])), "unicode")
