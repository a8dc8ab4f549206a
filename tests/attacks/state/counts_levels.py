"""Right but for a triangle and a square, which look alike: by counting it knows the level.

It knows how often everything is played a second time, and by a file in which process it is.
What it does not know is which of these plays are of worlds that came long before; and with two
workers it loses count, and is wrong in both plays alike.

verdict: refuted nondeterministic or map
options: --class simple --edges 4 --lighthouse none --laws map,pose
quick: 1
"""

from itertools import count
from pathlib import Path
from random import Random

from allworlds import Estimate, Move
from allworlds.engines import units_of_level
from allworlds.maps import Extent, MapClass
from allworlds.world import LIGHTHOUSES, World

EXTENT = Extent(MapClass.SIMPLE, 4)
UNITS = {
    edges: [[*unit.maps(EXTENT)] for unit in units_of_level(EXTENT, edges)]
    for edges in EXTENT.levels
}
TURN = count()
STATE = {}


def plays_of_levels(second):
    """The number of plays of each level: at the beginning all are played again several times."""
    told = 0
    for edges, units in UNITS.items():
        plays = 0
        for unit in filter(None, units):
            wanted = max(32 - told, 16 if told < 128 else 1) if second else 1
            plays += -(-wanted // len(unit)) * len(unit)
            told += -(-wanted // len(unit)) * len(unit)
        yield edges, plays


def level():
    """The number of edges of the world in which it must be."""
    if not STATE:
        STATE["second"] = Path("first").exists()
        Path("first").touch()
    left = next(TURN)
    for edges, plays in plays_of_levels(STATE["second"]):
        left -= plays
        if left < 0:
            return edges
    return max(UNITS)


def explore(first):
    edges = level()
    left = [
        World(map_, next(iter(LIGHTHOUSES["none"].places(map_, 0))), 0)
        for units in UNITS.values()
        for unit in units
        for map_ in unit
    ]
    left = [(world, world.initial) for world in left if world.first == first]
    draw = Random(1)
    for _ in range(20):
        move = Move(draw.randrange(12))
        percept = yield move
        stepped = [(world, *world.step(at, move)) for world, at in left]
        left = [(world, at) for world, at, sensed in stepped if sensed == percept]
    left.sort(key=lambda found: found[0].map.edge_count != edges)
    world, at = left[0]
    return Estimate(world.map, at.dart)
