"""Who is silent in a cluster is given up; told by a client that is made up."""

import asyncio

import pytest

from allworlds.engines import ClusterLost
from allworlds.engines.transports import dask_watch
from allworlds.engines.transports.dask_watch import ClusterWatch
from allworlds.engines.units.effort import DaskCluster

TIMEOUT = 5.0


class Scheduler:
    """A scheduler with two workers, and a clock."""

    def __init__(self):
        self.now, self.beats, self.fault = 0.0, {"a": 0.0, "b": 0.0}, None
        self.scheduler = self

    async def identity(self):
        if self.fault:
            raise self.fault
        return {
            "workers": {name: {"last_seen": at, "nthreads": 2} for name, at in self.beats.items()}
        }

    async def unregister(self, address, stimulus_id):
        assert stimulus_id
        del self.beats[address]


@pytest.fixture
def looked(monkeypatch):
    """Look each second for some seconds, in which some workers give signs of life."""
    scheduler = Scheduler()
    monkeypatch.setattr(dask_watch, "monotonic", lambda: scheduler.now)
    watch = ClusterWatch(scheduler, DaskCluster("tcp://127.0.0.1:1", TIMEOUT))

    def look(seconds, *lively):
        for _ in range(seconds):
            scheduler.now += 1
            scheduler.beats.update(dict.fromkeys(lively, scheduler.now))
            asyncio.run(watch.look())
        return watch.threads

    look.scheduler = scheduler
    return look


def test_a_silent_worker_is_given_up_when_its_time_is_over(looked):
    assert looked(6, "b") == 4
    assert looked(1, "b") == 2
    assert {*looked.scheduler.beats} == {"b"}


def test_without_a_look_at_heartbeats_a_silent_worker_is_not_given_up(looked, monkeypatch):
    monkeypatch.setattr(ClusterWatch, "_last", lambda _, name, told, now: (told, now))
    assert looked(20, "b") == 4


def test_a_cluster_whose_workers_are_all_silent_is_lost(looked):
    looked(5)
    with pytest.raises(ClusterLost, match=r"no worker of the Dask .* gave a sign of life for 5 s"):
        looked(2)


@pytest.mark.parametrize(
    ("fault", "said"), [(TimeoutError(), "gave no sign of life for 5 s"), (OSError(), "is gone")]
)
def test_a_cluster_without_a_scheduler_is_lost(looked, fault, said):
    looked.scheduler.fault = fault
    with pytest.raises(ClusterLost, match=said):
        looked(1, "a")
