"""Intervals: against tables, against every resample, and in samples whose mean is known."""

from itertools import product
from statistics import NormalDist, mean

import pytest

from allworlds.studies.compare.intervals import (
    geometric_mean,
    mean_interval,
    student_quantile,
)


@pytest.mark.parametrize(
    ("freedom", "value"),
    # E. S. Pearson, H. O. Hartley, Biometrika Tables for Statisticians I, table 12.
    [(1, 12.706), (2, 4.303), (3, 3.182), (4, 2.776), (9, 2.262), (10, 2.228), (120, 1.980)],
)
def test_student_is_that_of_the_tables(freedom, value):
    assert student_quantile(0.975, freedom) == pytest.approx(value, abs=5e-4)


def test_student_with_one_and_two_degrees_has_its_closed_form():
    # Of Cauchy's distribution, and 2 a / sqrt(2 - (2a)^2 ...) of two degrees.
    assert student_quantile(0.75, 1) == pytest.approx(1)
    share = 0.9
    closed = (2 * share - 1) * (2 / (4 * share * (1 - share))) ** 0.5
    assert student_quantile(share, 2) == pytest.approx(closed)


def test_the_draws_have_the_quantiles_of_all_resamples():
    values = [1.0, 2.0, 4.0, 8.0, 16.0]
    every = sorted(mean(drawn) for drawn in product(values, repeat=5))
    tail = NormalDist().cdf(-student_quantile(0.975, 4) * (5 / 4) ** 0.5)
    low, high = mean_interval(values)
    below = sum(value <= low for value in every) / len(every)
    above = sum(value >= high for value in every) / len(every)
    assert below == pytest.approx(tail, abs=0.003)
    assert above == pytest.approx(tail, abs=0.003)


def test_an_interval_is_the_same_every_time_and_moves_with_its_sample():
    values = [3.0, 1.0, 4.0, 1.0, 5.0, 9.0]
    low, high = mean_interval(values)
    assert mean_interval(values) == (low, high)
    assert low < mean(values) < high
    assert mean_interval([10 + 2 * v for v in values]) == pytest.approx(
        (10 + 2 * low, 10 + 2 * high)
    )


def test_few_worlds_have_no_interval():
    assert mean_interval([1.0, 2.0, 3.0, 4.0]) is None


def test_a_geometric_mean_does_not_mind_which_explorer_is_first():
    ratios = [0.5, 0.7, 0.2, 0.9, 1.4, 0.8]
    found, (low, high) = geometric_mean(ratios)
    other, (least, most) = geometric_mean([1 / ratio for ratio in ratios])
    assert found == pytest.approx(1 / other)
    assert (low, high) == pytest.approx((1 / most, 1 / least), rel=0.02)
    assert geometric_mean([1.0, 0.0]) is None
