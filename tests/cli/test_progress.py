"""Progress: how far a long job is, and how long it would take."""

import json
import sys

import pytest

from allworlds import ambiguity, count, search
from allworlds.cli import output
from listeners import Hears
from schemas.validating import complaints

pytestmark = pytest.mark.usefixtures("compiled")


HEARD = {
    "count": lambda listener: count(edges=4, listener=listener),
    "count compiled": lambda listener: count(edges=7, listener=listener),
    "count simple": lambda listener: count(vertices=4, map_class="simple", listener=listener),
    "census": lambda listener: ambiguity.census(edges=3, listener=listener),
}


@pytest.mark.parametrize("name", ["count", "count simple", "census"])
def test_what_is_promised_is_done(name):
    heard = Hears()
    HEARD[name](heard)
    assert heard.done == [total for _, total, _ in heard.stages]
    assert all(total > 0 for _, total, of in heard.stages if of == "worlds")


def test_a_search_says_that_its_time_is_a_guess(tmp_path):
    heard = Hears()
    search(lighthouse="position", vertices=1, edges=2, out=tmp_path, listener=heard)
    ((name, total, of),) = heard.stages
    assert (name, 0 < heard.done[0] <= total) == ("search", True)
    assert "a guess" in of


@pytest.mark.usefixtures("without_workers")
def test_an_estimate_is_a_document(cli, monkeypatch):
    monkeypatch.setattr("allworlds.studies.check.time_estimate.SECONDS", 0.01)
    asked = ("check", "--edges", 3, "--engine", "python", "--shard", "0/1", "--estimate")
    code, out, _ = cli(*asked, "--json")
    document = json.loads(out)
    assert complaints("estimate.schema.json", document) == []
    assert [guess["edges"] for guess in document["larger"]] == [4]
    assert (code, document["worlds"], document["engine"]) == (0, 86, "python")
    assert document["rate"] > 0
    assert document["seconds"] == round(86 / document["rate"], 1)


def test_a_terminal_sees_a_bar_with_its_rate(capsys, monkeypatch):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    monkeypatch.setenv("TERM", "xterm")
    with output.Progress(quiet=False) as progress:
        progress.level(3, 20)
        for _ in range(3):
            progress.progress(5)
            progress._bar.refresh()
        assert [task.completed for task in progress._bar.tasks] == [15]
        progress.stage("bench", 2, "turns")
    said = capsys.readouterr().err
    assert "edges 3" in said
    assert "worlds" in said
    assert "turns" in said


def test_a_run_that_goes_on_is_told_after_ever_longer_silences(capsys):
    seconds = 0.0
    progress = output.Progress(quiet=False, clock=lambda: seconds)
    progress.level(60, 50)
    progress.progress(3)
    told = []
    for seconds in range(0, 101, 5):
        progress.walk(1000 * seconds, 160_000)
        if capsys.readouterr().err:
            told.append(seconds)
    assert told == [10, 30, 70]
    seconds = 200.0
    progress.progress(1)
    progress.walk(2, 160_000)  # of the next run
    assert capsys.readouterr().err == ""
    seconds = 1000.0
    progress.walk(12_000, 160_000)
    said = "edges 60, 4 of 50 worlds done: the run in progress is at turn 12,000 of the explorer"
    assert said in capsys.readouterr().err


def test_a_quiet_progress_tells_of_no_run(capsys):
    seconds = iter([0.0, 100.0])
    output.Progress(quiet=True, clock=lambda: next(seconds)).walk(1, 2)
    assert capsys.readouterr().err == ""
