"""Intervals of means and ratios of positive costs, by Student's t on logarithms.

The worlds of one size are a sample, unless they are all there are: then their mean is exact, and
has no interval.  Fewer than :data:`LEAST_WORLDS` different ones have none either, nor has a sample
where scipy is not installed.  A ratio is a geometric mean, whose logarithm is the mean of
logarithms.  The logarithm of a mean scatters, to the first order, as the mean does, as a share of
it.  Of samples of 5, 10 and 30 costs whose logarithms are normal with the deviation 0.3, 95% of the
intervals of a ratio hold the true one, and 94.6%, 94.4% and 94.8% of those of a mean; with the
deviation 0.6 of a mean 93%.  BCa intervals, by a bootstrap, hold that with 0.3 in 85%, 91% and 92%.
"""

from collections.abc import Sequence
from math import exp, log, sqrt
from statistics import fmean, geometric_mean, stdev
from typing import TypeAlias

from allworlds.inputs.checks import lack_of

LEVEL = 0.95
"""The share of intervals that should hold the true value."""

LEAST_WORLDS = 5
"""The smallest sample that has an interval: different worlds of one size."""

Interval: TypeAlias = tuple[float, float]


def lack() -> str:
    """The words that there is no interval for want of scipy; empty if it is installed."""
    return lack_of("scipy", "figures")


def mean_interval(values: Sequence[float]) -> Interval | None:
    """The interval of the mean of a sample; None for too few values, for a 0 or without scipy."""
    if not _has_interval(values):
        return None
    mean = fmean(values)
    return _interval(mean, stdev(values) / mean, len(values))


def ratio_interval(values: Sequence[float]) -> Interval | None:
    """The interval of the geometric mean of a sample; None as for :func:`mean_interval`."""
    if not _has_interval(values):
        return None
    return _interval(geometric_mean(values), stdev(map(log, values)), len(values))


def _has_interval(values: Sequence[float]) -> bool:
    return len(values) >= LEAST_WORLDS and min(values) > 0 and not lack()


def _interval(middle: float, deviation: float, size: int) -> Interval:
    """The interval of a value whose logarithm is a mean, of a sample with this deviation."""
    from scipy.special import stdtrit

    factor: float = exp(stdtrit(size - 1, (1 + LEVEL) / 2) * deviation / sqrt(size))
    return middle / factor, middle * factor
