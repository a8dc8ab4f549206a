"""Checks and counts of classes that are narrowed, by ours and by the user's own."""

import pytest

import allworlds
from allworlds.inputs.checks import InputError
from studies import test_where as quick

folder = quick.folder


@pytest.mark.parametrize("where", ["cubic", "trees", "triangulation", "genus:1", "girth:2"])
def test_shards_under_a_condition_are_the_whole(where, tmp_path):
    whole = allworlds.check(edges=4, where=where)
    for shard in (0, 1, 2):
        allworlds.check(edges=4, where=where, shard=(shard, 3), run=tmp_path / f"{shard}")
    merged = allworlds.merge(*(tmp_path / f"{shard}" for shard in (0, 1, 2)))
    assert merged.to_json()["rows"] == whole.to_json()["rows"]
    assert merged.to_json()["scope"]["gate"] == whole.to_json()["scope"]["gate"]


def test_a_shrunk_world_keeps_the_condition(folder):
    options = {"lighthouse": "none", "task": "cover:edges", "workers": 1}
    for where in ("cubic", "alone.py:even"):
        report = allworlds.fuzz(
            "mine.py:goes_on", edges=9, min_edges=6, runs=5, where=where, **options
        )
        (finding,) = report.findings
        degrees = finding.world.map.degrees
        assert all(d == 3 if where == "cubic" else d % 2 == 0 for d in degrees)


@pytest.mark.parametrize("where", ["cubic", "mine.py:below?edges=2"])
def test_a_condition_that_is_true_of_no_drawn_map_is_refused_in_one_line(folder, where):
    with pytest.raises(InputError, match="were drawn, and the condition is true of none") as error:
        allworlds.fuzz("algorithm1", edges=4, min_edges=4, runs=2, where=where, workers=1)
    assert "\n" not in str(error.value)
