"""A published S is a part of the world, or breaks a law; as the Python laws say."""

import numpy as np
from numba import njit

from allworlds.engines.kernel.laws import (
    INVARIANT_1,
    INVARIANT_2,
    look_at,
)
from allworlds.engines.kernel.records import ANSWER, JUDGED, WORLD, new


@njit(error_model="numpy")
def look(judged, published, world, dart, walked):
    look_at(judged, published, world, dart, walked)


def published_as(sigma, alpha, here):
    """The record of a published S, and the arrays to which it points."""
    arrays = [np.array(values, np.int32) for values in (sigma, alpha)]
    answer = new(ANSWER)
    answer.sigma, answer.alpha = (array.ctypes.data for array in arrays)
    answer.darts, answer.here = len(sigma), here
    return answer, arrays


def seen_by_the_kernel(case, checkpoint, walked):
    """The laws I-1 and I-2 that the one checkpoint breaks, by compiled code."""
    world, judged = new(WORLD), new(JUDGED)
    world.darts = len(case.map.sigma)
    world.sigma[: world.darts], world.alpha[: world.darts] = case.map.sigma, case.map.alpha
    answer, _arrays = published_as(checkpoint.sigma, checkpoint.alpha, checkpoint.here)
    look(judged, answer, world, case.trail[-1], sum(1 << d for d in walked))
    return [bool(judged.broken >> law & 1) for law in (INVARIANT_1, INVARIANT_2)]
