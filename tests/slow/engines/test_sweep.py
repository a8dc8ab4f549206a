"""The other jobs of every verb that goes through worlds, as the quick tests treat one a kind."""

import json

import pytest

import allworlds
from allworlds import fuzz
from engines import test_sweep as quick
from engines.test_sweep import SWEEPS, WRONG, Interrupts, assert_finished_rows, text

pytestmark = pytest.mark.usefixtures("compiled", "without_workers")

OTHERS = [name for name in quick.SWEEPS if name not in quick.KINDS]

cluster = quick.cluster
undisturbed = quick.undisturbed


@pytest.mark.parametrize("name", OTHERS)
def test_as_many_worlds_are_done_in_each_level_as_were_announced(name):
    quick.test_as_many_worlds_are_done_in_each_level_as_were_announced(name)


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("name", [name for name in quick.SWEEPS if name not in quick.ON_A_CLUSTER])
def test_what_a_cluster_does_is_the_same_and_goes_on_without_it(
    name, undisturbed, cluster, tmp_path
):
    quick.test_what_a_cluster_does_is_the_same_and_goes_on_without_it(
        name, undisturbed, cluster, tmp_path
    )


@pytest.mark.parametrize("name", OTHERS)
def test_what_was_finished_when_it_was_ended_is_reported(name, undisturbed, monkeypatch):
    quick.test_what_was_finished_when_it_was_ended_is_reported(name, undisturbed, monkeypatch)


@pytest.mark.parametrize("name", OTHERS)
def test_a_time_limit_that_is_over_at_once_leaves_it_undecided(name):
    quick.test_a_time_limit_that_is_over_at_once_leaves_it_undecided(name)


@pytest.mark.long
@pytest.mark.no_cover
@pytest.mark.parametrize("name", SWEEPS)
def test_what_was_interrupted_at_several_places_goes_on(name, undisturbed, tmp_path):
    job, whole = SWEEPS[name], undisturbed(name)
    for parts in (1, 2, 3):
        cut = job(run=tmp_path, listener=Interrupts(parts))
        if cut.exit_code != 130:  # it has fewer units
            break
        assert_finished_rows(text(cut), whole)
        assert allworlds.status(tmp_path).state == "unfinished"
    assert text(job(run=tmp_path)) == whole
    assert text(job(run=tmp_path)) == whole
    standing = allworlds.status(tmp_path)
    assert (standing.state, standing.left_s) == ("finished", 0)
    if "refuted" not in name:  # a finding ends it before the last level
        assert standing.worlds.done == standing.worlds.all
        assert standing.units.done == standing.units.all


@pytest.mark.no_cover
@pytest.mark.parametrize("name", SWEEPS)
def test_what_is_sharded_and_merged_is_the_same(name, undisturbed, tmp_path):
    job = SWEEPS[name]
    code = json.loads(undisturbed(name)).get("exit_code", 0)
    runs = [tmp_path / str(k) for k in range(3)]
    codes = {job(run=run, shard=(k, 3)).exit_code for k, run in enumerate(runs)}
    assert codes <= {0, code}
    merged = allworlds.merge(*reversed(runs))
    assert text(merged) == undisturbed(name)


@pytest.mark.long
def test_what_a_shrinker_had_when_the_time_was_up_is_not_the_end(tmp_path, monkeypatch):
    """A directory keeps no smallest finding that was not sought to the end."""

    def job(**more):
        return fuzz(f"{WRONG}:everywhere", edges=4, min_edges=3, runs=20, **more)

    with monkeypatch.context() as patch:
        late = []

        def shrunk(finding, *_):
            late.append(finding)
            return finding

        patch.setattr("allworlds.studies.fuzz.smallest_from", shrunk)
        patch.setattr(
            "allworlds.studies.check.tally_sweep.Confirmation.is_late",
            property(lambda _: bool(late)),
        )
        assert job(run=tmp_path, time_limit=1000).findings
    assert late
    assert text(job(run=tmp_path)) == text(job())
