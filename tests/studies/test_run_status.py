"""A run directory says how far it is."""

import pytest

import allworlds
from allworlds.progress import Silent
from kept_jobs import EXPLORERS


@pytest.mark.usefixtures("without_workers")
def test_a_finished_directory_says_so(tmp_path):
    report = allworlds.check(edges=3, engine="python", run=tmp_path)
    standing = allworlds.status(tmp_path)
    assert (standing.state, standing.left) == ("finished", 0)
    assert standing.worlds == (report.worlds, report.worlds)
    assert standing.units[0] == standing.units[1] > 9
    assert standing.worst.cost == max(row.max_cost for row in report.tally.rows.values())
    assert standing.findings == 0
    assert standing.identity.explorer["name"] == "algorithm1"


class Looks(Silent):
    def __init__(self, run, done):
        self.run, self.done, self.seen = run, done, []

    def progress(self, worlds):
        self.done -= worlds
        if self.done < 0 and not self.seen:
            self.seen.append(allworlds.status(self.run))


@pytest.mark.usefixtures("without_workers")
def test_a_directory_can_be_looked_at_while_it_grows(tmp_path):
    watcher = Looks(tmp_path, 40)
    allworlds.check(edges=3, engine="python", run=tmp_path, listener=watcher)
    (standing,) = watcher.seen
    assert standing.state == "running"
    assert 0 < standing.units[0] < standing.units[1]
    assert 0 < standing.worlds[0] < standing.worlds[1] == 86
    assert standing.rate > 0
    assert standing.left > 0


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("verb", ["worst --edges 3", "ambiguity census --class simple --edges 3"])
def test_every_verb_that_keeps_units_has_a_status(verb, report, cli, tmp_path):
    report(verb, "--run", str(tmp_path), "--shard", "0/2")
    code, document, _ = report("status", str(tmp_path))
    assert (code, document["shard"], document["state"]) == (0, "0/2", "finished")
    assert (document["worst"] is None) == verb.startswith("ambiguity")
    code, out, _ = cli("status", tmp_path)
    assert "shard 0/2" in out
    assert "finished" in out


@pytest.mark.usefixtures("without_workers")
def test_findings_are_counted_before_the_end(cli, tmp_path):
    name = f"{EXPLORERS / 'wrong.py'}:everywhere"
    assert allworlds.check(name, edges=2, time_limit=1e-9, run=tmp_path).exit_code in (1, 3)
    standing = allworlds.status(tmp_path)
    assert standing.state == "unfinished"
    allworlds.check(name, edges=2, run=tmp_path)
    assert allworlds.status(tmp_path).findings > 0
    assert "so far" in cli("status", tmp_path)[1]
