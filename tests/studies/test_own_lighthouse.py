"""A lighthouse of the user's own, wherever worlds are made."""

import re

import pytest

import allworlds
from allworlds import World
from allworlds.engines import user_code_checks
from allworlds.inputs.checks import InputError
from allworlds.maps import named_map
from allworlds.reports.drawing.text import draw as in_characters
from allworlds.reports.formats import text
from allworlds.reports.parts import scene_of
from allworlds.world import Labelling
from allworlds.world.lighthouses.kinds import lighthouse_kind
from models import PARITY

EXPLORER = """
from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first, *, choices):
    return (yield from algorithm1(first, choices=choices))
"""

TOLD = '''
from allworlds import CombinatorialMap, Estimate, Move


def counts(first, *, told):
    """Right where the map has one edge: it says what it has been told."""
    if told == {"n": 1, "m": 1}:
        return Estimate(CombinatorialMap((1, 0), (1, 0)), 0)
    told.clear()
    yield Move(0)
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 1)


def asks(depth=1):
    def run(first):
        for _ in range(depth):
            yield Move(0)
        return Estimate(CombinatorialMap((0, 1), (1, 0)), depth % 2)

    return run
'''


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "parity.py").write_text(PARITY)
    (tmp_path / "mine.py").write_text(EXPLORER)
    (tmp_path / "both.py").write_text(PARITY + EXPLORER)
    (tmp_path / "told.py").write_text(TOLD)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_with_so_many_bearings_that_none_is_lost_it_is_as_good_as_directional(folder):
    report = allworlds.check("mine.py:explore", edges=3, lighthouse="parity.py:Parity:modulus=9")
    ours = allworlds.check(edges=3)
    assert report.verdict.value == "holds"
    assert (report.runs, report.traversals) == (ours.runs, ours.traversals)


def test_the_compiled_engine_says_that_it_does_not_know_it(folder):
    with pytest.raises(InputError, match="does not know the lighthouse"):
        allworlds.check(edges=2, lighthouse="parity.py:Parity", engine="kernel")
    assert allworlds.check(edges=5, lighthouse="parity.py:Copy", max_findings=1).engine == "python"


def test_an_explorer_in_the_same_file_is_told_of_in_the_scope(folder):
    asked = {"edges": 1, "workers": 1}
    same = allworlds.check("both.py:explore", lighthouse="both.py:Parity", **asked)
    apart = allworlds.check("mine.py:explore", lighthouse="both.py:Parity", **asked)
    assert same.to_json()["scope"]["shared_file"] == "both.py"
    assert "both.py holds the explorer, and code that judges it" in text(same, 100)
    assert "shared_file" not in apart.to_json()["scope"]


def test_an_error_in_it_ends_a_check_whoever_comes_upon_it(folder):
    (folder / "late.py").write_text(
        PARITY.replace("return Percept", "assert map_.edge_count < 2\n        return Percept")
    )
    for explorer in ("algorithm1", "mine.py:explore"):
        with pytest.raises(InputError, match=r"^lighthouse 'late.py:Parity': sensed raises"):
            allworlds.check(explorer, edges=2, lighthouse="late.py:Parity", workers=1)


LATE = """
from allworlds import Drop, Estimate, Lighthouse, Move


class Chalk(Lighthouse):
    leaves_marks = True

    @classmethod
    def places(cls, map_, start):
        yield cls()

    def refusal(self, action, lying, hand):
        return "" if type(action) is Drop else "a Move or Drop"

    def acted(self, map_, state, action):
        return state if map_.edge_count < 4 else 5

    def left_marks(self, map_, state):
        return 0 if map_.edge_count < 5 else 1 // 0


def drops(first):
    yield Drop()
    while True:
        yield Move(1)
"""


@pytest.mark.parametrize("workers", [1, 2])
def test_an_error_in_marks_beyond_the_trial_is_no_fault_of_the_explorer(folder, workers):
    (folder / "late.py").write_text(LATE)
    (folder / "drops.py").write_text(LATE)
    asked = {"lighthouse": "late.py:Chalk", "task": "cover", "where": "trees", "workers": workers}
    held = allworlds.check("drops.py:drops", edges=3, **asked)
    assert held.verdict.value == "holds"
    for verb, more in ((allworlds.check, {}), (allworlds.fuzz, {"runs": 20})):
        with pytest.raises(InputError, match=r"^acted of the lighthouse .late.py:Chalk. gives 5"):
            verb("drops.py:drops", edges=4, **asked, **more)


