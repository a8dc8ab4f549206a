"""A run directory says how far it is."""

import pytest

import allworlds
from allworlds.engines import Silent
from allworlds.studies.status.run_status import DoneOf
from kept_jobs import EXPLORERS


@pytest.mark.usefixtures("without_workers")
def test_a_finished_directory_says_so(tmp_path):
    report = allworlds.check(edges=3, engine="python", run=tmp_path)
    standing = allworlds.status(tmp_path)
    assert (standing.state, standing.left_s) == ("finished", 0)
    assert standing.worlds == DoneOf(done=report.worlds, all=report.worlds)
    assert standing.units.done == standing.units.all > 9
    assert standing.worst.cost == max(row.max_cost for row in report.tally.rows.values())
    assert standing.findings == 0
    assert standing.explorer == "algorithm1"


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
    assert 0 < standing.units.done < standing.units.all
    assert 0 < standing.worlds.done < standing.worlds.all == 86
    assert standing.rate > 0
    assert standing.left_s > 0


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
