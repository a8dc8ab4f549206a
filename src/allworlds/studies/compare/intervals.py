"""Intervals of means and ratios by the bootstrap over worlds.

The worlds of one size are a sample, unless they are all there are: then their mean is exact, and
has no interval.  What is found in too few worlds has none either: the worlds of a size are the
different ones in which an explorer was run, and a single one shows no spread.  A *bootstrap* draws
as many worlds again from these, with repetition, :data:`DRAWS` times, and takes the middle of the
values found.  Small samples make a plain bootstrap too narrow, so that the tails that are cut off
are made smaller, by the factor that turns the plain interval of a normal population into Student's.
Of normal samples of 5 worlds 93% of the intervals hold the true mean, of 10 worlds 94%; plain ones
84% and 90%.  All draws have a fixed seed.

Source: T. C. Hesterberg, What Teachers Should Know About the Bootstrap, The American Statistician
69 (2015), section 4.1 ('expanded percentile').
"""

from collections.abc import Sequence
from functools import cache
from itertools import accumulate, islice
from math import atan, cos, exp, fsum, log, pi, sin, sqrt
from operator import mul
from statistics import NormalDist
from typing import Any, TypeAlias

DRAWS = 4000
"""Samples that are drawn from a sample."""

LEVEL = 0.95
"""The share of intervals that should hold the true value."""

LEAST_WORLDS = 5
"""The smallest sample that has an interval: different worlds of one size."""

Interval: TypeAlias = tuple[float, float]


def mean_interval(values: Sequence[float]) -> Interval | None:
    """The interval of the mean of a sample; None for fewer than :data:`LEAST_WORLDS` values."""
    if len(values) < LEAST_WORLDS:
        return None
    from numpy import asarray, quantile

    drawn = asarray(values, dtype=float)[_draws(len(values))].mean(axis=1)
    tail = _tail(len(values))
    low, high = quantile(drawn, [tail, 1 - tail])
    return float(low), float(high)


def geometric_mean(values: Sequence[float]) -> tuple[float, Interval | None] | None:
    """The geometric mean of a sample with its interval; None if a value is 0."""
    if min(values) <= 0:
        return None
    logs = [log(value) for value in values]
    interval = mean_interval(logs)
    found = interval and (exp(interval[0]), exp(interval[1]))
    return exp(fsum(logs) / len(logs)), found


@cache
def _draws(size: int) -> Any:
    """The members of the drawn samples, a line for each; shape (:data:`DRAWS`, size)."""
    from numpy.random import RandomState  # the one generator whose numbers never change

    return RandomState(0).randint(size, size=(DRAWS, size))


def _tail(size: int) -> float:
    """The share to be cut off at each end, for a sample of this size."""
    student = student_quantile((1 + LEVEL) / 2, size - 1)
    return NormalDist().cdf(-student * sqrt(size / (size - 1)))


@cache
def student_quantile(share: float, freedom: int) -> float:
    """The number that a variable of Student's distribution is below with that probability.

    Args:
        share: the probability, at least 1/2 and less than 1.
        freedom: degrees of freedom, a positive integer.

    Source: Abramowitz and Stegun, Handbook of Mathematical Functions, 26.7.3 and 26.7.4.
    """
    low, high = 0.0, 1.0
    while _student(high, freedom) < share:
        high *= 2
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if _student(middle, freedom) < share else (low, middle)
    return high


def _student(value: float, freedom: int) -> float:
    """The probability that a variable of Student's distribution is below a positive value."""
    angle, odd = atan(value / sqrt(freedom)), freedom % 2
    factors = (cos(angle) ** 2 * (k - 1) / k for k in range(2 + odd, freedom + 1, 2))
    terms = accumulate(factors, mul, initial=sin(angle) * (cos(angle) if odd else 1.0))
    inside = fsum(islice(terms, freedom // 2))
    return (1 + (2 / pi * (angle + inside) if odd else inside)) / 2
