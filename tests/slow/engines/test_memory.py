"""The memory of a check does not grow with its units."""

import gc
import tracemalloc

import pytest

from allworlds import ambiguity, check, worst
from allworlds.engines.listeners import Listener
from allworlds.engines.tally import Tally
from small import slowest

pytestmark = pytest.mark.usefixtures("compiled")

MOST = 150
"""Bytes a unit: a result is ten times as much."""


class Watches(Listener):
    """Looks, after every so many parts of units, how much memory is in use."""

    def __init__(self, units):
        self.units, self.done, self.used = units, 0, []

    def progress(self, worlds):
        self.done += 1
        if self.done % self.units == 0:
            gc.collect()
            self.used.append(tracemalloc.get_traced_memory()[0])

    @property
    def growth(self):
        """Bytes a unit, over the last three quarters of them."""
        begun = len(self.used) // 4
        assert len(self.used) - begun >= 4, "too few units to tell"
        return (self.used[-1] - self.used[begun]) / (self.units * (len(self.used) - 1 - begun))


@pytest.fixture(autouse=True)
def _many_units(monkeypatch):
    """Many units, and nothing is kept because its worlds are small: units, and logs of runs."""
    monkeypatch.setattr("allworlds.engines.units.DEPTHS", ((9, 5),))
    monkeypatch.setattr("allworlds.engines.sweep.SMALL", 0)
    monkeypatch.setattr("allworlds.engines.across.ACROSS", 0)


CHECKS = {
    "python": lambda **more: check(edges=4, engine="python", workers=1, **more),
    # Each further thread has memory of its own, once, whenever it gets its first unit.
    "compiled": lambda **more: check(edges=4, engine="kernel", workers=1, **more),
    "worst": lambda **more: worst(edges=4, **more),
    "census": lambda **more: ambiguity.census(edges=4, **more),
}


def growth_of(name, **more):
    """Bytes a unit, when what is loaded once has been loaded: code that was compiled, too."""
    for _ in range(3):
        CHECKS[name]()
    watches = Watches(40)
    gc.collect()
    gc.freeze()
    tracemalloc.start()
    try:
        CHECKS[name](listener=watches, **more)
    finally:
        tracemalloc.stop()
        gc.unfreeze()
    return watches.growth


@pytest.mark.slowest
@pytest.mark.early
@pytest.mark.parametrize("name", [slowest("python"), slowest("compiled"), "worst", "census"])
def test_memory_does_not_grow_with_the_units(name, tmp_path):
    # A census keeps what each of its worlds shows, and so grows with the worlds of its units.
    most = 2 * MOST if name == "census" else MOST
    assert growth_of(name) < most
    assert growth_of(name, run=tmp_path / "run") < most


@pytest.mark.slowest
@pytest.mark.early
@pytest.mark.parametrize("name", ["python", slowest("compiled")])
def test_a_check_that_keeps_every_result_is_found_out(name, monkeypatch):
    kept, add = [], Tally.add

    def keeps(self, other):
        kept.append(other)
        add(self, other)

    monkeypatch.setattr(Tally, "add", keeps)
    assert growth_of(name) > 3 * MOST
