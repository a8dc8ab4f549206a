"""The other jobs of every verb that goes through worlds, as the quick tests treat one a kind."""

import pytest

from engines import test_sweep as quick

pytestmark = pytest.mark.usefixtures("compiled", "without_workers")

OTHERS = [name for name in quick.SWEEPS if name not in quick.KINDS]

cluster = quick.cluster
undisturbed = quick.undisturbed


@pytest.mark.parametrize("name", OTHERS)
def test_what_was_interrupted_at_several_places_goes_on(name, undisturbed, tmp_path):
    quick.test_what_was_interrupted_at_several_places_goes_on(name, undisturbed, tmp_path)


@pytest.mark.parametrize("name", OTHERS)
def test_as_many_worlds_are_done_in_each_level_as_were_announced(name):
    quick.test_as_many_worlds_are_done_in_each_level_as_were_announced(name)


@pytest.mark.parametrize("name", OTHERS)
def test_what_is_sharded_and_merged_is_the_same(name, undisturbed, tmp_path):
    quick.test_what_is_sharded_and_merged_is_the_same(name, undisturbed, tmp_path)


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
