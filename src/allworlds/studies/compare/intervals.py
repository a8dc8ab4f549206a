"""Intervals of means, ratios and exponents of positive costs, by Student's t on logarithms.

The worlds of one size are a sample, unless they are all there are: then their mean is exact, and
has no interval.  Fewer than :data:`LEAST_WORLDS` different ones have none either, nor has a sample
where scipy is not installed.  A ratio is a geometric mean, whose logarithm is the mean of
logarithms.  The logarithm of a mean scatters, to the first order, as the mean does, as a share of
it.  Of samples of 5, 10 and 30 costs whose logarithms are normal with the deviation 0.3, 95% of the
intervals of a ratio hold the true one, and 94.6%, 94.4% and 94.8% of those of a mean; with the
deviation 0.6 of a mean 93%.  BCa intervals, by a bootstrap, hold that with 0.3 in 85%, 91% and 92%.

An exponent is the slope of a straight line, by least squares through a point for each size: the
logarithms of its edges and of its mean cost.  Its interval is that of a linear regression.  It has
none where sizes are few, or where the points bend: no power of the edges grows like them.
"""

from collections.abc import Mapping, Sequence
from math import exp, fsum, log, sqrt
from statistics import fmean, geometric_mean, linear_regression, stdev
from typing import TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import lack_of

LEVEL = 0.95
"""The share of intervals that should hold the true value."""

LEAST_WORLDS = 5
"""The smallest sample that has an interval: different worlds of one size."""

LEAST_SIZES = 5
"""The least number of sizes from which an exponent is fitted."""

CLOSE = 0.01
"""The largest deviation from a power, as a share, in which no bend is looked for."""

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


class Power(Struct, frozen=True):
    """The power of the edges that fits mean costs best.

    Attributes:
        exponent: of the edges; None where none is fitted.
        interval: of the exponent, or None.
        lack: the words why there is no interval; empty if there is one.
    """

    exponent: float | None
    interval: Interval | None
    lack: str


def power(costs: Mapping[int, float]) -> Power:
    """The power law of mean costs by edges: of :data:`LEAST_SIZES` or more, all positive."""
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
    """The part of each height that the best straight line leaves."""
    slope, height = linear_regression(across, up)
    return [y - height - slope * x for x, y in zip(across, up, strict=True)]


def _reach(left: Sequence[float], across: Sequence[float], degrees: int) -> float:
    """The half width of the interval of a slope, from what its line leaves."""
    middle = fmean(across)
    width = fsum((x - middle) ** 2 for x in across)
    return _student(degrees) * sqrt(fsum(e * e for e in left) / degrees / width)


def _bend(sizes: Sequence[float], heights: Sequence[float]) -> str:
    """The words that the points bend, by a square beside the line; empty if they do not.

    By the theorem of Frisch, Waugh and Lovell its coefficient is the slope of what the line leaves
    of the heights over what it leaves of the squares.
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
    """The interval of a value whose logarithm is a mean, of a sample with this deviation."""
    factor = exp(_student(size - 1) * deviation / sqrt(size))
    return middle / factor, middle * factor


def _student(degrees: int) -> float:
    """The factor of Student's t that leaves out the same share on both sides."""
    from scipy.special import stdtrit

    factor: float = stdtrit(degrees, (1 + LEVEL) / 2)
    return factor
