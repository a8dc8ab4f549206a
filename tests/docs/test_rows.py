"""The page of rows names the columns that rows have."""

import re
from pathlib import Path

import pytest

import allworlds
from allworlds import ambiguity

pytestmark = pytest.mark.usefixtures("compiled")  # for worst

PAGE = (Path(__file__).parents[2] / "docs/how-to/rows.md").read_text(encoding="utf-8")


def told():
    """The columns by the command, as the page has them."""
    rows = re.findall(r"^\| (`.*?) \| (.*?) \| (`.*?) \|$", PAGE, re.MULTILINE)
    return {
        command: re.findall(r"`(\w+)`", columns)
        for commands, _, columns in rows
        for command in re.findall(r"`(.*?)`", commands)
    }


def compared(by):
    return allworlds.compare("folding", "algorithm1", edges=1, by=by)


MADE = {
    "check": lambda: allworlds.check(edges=1),
    "fuzz": lambda: allworlds.fuzz(edges=2, runs=1),
    "count": lambda: allworlds.count(edges=1),
    "run": lambda: allworlds.run("algorithm1", "k4"),
    "worst": lambda: allworlds.worst(edges=1),
    "compare": lambda: compared(None),
    "compare --by world": lambda: compared("world"),
    "compare --by run": lambda: compared("run"),
    "compare --to M --by size": lambda: allworlds.compare(
        "algorithm1", family="bouquet", to=12, draws=1, by="size"
    ),
    "ambiguity census": lambda: ambiguity.census(edges=1),
    "ambiguity class": lambda: ambiguity.class_of("k4"),
    "ambiguity twins": lambda: ambiguity.twins("k4", "k4"),
}


def test_the_page_names_these_commands():
    assert [*told()] == [*MADE]


@pytest.mark.parametrize("command", MADE)
def test_the_columns_are_those_of_the_page(command):
    rows = MADE[command]().records()
    assert rows
    assert all([*row] == told()[command] for row in rows)
