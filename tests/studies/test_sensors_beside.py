"""Explorers in a comparison, each under the lighthouse behind its name."""

import re

import pytest

from allworlds import check, compare
from allworlds.inputs.checks import InputError
from allworlds.reports.formats import text as text_of

DOOR, WORD = "algorithm1-door@door", "algorithm1-word@word:10*"


@pytest.fixture(scope="module")
def report():
    return compare("algorithm1@directional", DOOR, WORD, edges=2, lighthouse="cluster")


def test_each_runs_under_its_own_lighthouse_and_nobody_under_another(report):
    kinds = [str(one.lighthouse) for one in report.explorers]
    assert kinds == ["directional", "door", "word:10*"]
    assert [one.name for one in report.explorers] == ["algorithm1@directional", DOOR, WORD]
    for name in (DOOR, WORD):
        explorer, _, lighthouse = name.partition("@")
        checked = check(explorer, edges=2, lighthouse=lighthouse).to_json()["rows"]
        costs = {(row["edges"], row["vertices"]): row["max_cost"] for row in checked}
        assert {(row.edges, row.vertices): row.worst[name] for row in report.rows} == costs


def test_there_is_a_column_for_each(report):
    lines = text_of(report, 120).split("\n")
    (header,) = (
        i for i, line in enumerate(lines) if line.startswith("edges  vertices  worlds  alg")
    )
    assert re.split("  +", lines[header])[3:] == ["algorithm1@directional", DOOR, WORD]
    assert re.split("  +", lines[header + 1].strip())[3:] == ["1.00 (1)", "3.00 (3)", "4.00 (5)"]


def test_one_explorer_under_two_lighthouses_is_two(report):
    report = compare(WORD, "algorithm1-word@word:1020*", "algorithm1-word", edges=1)
    assert [str(one.lighthouse) for one in report.explorers] == [
        "word:10*",
        "word:1020*",
        "word:120*",
    ]
    assert "algorithm1-word@word:1020*  algorithm1-word" in text_of(report, 120)


def test_of_worlds_that_grow_one_is_shown_again_with_its_lighthouse():
    report = compare(WORD, DOOR, family="lattice", to=12, draws=1, places=1)
    assert "allworlds run algorithm1-word --lighthouse 'word:10*' --family" in text_of(report, 120)


@pytest.mark.parametrize(
    ("names", "error"),
    [
        (["algorithm1@dor", DOOR], "lighthouse 'dor' is not one of"),
        (["algorithm1@", DOOR], "lighthouse '' is not one of"),
        ([DOOR, DOOR], f"explorer '{DOOR}' is named twice"),
        (["a@b/c.py:explore", DOOR], "a@b/c.py"),
        (["algorithm@door", DOOR], "algorithm"),
    ],
)
def test_a_name_that_is_none_is_refused(names, error):
    with pytest.raises(InputError, match=re.escape(error)):
        compare(*names, edges=1)


def test_the_world_that_differs_most_is_lit_by_the_lighthouse_of_the_first():
    for first, second, kind in (
        ("algorithm1", "algorithm1-door", "directional"),
        ("algorithm1-door", "algorithm1", "door"),
    ):
        assert compare(first, second, edges=2).differ_most.world.lighthouse.kind == kind
