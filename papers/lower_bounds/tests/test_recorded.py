"""The data that are kept of large worlds and of bouquets: the program finds the same again."""

import csv
import importlib
import io
from statistics import mean

import pytest

from allworlds import compare
from allworlds.reports.formats import file_of
from bouquets import bound_of_information, bouquets, cautious_cost, number_of_bouquets, told_apart
from optima import fewest_traversals
from paper_claims import PAPER

FOUR = ("algorithm1", "remembering", "greedy", "prudent")
FIGURES = PAPER / "figures"


@pytest.fixture
def growth(monkeypatch):
    """The module that reads the data of large worlds."""
    monkeypatch.syspath_prepend(FIGURES)
    return importlib.import_module("growth")


def test_the_data_of_large_worlds_are_rows_of_the_program(growth):
    report = compare("algorithm1", family="torus,dense", to=20, draws=2, by="world")
    made = [*csv.DictReader(io.StringIO(file_of("csv", report)))]
    rows = [*growth.kept(made)]
    assert [*growth.by_family(rows)] == ["torus", "dense"]
    kept = growth.read()
    assert set(kept[0]) == set(rows[0])
    for row in rows:
        if row["edges"] == "18":
            # The same world is in the kept data, with the same numbers.
            assert row in kept


def test_the_kept_data_have_every_explorer_in_every_world(growth):
    for rows in growth.by_family(growth.read()).values():
        worlds = [{(r["family"], r["seed"]) for r in rows if r["explorer"] == n} for n in FOUR]
        assert all(each == worlds[0] for each in worlds)
        assert len(rows) == len(FOUR) * len(worlds[0])


def test_the_optimum_in_bouquets_is_the_one_that_is_kept():
    with (FIGURES / "optimum-bouquets.csv").open(encoding="utf-8", newline="") as file:
        kept = {int(row["loops"]): row for row in csv.DictReader(file)}
    for loops, row in kept.items():
        worlds = number_of_bouquets(loops)
        assert int(row["worlds"]) == worlds
        assert int(row["information"]) == bound_of_information(worlds)
        assert int(row["cautious"]) == cautious_cost(loops)
    for loops in (1, 2, 3):
        assert int(kept[loops]["optimum"]) == fewest_traversals(bouquets(loops), told_apart)


def test_the_figure_of_greedy_is_drawn_from_the_kept_data(growth):
    pytest.importorskip("matplotlib")
    greedy = importlib.import_module("greedy")
    figure = greedy.drawn()
    families = growth.by_family(growth.read())
    del families[greedy.LEFT_OUT]
    assert [panel.get_title() for panel in figure.axes] == [*families]
    assert len(families) == 12
    text = greedy.FILE.read_text(encoding="utf-8")
    assert all(f">{family}<" in text for family in families)
    for panel, rows in zip(figure.axes, families.values(), strict=True):
        for line, name in zip(panel.get_lines(), greedy.WHO, strict=True):
            costs = growth.costs(rows, name)
            assert [*line.get_ydata()] == pytest.approx([mean(some) for some in costs.values()])
