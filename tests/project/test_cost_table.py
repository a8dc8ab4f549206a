"""The tables of docs/how-to/bound.md against their sources."""

import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def document():
    return json.loads((ROOT / "benchmarks/results/kernel.json").read_text(encoding="utf-8"))


def benchmark(name):
    """The module that prints a table."""
    spec = importlib.util.spec_from_file_location(name, ROOT / "benchmarks" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def cost():
    return benchmark("cost")


def test_the_page_holds_the_table_of_the_measurement(document, cost):
    page = (ROOT / "docs/how-to/bound.md").read_text(encoding="utf-8")
    assert "\n".join(cost.table(document)) in page


def test_the_page_names_the_rate_that_it_reckons_with(document):
    page = (ROOT / "docs/how-to/bound.md").read_text(encoding="utf-8")
    rate = document["contenders"][0]["worlds_per_second"]["median"]
    assert f"walks {rate:,.0f} worlds a second" in page


@pytest.mark.slow
@pytest.mark.usefixtures("compiled")
def test_the_program_that_measures_sets_others_beside_the_engines():
    line = [sys.executable, ROOT / "benchmarks/rounds.py", "--edges=4", "--rounds=1"]
    told = subprocess.run([*line, "--peer=a@3=true"], check=True, capture_output=True).stdout
    document = json.loads(told)
    names = [row["name"] for row in document["contenders"]]
    assert names == ["kernel", "kernel-2", "count", "judge", "python", "a"]
    assert document["contenders"][-1]["worlds"] == 74  # OEIS A000698
    assert [row["to"] for row in document["ratios"]] == names[1:]
    failed = subprocess.run([*line, "--peer=culprit=false"], check=False, capture_output=True)
    assert b"'culprit'" in failed.stderr


def test_each_line_is_worlds_by_the_rate(cost):
    rows = list(cost.rows(1000.0))
    assert [row[0] for row in rows] == list(range(1, 13))
    # OEIS A000698.
    assert [row[1] for row in rows[:9]] == [
        *(2, 10, 74, 706, 8162, 110410, 1708394, 29752066, 576037442),
    ]
    for _, worlds, total, seconds in rows:
        assert total >= worlds
        assert seconds == total / 1000


def test_the_measurement_says_where_and_when_it_was_made(document):
    assert document["schema"] == 1
    assert re.fullmatch(r"[0-9]+\.[0-9]+\.[0-9]+", document["version"])
    assert document["machine"]["processor"]
    assert document["rounds"] >= 3


def test_the_page_of_bounds_holds_the_table_of_the_effort():
    document = json.loads((ROOT / "benchmarks/results/effort.json").read_text(encoding="utf-8"))
    effort = benchmark("effort")
    page = (ROOT / "docs/how-to/bound.md").read_text(encoding="utf-8")
    assert "\n".join(effort.table(document)) in page
    for kind in document["kinds"].values():
        assert kind["worlds"] == effort.worlds(kind["edges"])
        assert kind["seconds"] >= effort.LONG_ENOUGH > kind["smallest"]


def test_a_copy_without_history_or_git_is_measured_too(monkeypatch, tmp_path):
    effort = benchmark("effort")
    monkeypatch.setattr(effort, "HERE", tmp_path)
    assert effort.commit() == "unknown"
    monkeypatch.setenv("PATH", str(tmp_path))
    assert effort.commit() == "unknown"
