"""The tables of pages that are made from results: they are written, and true."""

import csv
import importlib
import io
import re
from statistics import mean

import pytest

from allworlds import compare, optimum, worst
from allworlds.reports import file_of
from evidence.write import (
    BOUNDS,
    CLAIMS,
    EXPLORERS,
    FIGURES,
    FOUR,
    PAPER,
    PLACES,
    against_the_adversary,
    beside_algorithm_1,
    beside_the_bound,
    between,
    claims_page,
    corridors,
    exponents,
    growth,
    large_worlds,
    placed,
    ratios,
    shields,
    six_edges,
    small_worlds,
)
from small import long


def rows(page, name):
    """The lines of a table of a page."""
    return between(page.read_text(encoding="utf-8"), name).strip().splitlines()


def test_the_page_of_claims_is_written():
    assert CLAIMS.read_text(encoding="utf-8") == claims_page()


def test_every_table_that_a_page_marks_is_written():
    for page in (PAPER, EXPLORERS):
        marked = re.findall(r"<!-- ([\w ]+): written by", page.read_text(encoding="utf-8"))
        assert marked == [name for where, name, _ in PLACES if where == page]


@pytest.mark.parametrize("far", [1, long(2)])
def test_the_table_of_the_adversary_is_that_of_its_runs(far):
    *_, row = against_the_adversary(far, far)
    assert rows(EXPLORERS, "adversary")[far + 1] == row


@pytest.mark.parametrize(
    ("page", "name", "lines"),
    [
        (PAPER, "worst", beside_the_bound),
        (EXPLORERS, "large worlds", large_worlds),
        (EXPLORERS, "ratios", ratios),
        (EXPLORERS, "exponents", exponents),
        (EXPLORERS, "corridors", corridors),
    ],
)
def test_a_table_of_kept_data_is_that_of_its_data(page, name, lines):
    assert rows(page, name) == [*lines()]


def test_the_kept_worst_cases_are_those_of_the_program():
    with BOUNDS.open(encoding="utf-8", newline="") as file:
        kept = {(int(row["edges"]), int(row["vertices"])): row for row in csv.DictReader(file)}
    for row in worst(edges=3).rows:
        told = kept[row.edges, row.vertices]
        found = (row.worst, row.bound, row.best)
        assert (told["worst"], told["bound_1_plus_2"], told["best_schedule"]) == (*map(str, found),)
    for row in optimum(edges=2).rows:
        known = [int(told["optimum"]) for (m, _), told in kept.items() if m == row.edges]
        assert max(known) <= row.optimum


def test_the_table_of_small_worlds_is_that_of_the_program_as_far_as_it_is_quick():
    found = [*small_worlds(3)]
    assert rows(EXPLORERS, "small worlds")[: len(found)] == found
    assert len(found) == 9


@pytest.mark.slow
@pytest.mark.long
def test_the_tables_of_small_worlds_are_those_of_the_program():
    assert rows(EXPLORERS, "small worlds") == [*small_worlds()]
    assert rows(EXPLORERS, "beside algorithm 1") == [*beside_algorithm_1()]


@pytest.mark.slow
def test_the_table_of_six_edges_is_that_of_the_program_as_far_as_it_is_compiled():
    head, line, one, bounds = six_edges(["algorithm1"])
    told = rows(EXPLORERS, "six edges")
    assert (told[:3], told[-1]) == ([head, line, one], bounds)
    numbers = [[int(cell.replace(",", "")) for cell in row.split("|")[3:10]] for row in told[2:]]
    assert len(numbers) == len(FOUR) + 1
    for costs in numbers[:-1]:
        assert all(cost <= bound for cost, bound in zip(costs, numbers[-1], strict=True))


@pytest.mark.slow
@pytest.mark.long
def test_the_table_of_shields_is_that_of_the_program():
    assert rows(EXPLORERS, "shields") == [*shields()]


def test_the_table_beside_algorithm_1_counts_every_world_once():
    told = rows(EXPLORERS, "beside algorithm 1")[2:]
    for row in told:
        assert sum(int(cell.replace(",", "")) for cell in row.split("|")[2:5]) == 8954
    assert len(told) == len(FOUR) - 1


def test_the_data_of_large_worlds_are_rows_of_the_program():
    report = compare("algorithm1", family="torus,dense", to=20, worlds=2, by="world")
    made = [*csv.DictReader(io.StringIO(file_of("compare", "csv", report)))]
    rows = [*growth().kept(made)]
    assert [*growth().by_family(rows)] == ["torus", "dense"]
    kept = growth().read()
    assert set(kept[0]) == set(rows[0])
    for row in rows:
        if row["edges"] == "18":
            # The same world is in the kept data, with the same numbers.
            assert row in kept


def test_the_kept_data_have_every_explorer_in_every_world():
    for rows in growth().by_family(growth().read()).values():
        worlds = [{(r["family"], r["seed"]) for r in rows if r["explorer"] == n} for n in FOUR]
        assert all(each == worlds[0] for each in worlds)
        assert len(rows) == len(FOUR) * len(worlds[0])


@pytest.mark.slow
def test_the_figure_of_greedy_is_drawn_from_the_kept_data(monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.syspath_prepend(FIGURES)
    greedy = importlib.import_module("greedy")
    figure = greedy.drawn()
    families = growth().by_family(growth().read())
    del families[greedy.LEFT_OUT]
    assert [panel.get_title() for panel in figure.axes] == [*families]
    assert len(families) == 12
    text = greedy.FILE.read_text(encoding="utf-8")
    assert all(f">{family}<" in text for family in families)
    for panel, rows in zip(figure.axes, families.values(), strict=True):
        for line, name in zip(panel.get_lines(), greedy.WHO, strict=True):
            costs = growth().costs(rows, name)
            assert [*line.get_ydata()] == pytest.approx([mean(some) for some in costs.values()])


def test_lines_are_placed_between_the_marks_of_their_name():
    text = "a\n<!-- x: written by tests/evidence/write.py -->\nold\n<!-- end of x -->\nb\n"
    new = placed(text, "x", iter(["1", "2"]))
    assert new == text.replace("old", "1\n2")
    assert between(new, "x") == "\n1\n2\n"
