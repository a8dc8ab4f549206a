"""Pictures of worlds, which show all that can be sensed in them, whatever the lighthouse."""

import re

import pytest

from allworlds.documents.document import replace
from allworlds.maps import named_map, rooted_maps
from allworlds.protocol.actions import Percept
from allworlds.reports.drawing.svg import in_words, picture
from allworlds.reports.drawing.text import draw
from allworlds.reports.parts import Scene, scene_of
from allworlds.world import LIGHTHOUSES, Compass, Directional, Nothing, World


class Labels(Nothing):
    """A lighthouse that no picture knows: every vertex has a number, and points to a dart."""

    def percepts(self, map_):
        """The number of the vertex, and the bearing of its last dart."""
        found = []
        for dart in map_.darts:
            vertex = map_.vertex_of[dart]
            bearing = map_.offset(dart, map_.vertices[vertex][-1])
            found.append(Percept(map_.degree_at[dart], vertex + 1, bearing))
        return tuple(found)


def worlds(kind, largest=3):
    maps = [map_ for m in range(1, largest + 1) for map_ in rooted_maps(m)]
    return [World(map_, place) for map_ in maps for place in kind.places(map_, 0)]


def read(map_, marks, letters, pointed):
    """The percept at each dart, with these marks of vertices and of darts, and pointed darts."""
    percepts = []
    for dart in map_.darts:
        around = [dart]
        while map_.sigma[around[-1]] != dart:
            around.append(map_.sigma[around[-1]])
        here = [place for place, other in enumerate(around) if other in pointed]
        (vertex,) = [v for v, darts in enumerate(map_.vertices) if dart in darts]
        mark = letters.get(dart, marks.get(vertex, 0))
        percepts.append(Percept(len(around), mark, *here))
    return tuple(percepts)


def read_text(map_, text):
    """Marks of vertices and of darts, and pointed darts, read from an arc diagram."""
    lines = text.split("\n\n")[0].split("\n")
    bottom = next(i for i, line in enumerate(lines) if line.startswith("("))
    dart_at = {m.start(): int(m.group()) for m in re.finditer(r"\d+", lines[bottom])}
    names = re.findall(r"v(\d+) *(●?)(\d*)", next(line for line in lines if " v0" in line))
    marks = {int(v): int(count or 1) for v, mark, count in names if mark}
    pointed = [dart_at[i] for line in lines for i, sign in enumerate(line) if sign == "▲"]
    signs = [found for line in lines[bottom + 2 :] for found in re.finditer(r"●(\d)", line)]
    letters = {dart_at[found.start()]: int(found[1]) for found in signs}
    return marks, letters, pointed


@pytest.mark.parametrize("kind", [*LIGHTHOUSES.values(), Labels], ids=lambda kind: kind.__name__)
def test_what_is_sensed_can_be_read_from_the_scene_and_from_its_text(kind):
    met = worlds(kind)
    assert met
    for world in met:
        scene, shown = replace(scene_of(world), robot=0), world.percepts
        if world.lighthouse.labels_vertices:  # which are no markers
            shown = tuple(replace(percept, marks=0) for percept in shown)
        assert read(world.map, scene.marks, scene.letters, scene.pointed) == shown
        assert read(world.map, *read_text(world.map, draw(scene, 200))) == shown


def test_two_worlds_that_differ_in_their_norths_have_two_pictures():
    k4 = named_map("k4")
    one, other = (scene_of(World(k4, Compass((n, 3, 6, 9)))) for n in (0, 1))
    assert draw(one) != draw(other)
    assert in_words(one) != in_words(other)


def test_every_part_of_a_world_is_passed_on():
    scene = replace(
        scene_of(World(named_map("theta"), Directional(2), 1)), robot=3, labels="abcdef"
    )
    assert (scene.start, scene.robot, "".join(scene.labels)) == (1, 3, "abcdef")
    assert (scene.marks, list(scene.pointed)) == ({0: 1}, [2])


def test_what_is_known_of_some_darts_alone_is_shown():
    theta = named_map("theta")
    scene = Scene.sensed(theta, 0, [(2, Percept(3)), (5, Percept(3, 2, 1))])
    assert (scene.marks, list(scene.pointed)) == ({1: 2}, [theta.sigma[5]])


def test_without_a_walk_there_is_no_robot():
    scene = Scene(named_map("theta"), 4)
    assert "R" not in draw(scene)
    assert in_words(scene).endswith("The start is dart 4.")
    assert "here" not in {g.get("class") for g in picture(scene, "p", "a map").iter("g")}


def test_marks_of_single_darts_are_told_and_drawn():
    theta = named_map("theta")
    scene = Scene(theta, 0, letters={2: 3, 1: 1})
    assert "Marks that are sensed by single darts: 1 by 1, 3 by 2." in in_words(scene)
    drawn = picture(scene, "p", "a map").iter("tspan")
    assert [each.text for each in drawn if each.get("class") == "letter"] == ["●1", "●3"]
