"""Intervals: against a table of Student's distribution, and in samples whose mean is known."""

from math import exp, log, sqrt
from random import Random
from statistics import fmean, geometric_mean, mean, quantiles

import pytest

from allworlds.studies.compare.intervals import _bend, lack, mean_interval, power, ratio_interval

pytest.importorskip("scipy", reason="the extra figures is not installed")


def covered(interval, true, size, trials, deviation=0.3):
    """The share of lognormal samples of that size whose interval holds the true value."""
    random = Random(1)
    samples = ([random.lognormvariate(0, deviation) for _ in range(size)] for _ in range(trials))
    return sum(low <= true <= high for low, high in map(interval, samples)) / trials


def percentile(values):
    """Mutant: the interval of a plain bootstrap."""
    random = Random(1)
    drawn = [fmean(random.choices(values, k=len(values))) for _ in range(100)]
    ends = quantiles(drawn, n=40)
    return ends[0], ends[-1]


def test_the_factor_of_five_worlds_is_that_of_the_table():
    # E. S. Pearson, H. O. Hartley, Biometrika Tables for Statisticians I, table 12: 4 degrees.
    student = 2.776
    values = [exp(v) for v in (-2, -1, 0, 1, 2)]  # the deviation of the logarithms: sqrt(10 / 4)
    low, high = ratio_interval(values)
    assert high == pytest.approx(exp(student * sqrt(2.5 / 5)), rel=1e-3)
    assert low == pytest.approx(1 / high)
    low, high = mean_interval([8, 9, 10, 11, 12])
    assert high == pytest.approx(10 * exp(student * sqrt(2.5 / 5) / 10), rel=1e-4)
    assert low == pytest.approx(100 / high)


@pytest.mark.parametrize(("interval", "true"), [(mean_interval, exp(0.045)), (ratio_interval, 1)])
def test_an_interval_holds_the_true_value_as_often_as_it_says(interval, true):
    assert 0.92 < covered(interval, true, 5, 300) < 0.98


def test_the_bounds_of_that_test_refuse_a_plain_bootstrap():
    assert covered(percentile, exp(0.045), 5, 100) < 0.9


def test_an_interval_grows_with_its_sample():
    values = [3.0, 1.0, 4.0, 1.0, 5.0, 9.0]
    low, high = mean_interval(values)
    assert low < mean(values) < high
    assert mean_interval([2 * v for v in values]) == pytest.approx((2 * low, 2 * high))
    assert mean_interval(values * 4)[1] < high


@pytest.mark.parametrize("interval", [mean_interval, ratio_interval])
def test_few_worlds_and_a_cost_of_0_have_no_interval(interval):
    assert interval([1.0, 2.0, 3.0, 4.0]) is None
    assert interval([1.0, 2.0, 3.0, 4.0, 0.0]) is None
    assert interval([1.0, 2.0, 3.0, 4.0, 5.0])


def test_a_ratio_does_not_mind_which_explorer_is_first():
    ratios = [0.5, 0.7, 0.2, 0.9, 1.4, 0.8]
    low, high = ratio_interval(ratios)
    assert low < geometric_mean(ratios) < high
    assert ratio_interval([1 / ratio for ratio in ratios]) == pytest.approx((1 / high, 1 / low))


@pytest.mark.parametrize("interval", [mean_interval, ratio_interval])
def test_without_scipy_there_is_no_interval_and_a_word_why(interval, monkeypatch):
    monkeypatch.setattr("allworlds.inputs.checks.find_spec", lambda _: None)
    assert interval([1.0, 2.0, 3.0, 4.0, 5.0]) is None
    assert lack() == "needs scipy: in a clone of allworlds, pip install '.[figures]'"


# ---------------------------------------------------------------- exponents

SIZES = (12, 24, 50, 100, 200)


def grown(of, scatter=0.0, seed=0):
    """Costs by size, with a deviation of their logarithms."""
    random = Random(seed)
    return {m: of(m) * exp(random.gauss(0, scatter)) for m in SIZES}


def test_an_exponent_and_its_interval_are_those_of_a_linear_regression():
    from numpy import log as logs
    from scipy.stats import linregress, t

    costs = grown(lambda m: 3 * m**2, 0.1)
    found = power(costs)
    other = linregress(logs([*costs]), logs([*costs.values()]))
    reach = t.ppf(0.975, len(costs) - 2) * other.stderr
    assert found.exponent == pytest.approx(other.slope)
    assert found.interval == pytest.approx((other.slope - reach, other.slope + reach))


def test_an_interval_holds_the_exponent_as_often_as_it_says():
    """Of those that it gives: a bend that is none is seen in one of twenty."""
    found = [power(grown(lambda m: m**1.5, 0.1, seed)) for seed in range(400)]
    given = [each.interval for each in found if each.interval]
    held = sum(low <= 1.5 <= high for low, high in given)
    assert 0.92 < held / len(given) < 0.98
    assert 0.02 < 1 - len(given) / len(found) < 0.08


@pytest.mark.parametrize(
    ("of", "lack"),
    [
        (lambda m: exp(m / 40), "grows faster than a power"),
        (log, "grows slower than a power"),
        (lambda m: m**2, ""),
        (lambda m: m - 12, "a cost of 0"),
    ],
)
def test_costs_that_are_no_power_have_no_interval_and_say_why(of, lack):
    found = power(grown(of))
    assert found.lack == lack
    assert (found.interval is None) == bool(lack)


def test_few_sizes_have_no_exponent():
    costs = grown(lambda m: m)
    del costs[12]
    assert power(costs).exponent is None
    assert power(costs).lack == "fewer than 5 sizes"


def test_points_on_a_line_have_no_bend():
    assert _bend([1, 2, 3, 4, 5], [2, 4, 6, 8, 10]) == ""
