"""Checks and counts of classes that are narrowed, by ours and by the user's own."""

import signal

import pytest

import allworlds
from allworlds.engines.limits import models_bounded
from allworlds.inputs.checks import InputError
from allworlds.maps import counting
from allworlds.reports.formats import text
from small import slowest

PREDICATES = """
import os
import time

def even(map_):
    return all(degree % 2 == 0 for degree in map_.degrees)


def below(edges):
    return lambda map_: map_.edge_count < edges


def first_dart(map_):
    return map_.vertex_of[0] == map_.vertex_of[1]


def raises(map_):
    return 1 // 0


def says_one(map_):
    return 1


def by_hash(map_):
    return map_.vertex_count < 2 or map_.edge_count == 3 and hash("lamp") % 2 == 0


def by_hash_in_large_ones(map_):
    return map_.vertex_count < 2 or map_.edge_count == 5 and hash("lamp") % 2 == 0


def ends_players(map_):
    if map_.edge_count > 3 and "ALLWORLDS_PLAYER" in os.environ:
        os.kill(os.getpid(), 9)
    return True


def endless(map_):
    while map_.edge_count > 3:
        try:
            time.sleep(0.01)
        except Exception:
            pass
    return True


def endless_at_once(map_):
    while True:
        pass


nothing = 3


def goes_on(first):
    from allworlds import Move

    while True:
        yield Move(1)


def explore(first, *, choices):
    from allworlds.explorers.builtin.algorithm1 import algorithm1

    return (yield from algorithm1(first, choices=choices))
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "mine.py").write_text(PREDICATES)
    (tmp_path / "alone.py").write_text(PREDICATES)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(("where", "worlds"), [("eulerian", 11), ("trees", 8), (None, 86)])
@pytest.mark.parametrize("workers", [1, 2])
def test_a_check_is_of_the_maps_of_which_it_is_true(where, worlds, workers):
    report = allworlds.check(edges=3, where=where, workers=workers)
    expected = sum(1 for _ in allworlds.worlds(edges=3, where=where))
    assert report.verdict.value == "holds"
    assert report.worlds == expected
    gate = report.to_json()["scope"]["gate"]
    assert sum(cell["counted"] for cell in gate) == sum(cell["enumerated"] for cell in gate)
    assert sum(cell["counted"] for cell in gate) == expected
    assert report.to_json()["scope"].get("where") == where


def test_several_conditions_add_up(folder, cli):
    several = ["girth:2", "alone.py:even", "girth:2"]
    report = allworlds.check("mine.py:explore", edges=3, where=several, workers=1)
    assert report.to_json()["scope"]["where"] == "girth:2 and alone.py:even"
    both = [
        world
        for world in allworlds.worlds(edges=3, where="girth:2")
        if all(degree % 2 == 0 for degree in world.map.degrees)
    ]
    assert report.worlds == len(both) > 0
    assert report.worlds < sum(1 for _ in allworlds.worlds(edges=3, where="alone.py:even"))
    code, out, _ = cli("count", "--edges", "4", "--where", "trees", "--where", "regular:1")
    assert code == 0
    assert out.startswith("COUNTED    1 rooted map of the class 'maps', trees and regular:1,")
    with pytest.raises(InputError, match=r"^where 'foo' is not one of cubic"):
        allworlds.count(edges=2, where="cubic and foo")


def test_a_predicate_of_ones_own_is_the_same_as_ours(folder):
    ours = allworlds.check("mine.py:explore", edges=3, where="eulerian", workers=1)
    theirs = allworlds.check("mine.py:explore", edges=3, where="alone.py:even", workers=2)
    assert ours.rows == theirs.rows
    assert "no formula counts" in text(theirs, 100)
    same = allworlds.check("mine.py:explore", edges=2, where="mine.py:even", workers=1)
    assert same.scope.shared_file == "mine.py"
    assert theirs.scope.shared_file == ""
    with pytest.raises(InputError, match="does not know the condition"):
        allworlds.check(edges=3, where="alone.py:even", engine="kernel")


def test_a_count_is_compared_with_the_source_of_the_condition_if_it_has_one(folder):
    report = allworlds.count(edges=4, where="trees")
    assert [row.rooted for row in report.rows] == [1, 2, 5, 14]
    assert report.gate.source == "Catalan numbers"
    assert report.gate.agrees
    assert "(Catalan numbers)" in text(report, 1000)
    assert allworlds.count(edges=9, where="cubic").rows[-1].rooted == 1105  # OEIS A062980
    own = allworlds.count(edges=4, where="mine.py:below?edges=3")
    assert own.rows[-1].rooted == 0
    assert own.to_json()["gate"] is None
    assert own.exit_code == 0
    assert "no formula counts" in text(own, 100)
    assert allworlds.count(edges=2, where="girth:9", map_class="maps").rows[0].rooted == 1


def test_a_wrong_count_under_a_condition_is_an_error(monkeypatch):
    right = counting.catalan
    monkeypatch.setattr(counting, "catalan", lambda m: right(m) + (m == 3))
    assert allworlds.count(edges=3, where="trees").exit_code == 70
    report = allworlds.check(edges=3, where="trees")
    assert report.verdict.value == "error"
    assert "but the independent count (Catalan numbers) is 6" in text(report, 1000)
    assert allworlds.ambiguity.census(edges=3, where="trees").exit_code == 70


@pytest.mark.parametrize("where", ["cubic", "alone.py:even", "genus:2"])
def test_random_worlds_under_a_condition(where, folder):
    options = {"edges": 9, "min_edges": 5, "runs": 20, "where": where}
    report = allworlds.fuzz("algorithm1", workers=1, **options)
    assert report.verdict.value == "not-refuted"
    assert report.runs == 20
    assert report.scope.where == where
    assert {row.edges for row in report.rows} <= {5, 6, 7, 8, 9}
    assert where != "cubic" or {row.edges for row in report.rows} == {6, 9}
    assert allworlds.fuzz("algorithm1", workers=2, **options).rows == report.rows


def test_explorers_are_compared_in_it():
    report = allworlds.compare("algorithm1", "folding", edges=3, where="trees")
    assert sum(row.runs for row in report.rows if row.edges == 3) > 0
    assert {row.vertices - row.edges for row in report.rows} == {1}


def test_a_run_directory_is_of_its_content(folder):
    first = allworlds.check(edges=2, where="alone.py:even", run="rd")
    assert allworlds.merge("rd").to_json()["rows"] == first.to_json()["rows"]
    (folder / "alone.py").write_text(PREDICATES + "\n")
    with pytest.raises(InputError, match="is of another text of 'alone"):
        allworlds.check(edges=2, where="alone.py:even", run="rd")


def test_where_nothing_is_true_the_check_is_vacuous(folder):
    assert allworlds.check(edges=2, where="mine.py:below?edges=1").verdict.value == "vacuous"


@pytest.mark.parametrize(
    ("where", "said"),
    [
        ("mine.py:first_dart", "is no function of the map: asked twice about .*, it says"),
        ("mine.py:raises", "raises ZeroDivisionError"),
        ("mine.py:says_one", "returns 1, not True or False"),
        ("mine.py:nothing", "is no function, but 3"),
        ("mine.py:below?vertices=3", r"unexpected keyword argument 'vertices'; legal is \(edges"),
        ("mine.py:absent", "has no 'absent'"),
        ("planar", "'planar' is not one of cubic, regular:D"),
    ],
)
def test_what_is_no_condition_is_refused_in_one_line(folder, where, said):
    with pytest.raises(InputError, match=said) as error:
        allworlds.check(edges=2, where=where)
    assert "\n" not in str(error.value)


@pytest.mark.processes
@pytest.mark.parametrize(
    "asked",
    [
        lambda where: allworlds.count(edges=3, where=where),
        lambda where: allworlds.check(edges=3, where=where),
        lambda where: allworlds.check("alone.py:explore", edges=3, where=where, workers=2),
        slowest(
            lambda where: allworlds.compare("alone.py:explore", "folding", edges=3, where=where)
        ),
        slowest(lambda where: allworlds.fuzz(edges=3, runs=16, where=where)),
        slowest(lambda where: allworlds.ambiguity.census(edges=3, where=where)),
    ],
)
def test_a_predicate_that_is_another_one_in_other_processes_is_refused_by_name(folder, asked):
    with pytest.raises(InputError, match=r"^where 'mine.py:by_hash' is no function of the map: "):
        asked("mine.py:by_hash")


@pytest.mark.slowest
@pytest.mark.processes
def test_a_predicate_is_asked_again_in_large_maps_too(folder):
    with pytest.raises(InputError, match=r"same maps of the unit 5:"):
        allworlds.count(edges=5, where="mine.py:by_hash_in_large_ones")


@pytest.mark.processes
def test_a_predicate_that_ends_processes_is_named(folder):
    with pytest.raises(InputError, match=r"^where 'mine.py:ends_players': a process that asked"):
        allworlds.count(edges=4, where="mine.py:ends_players")


def test_the_time_limit_ends_a_predicate_that_does_not(folder, cli):
    code, _, _ = cli("count", "--edges", "4", "--where", "mine.py:endless", "--time-limit", "0.2")
    assert code == 3
    assert signal.getsignal(signal.SIGALRM) == signal.SIG_DFL
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)


def test_the_time_limit_ends_a_predicate_that_is_tried(folder, cli):
    where = "mine.py:endless_at_once"
    code, _, err = cli("count", "--edges", "4", "--where", where, "--time-limit", "0.2")
    assert code == 3
    assert "the time limit was reached in where 'mine.py:endless_at_once'" in err


def test_what_is_not_bounded_where_the_alarm_is_somebody_elses():
    ours = signal.signal(signal.SIGALRM, signal.SIG_IGN)
    try:
        with models_bounded(0.0):
            assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
    finally:
        signal.signal(signal.SIGALRM, ours)
