"""The world: an immutable value without the robot, whose position is in a state (``State``)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Annotated, Any, Literal

from msgspec import Struct

from allworlds.documents.document import Document, IfAny, Pair, about
from allworlds.documents.shown import Pictured
from allworlds.inputs.checks import parse_json, show
from allworlds.maps.combinatorial import Alpha, CombinatorialMap, Dart, Sigma
from allworlds.maps.networks import from_networkx, to_networkx
from allworlds.protocol.actions import Action, IllegalAction, Move, Percept, Told
from allworlds.words import size
from allworlds.world.labels import PLAIN, Labelling, labels_of_nodes
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.kinds import GivenLighthouse, lighthouse_from_json
from allworlds.world.lighthouses.marked import Directional
from allworlds.world.lighthouses.options import InvalidWorld, refuse_other_keys, the_integer
from allworlds.world.lighthouses.own_kind import own_place
from allworlds.world.state import State


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
    name: Annotated[IfAny[str], about("what it is called, in its file")] = ""
    names: Annotated[
        IfAny[tuple[str, ...]],
        about("of the vertices, which are the cycles of sigma by least dart"),
    ] = ()
    positions: Annotated[
        IfAny[tuple[Pair[float], ...]],
        about("of the same vertices in pictures: to the right, and up"),
    ] = ()


class Entry(Struct, frozen=True):
    """A world as a file tells it: a map, and perhaps its labels, start and lighthouse.

    Attributes:
        map: the map; the notation of the file determines the numbers of its darts.
        labels: the names of the world and of its vertices in the file.
        start: the dart that the robot faces; None if the file does not fix it.
        lighthouse: the JSON object of the lighthouse; None if the file does not fix it.
    """

    map: CombinatorialMap
    labels: Labelling = PLAIN
    start: Dart | None = None
    lighthouse: Any = None

    @classmethod
    def from_json(cls, document: object, name: str = "") -> "Entry":
        """The entry of a JSON object with the keys of a :class:`WorldDocument`.

        Only ``sigma`` and ``alpha`` are required.  ``name`` is the name of the world if the object
        has no key ``name``.

        Raises:
            InvalidMap, InvalidWorld: naming the offending value and what would be legal.
        """
        if not isinstance(document, Mapping):
            raise InvalidWorld(
                f"a world is an object with 'sigma' and 'alpha', not {show(document)}"
            )
        refuse_other_keys("world", document, WorldDocument.__struct_fields__)
        if document.get("lighthouse", "") is None:
            raise InvalidWorld("lighthouse = None is no object; without one any may stand there")
        map_ = CombinatorialMap.from_json(document)
        start = a_start(document["start"], map_) if "start" in document else None
        names, positions = document.get("names", ()), document.get("positions", ())
        labels = Labelling(document.get("name", name), names, positions)
        return cls(map_, labels, start, document.get("lighthouse"))

    def world(self, kind: GivenLighthouse = Directional.kind) -> "World":
        """The world of the entry, with defaults for its missing parts.

        The defaults are a lighthouse of kind ``kind`` at its default place, and the start dart 0.
        """
        start = self.start or 0
        lighthouse = lighthouse_from_json(self.lighthouse, self.map, start, kind)
        return World(self.map, lighthouse, start, labels=self.labels)


@dataclass(frozen=True, init=False)
class World(Pictured):
    """A map, a lighthouse that stands in it, and the dart that the robot faces at the start.

    Args:
        map: the map.
        lighthouse: a lighthouse at its place; or a kind, such as ``"position"``, which is put at
            its default place; None stands for ``"directional"``.
        start: the dart.
        labels: the name of the world, and names and positions of its vertices.  The equality of
            worlds ignores them.

    Raises:
        InvalidWorld: if the start is no dart, or the lighthouse or the labels do not fit.
    """

    map: CombinatorialMap
    lighthouse: Lighthouse
    start: Dart
    labels: Labelling = field(compare=False, repr=False)

    def __init__(
        self,
        map: CombinatorialMap,  # noqa: A002  # the word of the field
        lighthouse: Lighthouse | GivenLighthouse | None = None,
        start: Dart = 0,
        *,
        labels: Labelling = PLAIN,
    ) -> None:
        if not isinstance(map, CombinatorialMap):
            raise InvalidWorld(f"map = {show(map)} is no CombinatorialMap; maps.family makes one")
        start = a_start(start, map)
        if not isinstance(lighthouse, Lighthouse):
            kind = Directional.kind if lighthouse is None else lighthouse
            lighthouse = lighthouse_from_json(None, map, start, kind)
        lighthouse = own_place(lighthouse)
        lighthouse.check(map, start)
        object.__setattr__(self, "map", map)
        object.__setattr__(self, "lighthouse", lighthouse)
        object.__setattr__(self, "start", start)
        if labels is not PLAIN:
            if not isinstance(labels, Labelling):
                raise InvalidWorld(f"labels = {show(labels)} is no Labelling")
            labels = labels.checked(map)
        object.__setattr__(self, "labels", labels)

    @cached_property
    def percepts(self) -> tuple[Percept, ...]:
        """For each dart the percept of a robot that arrives by it and has left no marks."""
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
    def in_words(self) -> str:
        """Words such as ``a world with 1 edge and 2 vertices``, and the world's name if any."""
        called = f"the world {self.labels.name}," if self.labels.name else "a world"
        return f"{called} with {size(self.map.edge_count, self.map.vertex_count)}"

    @property
    def told(self) -> Told:
        """The value that the explorer is told before the start; None if it is told nothing."""
        return self.lighthouse.told(self.map)

    def step(self, state: State, action: Action) -> tuple[State, Percept]:
        """The state after the action, and the robot's percept in this state.

        Raises:
            IllegalAction: if the action is illegal in this state, for example because the robot has
                no marker to drop; the error names the legal actions.
        """
        if type(action) is Move:
            dart = self.map.move(state.dart, action.k)
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
        """The robot's percept in a state, including the marks that the robot has left there."""
        return self.percepts[state.dart].marked(self.lighthouse.left_marks(self.map, state))

    def relabelled(self, names: Sequence[Dart]) -> "World":
        """Return this world with dart ``d`` renamed to ``names[d]``."""
        map_, labels = self.map.relabelled(names), self.labels
        if labels is not PLAIN:
            labels = labels.relabelled(self.map, names, map_)
        return World(map_, self.lighthouse.relabelled(names), names[self.start], labels=labels)

    def mirrored(self) -> "World":
        """The mirror image of the world; the marker and the start stay at their darts."""
        return World(
            self.map.mirrored(), self.lighthouse, self.start, labels=self.labels.mirrored()
        )

    def to_networkx(self) -> Any:
        """The graph of the map for networkx; see :func:`allworlds.maps.networks.to_networkx`.

        The graph has the attributes ``start`` and ``lighthouse``, as in :meth:`to_json`.  If
        the world has labels, the graph has an attribute ``name``, and its nodes have ``name`` and
        ``pos``.  :meth:`from_networkx` reads all of these.
        """
        graph, labels = to_networkx(self.map), self.labels
        graph.graph.update(start=self.start, lighthouse=self.lighthouse.to_json())
        graph.graph.update({"name": labels.name} if labels.name else {})
        for key, values in (("name", labels.vertices), ("pos", labels.positions)):
            for vertex, value in enumerate(values):
                graph.nodes[vertex][key] = value
        return graph

    @classmethod
    def from_networkx(
        cls,
        graph: Any,
        lighthouse: Lighthouse | GivenLighthouse | None = None,
        start: Dart = 0,
        order: Literal["positions", "planar"] | None = None,
    ) -> "World":
        """The world whose map is that of a graph of networkx.

        Args:
            graph: a graph that :func:`allworlds.maps.networks.from_networkx` accepts.
            lighthouse: a lighthouse or a kind, like the argument of :class:`World`, for a graph
                without the attribute ``lighthouse``.
            start: the dart of the start, for a graph without the attribute ``start``.
            order: the source of the clockwise order of edges round each node.  ``positions``: the
                attribute ``pos`` of the nodes.  ``planar``: an embedding that networkx computes.
                None: the attribute ``darts`` of the nodes and edges, which :meth:`to_networkx`
                writes; or the attributes ``cw`` and ``ccw`` of the edges of a ``PlanarEmbedding``.
                See also :func:`allworlds.maps.networks.from_networkx`.

        ``lighthouse`` and ``start`` name darts by their numbers in the map.  If the order is None,
        and the graph has the attribute ``darts``, this attribute gives the numbers.  Otherwise the
        darts are numbered node by node, so look at the map of the world before you name a dart.

        The nodes' attributes ``name`` and ``pos``, if they are legal, give the names and positions
        of the vertices; without ``name`` the nodes themselves are the names, unless they are 0,
        1, ...

        Raises:
            InvalidMap, InvalidWorld: naming the offending value and what would be legal.
        """
        map_, attributes = from_networkx(graph, order), graph.graph
        begin = a_start(attributes.get("start", start), map_)
        if "lighthouse" in attributes:
            lighthouse = lighthouse_from_json(attributes["lighthouse"], map_, begin)
        nodes = [*graph.nodes(data=True)]
        if order is None and "darts" in nodes[0][1]:
            nodes.sort(key=lambda node: map_.vertex_of[node[1]["darts"][0]])
        labels = labels_of_nodes(attributes.get("name", ""), nodes, map_)
        return cls(map_, lighthouse, begin, labels=labels)

    def to_json(self) -> dict[str, Any]:
        """The world as a JSON object, with the keys of :class:`WorldDocument`."""
        return WorldDocument(
            sigma=self.map.sigma,
            alpha=self.map.alpha,
            start=self.start,
            lighthouse=self.lighthouse,
            name=self.labels.name,
            names=self.labels.vertices,
            positions=self.labels.positions,
        ).to_json()

    @classmethod
    def from_json(
        cls, document: str | Mapping[str, Any], *, missing: GivenLighthouse = Directional.kind
    ) -> "World":
        """The world of a JSON object of :meth:`to_json`, or of its text; unknown keys are refused.

        ``start`` may be missing (then it is 0), and so may the lighthouse, which is then of the
        kind ``missing``, at its default place.

        Raises:
            InvalidMap, InvalidWorld: naming the offending value and what would be legal.
        """
        if isinstance(document, str):
            document = parse_json(document, InvalidWorld)
        return Entry.from_json(document).world(missing)


def at_place(world: World, number: int) -> World:
    """The world with its lighthouse at the place with this number.

    Raises:
        InvalidWorld: naming the numbers of the lighthouse's places.
    """
    places = list(world.lighthouse.as_kind.places(world.map, world.start))
    if number not in range(len(places)):
        raise InvalidWorld(
            f"place {show(number)} is none of the {len(places)} places of the lighthouse "
            f"{world.lighthouse.kind} in this world, which are numbered from 0"
        )
    return World(world.map, places[number], world.start, labels=world.labels)


def a_start(given: object, map_: CombinatorialMap) -> Dart:
    """The given start as an integer; raise InvalidWorld unless it is a dart of the map."""
    start = the_integer("start", given)
    if start not in map_.darts:
        raise InvalidWorld(f"start = {show(start)} is no dart; darts are 0..{len(map_.sigma) - 1}")
    return start
