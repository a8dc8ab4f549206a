"""The world: pure, and the only place where the robot's position is known."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any

from allworlds.document import Document, Pictured, about
from allworlds.inputs.checks import parse_json, show
from allworlds.maps.combinatorial import Alpha, CombinatorialMap, Dart, Sigma
from allworlds.maps.networks import from_networkx, to_networkx
from allworlds.protocol.actions import Action, IllegalAction, Move, Percept, Told
from allworlds.world.lighthouses.base import Lighthouse, State
from allworlds.world.lighthouses.kinds import GivenLighthouse, lighthouse_from_json
from allworlds.world.lighthouses.marked import Directional
from allworlds.world.lighthouses.options import InvalidWorld, refuse_other_keys, the_integer


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


@dataclass(frozen=True, init=False)
class World(Pictured):
    """A map, a lighthouse that stands in it, and the dart that the robot faces at the start.

    Args:
        map: the map.
        lighthouse: one that stands at its place; or a kind, such as ``"position"``, which is put
            at its default place; None stands for ``"directional"``, as in a WORLD that names none.
        start: the dart.

    Raises:
        InvalidWorld: if the start is no dart, or the lighthouse does not fit.
    """

    map: CombinatorialMap
    lighthouse: Lighthouse
    start: Dart

    def __init__(
        self,
        map: CombinatorialMap,  # noqa: A002  # the word of the field
        lighthouse: Lighthouse | GivenLighthouse | None = None,
        start: Dart = 0,
    ) -> None:
        if not isinstance(map, CombinatorialMap):
            raise InvalidWorld(f"map = {show(map)} is no CombinatorialMap; maps.family makes one")
        start = _a_start(start, map)
        if not isinstance(lighthouse, Lighthouse):
            kind = Directional.kind if lighthouse is None else lighthouse
            lighthouse = lighthouse_from_json(None, map, start, kind)
        lighthouse.check(map, start)
        object.__setattr__(self, "map", map)
        object.__setattr__(self, "lighthouse", lighthouse)
        object.__setattr__(self, "start", start)

    @cached_property
    def percepts(self) -> tuple[Percept, ...]:
        """For each dart the percept of a robot that has arrived by it and dropped no marker."""
        return self.lighthouse.percepts(self.map)

    @property
    def initial(self) -> State:
        """The state at the start."""
        return State(self.start, (), self.lighthouse.in_hand)

    @property
    def first(self) -> Percept:
        """The percept before any motion."""
        return self.percepts[self.start]

    @property
    def over(self) -> bool:
        """Whether the world ends the run: it never does."""
        return False

    @property
    def told(self) -> Told:
        """The value that the explorer is told before the start; None if there is none."""
        return self.lighthouse.told(self.map)

    def step(self, state: State, action: Action) -> tuple[State, Percept]:
        """The state after the action, and the robot's percept then.

        Raises:
            IllegalAction: for markers that are not there, naming the legal actions.
        """
        if type(action) is Move:
            dart = self.map.alpha[self.map.turn(state.dart, action.k)]
            if state.lying or state.hand or state.written:
                after = State(dart, state.lying, state.hand, state.written)
                return after, self.sensed(after)
            return State(dart), self.percepts[dart]
        lying = state.lying.count(self.map.vertex_of[state.dart])
        if refusal := self.lighthouse.refusal(action, lying, state.hand):
            raise IllegalAction(refusal)
        after = self.lighthouse.acted(self.map, state, action)
        return after, self.sensed(after)

    def sensed(self, state: State) -> Percept:
        """The robot's percept in a state, with the marks that it has left there itself."""
        return self.percepts[state.dart].marked(self.lighthouse.left_marks(self.map, state))

    def relabelled(self, names: Sequence[Dart]) -> "World":
        """Return this world with dart ``d`` renamed to ``names[d]``."""
        return World(
            self.map.relabelled(names), self.lighthouse.relabelled(names), names[self.start]
        )

    def mirrored(self) -> "World":
        """The mirror image, marker and start included."""
        return World(self.map.mirrored(), self.lighthouse, self.start)

    def to_networkx(self) -> Any:
        """The graph of the map, of networkx; see :func:`allworlds.maps.networks.to_networkx`.

        Its attributes ``start`` and ``lighthouse`` are those of the world's document, and
        :meth:`from_networkx` takes them back.
        """
        graph = to_networkx(self.map)
        graph.graph.update(start=self.start, lighthouse=self.lighthouse.to_json())
        return graph

    @classmethod
    def from_networkx(
        cls, graph: Any, lighthouse: Lighthouse | GivenLighthouse | None = None, start: Dart = 0
    ) -> "World":
        """The world in the map of a graph of networkx.

        Args:
            graph: as :func:`allworlds.maps.networks.from_networkx` takes it.
            lighthouse: as for a world, if the graph has no attribute of that name.
            start: likewise.

        Raises:
            InvalidMap, InvalidWorld: naming the offending value and what would be legal.
        """
        map_, told = from_networkx(graph), graph.graph
        begin = _a_start(told.get("start", start), map_)
        if "lighthouse" in told:
            lighthouse = lighthouse_from_json(told["lighthouse"], map_, begin)
        return cls(map_, lighthouse, begin)

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
        cls, document: str | Mapping[str, Any], *, missing: GivenLighthouse = Directional.kind
    ) -> "World":
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


def at_place(world: World, number: int) -> World:
    """The world with its lighthouse at the place of that number.

    Raises:
        InvalidWorld: naming the numbers of its places.
    """
    places = list(world.lighthouse.as_kind.places(world.map, world.start))
    if number not in range(len(places)):
        raise InvalidWorld(
            f"place {show(number)} is none of the {len(places)} places of the lighthouse "
            f"{world.lighthouse.kind} in this world, which are numbered from 0"
        )
    return World(world.map, places[number], world.start)


def _a_start(given: object, map_: CombinatorialMap) -> Dart:
    """The start; raise InvalidWorld unless it is a dart of the map."""
    start = the_integer("start", given)
    if start not in map_.darts:
        raise InvalidWorld(f"start = {show(start)} is no dart; darts are 0..{len(map_.sigma) - 1}")
    return start
