"""The figure of the bound: its content against other roads to it, and what is kept of it."""

import csv
import sys
from collections import defaultdict

import pytest
from msgspec import structs

import figure_bounds as program
from allworlds.documents.document import replace
from allworlds.outcome import Interrupted
from drawn import write
from optima import optimum
from paper_claims import PAPER

KEPT = PAPER / "figures" / "figure-bounds.csv"


@pytest.fixture(scope="module")
def cells():
    """All worlds with at most 3 edges, and the two smallest corridors."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(program, "MOST_FAR", 2)
        yield program.figure_bounds(3)


def test_the_optimum_of_all_sizes_together_is_no_less_than_that_of_each(cells):
    assert cells.right
    largest = defaultdict(int)
    for cell in cells.cells:
        largest[cell.edges] = max(largest[cell.edges], cell.optimum)
    for edges, together in enumerate(optimum(None, edges=3).figures["optimum"], 1):
        assert largest[edges] <= together
    # Whoever knows m and n has no better worst case here than who knows m.
    assert largest == {1: 0, 2: 1, 3: 4}


def test_a_worst_case_above_the_bound_or_below_the_optimum_is_refuted(cells):
    for spoilt in ({"worst": 10**6}, {"worst": 0, "best": 0}, {"optimum": 10**6}):
        wrong = (replace(cells.cells[-1], **spoilt), *cells.cells[:-1])
        assert not replace(cells, cells=wrong).right
    for spoilt in ({"cost": 95}, {"cost": 10**6}):
        wrong = (replace(cells.corridors[0], **spoilt), *cells.corridors[1:])
        assert not replace(cells, corridors=wrong).right
    disagrees = structs.replace(cells.report.rows[0], worlds=7)
    assert not replace(cells, report=structs.replace(cells.report, rows=(disagrees,))).right


def test_what_is_kept_are_rows_of_the_program(cells):
    header, rows = cells.table()
    with KEPT.open(encoding="utf-8", newline="") as file:
        names, *kept = csv.reader(file)
    assert names == header
    for row in rows:
        assert ["" if cell is None else str(cell) for cell in row] in kept
    assert len(kept) == 35 + 3


def test_the_costs_against_the_adversary_stand_in_the_table(cells):
    header, rows = cells.table()
    first, second = (dict(zip(header, row, strict=True)) for row in rows[-2:])
    assert (first["edges"], first["vertices"], first["adversary"]) == (28, 4, 882)
    assert first["testers_at_least"] == 96
    assert (second["far_hubs"], second["edges"], second["adversary"]) == (2, 91, 11735)


def test_nothing_known_is_drawn_as_nothing(cells, tmp_path):
    pytest.importorskip("matplotlib")
    some = structs.replace(cells.report, ending=Interrupted(), rows=())
    empty = replace(cells, report=some, cells=())
    assert empty.caption() == ("Interrupted before anything was known.",)
    write(empty, tmp_path / "f.png")
    assert (tmp_path / "f.png").read_bytes()[1:4] == b"PNG"


def test_a_panel_is_drawn_for_each_size_and_one_for_corridors_the_same_each_time(
    cells, tmp_path, monkeypatch, capsys
):
    pytest.importorskip("matplotlib")
    files = [tmp_path / f"{i}.svg" for i in range(2)]
    monkeypatch.setattr(program, "figure_bounds", lambda _edges: cells)
    for file in files:
        monkeypatch.setattr(sys, "argv", ["figure_bounds.py", "--edges", "3", "--out", str(file)])
        assert program.main() == 0
    assert cells.caption()[0] in capsys.readouterr().out
    first, second = (file.read_text(encoding="utf-8") for file in files)
    assert first == second
    assert all(f">n = {vertices}<" in first for vertices in (1, 2, 3, 4))
    assert ">corridors<" in first
    spoilt = (replace(cells.corridors[0], cost=95),)
    monkeypatch.setattr(program, "figure_bounds", lambda _: replace(cells, corridors=spoilt))
    assert program.main() == 1
