"""Explorers of the field (``examples/field``): each holds, or is refuted in its smallest world."""

import pytest

import allworlds
from explorers import test_field as quick
from explorers.test_field import (
    HOLD,
    HOMING,
    PEBBLE,
    REFUTED,
    ROTOR,
    TREMAUX,
    UNIVERSAL,
    VIEWS,
    checked,
    loaded,
)

in_their_folder = quick.in_their_folder

pytestmark = pytest.mark.usefixtures("without_workers")


FURTHER = {
    ("rotor.py:rotor", "2*m*(n-1) + 2*m", 4): ROTOR,
    ("tremaux.py:tremaux", "2*m", 4): TREMAUX,
    ("pebble.py:draws", "4*m*n", 4): PEBBLE,
    ("views.py:to_n", "none", 4): VIEWS,
    ("homing.py:learns", "none", 3): HOMING,
}
"""The same, further."""


@pytest.mark.slowest
@pytest.mark.parametrize(("asked", "options"), FURTHER.items(), ids=lambda each: str(each)[:40])
def test_an_explorer_of_the_field_holds_further(asked, options):
    assert checked(*asked, options).verdict.value == "holds"


@pytest.mark.slowest
def test_views_of_depth_2_are_not_enough_for_4_edges():
    (finding,) = checked("views.py:looks?depth=2", "none", 4, VIEWS).findings
    assert (finding.law, finding.world.map.edge_count) == ("task", 4)


def has_word(maps, length):
    """Whether some word of that length visits every vertex of these cubic maps.

    Depth first, offset by offset; a beginning is given up if a map lacks more vertices than
    offsets are left.
    """
    ways = [[[m.alpha[m.turn(d, k)] for k in range(3)] for d in m.darts] for m in maps]

    def goes_on(robots, left):
        if not robots:
            return True
        if any(len(lacking) > left for _, _, lacking in robots):
            return False
        for k in range(3):
            moved = [(i, ways[i][dart][k], lacking) for i, dart, lacking in robots]
            after = [(i, dart, lack - {maps[i].vertex_of[dart]}) for i, dart, lack in moved]
            if goes_on([robot for robot in after if robot[2]], left - 1):
                return True
        return False

    vertices = [frozenset(range(m.vertex_count)) - {m.vertex_of[0]} for m in maps]
    return goes_on([(i, 0, lacking) for i, lacking in enumerate(vertices)], length)


@pytest.mark.slowest
def test_13_offsets_visit_every_cubic_map_with_at_most_6_edges(monkeypatch):
    # 13 is what the issue of the project's user expects.
    universal = loaded("universal", monkeypatch)
    found = universal.shortest_word(6)
    assert len(found) == 13
    name = "universal.py:follows?word="
    assert checked(f"{name}{found}", "none", 6, UNIVERSAL).verdict.value == "holds"
    assert checked(f"{name}{found[:-1]}", "none", 6, UNIVERSAL).findings[0].law == "task"
    maps = [world.map for world in allworlds.worlds(edges=6, lighthouse="none", where="cubic")]
    assert not has_word(maps, 12)
    assert has_word(maps, 13)


@pytest.mark.parametrize(("asked", "options"), HOLD.items(), ids=lambda each: str(each)[:40])
def test_an_explorer_of_the_field_holds(asked, options):
    assert checked(*asked, options).verdict.value == "holds"


@pytest.mark.parametrize(("asked", "expected"), REFUTED.items(), ids=lambda each: str(each)[:40])
def test_a_wrong_one_is_refuted_in_its_smallest_world(asked, expected):
    options, law, edges, vertices = expected
    (finding,) = checked(*asked, edges, options).findings
    world = finding.world.map
    assert (finding.law, world.edge_count, world.vertex_count) == (law, edges, vertices)
    assert finding.minimal
    assert finding.confirmed
    if edges > 1:
        assert checked(*asked, edges - 1, options).verdict.value == "holds"
