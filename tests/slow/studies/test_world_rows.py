"""Rows for programs: every world and every run, with names by which ``run`` finds them."""

import csv

import pytest

from allworlds import run, worst
from allworlds.world import world_named
from allworlds.world.world import at_place
from studies.test_world_rows import rows_of


def test_every_file_of_a_worst_case_names_a_run_that_attains_it():
    report = worst(edges=3)
    for row in rows_of(report, "worst"):
        world = at_place(world_named(row["code"]), int(row["place"]))
        choices = [int(choice) for choice in row["choices"].split(",") if choice]
        assert run("algorithm1", world, choices=choices).outcome.cost == int(row["worst"])


@pytest.mark.slowest
def test_parquet_has_the_rows_of_the_csv(cli, refused, monkeypatch, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    file, text = tmp_path / "a.parquet", tmp_path / "a.csv"
    words = ("compare", "algorithm1", "folding", "--edges", 2, "--by", "world", "-o")
    assert cli(*words, file)[0] == 0
    assert cli(*words, text)[0] == 0
    told = parquet.read_table(file).to_pylist()
    assert [
        {name: "" if value is None else str(value) for name, value in row.items()} for row in told
    ] == [*csv.DictReader(text.read_text().splitlines())]
    monkeypatch.setattr("allworlds.inputs.checks.find_spec", lambda _: None)
    assert "notebook" in refused(*words, tmp_path / "b.parquet")
