"""A published S is a part of the world, or breaks a law; as the Python laws say."""

import numpy as np
from numba import njit

from allworlds.engines.kernel.arrays import ANSWER, JUDGED, WORLD, new
from allworlds.engines.kernel.laws import (
    INVARIANT_1,
    INVARIANT_2,
    look_at,
)
from allworlds.judging.laws.law_table import LAWS, Case
from allworlds.judging.walk import Walk
from allworlds.maps import rooted_maps
from allworlds.protocol.actions import Checkpoint
from allworlds.studies.run import run
from allworlds.world import Directional, World


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
    look(judged, answer, world, case.walk.here, sum(1 << d for d in walked))
    return [bool(judged.broken >> law & 1) for law in (INVARIANT_1, INVARIANT_2)]


def test_both_engines_say_the_same_of_a_u_that_holds_either_dart_of_an_edge():
    compared = {"smaller": 0, "larger": 0}
    for map_ in (map_ for edges in (1, 2, 3) for map_ in rooted_maps(edges)):
        episode = run("algorithm1", World(map_, Directional(0))).outcome.episode
        for steps, shown in episode.checkpoints:
            walk = Walk.of(episode.walk.world, episode.walk.actions[:steps])
            walked = walk.arrivals | {map_.alpha[dart] for dart in walk.arrivals}
            for dart, partner in enumerate(shown.alpha):
                if dart == partner:
                    continue
                alpha = [*shown.alpha[:dart], dart, *shown.alpha[dart + 1 :]]
                still_open = Checkpoint(shown.sigma, alpha, shown.here)
                case = Case(walk, ((steps, still_open),), episode.ending.answer)
                broken = [bool(LAWS[law].check(case)) for law in ("invariant-1", "invariant-2")]
                assert broken == seen_by_the_kernel(case, still_open, walked)
                # S is the explored part all the same: only U is wrong.
                assert broken == [False, True]
                compared["larger" if dart > partner else "smaller"] += 1
    assert min(compared.values()) > 100
