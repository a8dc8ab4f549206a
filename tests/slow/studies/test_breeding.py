import pytest

from allworlds import merge
from allworlds.engines.limits import Limits
from allworlds.engines.single import subject_of
from allworlds.engines.units import Sample
from allworlds.maps.mixture import default_mix
from allworlds.reports.formats import text as text_of
from allworlds.studies.fuzz.breeding import (
    BRED_PER_BLOCK,
    DRAWS_PER_BLOCK,
    DRAWS_TRACED,
    Bred,
    bred,
)
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.fuzz.sampling import Batch, batches
from studies.test_breeding import EXTENT, SCOPE, is_late, late

LATE = f"{late.__code__.co_filename}:late"


@pytest.mark.slowest
def test_a_bred_world_finds_what_as_many_draws_do_not():
    drawn = [
        map_
        for batch in batches(Sample(DRAWS_PER_BLOCK + BRED_PER_BLOCK))
        for map_, _ in batch.placed(EXTENT, SCOPE.rules.kind)
    ]
    assert len(drawn) == DRAWS_PER_BLOCK + BRED_PER_BLOCK
    assert not any(map(is_late, drawn))
    block = Bred(Batch(0, 0, DRAWS_TRACED, default_mix(EXTENT)))
    found = [[*bred(block, SCOPE, subject_of(late, Limits()), Limits())] for _ in range(2)]
    assert found[0]
    assert found[0] == found[1]
    assert all(is_late(run.map) and EXTENT.include(run.map) for run in found[0])


@pytest.mark.slowest
@pytest.mark.processes
def test_bred_worlds_depend_on_neither_workers_nor_shards(tmp_path):
    sample = {"edges": 12, "runs": DRAWS_PER_BLOCK + DRAWS_TRACED}
    whole = fuzz(LATE, **sample)
    assert (whole.verdict, whole.runs, whole.bred) == ("refuted", DRAWS_PER_BLOCK, BRED_PER_BLOCK)
    assert is_late(whole.findings[0].world.map)
    assert "192 worlds made by changing drawn worlds" in text_of(whole, 100)
    assert fuzz(LATE, **sample, workers=2).to_json() == whole.to_json()
    (tmp_path / "runs").mkdir()
    for k in range(2):
        fuzz(LATE, **sample, shard=(k, 2), run=tmp_path / f"runs/{k}")
    assert merge(*(tmp_path / "runs").iterdir()).to_json() == whole.to_json()


@pytest.mark.slowest
def test_a_sample_without_a_finding_tells_how_many_were_bred():
    report = fuzz(f"{__file__}:right", edges=3, runs=DRAWS_PER_BLOCK)
    assert (report.verdict, report.runs, report.bred) == (
        "not-refuted",
        DRAWS_PER_BLOCK,
        BRED_PER_BLOCK,
    )
    assert sum(row.worlds for row in report.rows) == DRAWS_PER_BLOCK


def right(first, choices=None):
    from allworlds.explorers.builtin.algorithm1 import algorithm1

    return (yield from algorithm1(first, choices=choices))
