"""Explorers of the field (``examples/field``): each holds, or is refuted in its smallest world."""

import ast
import itertools
from pathlib import Path

import pytest

import allworlds
from allworlds.maps import unrooted_code

pytestmark = pytest.mark.usefixtures("without_workers")

FIELD = Path(__file__).parents[2] / "examples" / "field"
EXPLORERS = sorted(path.name for path in FIELD.glob("*.py") if path.name != "judges.py")

ROTOR = {
    "lighthouse": "compass+whiteboard:states=16",
    "task": "cover:edges",
    "schedules": "all",
}
TREMAUX = {"lighthouse": "compass+whiteboard:states=65536", "task": "home"}
PEBBLE = {"lighthouse": "compass+movable"}
VIEWS = {"lighthouse": "told:n", "task": "judges.py:kinds", "step_budget": 100_000}
HOMING = {"lighthouse": "directional+told:m", "bound": "none", "step_budget": 20_000}
ROUND = {"lighthouse": "told:m", "task": "judges.py:every_dart"}
CLEANER = {"lighthouse": "labels", "task": "cover"}
UNIVERSAL = {"lighthouse": "none", "task": "cover", "where": "cubic"}

HOLD = {
    ("rotor.py:rotor", "2*m*(n-1) + 2*m", 2): ROTOR,
    ("rotor.py:rotor", "2*m*d + 2*m", 2): ROTOR,
    ("tremaux.py:tremaux", "2*m", 3): TREMAUX,
    ("pebble.py:draws", "4*m*n", 3): PEBBLE,
    ("views.py:to_n", "none", 3): VIEWS,
    ("homing.py:learns", "none", 2): HOMING,
    ("right_hand.py:goes_round", "2*m", 4): {**ROUND, "where": "judges.py:one_face"},
    ("universal.py:follows?word=112", "none", 3): UNIVERSAL,
    ("cleaner.py:cleans", "4*m", 4): CLEANER,
}
"""Explorers that hold, with a bound, and the number of edges to which that takes a second."""

REFUTED = {
    ("rotor.py:rotor", "2*m"): (ROTOR, "bound", 3, 2),
    ("tremaux.py:tremaux", "2*m - 1"): (TREMAUX, "bound", 1, 1),
    ("tremaux.py:hasty", "none"): (TREMAUX, "task", 3, 3),
    ("pebble.py:blind", "none"): (PEBBLE, "pose", 2, 1),
    ("views.py:looks?depth=0", "none"): (VIEWS, "task", 2, 2),
    ("views.py:looks?depth=1", "none"): (VIEWS, "task", 3, 2),
    ("views.py:norris", "none"): (VIEWS, "task", 3, 2),
    ("homing.py:trusts", "none"): ({**HOMING, "step_budget": 500}, "budget", 1, 1),
    ("right_hand.py:goes_round", "none"): (ROUND, "task", 1, 1),
    ("cleaner.py:forgets", "none"): (CLEANER, "task", 3, 3),
}
"""Explorers that are refuted: the law, and the edges and vertices of the smallest world."""


@pytest.fixture(autouse=True)
def in_their_folder(monkeypatch):
    monkeypatch.chdir(FIELD)


def checked(explorer, bound, edges, options):
    return allworlds.check(explorer, **{"edges": edges, "workers": 1, "bound": bound, **options})


def test_the_right_hand_rule_walks_along_everything_in_maps_with_one_face_alone():
    worlds = [*allworlds.worlds(edges=3, lighthouse="told:m")]
    several = [world for world in worlds if len(world.map.faces) > 1]
    report = allworlds.check(
        "right_hand.py:goes_round", worlds=several, task=ROUND["task"], max_findings=1000, workers=1
    )
    wrong = {unrooted_code(finding.world.map) for finding in report.findings}
    assert wrong == {unrooted_code(world.map) for world in several}
    single = [world for world in worlds if world not in several]
    held = allworlds.check(
        "right_hand.py:goes_round", worlds=single, task=ROUND["task"], bound="2*m", workers=1
    )
    assert held.verdict.value == "holds"
    assert held.worlds + len(several) == len(worlds) == 86


def test_the_cleaner_that_forgets_to_turn_is_right_in_the_grid_from_every_start():
    report = allworlds.check("cleaner.py:forgets", worlds="grid.json", workers=1, **CLEANER)
    assert (report.verdict.value, report.runs) == ("holds", 48)


def covers(word, maps):
    """Whether a word visits every vertex of these rooted maps."""
    for map_ in maps:
        dart, visited = 0, {map_.vertex_of[0]}
        for offset in word:
            dart = map_.alpha[map_.turn(dart, offset)]
            visited.add(map_.vertex_of[dart])
        if len(visited) < map_.vertex_count:
            return False
    return True


def loaded(name, monkeypatch):
    monkeypatch.syspath_prepend(FIELD)
    return __import__(name)


def test_the_shortest_word_for_small_cubic_maps_is_found_by_trying_all(monkeypatch):
    universal = loaded("universal", monkeypatch)
    maps = [world.map for world in allworlds.worlds(edges=3, lighthouse="none", where="cubic")]
    found = universal.shortest_word(3)
    for length in range(1, len(found) + 1):
        good = [w for w in itertools.product(range(3), repeat=length) if covers(w, maps)]
        assert bool(good) == (length == len(found))
    assert covers([*map(int, found)], maps)


@pytest.mark.parametrize("name", EXPLORERS)
def test_each_file_is_short_and_says_where_it_is_from_and_what_to_expect(name):
    text = (FIELD / name).read_text(encoding="utf-8")
    told = ast.get_docstring(ast.parse(text))
    assert len(text.splitlines()) <= 120
    told = " ".join(told.split("\n\n    ")[0].split()) + told[told.index("\n    allworlds") :]
    for word in ("Source: ", "Lighthouse: ", "Task: ", "Expected: ", "    allworlds check "):
        assert word in told
    tried = {each[0].partition(":")[0] for each in [*HOLD, *REFUTED]}
    assert name in tried
    assert f"(field/{name})" in (FIELD.parent / "README.md").read_text(encoding="utf-8")
