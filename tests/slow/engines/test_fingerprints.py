"""Which worlds a level has: two compiled enumerations, that in Python, and the corpus."""

import pytest
from numpy import array, int64, zeros

from allworlds.engines.compiled_engine import level_of
from allworlds.engines.kernel.arrays import GLUING, WORLD, new
from allworlds.engines.kernel.code import LESS, fingerprint
from allworlds.engines.kernel.compiling import entry
from allworlds.engines.kernel.engine import walk
from allworlds.engines.kernel.worlds import advance, gluing_rule, settle
from allworlds.engines.units import units_of_level
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.count_source import listed
from allworlds.studies.check.report import known_fingerprints
from small import slowest

pytestmark = pytest.mark.usefixtures("compiled")


@entry
def glue(g, world, prefix, viable, sums):
    while advance(g, prefix, viable):
        settle(world, g)
        sums[world.vertices] = (sums[world.vertices] + fingerprint(world, world.alpha)) & LESS


def glued(edges):
    """The fingerprints of the maps that the kernel glues together."""
    sums = zeros(edges + 2, int64)
    for degree in range(1, 2 * edges + 1):
        gluing = new(GLUING)
        gluing.edges, gluing.limit = edges, edges + 1
        glue(gluing, new(WORLD), array([-degree]), gluing_rule(edges), sums)
    return in_hexadecimal(enumerate(sums.tolist()))


def walked(edges, policy="fifo"):
    """Those of the maps that it decides where the robot looks."""
    extent, sums = Extent(MapClass.MAPS, edges), [0] * (edges + 2)
    level = level_of("algorithm1", Rules(policy=policy), extent, edges)
    for unit in units_of_level(extent, edges):
        for row in walk(level, unit.prefix).counts:
            sums[row.vertices] = (sums[row.vertices] + row.fingerprint) & LESS
    return in_hexadecimal(enumerate(sums))


def in_hexadecimal(sums):
    return {n: f"{each:x}" for n, each in sums if each}


@pytest.mark.parametrize("edges", [6, 7, slowest(8)])
def test_both_compiled_enumerations_have_the_worlds_of_the_corpus(edges):
    known = known_fingerprints(Extent(MapClass.MAPS, edges), edges)
    assert len(known) == edges + 1
    assert glued(edges) == known
    assert walked(edges) == known


@pytest.mark.parametrize("edges", [6, 7])
@pytest.mark.parametrize("policy", ["lifo", "nearest"])
def test_the_worlds_are_the_same_whatever_the_robot_looks_at_first(policy, edges):
    assert walked(edges, policy) == known_fingerprints(Extent(MapClass.MAPS, edges), edges)


@pytest.mark.parametrize("edges", [5, slowest(6), slowest(7)])
def test_the_enumeration_in_python_has_the_worlds_of_the_corpus(edges):
    extent = Extent(MapClass.MAPS, edges)
    assert in_hexadecimal(listed(extent, edges).items()) == known_fingerprints(extent, edges)
