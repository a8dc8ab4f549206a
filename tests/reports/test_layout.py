"""Tables and paragraphs in every width of a terminal."""

import pytest

from allworlds.reports.formats import text
from allworlds.reports.plain_text import table
from allworlds.studies.check.exhaustive import check
from allworlds.studies.run import run

HEADER = ["edges", "vertices", "worlds", "does"]
ROWS = [["1", "2", "1,000", "everything there is"], ["2", "10", "7", ""]]


def test_a_table_that_fits_has_a_line_for_each_row():
    assert table(HEADER, ROWS, "rrr", 45) == [
        "edges  vertices  worlds  does",
        "    1         2   1,000  everything there is",
        "    2        10       7",
    ]


def test_a_column_of_text_is_wrapped():
    assert table(HEADER, ROWS, "rrr", 37) == [
        "edges  vertices  worlds  does",
        "    1         2   1,000  everything",
        "                         there is",
        "    2        10       7",
    ]
    assert table(["says", "much"], [["so it is", "1"]], "lr", 11) == [
        "says   much",
        "so it     1",
        "is",
    ]


def test_a_number_is_never_wrapped_however_wide_it_is():
    assert table(["number", "text"], [[20 * "1", "a few words more"]], "rl", 30) == [
        "              number  text",
        f"{20 * '1'}  a few",
        "                      words",
        "                      more",
    ]


def test_a_table_that_is_too_wide_is_cut_into_tables_that_begin_with_the_same_columns():
    assert table(HEADER[:3], [row[:3] for row in ROWS], "rrr", 16) == [
        "edges  vertices",
        "    1         2",
        "    2        10",
        "",
        "edges  worlds",
        "    1   1,000",
        "    2       7",
    ]


@pytest.mark.parametrize("width", range(1, 50))
def test_no_cell_is_lost_in_any_width(width):
    told = " ".join(table(HEADER, ROWS, "rrr", width, keys=2)).split()
    cells = " ".join([*HEADER, *(cell for row in ROWS for cell in row)]).split()
    assert set(told) == set(cells)
    for cell in ("1,000", "everything"):
        assert told.count(cell) == 1


@pytest.mark.parametrize("width", [40, 50, 60, 80, 100])
def test_every_line_of_a_check_and_of_a_walk_is_within_the_width(width):
    walk = text(run("algorithm1", "theta"), width)
    told = text(check(edges=3), width).splitlines() + walk.splitlines()
    assert max(map(len, told)) <= width
    for step in range(9):
        assert f"\n{step:>4}  " in walk
