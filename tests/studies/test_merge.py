"""Shards of a job, merged, are equal to the whole job."""

import pytest

import allworlds
from allworlds.engines.listeners import Listener
from allworlds.engines.run_directory import Gap
from allworlds.inputs.checks import InputError
from allworlds.studies.merge import sweep_of
from allworlds.verbs import VERBS
from kept_jobs import EXPLORERS

pytestmark = pytest.mark.usefixtures("compiled")

WRONG = EXPLORERS / "wrong.py"


def sharded(report, command, directory, shards):
    """The directories of all shards, and the exit codes."""
    runs = [str(directory / f"shard-{k}") for k in range(shards)]
    return runs, {
        report(command, "--shard", f"{k}/{shards}", "--run", run)[0] for k, run in enumerate(runs)
    }


def test_rows_are_chosen_for_jobs_that_have_them(refused, tmp_path):
    allworlds.check(edges=1, run=tmp_path)
    with pytest.raises(InputError, match="by world has no effect on a job of check"):
        allworlds.merge(tmp_path, by="world")
    said = refused("merge", tmp_path, "--by", "world")
    assert said == "allworlds: by world has no effect without -o FILE.csv\n"


@pytest.mark.usefixtures("without_workers")
def test_a_merge_runs_no_explorer(report, tmp_path):
    file = tmp_path / "mine.py"
    file.write_text(WRONG.read_text())
    command = f"check {file}:everywhere --edges 3 --max-findings 2"
    code, whole, _ = report(command)
    runs, _ = sharded(report, command, tmp_path, 2)
    file.unlink()
    assert report("merge", *runs)[:2] == (code, whole) == (1, whole)
    assert all(finding["confirmed"] for finding in whole["findings"])


@pytest.mark.usefixtures("without_workers")
def test_the_shards_of_a_comparison_have_its_findings(report, tmp_path):
    command = f"compare algorithm1 {WRONG}:everywhere --edges 2"
    code, whole, _ = report(command)
    runs, _ = sharded(report, command, tmp_path, 2)
    assert report("merge", *runs)[:2] == (code, whole) == (1, whole)
    assert whole["findings"]


@pytest.mark.usefixtures("without_workers")
def test_a_shard_of_a_merge_that_is_missing_is_a_gap(report, cli, tmp_path):
    runs, _ = sharded(report, "check --edges 2", tmp_path, 3)
    code, out, err = cli("merge", runs[0], runs[2])
    assert (code, out) == (75, "")
    assert err == (
        "allworlds: what is missing is shard 1/3: give the run directory of each shard\n"
    )
    report("check --edges 2", "--shard", "0/12", "--run", str(tmp_path / "one"))
    code, _, err = cli("merge", tmp_path / "one")
    assert code == 75
    assert "shard 1/12, 2/12, " in err
    assert "9/12 and 2 more" in err


class Ends(Listener):
    def progress(self, worlds):
        raise KeyboardInterrupt


@pytest.mark.usefixtures("without_workers")
def test_a_shard_that_is_not_finished_is_a_gap(tmp_path):
    job = lambda k, **more: allworlds.check(  # noqa: E731
        edges=2, shard=(k, 2), run=tmp_path / str(k), **more
    )
    assert job(0, listener=Ends()).exit_code == 130
    job(1)
    with pytest.raises(Gap, match=r"is not finished: give the commands of '.*/0' \(shard 0/2\)"):
        allworlds.merge(tmp_path / "0", tmp_path / "1")
    job(0)
    merged = allworlds.merge(tmp_path / "0", tmp_path / "1")
    alone = allworlds.check(edges=2)
    assert type(merged) is type(alone)
    assert merged.to_json() == alone.to_json()
    assert str(merged) == str(alone)
    assert merged.records() == alone.records()


@pytest.mark.usefixtures("without_workers")
def test_a_finding_that_nobody_has_confirmed_is_a_gap(tmp_path, monkeypatch):
    def interrupted(*_):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr("allworlds.engines.single.played_again", interrupted)
        report = allworlds.check(f"{WRONG}:everywhere", edges=1, run=tmp_path)
    assert report.exit_code == 130
    with pytest.raises(Gap, match="a finding has not been confirmed yet: give the commands of"):
        allworlds.merge(tmp_path)


@pytest.mark.usefixtures("without_workers")
def test_what_is_not_of_one_job_is_not_merged(report, refused, tmp_path):
    runs, _ = sharded(report, "check --edges 2", tmp_path, 2)
    for more, said in {
        "check --edges 3": "is of edges = 3, not 2 as",
        "check --edges 2 --policy lifo": "is of policy = 'lifo', not 'fifo' as",
        "worst --edges 2": "is of 'worst', not 'check' as",
        "ambiguity census --edges 2": "is of 'ambiguity census', not 'check' as",
    }.items():
        other = str(tmp_path / said.replace("/", ""))
        report(more, "--shard", "1/2", "--run", other)
        assert said in refused("merge", runs[0], other)
    assert "are both shard 0/2" in refused("merge", runs[0], runs[0])
    report("check --edges 2", "--shard", "1/3", "--run", str(tmp_path / "third"))
    assert "is of shard 1/3, and not of a job in 2 parts" in refused(
        "merge", runs[0], tmp_path / "third"
    )


@pytest.mark.usefixtures("without_workers")
def test_directories_of_another_version_are_not_merged(report, refused, tmp_path, monkeypatch):
    runs, _ = sharded(report, "check --edges 1", tmp_path, 1)
    monkeypatch.setattr("allworlds.studies.merge.__version__", "9.9")
    assert "not '9.9'" in refused("merge", *runs)


def test_a_merge_of_nothing_is_refused():
    with pytest.raises(InputError, match="at least one"):
        allworlds.merge()


@pytest.mark.usefixtures("without_workers")
def test_units_that_are_in_two_directories_are_refused(report, tmp_path, monkeypatch):
    """Were the shards dealt out in another way, they would overlap."""
    report("worst --edges 2", "--shard", "0/2", "--run", str(tmp_path / "a"))
    monkeypatch.setattr("allworlds.engines.units.dealt", lambda weights, _: range(len(weights)))
    report("worst --edges 2", "--shard", "1/2", "--run", str(tmp_path / "b"))
    with pytest.raises(InputError, match=r"overlap: unit .* is in"):
        allworlds.merge(tmp_path / "a", tmp_path / "b")


def test_the_gate_stands_over_the_union(report, tmp_path, monkeypatch):
    """A world that is missing in a shard is missed by the merge."""
    monkeypatch.setattr(
        "allworlds.engines.units.prefixes", lambda *_: iter([(-1,), (-2,)]), raising=True
    )
    runs, codes = sharded(report, "worst --edges 2", tmp_path, 2)
    assert codes == {0}
    assert report("merge", *runs)[0] == 70


SHARDED = (
    "check --edges 1",
    "worst --edges 1",
    "compare folding folding-oldest --edges 1",
    "count --edges 1",
    "fuzz --edges 2 --runs 3",
    "ambiguity census --edges 1",
)


def test_a_shard_says_that_it_cannot_be_merged(report):
    for command in SHARDED:
        code, _, err = report(command, "--shard", "0/2")
        assert (code, err) == (
            0,
            "allworlds: without --run DIR the report of this shard cannot be merged with others\n",
        )


def test_what_a_run_directory_keeps_can_be_merged():
    for verb in VERBS:
        if verb.swept:
            assert sweep_of(verb.name).verb == verb.name
        else:
            with pytest.raises(StopIteration):
                sweep_of(verb.name)
