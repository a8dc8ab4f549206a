"""Worlds: a map, a lighthouse and a start; explorers never see a world.

``lighthouses``
    the marks and directions in a world, and the percepts that they cause;
``state``
    the state that a step changes: the robot's dart, its markers, and the written numbers;
``world``
    map, lighthouse and start together, and the effect of a step;
``labels``
    the names of a world and its vertices, and the positions of the vertices;
``named``
    the forms of a WORLD on the command line and in Python; the worlds, findings and pairs of
    worlds that come with the package;
``selection``
    the options that choose the lighthouse and the condition on maps; the function that yields all
    worlds of a class.  A lighthouse or a condition may be a user's program; to find mistakes, the
    program is tried on small maps before it is used;
``bisimulation``
    the checker of proofs that worlds are indistinguishable.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.protocol.actions import IllegalAction as IllegalAction
    from allworlds.world.labels import Labelling as Labelling
    from allworlds.world.lighthouses.base import (
        Lighthouse as Lighthouse,
        Sensing as Sensing,
        Where as Where,
    )
    from allworlds.world.lighthouses.composed import (
        Composed as Composed,
        Doormarks as Doormarks,
        Knowledge as Knowledge,
        Movable as Movable,
        Nothing as Nothing,
        Whiteboard as Whiteboard,
    )
    from allworlds.world.lighthouses.kinds import LIGHTHOUSES as LIGHTHOUSES
    from allworlds.world.lighthouses.marked import (
        Cluster as Cluster,
        Compass as Compass,
        Directional as Directional,
        Door as Door,
        Labels as Labels,
        Natural as Natural,
        Position as Position,
        Word as Word,
    )
    from allworlds.world.lighthouses.options import InvalidWorld as InvalidWorld
    from allworlds.world.named import (
        code_of as code_of,
        map_of_code as map_of_code,
        names_of_worlds as names_of_worlds,
        world_named as world_named,
    )
    from allworlds.world.selection import worlds as worlds
    from allworlds.world.state import State as State
    from allworlds.world.world import World as World, at_place as at_place
else:
    open_door(__name__)
