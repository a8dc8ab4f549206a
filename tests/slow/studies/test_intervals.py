"""Coverage of intervals, measured by simulation."""

from functools import partial
from math import exp
from random import Random

import pytest

from allworlds.studies.compare.intervals import mean_interval, ratio_interval

pytest.importorskip("scipy", reason="the extra figures is not installed")


def covered(interval, draw, true, size, trials=2000):
    """The share of samples of that size whose interval holds the true value."""
    samples = ([draw() for _ in range(size)] for _ in range(trials))
    return sum(low <= true <= high for low, high in map(interval, samples)) / trials


@pytest.mark.slowest
@pytest.mark.parametrize("size", [5, 10, 30])
@pytest.mark.parametrize("deviation", [0.1, 0.3])
def test_intervals_of_lognormal_costs_hold_the_true_value_as_often_as_they_say(size, deviation):
    draw = partial(Random(size).lognormvariate, 0, deviation)
    # Of 2000 trials the standard error is 0.005.
    assert covered(ratio_interval, draw, 1, size) == pytest.approx(0.95, abs=0.015)
    true = exp(deviation**2 / 2)
    assert covered(mean_interval, draw, true, size) == pytest.approx(0.947, abs=0.015)


@pytest.mark.slowest
@pytest.mark.parametrize("size", [5, 30])
def test_of_other_costs_the_interval_of_the_mean_holds_it_nearly_as_often(size):
    random = Random(size)
    gamma = partial(random.gammavariate, 11, 1 / 11)
    normal = partial(random.gauss, 1, 0.2)
    for draw in (gamma, normal):
        assert covered(mean_interval, draw, 1, size) == pytest.approx(0.95, abs=0.015)
