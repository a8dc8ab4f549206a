"""Strategies for Hypothesis: maps, worlds, motions and choices that shrink to small, simple ones.

Worlds shrink to fewer edges, then to fewer vertices, then to a start at dart 0; findings have the
same order.  For example, a property of your explorer::

    from hypothesis import given
    from allworlds import run, strategies

    @given(strategies.worlds())
    def test_my_explorer_is_right(world):
        assert run(my_explorer, world).finding is None

Hypothesis draws a map edge by edge from its root edge.  Every partial map can be completed, so no
drawn value is rejected.
"""

from collections.abc import Callable, Sequence, Sized
from itertools import combinations_with_replacement, count
from math import comb
from typing import TypeAlias

from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis.strategies import DrawFn, SearchStrategy, builds, composite, integers, lists

from allworlds.inputs.checks import InputError, an_integer
from allworlds.maps.classes import MapClass
from allworlds.maps.combinatorial import CombinatorialMap, Dart, cycles, places, rooted_code
from allworlds.protocol.choices import ChoiceKind, Choices
from allworlds.world.lighthouses import base, kinds
from allworlds.world.world import World

__all__ = [
    "choices",
    "maps",
    "motions",
    "planar_maps",
    "planar_simple_maps",
    "simple_maps",
    "worlds",
]


def maps(min_edges: int = 1, max_edges: int = 6) -> SearchStrategy[CombinatorialMap]:
    """Maps with loops and parallel edges, of any genus; the root is dart 0.

    Every rooted map with these numbers of edges can be drawn, in its canonical numbering.  A
    failing map shrinks towards fewer edges, then towards fewer vertices, and at last to one loop.

    Example:
        ``@given(maps(max_edges=4))``

    Raises:
        InputError: unless ``1 <= min_edges <= max_edges``.

    Cost: O(m^3) for a map.
    """
    return _of_class(MapClass.MAPS, min_edges, max_edges)


def simple_maps(min_edges: int = 1, max_edges: int = 6) -> SearchStrategy[CombinatorialMap]:
    """Maps without loops and parallel edges; otherwise like :func:`maps`.

    Example:
        ``@given(simple_maps(min_edges=3))``
    """
    return _of_class(MapClass.SIMPLE, min_edges, max_edges)


def planar_maps(min_edges: int = 1, max_edges: int = 6) -> SearchStrategy[CombinatorialMap]:
    """Maps of genus 0; otherwise like :func:`maps`.

    Example:
        ``@given(planar_maps(max_edges=10))``
    """
    return _of_class(MapClass.PLANAR, min_edges, max_edges)


def planar_simple_maps(min_edges: int = 1, max_edges: int = 6) -> SearchStrategy[CombinatorialMap]:
    """Maps of genus 0 without loops and parallel edges; otherwise like :func:`maps`.

    Example:
        ``@given(planar_simple_maps(max_edges=10))``
    """
    return _of_class(MapClass.PLANAR_SIMPLE, min_edges, max_edges)


def sampled_maps(map_class: str, max_edges: int, count: int) -> list[CombinatorialMap]:
    """The first ``count`` maps of a class that Hypothesis draws, the same every time.

    Args:
        map_class: the name of the class.
        max_edges: the largest number of edges.
        count: the number of maps.
    """
    drawn: list[CombinatorialMap] = []

    @settings(
        max_examples=count,
        derandomize=True,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=[*HealthCheck],
    )
    @given(_of_class(MapClass.named(map_class), 1, max_edges))
    def draw(map_: CombinatorialMap) -> None:
        drawn.append(map_)

    draw()
    return drawn


def worlds(
    map_strategy: SearchStrategy[CombinatorialMap] | None = None,
    lighthouse: kinds.GivenLighthouse = "directional",
) -> SearchStrategy[World]:
    """Worlds: a map, the dart that the robot faces at the start, a place of the lighthouse.

    A failing world first gets a smaller map; then the start shrinks towards dart 0, and the place
    towards the first place (where a directional marker points along the robot's dart).  A start for
    which the lighthouse has no place is not drawn.

    Args:
        map_strategy: the strategy of the map (default: :func:`maps`).
        lighthouse: ``KIND[:key=value,...]``.

    Example:
        ``@given(worlds(simple_maps(), lighthouse="directional"))``

    Raises:
        InputError: for an unknown lighthouse.
    """
    return _lit(
        maps() if map_strategy is None else map_strategy, kinds.lighthouse_kind(lighthouse).as_class
    )


def motions(max_size: int = 20) -> SearchStrategy[list[int]]:
    """Lists of at most ``max_size`` motions ``k``, for ``Move(k)``; k is from -12 to 12.

    A failing list shrinks towards few motions, and towards ``k = 0``, which leads back by the edge
    of arrival.

    Example:
        ``@given(worlds(), motions(max_size=8))``
    """
    return lists(integers(-12, 12), max_size=max_size)


def choices(max_size: int = 40) -> SearchStrategy[Choices]:
    """Choices for one run: the first ``max_size`` choices can be any, all later ones are option 0.

    Failing choices shrink towards the first option (option 0) of every choice; for Algorithm 1 this
    is the policy ``fifo``.  A run uses up its ``Choices``, so draw one for each run.

    Example:
        ``@given(worlds(), choices())``
    """
    return builds(Choices, builds(Answers, lists(integers(min_value=0), max_size=max_size)))


