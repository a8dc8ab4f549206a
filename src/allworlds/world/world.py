"""The world: pure, and the only thing that knows where the robot is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any

from allworlds.document import Document, about
from allworlds.inputs import integer, parse_json, show
from allworlds.maps import Alpha, CombinatorialMap, Dart, Sigma
from allworlds.protocol import Action, Drop, Move, Percept
from allworlds.world.lighthouses.base import InvalidWorld, Lighthouse, refuse_other_keys
from allworlds.world.lighthouses.directional import Directional
from allworlds.world.lighthouses.kinds import lighthouse_from_json
from allworlds.world.state import State, without_markers


class IllegalAction(ValueError):
    """An action that this world does not know."""


class WorldDocument(Document):
    """World.

    A map, a start and a lighthouse. Any other key is refused.
    """

    sigma: Sigma
    alpha: Alpha
    start: Annotated[Dart, about("the dart that the robot faces; else 0")] = 0
    lighthouse: Annotated[
        Lighthouse, about("where it stands; else the explorer's own, or a directional one")
    ] = Directional(0)


@dataclass(frozen=True)
class World:
    """A map, a lighthouse that stands in it, and the dart that the robot faces at the start.

    Raises:
        InvalidWorld: if the start is no dart, or the lighthouse does not fit.
    """

    map: CombinatorialMap
    lighthouse: Lighthouse
    start: Dart = 0

    def __post_init__(self) -> None:
        self.lighthouse.check(self.map, _a_start(self.start, self.map))

    @cached_property
    def percepts(self) -> tuple[Percept, ...]:
        """For each dart what is sensed by a robot that has arrived by it and dropped nothing."""
        return self.lighthouse.percepts(self.map)

    @property
    def initial(self) -> State:
        """The state at the start."""
        return State(self.start, (), self.lighthouse.in_hand)

    @property
    def first(self) -> Percept:
        """What is sensed before any motion."""
        return self.percepts[self.start]

    @property
    def told(self) -> int | None:
        """What the lighthouse tells the explorer before the start, if anything."""
        return self.lighthouse.told(self.map)

    def step(self, state: State, action: Action) -> tuple[State, Percept]:
        """The state after the action, and what the robot senses then.

        Raises:
            IllegalAction: for markers that there are not, with what would be legal.
        """
        if type(action) is Move:
            dart = self.map.alpha[self.map.turn(state.dart, action.k)]
            if state.lying or state.hand:
                after = State(dart, state.lying, state.hand)
                return after, self.sensed(after)
            return without_markers(dart), self.percepts[dart]
        here, lying = self.map.vertex_of[state.dart], [*state.lying]
        if refusal := self.lighthouse.refusal(action, lying.count(here), state.hand):
            raise IllegalAction(refusal)
        if type(action) is Drop:
            lying.append(here)
        else:
            lying.remove(here)
        hand = state.hand + len(state.lying) - len(lying)
        after = State(state.dart, tuple(sorted(lying)), hand)
        return after, self.sensed(after)

    def sensed(self, state: State) -> Percept:
        """What the robot senses in a state: what has been dropped is one mark each."""
        percept = self.percepts[state.dart]
        return percept.marked(state.lying.count(self.map.vertex_of[state.dart]))

    def relabelled(self, names: Sequence[Dart]) -> World:
        """The same world with dart ``d`` renamed to ``names[d]``."""
        return World(
            self.map.relabelled(names), self.lighthouse.relabelled(names), names[self.start]
        )

    def mirrored(self) -> World:
        """The mirror image, marker and start included."""
        return World(self.map.mirrored(), self.lighthouse, self.start)

    def to_json(self) -> dict[str, Any]:
        """The document :class:`WorldDocument`."""
        return WorldDocument(
            sigma=self.map.sigma,
            alpha=self.map.alpha,
            start=self.start,
            lighthouse=self.lighthouse,
        ).to_json()

    @classmethod
    def from_json(
        cls, document: str | Mapping[str, Any], *, missing: str = Directional.kind
    ) -> World:
        """The world of :meth:`to_json`'s document, or of its text; other keys are refused.

        ``start`` may be missing (0), and so may the lighthouse: then it is of the kind
        ``missing``, at its default place.

        Raises:
            InvalidMap, InvalidWorld: naming the offending value and what would be legal.
        """
        if isinstance(document, str):
            document = parse_json(document, InvalidWorld)
        if not isinstance(document, Mapping):
            raise InvalidWorld(
                f"a world is an object with 'sigma' and 'alpha', not {show(document)}"
            )
        refuse_other_keys("world", document, ("sigma", "alpha", "start", "lighthouse"))
        if document.get("lighthouse", "") is None:
            raise InvalidWorld(f"lighthouse = None is no object; without one it is {missing}")
        map_ = CombinatorialMap.from_json(document)
        # A lighthouse looks for its place from the start, which must be one then.
        start = _a_start(document.get("start", 0), map_)
        lighthouse = lighthouse_from_json(document.get("lighthouse"), map_, start, missing)
        return cls(map_, lighthouse, start)


def _a_start(given: object, map_: CombinatorialMap) -> Dart:
    """The start, if it is a dart of the map; else raises InvalidWorld."""
    try:
        start = integer(given)
    except TypeError:
        raise InvalidWorld(f"start = {show(given)} is not an integer") from None
    if start not in map_.darts:
        raise InvalidWorld(f"start = {show(start)} is no dart; darts are 0..{len(map_.sigma) - 1}")
    return start
