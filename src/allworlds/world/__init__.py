"""Worlds: a map, a lighthouse and a start; explorers never see one.

``lighthouses``
    what is marked, and what of it can be sensed; one kind a module;
``state``
    what a step changes: where the robot is, and where its markers are;
``world``
    the three together, and what a step does;
``enumeration``
    every world of a class, for loops of one's own;
``named``
    what a WORLD may be on the command line and in Python;
``corpus``
    the worlds, findings and pairs that ship with the package;
``bisimulation``
    the checker of a proof that two worlds look alike.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.world.bisimulation import flaw as flaw
    from allworlds.world.corpus import Manifest as Manifest, own_corpus as own_corpus
    from allworlds.world.enumeration import worlds as worlds
    from allworlds.world.lighthouses.base import (
        InvalidWorld as InvalidWorld,
        Lighthouse as Lighthouse,
        WalkInAnswer as WalkInAnswer,
    )
    from allworlds.world.lighthouses.cluster import Cluster as Cluster
    from allworlds.world.lighthouses.compass import Compass as Compass
    from allworlds.world.lighthouses.directional import Directional as Directional
    from allworlds.world.lighthouses.kinds import (
        LIGHTHOUSES as LIGHTHOUSES,
        AskedLighthouse as AskedLighthouse,
        lighthouse_from_json as lighthouse_from_json,
        lighthouse_named as lighthouse_named,
    )
    from allworlds.world.lighthouses.labels import Labels as Labels
    from allworlds.world.lighthouses.movable import Movable as Movable
    from allworlds.world.lighthouses.natural import Natural as Natural
    from allworlds.world.lighthouses.nothing import Nothing as Nothing
    from allworlds.world.lighthouses.position import Position as Position
    from allworlds.world.lighthouses.sensing import Sensing as Sensing, Where as Where
    from allworlds.world.named import (
        HOLES as HOLES,
        FamilyWords as FamilyWords,
        map_of_family as map_of_family,
        world_named as world_named,
    )
    from allworlds.world.state import State as State
    from allworlds.world.world import (
        IllegalAction as IllegalAction,
        World as World,
        WorldDocument as WorldDocument,
    )
else:
    open_door(__name__)
