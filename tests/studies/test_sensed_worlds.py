"""The census of any lighthouse."""

import pytest

import allworlds
from allworlds.inputs import InputError
from allworlds.maps import Labelled, classes_of_union
from allworlds.reports import text
from allworlds.world import worlds
from models import PARITY

census = allworlds.ambiguity.census


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "parity.py").write_text(PARITY)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_copy_of_position_has_the_census_of_position(folder):
    ours, theirs = census(edges=4), census(edges=4, lighthouse="parity.py:Copy")
    assert ours.rows == theirs.rows
    assert (ours.pair, len(theirs.pair)) == ((), 2)
    assert ours.scope.lighthouse == "position"
    assert ours.rows[-1].ambiguous_worlds > 0


@pytest.mark.parametrize("kind", ["directional", "cluster:single=true", "labels"])
def test_where_every_world_can_be_known_none_is_ambiguous(kind):
    report = census(edges=3, lighthouse=kind)
    assert [row.ambiguous_worlds for row in report.rows] == [0, 0, 0]
    assert report.pair == ()
    assert all(row.marked_worlds for row in report.rows)


@pytest.mark.parametrize("kind", ["none", "compass", "natural", "position+told:n,m"])
def test_parts_are_those_that_comparing_every_two_worlds_gives(kind):
    found = {}
    for world in worlds(edges=2, lighthouse=kind, places="all"):
        for part in found.setdefault(world.map.edge_count, []):
            other = part[0]
            pair = [Labelled(w.map, w.percepts, w.start) for w in (world, other)]
            # Starts are all there: two worlds are of one part if some starts look the same.
            first, second = classes_of_union(*pair)
            if set(first) & set(second) and world.told == other.told:
                part.append(world)
                break
        else:
            found[world.map.edge_count].append([world])
    report = census(edges=2, lighthouse=kind)
    for row in report.rows:
        parts = found.get(row.edges, [])
        shapes = [{len(world.map.sigma) for world in part} for part in parts]
        assert all(len(shape) == 1 for shape in shapes)
        assert (row.classes > 0) <= any(len(part) > 1 for part in parts)
        if row.classes == 0:
            assert row.marked_worlds == len(parts)


def test_the_smallest_pair_comes_with_a_proof(folder):
    report = census(edges=3, lighthouse="parity.py:Parity")
    one, other = report.pair
    assert allworlds.twins(one, other).distinguishable is False
    assert report.bisimulation == allworlds.twins(one, other).bisimulation
    first = next(row for row in report.rows if row.classes)
    assert one.map.edge_count == first.edges
    assert text("ambiguity census", report, 100)


def test_what_is_told_tells_worlds_apart():
    free, told = (census(edges=3, lighthouse=kind) for kind in ("none", "told:n,m,g"))
    assert free.rows[-1].classes > 0
    assert told.rows[-1].ambiguous_worlds < free.rows[-1].ambiguous_worlds


def test_it_is_the_same_from_a_run_directory(folder):
    asked = {"edges": 3, "lighthouse": "parity.py:Parity"}
    whole = census(**asked)
    assert census(run="rd", **asked).to_json() == census(run="rd", **asked).to_json()
    assert census(run="rd", **asked).rows == whole.rows
    (folder / "parity.py").write_text(PARITY + "\n")
    with pytest.raises(InputError, match="is of another text of 'parity"):
        census(run="rd", **asked)


def test_where_the_robot_leaves_marks_there_is_no_census():
    for kind in ("movable", "whiteboard", "compass+ports"):
        with pytest.raises(InputError, match="leaves marks itself"):
            census(edges=2, lighthouse=kind)


def test_a_census_of_a_narrower_class_is_compared_with_its_own_source():
    report = census(edges=3, where="trees")
    assert report.to_json()["gate"] == {"source": "Catalan numbers", "agrees": True}
    assert report.exit_code == 0
    assert report.rows[-1].marked_worlds < census(edges=3).rows[-1].marked_worlds
