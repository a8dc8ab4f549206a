"""Shards of a job, merged, are equal to the whole job."""

import json

import pytest

import allworlds
from kept_jobs import JOBS
from studies.test_merge import sharded

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.slowest
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize(("name", "shards"), [*((name, 3) for name in JOBS), ("check", 1)])
def test_what_is_sharded_and_merged_is_the_whole(name, shards, report, tmp_path):
    code, whole, _ = report(JOBS[name])
    runs, codes = sharded(report, JOBS[name], tmp_path, shards)
    assert codes <= {0, code}
    merged, said, _ = report("merge", *reversed(runs))
    # Byte for byte, and so in the same order.
    assert (merged, json.dumps(said)) == (code, json.dumps(whole))


@pytest.mark.slowest
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize(
    ("worlds", "by"),
    [
        ({"edges": 3}, "size"),
        ({"edges": 2}, "world"),
        ({"family": "strip", "to": 30, "draws": 3}, "size"),
        ({"family": "strip", "to": 20, "draws": 2}, "run"),
    ],
)
def test_a_merge_has_the_rows_that_the_whole_has(worlds, by, tmp_path):
    runs = [tmp_path / str(k) for k in range(2)]
    for k, run in enumerate(runs):
        allworlds.compare("folding-oldest", "algorithm1", **worlds, shard=(k, 2), run=run)
    whole = allworlds.compare("folding-oldest", "algorithm1", **worlds, by=by).records()
    assert allworlds.merge(*runs, by=by).records() == whole
    assert len(whole) > 2
