"""Findings, reports and corpora of version 0.1.0 replay; its run directories are refused."""

import json
import shutil
from pathlib import Path

import pytest

SUPPORT = Path(__file__).parents[1] / "support" / "data" / "0.1.0"
EXPLORERS = Path(__file__).parents[1] / "recorded" / "explorers.py"
REFUTED = ["bad-check", "mutant", "greedy", "deep", "learner"]


@pytest.fixture
def written(tmp_path, monkeypatch):
    """The folder in which it was written, with its explorers."""
    shutil.copytree(SUPPORT, tmp_path, dirs_exist_ok=True)
    shutil.copy(EXPLORERS, tmp_path)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("name", REFUTED)
def test_a_report_of_0_1_0_replays_as_it_did(name, written, cli):
    report = json.loads((written / f"{name}.json").read_text(encoding="utf-8"))
    assert report["made_by"]["version"] == "0.1.0"
    (finding,) = report["findings"]
    code, out, _ = cli("replay", f"{name}.json", "--json")
    told = json.loads(out)
    assert (code, told["outcome"]) == (0, "reproduced")
    assert told["explorer"] == finding["explorer"]
    for key in ("law", "world", "transcript", "expected", "seen", "choices"):
        assert told["run"]["finding"][key] == finding[key]


def test_the_explorers_of_0_1_0_are_found_under_the_names_that_they_had():
    named = {json.loads((SUPPORT / f"{name}.json").read_text())["explorer"] for name in REFUTED}
    assert named == {
        "explorers.py:first_edge",
        "allworlds.mutation.explorers:pose_lost",
        "allworlds.mutation.explorers:mirror_image",
        "allworlds.explorers:greedy",
        "allworlds.explorers.remembering:remembering",
    }


def test_a_check_of_0_1_0_says_the_same_today(written, cli):
    before = json.loads((written / "holds.json").read_text(encoding="utf-8"))
    code, out, _ = cli("check", "--edges", 3, "--json")
    today = json.loads(out)
    for report in (before, today):
        del report["made_by"]
    assert (code, today) == (0, before)


def test_a_corpus_of_0_1_0_is_tried_again(written, cli):
    (name,) = [file.name for file in (written / "corpus").iterdir()]
    code, out, _ = cli("check", "explorers.py:first_edge", "--corpus", "corpus", "--json")
    report = json.loads(out)
    assert code == 1
    assert report["corpus"]["reproduced"] == [name]


@pytest.mark.parametrize(
    "command", ["check --edges 3 --run run", "merge run", "status run"], ids=str.split
)
def test_a_run_directory_of_0_1_0_is_refused_by_name(command, written, refused):
    before = (written / "run" / "units.sqlite").read_bytes()
    said = refused(*command.split())
    assert "run directory 'run' is of format 1, written by version 0.1.0" in said
    assert "this version, 0.2.0, reads format 2" in said
    assert (written / "run" / "units.sqlite").read_bytes() == before
