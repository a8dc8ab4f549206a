"""A run directory says how far it is."""

import pytest

import allworlds
from allworlds.engines.listeners import Listener
from allworlds.studies.merge import DoneOf
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


@pytest.mark.usefixtures("without_workers")
def test_of_a_comparison_the_largest_cost_of_all_explorers_is_shown(tmp_path):
    report = allworlds.compare("algorithm1", "dfs", edges=2, run=tmp_path)
    largest = max(cost for row in report.rows for cost in row.worst.values())
    assert allworlds.status(tmp_path).worst.cost == largest


class Looks(Listener):
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
    assert standing.left_s >= 0


@pytest.mark.usefixtures("compiled", "without_workers")
@pytest.mark.parametrize("verb", ["worst --edges 3", "ambiguity census --class simple --edges 3"])
def test_every_verb_that_keeps_units_has_a_status(verb, report, cli, tmp_path):
    report(verb, "--run", str(tmp_path), "--shard", "0/2")
    code, document, _ = report("status", str(tmp_path))
    assert (code, document["shard"], document["state"]) == (0, "0/2", "finished")
    assert (document["worst"] is None) == verb.startswith("ambiguity")
    code, out, _ = cli("status", tmp_path)
    assert "shard 0/2" in " ".join(out.split())
    assert "finished" in out


@pytest.mark.usefixtures("without_workers")
def test_findings_are_counted_before_the_end(cli, tmp_path):
    name = f"{EXPLORERS / 'wrong.py'}:everywhere"
    assert allworlds.check(name, edges=2, time_limit=1e-9, run=tmp_path).exit_code in (1, 3)
    standing = allworlds.status(tmp_path)
    assert standing.state == "unfinished"
    allworlds.check(name, edges=2, run=tmp_path)
    assert allworlds.status(tmp_path).findings > 0
    assert "findings   2\n" in cli("status", tmp_path)[1]


def flat(words):
    return " ".join(words.split())


@pytest.mark.usefixtures("without_workers")
def test_the_job_is_told_with_everything_that_was_asked_for(cli, tmp_path):
    options = {"task": "cover", "policy": "lifo", "lighthouse": "compass", "where": "trees"}
    allworlds.check("dfs", edges=2, run=tmp_path, step_budget=50, **options)
    told = flat(cli("status", tmp_path)[1])
    assert "job check dfs: class maps, where trees, edges 2, lighthouse compass, task cover" in told
    assert "options --policy lifo --step-budget 50" in told
    assert "so far" not in told
    assert "1 traversals" not in told


@pytest.mark.usefixtures("without_workers")
def test_worlds_that_no_source_counts_are_at_most_so_many(cli, tmp_path):
    predicate = tmp_path / "mine.py"
    predicate.write_text("def few(map):\n    return map.vertex_count == 2\n", encoding="utf-8")
    allworlds.check(edges=3, where=f"{predicate}:few", run=tmp_path / "run")
    assert "38 of at most 86" in flat(cli("status", tmp_path / "run")[1])
    allworlds.check(edges=3, where="trees", run=tmp_path / "trees")
    assert "worlds 8 of 8 " in flat(cli("status", tmp_path / "trees")[1])


@pytest.mark.usefixtures("without_workers")
def test_of_a_shard_its_part_of_all_worlds_is_told(tmp_path):
    allworlds.check(edges=3, shard=(0, 2), run=tmp_path)
    assert allworlds.status(tmp_path).worlds.all == 43  # of 86


@pytest.mark.usefixtures("without_workers")
def test_what_is_not_finished_is_told_so_far(cli, tmp_path):
    def ends(edges, worlds):
        if edges == 3:
            raise KeyboardInterrupt

    class Ends(Listener):
        level = staticmethod(ends)

    allworlds.check(edges=3, run=tmp_path, listener=Ends())
    assert "worst 4 traversals so far, with 2 edges" in flat(cli("status", tmp_path)[1])