def test_what_is_told_is_a_dictionary_and_each_play_gets_its_own(folder):
    report = allworlds.check("told.py:counts", edges=1, lighthouse="told:n,m", workers=1)
    assert report.verdict.value == "holds"
    world = next(allworlds.worlds(edges=1, lighthouse="position+told:m"))
    assert "told before the start" in text(allworlds.run("told.py:counts", world), 100)


def test_arguments_of_a_name_make_an_explorer(folder):
    for depth in (2, 3):
        report = allworlds.check(f"told.py:asks?depth={depth}", edges=1, map_class="simple")
        assert report.verdict.value == ("holds" if depth < 2 else "refuted")
        assert report.findings[0].explorer == f"told.py:asks?depth={depth}"
        assert max(row.max_cost for row in report.rows) == depth
        assert allworlds.replay(report.findings[0]).outcome == "reproduced"
    with pytest.raises(InputError, match=r"unexpected keyword argument 'width'; legal is \(depth"):
        allworlds.check("told.py:asks?width=2", edges=1)


ANOTHER = """
import os
from dataclasses import dataclass
from allworlds import CombinatorialMap, Estimate, Lighthouse, Move, Percept

SEEN = set()


class Base(Lighthouse):
    @classmethod
    def places(cls, map_, start):
        yield cls(start)

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], self.marks(map_))


@dataclass(frozen=True)
class ByProcess(Base):
    dart: int

    def marks(self, map_):
        return os.getpid()


@dataclass(frozen=True)
class AfterAnother(Base):
    dart: int

    def marks(self, map_):
        SEEN.add(map_.edge_count)
        return int(map_.edge_count == 1 and 2 in SEEN)


@dataclass(frozen=True)
class Tells(Base):
    dart: int

    def marks(self, map_):
        return 0

    def told(self, map_):
        return os.getpid()


@dataclass(frozen=True)
class Constant(Base):
    dart: int

    def marks(self, map_):
        return 3


def wrong(first, told=None):
    yield Move(0)
    return Estimate(CombinatorialMap((1, 0), (1, 0)), 0)
"""


ASKED = {
    "check": lambda kind: allworlds.check("another.py:wrong", edges=2, lighthouse=kind, workers=1),
    "run": lambda kind: allworlds.run("another.py:wrong", "edge", lighthouse=kind),
}


@pytest.mark.processes
@pytest.mark.parametrize(
    ("verb", "kind"),
    [
        ("check", "ByProcess"),
        ("check", "AfterAnother"),
        ("check", "Tells"),
        ("check", "ByProcess+told:n"),
        ("run", "ByProcess"),
    ],
)
def test_a_lighthouse_that_is_another_one_in_other_processes_refutes_nothing(
    folder, monkeypatch, verb, kind
):
    monkeypatch.setattr(user_code_checks, "PROCESSES", 1)
    (folder / "another.py").write_text(ANOTHER)
    said = re.escape(f"lighthouse 'another.py:{kind}' is no function of its map and place: ")
    with pytest.raises(InputError, match=said):
        ASKED[verb](f"another.py:{kind}")


@pytest.mark.processes
def test_a_lighthouse_that_is_the_same_is_asked_again_and_the_finding_stands(folder):
    (folder / "another.py").write_text(ANOTHER)
    (found,) = ASKED["check"]("another.py:Constant").findings
    assert found.confirmed


HOLE = """
from dataclasses import dataclass, replace

from allworlds import Lighthouse, Percept


@dataclass(frozen=True)
class Hole(Lighthouse):
    dart: int
    hole: int
    wells: tuple
    depth: int = 1

    @classmethod
    def places(cls, map_, start):
        for hole in map_.darts:
            yield cls(start, hole, (0, 3))

    def relabelled(self, names):
        wells = tuple(names[dart] for dart in self.wells)
        return replace(self, dart=names[self.dart], hole=names[self.hole], wells=wells)

    def sensed(self, map_, here):
        there = map_.vertex_of[here] == map_.vertex_of[self.hole]
        return Percept(map_.degree_at[here], int(there))
"""


def test_what_stands_in_a_world_is_drawn_with_the_names_of_its_fields(folder):
    (folder / "hole.py").write_text(HOLE)
    kind = lighthouse_kind("hole.py:Hole").as_class
    path = named_map("path-3")
    world = World(path, kind(0, 2, (0, 3)), 0)
    assert scene_of(world).vertices == ["v0 wells", "v1 hole", "v2 wells"]
    assert "v1 hole" in in_characters(scene_of(world), 80)
    named = World(path, kind(0, 2, (0, 3)), 0, labels=Labelling("", ("a", "b", "c")))
    assert [*scene_of(named).vertices] == ["a wells", "b hole", "c wells"]
    parity = World(path, lighthouse_kind("parity.py:Parity").as_class(0), 0)
    assert scene_of(parity).vertices == ()
