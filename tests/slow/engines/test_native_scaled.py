"""A native explorer in a run directory, in shards and on a cluster: the report is the same."""

import pytest

from allworlds import check, merge
from native_libraries import example

pytestmark = pytest.mark.slowest


def test_a_native_explorer_is_scaled_out_in_compiled_code(tmp_path):
    pytest.importorskip("distributed")
    name = f"native:{example('c/algorithm1.c')}"
    job = {"edges": 4, "engine": "kernel"}
    whole = check(name, **job).to_json()
    assert (whole["exit_code"], whole["engine"]) == (0, "kernel")
    assert check(name, run=tmp_path / "run", **job).to_json() == whole
    shards = [tmp_path / str(k) for k in range(2)]
    for k, directory in enumerate(shards):
        check(name, shard=(k, 2), run=directory, **job)
    assert merge(*shards).to_json() == whole
    assert check(name, dask="local", **job).to_json() == whole