class Answers:
    """The policy of :func:`choices`: the numbers ``answers`` give the options of the first choices.

    Each number is taken modulo the number of options.  All later choices are option 0.
    """

    def __init__(self, answers: Sequence[int] = ()) -> None:
        self.answers = tuple(answers)
        self._left = iter(self.answers)

    def __repr__(self) -> str:
        return f"Answers({list(self.answers)})"

    def choose(self, kind: ChoiceKind, options: Sized, cost: Sequence[int] | None) -> int:  # noqa: ARG002
        """Return the next number modulo the number of options; 0 if no number is left.

        ``kind`` and ``cost`` have no effect here; other policies use them.
        """
        return next(self._left, 0) % len(options)


def _of_class(map_class: MapClass, least: int, most: int) -> SearchStrategy[CombinatorialMap]:
    if an_integer("min_edges", least) < 1:
        raise InputError(f"min_edges = {least}, but a map has at least 1 edge")
    if an_integer("max_edges", most) < least:
        raise InputError(f"max_edges = {most} is less than min_edges = {least}")
    return _grown(map_class, least, most)


@composite
def _lit(
    draw: DrawFn, map_strategy: SearchStrategy[CombinatorialMap], kind: type[base.Lighthouse]
) -> World:
    map_ = draw(map_strategy)
    start = draw(integers(0, len(map_.sigma) - 1))
    lighthouses = list(kind.places(map_, start))
    assume(lighthouses)
    return World(map_, lighthouses[draw(integers(0, len(lighthouses) - 1))], start)


@composite
def _grown(draw: DrawFn, map_class: MapClass, least: int, most: int) -> CombinatorialMap:
    """A map of the class, with ``least`` to ``most`` edges.

    Hypothesis draws the size of the map first, then both ends of each edge.
    """
    edges = draw(integers(least, most))
    vertices = draw(integers(_fewest_vertices(map_class, edges), edges + 1))
    return grow(map_class, edges, vertices, lambda options: draw(integers(0, len(options) - 1)))


def grow(
    map_class: MapClass, edges: int, vertices: int, pick: Callable[[Sized], int]
) -> CombinatorialMap:
    """A map of this class and size, in canonical numbering; ``pick`` chooses each of its edges.

    Args:
        map_class: the class.
        edges: m.
        vertices: n; the class has maps with m edges and n vertices.
        pick: a function that gets the edges that can be added next, and returns the index of one of
            them; it is called ``m`` times.

    Cost: O(m^3).
    """
    loops = [] if map_class.simple or vertices > edges else [LOOP]
    links = [LINK] if vertices > 1 else []
    roots = loops + links
    growth = _Growth(map_class, roots[pick(roots)])
    for edge in range(1, edges):
        new_vertices, new_edges = vertices - growth.vertex_count, edges - edge
        ways: list[NewEdge] = []
        if new_vertices < new_edges:
            ways += growth.between()
        if new_vertices:
            ways += [(dart, OUTWARD) for dart in range(len(growth.sigma))]
        growth.add(ways[pick(ways)])
    return CombinatorialMap.trusted(*rooted_code(growth.sigma, growth.alpha, 0))


def _fewest_vertices(map_class: MapClass, edges: int) -> int:
    """The smallest number of vertices of a map of the class with ``edges`` edges."""
    if not map_class.simple:
        return 1
    # The largest maps are complete graphs, in the plane triangulations.
    largest = ((n, 3 * n - 6 if map_class.planar and n > 2 else comb(n, 2)) for n in count(2))
    return next(n for n, most in largest if most >= edges)


LOOP = CombinatorialMap((1, 0), (1, 0))
LINK = CombinatorialMap((0, 1), (1, 0))

NewEdge: TypeAlias = tuple[Dart, Dart]
"""A new edge as a pair (a, b): its ends come right after dart a and right after dart b, clockwise;
if b is OUTWARD, the edge leads to a new vertex."""

OUTWARD: Dart = -1


class _Growth:
    """A map to which edges are added; it stays in its class.

    Every rooted map can grow like this: its root edge first, then the rest of a spanning tree, then
    the other edges.  In the classes of simple maps, too, a further edge always finds two vertices
    to join, until the map has the largest number of edges for its number of vertices.
    """

    def __init__(self, map_class: MapClass, root: CombinatorialMap) -> None:
        self.map_class = map_class
        self.sigma, self.alpha = list(root.sigma), list(root.alpha)
        self.vertex_count = root.vertex_count

    def between(self) -> list[NewEdge]:
        """All edges between vertices of the map that can be added; the map stays in its class.

        An edge is a pair (a, b) of darts, as in :data:`NewEdge`, with a <= b.  The pairs are in
        lexicographic order.
        """
        darts = range(len(self.sigma))
        face, _ = places(cycles([self.sigma[e] for e in self.alpha]))
        vertex, _ = places(cycles(self.sigma))
        joined = {(vertex[d], vertex[self.alpha[d]]) for d in darts}

        def allowed(a: Dart, b: Dart) -> bool:
            if self.map_class.planar and face[self.sigma[a]] != face[self.sigma[b]]:
                return False
            ends = vertex[a], vertex[b]
            return not self.map_class.simple or (ends[0] != ends[1] and ends not in joined)

        return [way for way in combinations_with_replacement(darts, 2) if allowed(*way)]

    def add(self, way: NewEdge) -> None:
        """Add the edge ``way`` to the map; :data:`NewEdge` says what its two darts mean."""
        a, b = way
        first = len(self.sigma)
        self.sigma += [first, first + 1]
        self.alpha += [first + 1, first]
        self._insert(first, a)
        if b == OUTWARD:
            self.vertex_count += 1
        else:
            self._insert(first + 1, b)

    def _insert(self, dart: Dart, behind: Dart) -> None:
        self.sigma[dart] = self.sigma[behind]
        self.sigma[behind] = dart
