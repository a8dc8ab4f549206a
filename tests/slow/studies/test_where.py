"""Checks and counts of classes that are narrowed, by ours and by the user's own."""

import pytest

import allworlds


@pytest.mark.parametrize("where", ["cubic", "trees", "triangulation", "genus:1", "girth:2"])
def test_shards_under_a_condition_are_the_whole(where, tmp_path):
    whole = allworlds.check(edges=4, where=where)
    for shard in (0, 1, 2):
        allworlds.check(edges=4, where=where, shard=(shard, 3), run=tmp_path / f"{shard}")
    merged = allworlds.merge(*(tmp_path / f"{shard}" for shard in (0, 1, 2)))
    assert merged.to_json()["rows"] == whole.to_json()["rows"]
    assert merged.to_json()["scope"]["gate"] == whole.to_json()["scope"]["gate"]
