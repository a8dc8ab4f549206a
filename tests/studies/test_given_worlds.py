"""Checks of worlds that the user gives."""

import pytest

import allworlds
from allworlds.inputs.checks import InputError
from allworlds.reports.formats import file_of, text

WRONG = """
from allworlds import Move


def goes_on(first):
    while True:
        yield Move(1)
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "mine.py").write_text(WRONG)
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("workers", [1, 2])
def test_given_worlds_are_tried_as_they_are_in_a_check_of_all(workers):
    given = allworlds.worlds(edges=3, places="all")
    report = allworlds.check("folding", worlds=given, workers=workers)
    every = allworlds.check("folding", edges=3)
    assert (report.verdict, report.exit_code) == (every.verdict, 0)
    assert (report.worlds, report.runs) == (every.runs, every.runs)
    assert report.traversals == every.traversals
    for one, all_ in zip(report.rows, every.rows, strict=True):
        assert (one.edges, one.vertices, one.max_cost) == (all_.edges, all_.vertices, all_.max_cost)
    scope = report.to_json()["scope"]
    assert (scope["given"], scope["gate"], scope["complete"]) == (every.runs, "absent", True)
    assert "given" not in every.to_json()["scope"]
    said = text(report, 1000)
    assert f"each of {every.runs} given worlds of the class 'maps'" in said
    assert "absent, as the worlds are given" in said


def test_a_world_may_be_numbered_in_any_way():
    (world,) = [w for w in allworlds.worlds(edges=4, where="trees") if w.map.vertex_count == 5][:1]
    names = [*range(3, 8), 0, 1, 2]
    first, second = (
        allworlds.check(worlds=[each]).to_json() for each in (world, world.relabelled(names))
    )
    assert first["rows"] == second["rows"]
    assert first["witnesses"] == second["witnesses"]


def test_a_refuted_world_is_found_and_is_not_said_to_be_the_smallest(folder):
    given = [*allworlds.worlds(edges=2, lighthouse="none")]
    report = allworlds.check("mine.py:goes_on", worlds=given, task="cover:edges", workers=1)
    (finding,) = report.findings
    assert finding.law == "budget"
    assert finding.world in given
    assert finding.confirmed
    assert not finding.minimal
    assert "every given world with 2 edges" in file_of("junit", report)
    alone = allworlds.check("mine.py:goes_on", worlds=given[:2], task="cover:edges", workers=1)
    assert alone.verdict.value == "holds"


def test_schedules_and_rules_apply_to_given_worlds():
    given = [*allworlds.worlds(edges=3, where="cubic")]
    every = allworlds.check(worlds=given, schedules="all")
    assert sum(row.episodes for row in every.rows) > every.runs == 5
    bounded = allworlds.check(worlds=given, bound="m")
    assert {finding.law for finding in bounded.findings} == {"bound"}


def test_an_engine_that_cannot_do_it_says_so():
    given = [*allworlds.worlds(edges=3)]
    with pytest.raises(
        InputError, match="'kernel' tries every map of a class, and no given worlds"
    ):
        allworlds.check(worlds=given, engine="kernel")


@pytest.mark.parametrize(
    ("worlds", "options", "said"),
    [
        ([], {}, "is empty"),
        (3, {}, "worlds = 3 is no series of worlds"),
        ([3], {}, r"worlds\[0\] = 3 is no World"),
        ([3], {"edges": 3}, "is no World"),
        (
            None,
            {"lighthouse": "none"},
            "lighthouse = 'none', but 2 given worlds have 'directional'",
        ),
        (None, {"run": "rd"}, "run keeps no worlds that live in this process alone"),
        (
            None,
            {"order": "clockwise"},
            "order = 'clockwise' has no effect without worlds of a file",
        ),
        (None, {"graph": "k4"}, "graph = 'k4' cannot be given together with worlds"),
    ],
)
def test_what_is_no_series_of_worlds_is_refused_in_one_line(worlds, options, said, folder):
    given = allworlds.worlds(edges=1) if worlds is None else worlds
    with pytest.raises(InputError, match=said) as error:
        allworlds.check(worlds=given, **options)
    assert "\n" not in str(error.value)


def test_class_condition_and_bounds_narrow_given_worlds():
    given = [*allworlds.worlds(edges=3, places="all")]
    for bound in ({"map_class": "simple"}, {"where": "cubic"}, {"vertices": 2}, {"edges": 2}):
        some = allworlds.check("folding", worlds=given, **bound)
        every = allworlds.check("folding", **{"edges": 3, **bound})
        assert (some.runs, some.traversals) == (every.runs, every.traversals)


def test_two_lighthouses_are_refused():
    given = [*allworlds.worlds(edges=1), *allworlds.worlds(edges=1, lighthouse="none")]
    with pytest.raises(InputError, match=r"worlds\[0\] has .*, and worlds\[2\] has 'none'"):
        allworlds.check(worlds=given)
