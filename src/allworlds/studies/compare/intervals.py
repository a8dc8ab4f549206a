"""Confidence intervals of mean costs, of ratios of costs, and of exponents, at the level of 95%.

An interval says how far the value of a sample may be from the true value.  The worlds of one size
are a sample, unless they are all worlds of that size: then their mean is exact, and has no
interval.  A sample has no interval if it has fewer than :data:`LEAST_WORLDS` different worlds, if a
cost is 0, or if scipy is not installed.

*Ratios and means.*  Student's t gives an interval of a mean from the standard deviation of the
values.  Here it is applied to logarithms.  The ratio of two explorers is the geometric mean of
their ratios in the single worlds.  So the logarithm of the ratio is the mean of logarithms, and t
applies to these logarithms.  A mean cost is an arithmetic mean.  Here the interval is one of the
logarithm of the mean cost.  In place of the standard deviation of the logarithms, the relative
deviation is taken: the standard deviation of the costs, divided by the mean cost.  The two
deviations are equal to first order.

This was tried in samples of costs whose logarithms have a normal distribution.  If the logarithms
have the standard deviation 0.3, the interval contains the true ratio in 95% of the samples; it
contains the true mean in 94.6%, 94.4% and 94.8% of the samples of 5, 10 and 30 costs.  If they have
the standard deviation 0.6, it contains the true mean in 93%.  The BCa intervals of a bootstrap are
worse: with the deviation 0.3 they contain the true mean in 85%, 91% and 92% of the samples.

*Exponents.*  For each size there is a point: the logarithm of the number of edges, and that of the
mean cost.  The exponent is the slope of the line that least squares fit to these points, and its
interval is that of a linear regression.  There is no interval for few sizes, or if the points
*bend*, that is, lie on a curve: then the cost is no power of the edges.
"""

from collections.abc import Mapping, Sequence
from math import exp, fsum, log, sqrt
from statistics import fmean, geometric_mean, linear_regression, stdev
from typing import TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import lack_of

LEVEL = 0.95
"""The share of intervals that should contain the true value."""

LEAST_WORLDS = 5
"""The least number of different worlds of one size whose mean or ratio has an interval."""

LEAST_SIZES = 5
"""The least number of sizes from which an exponent is fitted."""

CLOSE = 0.01
"""A relative deviation from a power law.  If no point deviates more, the points do not bend."""

Interval: TypeAlias = tuple[float, float]


def lack() -> str:
    """A text that says that there is no interval without scipy; empty if scipy is installed."""
    return lack_of("scipy", "figures")


def mean_interval(values: Sequence[float]) -> Interval | None:
    """The confidence interval of the true mean, from a sample of values.

    None for fewer than :data:`LEAST_WORLDS` values, for a value of 0, or without scipy.
    """
    if not _has_interval(values):
        return None
    mean = fmean(values)
    return _interval(mean, stdev(values) / mean, len(values))


def ratio_interval(values: Sequence[float]) -> Interval | None:
    """The confidence interval of the true geometric mean, from a sample of values.

    None in the same cases as for :func:`mean_interval`.
    """
    if not _has_interval(values):
        return None
    return _interval(geometric_mean(values), stdev(map(log, values)), len(values))


class Power(Struct, frozen=True):
    """The power of the number of edges that fits mean costs best.

    Attributes:
        exponent: the exponent of the number of edges; None if no power is fitted.
        interval: the confidence interval of the exponent; None if there is none.
        lack: the reason why there is no interval; empty if there is one.
    """

    exponent: float | None
    interval: Interval | None
    lack: str


def power(costs: Mapping[int, float]) -> Power:
    """The power law that fits mean costs; ``costs`` has a mean cost for each number of edges.

    No exponent is fitted for fewer than :data:`LEAST_SIZES` sizes, or if a cost is 0.
    """
    if len(costs) < LEAST_SIZES:
        return Power(None, None, f"fewer than {LEAST_SIZES} sizes")
    if min(costs.values()) <= 0:
        return Power(None, None, "a cost of 0")
    sizes, heights = [*map(log, costs)], [*map(log, costs.values())]
    slope, _ = linear_regression(sizes, heights)
    without = lack() or _bend(sizes, heights)
    if without:
        return Power(slope, None, without)
    reach = _reach(_left_by(sizes, heights), sizes, len(sizes) - 2)
    return Power(slope, (slope - reach, slope + reach), "")


def _left_by(across: Sequence[float], up: Sequence[float]) -> list[float]:
    """The residuals of ``up`` after a linear fit over ``across``.

    ``up`` has the heights of the points, ``across`` their abscissas.
    """
    slope, height = linear_regression(across, up)
    return [y - height - slope * x for x, y in zip(across, up, strict=True)]


def _reach(left: Sequence[float], across: Sequence[float], degrees: int) -> float:
    """The half width of the confidence interval of the slope of a fitted line.

    Args:
        left: the residuals of the fit.
        across: the abscissas of the points.
        degrees: the number of degrees of freedom of the residuals.
    """
    middle = fmean(across)
    width = fsum((x - middle) ** 2 for x in across)
    return _student(degrees) * sqrt(fsum(e * e for e in left) / degrees / width)


def _bend(sizes: Sequence[float], heights: Sequence[float]) -> str:
    """A text that says how the points bend; empty if a line fits the points well enough.

    A point has an abscissa x in ``sizes``, the logarithm of a number of edges, and a height y in
    ``heights``, the logarithm of a mean cost.  The points bend if a parabola fits them better than
    a line, that is, if the coefficient of ``x^2`` in the parabola differs significantly from 0.

    Linear fits are enough to find this coefficient, by the theorem of Frisch, Waugh and Lovell.
    First, ``x^2`` is fitted by a line over x, and y is fitted by another line over x; both fits
    leave residuals.  Then the residuals of y are fitted by a line over the residuals of ``x^2``.
    The slope of the last line is the coefficient.
    """
    left = _left_by(sizes, heights)
    if max(map(abs, left)) < CLOSE:
        return ""
    squares = _left_by(sizes, [x * x for x in sizes])
    curve, _ = linear_regression(squares, left)
    rest = [y - curve * x for x, y in zip(squares, left, strict=True)]
    if abs(curve) <= _reach(rest, squares, len(sizes) - 3):
        return ""
    return "grows faster than a power" if curve > 0 else "grows slower than a power"


def _has_interval(values: Sequence[float]) -> bool:
    return len(values) >= LEAST_WORLDS and min(values) > 0 and not lack()


def _interval(middle: float, deviation: float, size: int) -> Interval:
    """The confidence interval of ``middle``, which is a geometric mean.

    The logarithm of ``middle`` is the mean of a sample of ``size`` logarithms, whose standard
    deviation is ``deviation``.
    """
    factor = exp(_student(size - 1) * deviation / sqrt(size))
    return middle / factor, middle * factor


def _student(degrees: int) -> float:
    """The number t for the half width of an interval at the level :data:`LEVEL`.

    Student's t with this many degrees of freedom is between -t and t with the probability
    :data:`LEVEL`.
    """
    from scipy.special import stdtrit

    factor: float = stdtrit(degrees, (1 + LEVEL) / 2)
    return factor
