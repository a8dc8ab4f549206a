"""Intervals: against tables, against every resample, and in samples whose mean is known."""

from random import Random
from statistics import quantiles

import pytest
from numpy import asarray

from allworlds.studies.compare import intervals
from allworlds.studies.compare.intervals import mean_interval


def covered(size, trials, interval):
    """The share of normal samples of that size whose interval holds the mean, 0."""
    random = Random(1)
    samples = ([random.gauss() for _ in range(size)] for _ in range(trials))
    return sum(low <= 0 <= high for low, high in map(interval, samples)) / trials


def plain(values):
    """Mutant: the interval of the plain bootstrap."""
    drawn = asarray(values)[intervals._draws(len(values))].mean(axis=1)
    ends = quantiles(drawn.tolist(), n=40)
    return ends[0], ends[-1]


@pytest.mark.long
@pytest.mark.parametrize("size", [5, 10])
def test_an_interval_holds_the_true_mean_nearly_as_often_as_it_says(size):
    assert 0.92 < covered(size, 1000, mean_interval) < 0.97
    assert covered(size, 1000, plain) < 0.91
