"""Worlds: a map, a lighthouse and a start; explorers never see one.

``lighthouses``
    the marks and directions in a world, and the percepts that they cause; one kind a module;
``state``
    the state that a step changes: the places of the robot and of its markers;
``world``, ``illegal_action``
    map, lighthouse and start together, the effect of a step, and the error where there is none;
``enumeration``
    every world of a class, for loops of one's own;
``named``
    the forms of a WORLD on the command line and in Python;
``asked_lighthouse``, ``own_condition``
    the lighthouse of a request, and conditions that narrow a class of maps; the user's are tried;
``corpus``
    the worlds, findings and pairs that ship with the package;
``bisimulation``
    the checker of a proof that two worlds look alike.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.protocol import IllegalAction as IllegalAction
    from allworlds.world.lighthouses.base import (
        Lighthouse as Lighthouse,
        Sensing as Sensing,
        Where as Where,
    )
    from allworlds.world.lighthouses.composed import Composed as Composed
    from allworlds.world.lighthouses.everywhere import Compass as Compass, Labels as Labels
    from allworlds.world.lighthouses.kinds import (
        LIGHTHOUSES as LIGHTHOUSES,
        lighthouse_named as lighthouse_named,
    )
    from allworlds.world.lighthouses.knowledge import Knowledge as Knowledge, Nothing as Nothing
    from allworlds.world.lighthouses.left import (
        Movable as Movable,
        Ports as Ports,
        Whiteboard as Whiteboard,
    )
    from allworlds.world.lighthouses.marked import (
        Cluster as Cluster,
        Directional as Directional,
        Natural as Natural,
        Position as Position,
    )
    from allworlds.world.lighthouses.options import InvalidWorld as InvalidWorld
    from allworlds.world.named import (
        code_of as code_of,
        map_of_code as map_of_code,
        names_of_worlds as names_of_worlds,
        world_named as world_named,
    )
    from allworlds.world.own_condition import worlds as worlds
    from allworlds.world.state import State as State
    from allworlds.world.world import World as World, at_place as at_place

# For other parts of the program.
if TYPE_CHECKING:
    from allworlds.world.asked_lighthouse import (
        AskedLighthouse as AskedLighthouse,
        flaws_of as flaws_of,
        tried_kind as tried_kind,
    )
    from allworlds.world.bisimulation import flaw as flaw
    from allworlds.world.corpus import Manifest as Manifest, own_corpus as own_corpus
    from allworlds.world.lighthouses.base import (
        ReferenceLighthouse as ReferenceLighthouse,
        WalkInAnswer as WalkInAnswer,
    )
    from allworlds.world.lighthouses.kinds import (
        OWN as OWN,
        GivenLighthouse as GivenLighthouse,
        LighthouseKind as LighthouseKind,
        kind_of as kind_of,
        lighthouse_kind as lighthouse_kind,
        numbers_told as numbers_told,
        parts_of as parts_of,
    )
    from allworlds.world.lighthouses.knowledge import TOLD as TOLD
    from allworlds.world.lighthouses.left import NumberRoom as NumberRoom
    from allworlds.world.lighthouses.options import place_keys as place_keys
    from allworlds.world.named import (
        HOLES as HOLES,
        LIGHTHOUSE as LIGHTHOUSE,
        WORLD as WORLD,
        AskedWorld as AskedWorld,
        a_world as a_world,
        map_of_family as map_of_family,
    )
    from allworlds.world.own_condition import (
        AskedWhere as AskedWhere,
        Predicate as Predicate,
        a_condition as a_condition,
        files_of_condition as files_of_condition,
    )
    from allworlds.world.world import WorldDocument as WorldDocument
else:
    open_door(__name__)
