"""Scenes: a map with everything that a picture shows, whatever the lighthouse."""

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence

from msgspec import Struct, field

from allworlds.document import replace
from allworlds.judging.findings.finding import believed_walk, true_walk
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Estimate, Move, Percept
from allworlds.protocol.transcript import Transcript
from allworlds.world.world import World


class Names(Struct, frozen=True):
    """Names of darts and vertices in a picture, in their order."""

    darts: tuple[str, ...]
    vertices: tuple[str, ...]


class Scene(Struct, frozen=True):
    """Content of a picture; each form of picture draws as much of it as it can.

    Attributes:
        map: the map.
        start: the dart that the robot faced at the start; a picture begins there.
        robot: the dart where the robot is at the end of its walk; None where nobody walks.
        marks: the number of markers at each vertex that has any, by the vertex's index in
            ``map.vertices``.
        pointed: the darts to which a bearing is counted, at any number of vertices.
        labels: a short text for each dart, such as its class; None where there are none.
        walked: the darts by which the robot has arrived anywhere.
        ringed: the dart to look at; None where there is none.
        names: the names of darts and vertices, where they are not their numbers.
    """

    map: CombinatorialMap
    start: Dart = 0
    robot: Dart | None = None
    marks: Mapping[int, int] = field(default_factory=dict)
    pointed: Collection[Dart] = ()
    labels: Sequence[str] | None = None
    walked: Collection[Dart] = ()
    ringed: Dart | None = None
    names: Names | None = None

    @property
    def dart_names(self) -> Sequence[str]:
        """The name of each dart."""
        return self.names.darts if self.names else [*map(str, self.map.darts)]

    @property
    def vertex_names(self) -> Sequence[str]:
        """The name of each vertex."""
        if self.names:
            return self.names.vertices
        return [f"v{vertex}" for vertex in range(self.map.vertex_count)]

    @classmethod
    def sensed(
        cls,
        map_: CombinatorialMap,
        start: Dart,
        percepts: Iterable[tuple[Dart, Percept]],
    ) -> "Scene":
        """Return the scene of a map in which percepts are known for arrival at some darts.

        The dart at bearing 0 is pointed along, and a vertex with marks is marked.
        """
        known = list(percepts)
        # What is sensed last holds: markers can be taken away.
        marks = {map_.vertex_of[dart]: p.marks for dart, p in known}
        marks = {vertex: number for vertex, number in marks.items() if number}
        pointed = {map_.turn(dart, p.bearing) for dart, p in known if p.bearing is not None}
        return cls(map_, start, None, marks, sorted(pointed))


def scene_of(world: World, dropped: Collection[int] = ()) -> Scene:
    """The scene of a world, with everything that can be sensed in it.

    ``dropped`` holds the vertices at which the robot has dropped markers, one entry a marker.
    """
    map_, lying = world.map, Counter(dropped)
    percepts = ((d, p.marked(lying[map_.vertex_of[d]])) for d, p in enumerate(world.percepts))
    return Scene.sensed(map_, world.start, percepts)


def walk_in_world(world: World, transcript: Transcript) -> Scene:
    """The world with everything that is sensed, and the robot at the end of its walk."""
    states = [state for state, _ in true_walk(world, transcript)]
    trail = [state.dart for state in states]
    scene = scene_of(world, states[-1].lying)
    return replace(scene, robot=trail[-1], walked=_arrivals(trail, transcript))


def walk_in_answer(world: World, answer: Estimate, transcript: Transcript) -> Scene:
    """The answer with the percepts that it predicts, and the robot where the answer says."""
    walk = believed_walk(world, answer, transcript)
    # Where the answer has no place for the lighthouse it says nothing of markers.
    percepts = zip(walk.trail, walk.percepts or [], strict=False)
    scene = Scene.sensed(answer.map, walk.trail[0], percepts)
    return replace(scene, robot=answer.here, walked=_arrivals(walk.trail, transcript))


def _arrivals(trail: Sequence[Dart], transcript: Transcript) -> set[Dart]:
    """The darts by which the robot arrived, step by step; none before the first motion."""
    steps = zip(trail[1:], transcript.actions, strict=True)
    return {dart for dart, action in steps if type(action) is Move}
