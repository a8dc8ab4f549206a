"""Events that tell how far a long job is."""

import inspect
import json
import sys
from pathlib import Path

import pytest

from allworlds import ambiguity, bench, count, mutants, search
from allworlds.cli import events, output
from allworlds.engines import Silent, level_size
from allworlds.lazy import loaded
from allworlds.maps import Extent, MapClass
from allworlds.verbs import VERBS
from kept_jobs import EXPLORERS
from recorded.record import least
from schemas.validating import complaints
from small import long

pytestmark = pytest.mark.usefixtures("compiled")


class Adds(Silent):
    """A listener that notes each stage with its announced total, and adds up the work done."""

    def __init__(self):
        self.stages, self.done = [], []

    def level(self, edges, worlds):
        self.stage(edges, worlds, "worlds")

    def stage(self, name, total, of):
        self.stages.append((name, total, of))
        self.done.append(0)

    def progress(self, count):
        self.done[-1] += count


HEARD = {
    "count": lambda listener: count(edges=4, listener=listener),
    "count compiled": lambda listener: count(edges=7, listener=listener),
    "count simple": lambda listener: count(vertices=4, map_class="simple", listener=listener),
    "census": lambda listener: ambiguity.census(edges=3, listener=listener),
    "mutants": lambda listener: mutants(edges=1, listener=listener),
    "bench": lambda listener: bench(edges=4, rounds=2, listener=listener),
}


@pytest.mark.no_cover
@pytest.mark.parametrize(
    "name", [long(name) if name == "count compiled" else name for name in HEARD]
)
def test_what_is_promised_is_done(name):
    heard = Adds()
    HEARD[name](heard)
    assert heard.done == [total for _, total, _ in heard.stages]
    assert all(total > 0 for _, total, of in heard.stages if of == "worlds")


def test_a_search_says_that_its_time_is_a_guess(tmp_path):
    heard = Adds()
    search(lighthouse="position", vertices=1, edges=2, out=tmp_path, listener=heard)
    ((name, total, of),) = heard.stages
    assert (name, 0 < heard.done[0] <= total) == ("search", True)
    assert "a guess" in of


def test_events_are_lines_of_json(cli, tmp_path):
    file = tmp_path / "events.ndjson"
    wrong = f"{EXPLORERS / 'wrong.py'}:everywhere"
    code, out, _ = cli("check", wrong, "--edges", 2, "--json", "--events", file, "--shard", "0/1")
    lines = [json.loads(line) for line in file.read_text().splitlines()]
    report = json.loads(out)
    assert code == 1
    del report["made_by"]
    assert lines[-1] == {"schema": 1, "event": "verdict", "report": report}
    found = [line["finding"] for line in lines if line["event"] == "finding"]
    assert report["findings"][0]["world"] in [finding["world"] for finding in found]
    units = [line for line in lines if line["event"] == "unit"]
    assert sum(unit["worlds"] for unit in units) == report["worlds"]
    assert [line["edges"] for line in lines if line["event"] == "level"] == [1]


def is_watched(verb):
    function = loaded(verb.function)
    return "listener" in inspect.signature(function).parameters


WATCHED = {verb.name: verb.name.split() for verb in VERBS if is_watched(verb)}
TIMED = {"searched", "solver_seconds"}
"""What of a report holds times."""

AT_ONCE = {"ambiguity class", "merge", "paper figure"}
"""Their least commands have nothing to do but to read, to count and to draw."""


@pytest.mark.no_cover
@pytest.mark.parametrize("name", [name for name in WATCHED if name != "self bench"])
def test_every_verb_that_is_watched_writes_events(name, cli, tmp_path, monkeypatch):
    monkeypatch.setattr(events, "EVERY", 0.0)
    file = tmp_path / "events.ndjson"
    words = least(name, str(tmp_path))
    _, out, _ = cli(*words, "--json", "--events", file)
    lines = [json.loads(line) for line in file.read_text().splitlines()]
    assert [complaints("event.schema.json", line) for line in lines] == [[]] * len(lines)
    printed = json.loads(out)
    del printed["made_by"]
    told = lines[-1]["report"]
    assert set(told) == set(printed)
    assert all(told[key] == value for key, value in printed.items() if key not in TIMED)
    assert name in AT_ONCE or {line["event"] for line in lines} > {"progress", "verdict"}


@pytest.mark.no_cover
def test_every_verb_that_is_watched_has_the_option(cli):
    for words in WATCHED.values():
        assert "--events" in cli(*words, "--help")[1]


def test_a_notice_is_an_event(cli, tmp_path):
    file = tmp_path / "events.ndjson"
    cli("check", "--edges", 1, "--shard", "0/2", "--events", file)
    texts = [json.loads(line).get("text", "") for line in file.read_text().splitlines()]
    assert any("cannot be merged" in text for text in texts)


def test_every_unit_has_a_level(tmp_path, cli):
    file = tmp_path / "events.ndjson"
    cli("check", "--edges", 3, "--events", file)
    lines = [json.loads(line) for line in file.read_text().splitlines()]
    extent = Extent(MapClass.MAPS, 3)
    assert {line["edges"]: line["worlds"] for line in lines if line["event"] == "level"} == {
        edges: level_size(extent, edges) for edges in extent.levels
    }


def test_a_file_of_events_that_cannot_be_written_is_refused(refused, tmp_path):
    said = refused("check", "--edges", "1", "--events", tmp_path / "no" / "events")
    assert "cannot be written: No such file or directory" in said


class Full:
    """A file that takes no more."""

    def write(self, text):
        raise OSError(28, "No space left on device")


def test_a_full_disk_costs_events_alone(capsys):
    heard = events.Events(output.Progress(quiet=True), Full())
    heard.unit("1:-1", 1)
    heard.unit("1:-2", 1)
    heard.stage("x", 1, "turns")
    said = capsys.readouterr().err
    assert said == "allworlds: events are no longer written: No space left on device\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no disk that is always full")
def test_and_not_the_report(cli):
    code, out, err = cli("check", "--edges", 1, "-q", "--events", "/dev/full")
    assert (code, out.partition(":")[0]) == (0, "HOLDS")
    assert err == "allworlds: events are no longer written: No space left on device\n"


@pytest.mark.usefixtures("without_workers")
def test_an_estimate_is_a_document_and_an_event(cli, tmp_path, monkeypatch):
    monkeypatch.setattr("allworlds.studies.check.time_estimate.SECONDS", 0.01)
    file = tmp_path / "events.ndjson"
    asked = ("check", "--edges", 3, "--engine", "python", "--shard", "0/1", "--estimate")
    code, out, _ = cli(*asked, "--json", "--events", file)
    document = json.loads(out)
    *_, last = [json.loads(line) for line in file.read_text().splitlines()]
    assert complaints("event.schema.json", last) == []
    assert complaints("estimate.schema.json", document) == []
    del document["made_by"]
    assert last == {"schema": 1, "event": "verdict", "report": document}
    assert [guess["edges"] for guess in document["larger"]] == [4, 5]
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
        progress.stage("bench", 2, "turns")
        progress.unit("3:-1", 20)
        progress.finding({})
    said = capsys.readouterr().err
    assert "edges 3" in said
    assert "worlds" in said
    assert "turns" in said
