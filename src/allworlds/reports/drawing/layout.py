"""The layout of a map: regular, on a planar mesh, or with the vertices on a circle.

The *mesh* is a triangulation of a planar drawing of the map, see ``planar``.

A map can also be drawn and named like another map, as far as the two maps agree.
"""

from cmath import exp, phase, rect
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from itertools import pairwise
from math import pi, tau

from msgspec import Struct, field

from allworlds.documents.document import replace
from allworlds.maps.combinatorial import (
    CombinatorialMap,
    Dart,
    cycles,
    isomorphism,
    unrooted_code,
)
from allworlds.reports.drawing.planar import coordinates, mesh, planar
from allworlds.reports.drawing.regular import lattice, wheel
from allworlds.reports.parts import Scene, View


def points_of(way: Sequence[complex]) -> list[complex]:
    """Points on the curve of an edge, which show how far the curve reaches.

    The points are the two ends of the curve, and the ends and the middle of each of its parabolas.
    ``way`` holds the control points of the edge; :class:`Layout` tells which parabolas they make.
    """
    points = [way[0], (way[0] + way[1]) / 2]
    for a, b, c in zip(way, way[1:], way[2:], strict=False):
        points += [(a + 6 * b + c) / 8, (b + c) / 2]
    return [*points, way[-1]]


def bridges_of(way: Sequence[complex]) -> list[tuple[complex, complex]]:
    """The two ends of each straight part of an edge; such a part is at each of its crossings.

    ``way`` holds the control points of the edge, as in :class:`Layout`.  In an edge with crossings,
    every fifth control point is a crossing, except the last one: those with the indices 5, 10, 15
    and so on.  The crossing, the control point before it and the one after it are on one straight
    line (see :func:`straightened`).  So the edge is straight between two points: the middle between
    the point before and the crossing, and the middle between the crossing and the point after.
    """
    # Every fifth point between the ends of the edge is where it crosses another one.
    if len(way) % 5 != 1:
        return []
    around = zip(way[4::5], way[5:-1:5], way[6::5], strict=False)
    return [((before + at) / 2, (at + after) / 2) for before, at, after in around]


SQUAREST = 0.42 * pi
"""The least angle at which two edges cross in a drawing; wider angles stay as they are."""

STRAIGHT = 0.5
"""The length of the straight part of an edge at a crossing, as a share of the shortest of the four
rays from the crossing."""

EVEN = 0.75
"""The least angle between two darts at a vertex, as a share of the average angle there."""

BEND = pi / 3
"""The largest angle by which a dart is turned to reach the angle :data:`EVEN`."""

REACH = 0.8
"""The distance from a vertex to each point that :func:`spread` returns, as a share of the least
distance from the vertex to a point in ``round_it``."""


def straightened(centre: complex, round_it: Sequence[complex]) -> list[complex]:
    """For each of the four rays of a crossing, a point towards which the ray is to leave.

    Two edges cross; the rays are the two directions in which each edge leaves the crossing.  The
    new directions of the two rays of an edge are opposite, so that the edge is straight at the
    crossing.  The new angle between the edges is at least :data:`SQUAREST`, which is near a right
    angle.

    Args:
        centre: the crossing.
        round_it: for each of the four rays, clockwise, a point in its old direction; the first and
            the third ray belong to one edge.  The result has the rays in the same order, and its
            points at one distance from the crossing.
    """
    rays = [point - centre for point in round_it]
    first, second = (_line(rays[k], rays[k + 2]) for k in (0, 1))
    # The second edge's line is clockwise from that of the first, and by less than a half turn.
    angle = phase(second / first) % pi
    lacks = max(SQUAREST - angle, 0.0) - max(angle - (pi - SQUAREST), 0.0)
    first *= exp(-0.5j * lacks)
    second *= exp(0.5j * lacks)
    reach = STRAIGHT * min(map(abs, rays))
    return [centre + reach * line for line in (first, second, -first, -second)]


def _line(there: complex, back: complex) -> complex:
    """The mean of the direction ``there`` and the direction opposite to ``back``, of length 1."""
    line = there / abs(there) - back / abs(back)
    return line / abs(line)


def spread(centre: complex, round_it: Sequence[complex]) -> list[complex]:
    """For each dart of a vertex, the point towards which the dart leaves the vertex.

    Narrow angles between the darts become wider, and each dart keeps about its old direction.

    Args:
        centre: the vertex.
        round_it: the points to which the darts have led so far, clockwise.
    """
    rays = [point - centre for point in round_it]
    reach, count = REACH * min(map(abs, rays)), len(rays)
    first = phase(rays[0])
    angles = [first]
    for before, ray in pairwise(rays):
        angles.append(angles[-1] + phase(ray / before) % tau)
    least = min(b - a for a, b in pairwise([*angles, first + tau]))
    even = [tau * k / count for k in range(count)]
    middle = sum(a - b for a, b in zip(angles, even, strict=True)) / count
    lacks = [b + middle - a for a, b in zip(angles, even, strict=True)]
    part = max(0.0, (EVEN * tau / count - least) / max(tau / count - least, 1e-9))
    part = min(part, BEND / max(*map(abs, lacks), 1e-9))
    return [centre + rect(reach, a + part * lack) for a, lack in zip(angles, lacks, strict=True)]


MOST_DARTS = 200
"""The largest number of darts of a planar drawing, crossings included; larger maps are drawn round
a circle."""

STUB, NARROWEST, WIDEST = 24.0, 130.0, 900.0
"""In pixels: the least length of the straight beginning of an edge; the least and the largest size
of a drawing."""

DISC, CHIP, HIGH, GAP, FAR = 12.0, 10.0, 14.0, 16.0, 46.0
"""In pixels: the radii of a vertex and of the robot; the height of a number; the least distance of
two numbers; and how far a number may be moved from its vertex to keep this distance.
"""


class Layout(Struct, frozen=True):
    """A drawing in pixels; y grows downwards.

    An edge is drawn as a curve through some of its *control points*, or near them.  Straight
    helping lines, which are not drawn, join successive control points.  The edge begins with the
    first half of the first helping line, and ends with the last half of the last one.  Between
    these two pieces, a parabola leads from the middle of each helping line to the middle of the
    next one, and touches both.  If there are only two control points, the edge is the straight line
    between them.

    Attributes:
        vertices: the centre of each vertex.
        ways: for each dart the control points of its edge, from the dart's vertex to the other end.
            An edge of a lattice on a torus may be cut in two halves; then a dart has only the
            control points of its own half, from its vertex to the cut.
        letters: for each dart of a cut edge the letter that stands at the cut, the same for both.
    """

    vertices: tuple[complex, ...]
    ways: tuple[tuple[complex, ...], ...]
    letters: Mapping[Dart, str] = field(default_factory=dict)

    def pieces(self, dart: Dart, other: Dart) -> list[tuple[complex, ...]]:
        """The control points of the edge from ``dart`` to ``other``.

        The result has one tuple of control points; two tuples, one for each half, for a cut edge.
        """
        whole = [self.ways[dart]]
        return [*whole, self.ways[other][::-1]] if dart in self.letters else whole

    def stub(self, dart: Dart) -> complex:
        """The point up to which the edge of the dart is straight, seen from the dart's vertex.

        It is the middle between the first two control points of the edge, see :class:`Layout`.
        """
        start, towards, *_ = self.ways[dart]
        return (start + towards) / 2

    def along(self, dart: Dart) -> complex:
        """The direction in which the dart leaves its vertex, of length 1."""
        start, towards, *_ = self.ways[dart]
        return (towards - start) / abs(towards - start)

    def box(self, margin: float) -> tuple[float, float, float, float]:
        """The left, top, width and height of the box around the drawing, margin included."""
        points = [*self.vertices, *(p for way in self.ways for p in points_of(way))]
        left, top = (min(xs) - margin for xs in _coordinates(points))
        right, bottom = (max(xs) + margin for xs in _coordinates(points))
        return left, top, right - left, bottom - top


def rim(here: complex, others: Iterable[complex], wide: float) -> float:
    """The distance in pixels from a vertex to the middle of a dart's number.

    At this distance the number touches neither the vertex nor, if there is room, another number.

    Args:
        here: the direction in which the dart leaves, of length 1.
        others: the directions of the other darts at the vertex.
        wide: the width of the number.
    """
    aside, high = abs(here.real), abs(here.imag)
    half = min(wide / 2 / max(aside, 0.01), HIGH / 2 / max(high, 0.01))
    free = DISC + max(half, CHIP) + 2
    nearest = min((abs(here - other) for other in others), default=2)
    return max(free, min(GAP / max(nearest, 0.01), FAR))


@lru_cache(maxsize=256)
def layout(map_: CombinatorialMap, root: Dart) -> Layout:
    """The drawing of a map of any genus, with the root's vertex to the left.

    Lattices, also on a torus, paths, stars, rings and wheels have regular drawings, whatever their
    size.  Any other map is drawn on a planar mesh: a planar map without crossings, a map of higher
    genus with the fewest crossings that were found.  But if such a drawing would have more than
    :data:`MOST_DARTS` darts, those of crossings included, the vertices are put on a circle; then
    even the edges of a planar map may cross, and edges may run under a vertex.

    With the same root, but other numbers of the darts, a map has the same drawing, perhaps turned,
    unless the vertices are on a circle.
    """
    if ways := wheel(map_):
        return _finished(map_, root, ways)
    ways, letters = lattice(map_, root)
    if ways:
        return _finished(map_, root, ways, letters)
    if 2 * map_.edge_count <= MOST_DARTS:
        same = CombinatorialMap.trusted(*unrooted_code(map_))
        if ways := _ways(same):
            names = isomorphism(map_, same)
            assert names is not None
            return _finished(map_, root, [ways[names[dart]] for dart in map_.darts])
    return _finished(map_, root, _round_a_circle(map_))


@lru_cache(maxsize=256)
def _ways(map_: CombinatorialMap) -> list[list[complex]]:
    """For each dart the control points of its edge, in a planar drawing.

    In this drawing each crossing is an added vertex with four added darts.  The result is empty if
    the drawing has more than :data:`MOST_DARTS` darts.  The darts of bends are not counted; a bend
    is a vertex of degree 2 that :func:`planar` puts into a loop.
    """
    drawn = planar(map_)
    if drawn.unbent > MOST_DARTS:
        return []
    net = mesh(drawn)
    points = coordinates(net)
    vertices = cycles(drawn.sigma)
    centres = {d: points[net.first_vertex + i] for i, v in enumerate(vertices) for d in v}
    towards: dict[Dart, complex] = {}
    for vertex in vertices:
        if vertex[0] < drawn.unbent:
            leave = spread if vertex[0] < drawn.own else straightened
            round_it = [points[dart] for dart in vertex]
            towards.update(zip(vertex, leave(centres[vertex[0]], round_it), strict=True))
    ways = []
    for dart in range(drawn.own):
        way = [centres[dart]]
        along = drawn.way(dart)
        for near, far in zip(along[::2], along[1::2], strict=True):
            way += [towards[near], points[near]] if near in towards else [points[near]]
            way += [points[far], towards[far], centres[far]] if far in towards else [points[far]]
        ways.append(way)
    return ways


def _round_a_circle(map_: CombinatorialMap) -> list[list[complex]]:
    """For each dart the control points of its edge in a drawing with the vertices on a circle.

    The darts of a vertex leave the vertex at equal angles.  The first dart of the vertex in
    ``map_.vertices`` points away from the centre of the circle.
    """
    count = map_.vertex_count
    outwards = [exp(1j * tau * vertex / count) for vertex in map_.vertex_of]
    first = [map_.vertices[vertex][0] for vertex in map_.vertex_of]
    turns = [map_.offset(first[d], d) / map_.degree_at[d] for d in map_.darts]
    centre = [(count + 1) * out for out in outwards]
    ends = zip(centre, outwards, turns, strict=True)
    end = [here + out * exp(1j * tau * turn) for here, out, turn in ends]
    return [[centre[d], end[d], end[e], centre[e]] for d, e in enumerate(map_.alpha)]


def _finished(
    map_: CombinatorialMap,
    root: Dart,
    ways: Sequence[Sequence[complex]],
    letters: Mapping[Dart, str] | None = None,
) -> Layout:
    """Turn a drawing, scale it so that the numbers of the darts fit, and return its layout.

    The vertex of ``root`` becomes the origin, and the vertex that is farthest from it comes to lie
    to the right.  A lattice is turned by quarter turns only, so that its edges stay upright or
    level.

    Args:
        map_: the map.
        root: a dart of the vertex that becomes the origin.
        ways: for each dart the control points of its edge, as in :class:`Layout`.
        letters: for a lattice, the letter of each dart whose edge is cut, and an empty mapping if
            no edge is cut; None for any other map.
    """
    origin, spots = ways[root][0], tuple(ways[vertex[0]][0] for vertex in map_.vertices)
    others = spots if len(spots) > 1 else [way[1] for way in ways]
    # Rounded, for among equals the first is to be taken whatever the last bits are.
    far = max(others, key=lambda point: round(abs(point - origin), 6)) - origin
    if letters is not None:
        far = 1j ** round(phase(far) / (pi / 2))
    stub = min(abs(way[1] - way[0]) for way in ways) / 2
    points = [point for way in ways for point in points_of(way)]
    size = max(max(xs) - min(xs) for xs in _coordinates(points))
    scale = min(max(STUB / stub, NARROWEST / size), WIDEST / size)
    turn = far.conjugate() / abs(far) * scale
    return Layout(
        tuple((point - origin) * turn for point in spots),
        tuple(tuple((point - origin) * turn for point in way) for way in ways),
        letters or {},
    )


def _coordinates(points: Sequence[complex]) -> tuple[list[float], list[float]]:
    return [point.real for point in points], [point.imag for point in points]


def drawn_beside(
    first: View, other: View, drawn: Layout, agreement: int
) -> tuple[View, View, Layout]:
    """Both views for pictures side by side, and the layout of the view ``other``.

    A view shows a walk in a map; its trail has the robot's dart at the start and after each step.
    In both views a ring marks the robot's dart at the first step at which the two walks diverge.
    The darts and vertices of ``other`` are named like those of ``first``.

    Args:
        first: the view of one map.
        other: the view of the other map.
        drawn: the layout of the first map.
        agreement: the number of darts at the beginning of each trail before the walks diverge.
    """
    world, answer = first.scene, other.scene
    ties = _ties(first, other, agreement)
    beside = layout_like(ties, answer.map, answer.root, world.map, drawn)
    if agreement < len(first.trail):
        world = replace(world, ringed=first.trail[agreement])
        answer = replace(answer, ringed=other.trail[agreement])
    answer = replace(
        answer,
        darts=dart_names_like(ties, answer.map, len(world.map.sigma)),
        vertices=vertex_names_like(ties, answer.map, world),
    )
    return replace(first, scene=world), replace(other, scene=answer), beside


def named_like(first: View, other: View, agreement: int) -> View:
    """The view ``other``, with the names that the vertices have in the view ``first``.

    If vertices of ``first`` have no names, ``other`` stays as it is.  ``agreement`` is the number
    of darts at the beginning of each view's trail before the two walks diverge.
    """
    if not first.scene.vertices:
        return other
    names = vertex_names_like(_ties(first, other, agreement), other.scene.map, first.scene)
    return replace(other, scene=replace(other.scene, vertices=names))


def _ties(first: View, other: View, agreement: int) -> dict[Dart, Dart]:
    """For darts of the view ``other`` the darts of the view ``first`` that correspond to them.

    First: if the two maps are mirror images of each other, and not the same map, all darts
    correspond by the reflection.  Second: in every other case, also if the maps are the same, the
    two walks are compared.  As long as they agree, the robot's dart in one map corresponds to its
    dart in the other, and the further darts of the two vertices correspond clockwise from there;
    :func:`extended` finds further darts.

    ``agreement`` is the number of darts at the beginning of each view's trail before the walks
    diverge.
    """
    world, answer = first.scene.map, other.scene.map
    ties: dict[Dart, Dart] = {}
    for robot, belief in zip(first.trail[:agreement], other.trail[:agreement], strict=True):
        for k in range(world.degree_at[robot]):
            ties[answer.turn(belief, k)] = world.turn(robot, k)
    return mirror_of(answer, world) or extended(ties, answer, world)


def extended(
    tied: Mapping[Dart, Dart], map_: CombinatorialMap, other: CombinatorialMap
) -> dict[Dart, Dart]:
    """The pairs of darts in ``tied``, and the pairs that follow from them by sigma and alpha.

    Let two darts be a pair, and let a and b be their other ends.  If the vertices of a and b have
    equal degrees, and none of their darts is in a pair, then a and b become a pair, and clockwise
    from a and b the other darts of the two vertices become pairs, too.  Otherwise no pair follows
    from the first one.

    Args:
        tied: the pairs of darts to begin with.  They pair whole vertices: for each vertex with a
            dart in a pair, all its darts are paired with all darts of one vertex of equal degree.
        map_: the map whose darts are the keys.
        other: the map whose darts are the values.

    Cost: linear in the darts.
    """
    ties, used = dict(tied), set(tied.values())
    queue = [*ties]
    for dart in queue:
        a, b = map_.alpha[dart], other.alpha[ties[dart]]
        if map_.degree_at[a] != other.degree_at[b]:
            continue
        around = [(map_.turn(a, k), other.turn(b, k)) for k in range(map_.degree_at[a])]
        if any(x in ties or y in used for x, y in around):
            continue
        ties.update(around)
        used.update(y for _, y in around)
        queue += [x for x, _ in around]
    return ties


def dart_names_like(ties: Mapping[Dart, Dart], map_: CombinatorialMap, many: int) -> list[str]:
    """For each dart of a map the number of its partner in another map.

    ``ties`` has the partner of each dart that has one.  The other darts get new numbers, from
    ``many`` on: the other map has the numbers below ``many``.
    """
    new = iter(range(many, many + len(map_.sigma)))
    return [str(ties[d] if d in ties else next(new)) for d in map_.darts]


def vertex_names_like(ties: Mapping[Dart, Dart], map_: CombinatorialMap, other: Scene) -> list[str]:
    """For each vertex of a map the name of its partner in the scene ``other`` of another map.

    ``ties`` has the partner of each dart that has one; the vertices of two partners are partners,
    too.  Vertices without a partner get new names: ``new 1``, ``new 2``.
    """
    names, left = list[str](), dict(enumerate(other.vertex_names))
    new = iter(range(1, map_.vertex_count + 1))
    for vertex in map_.vertices:
        known = next((other.map.vertex_of[ties[d]] for d in vertex if d in ties), -1)
        names.append(left.pop(known, "") or f"new {next(new)}")
    return names


def mirror_of(map_: CombinatorialMap, other: CombinatorialMap) -> dict[Dart, Dart]:
    """The partner of each dart in the map ``other``, if ``other`` is the mirror image of the map.

    The result is empty if ``other`` is no mirror image.  It is also empty if the two maps are the
    same map: then their darts correspond without a reflection, and :func:`_ties` finds how.
    """
    if isomorphism(map_, other):
        return {}
    return dict(enumerate(isomorphism(map_.mirrored(), other) or ()))


def layout_like(
    ties: Mapping[Dart, Dart],
    map_: CombinatorialMap,
    root: Dart,
    other: CombinatorialMap,
    drawn: Layout,
) -> Layout:
    """Draw a map like the map ``other`` if the two are the same map or mirror images.

    Otherwise the map is drawn by itself.

    Args:
        ties: for each dart of the map its partner in the other map.
        map_: the map to draw.
        root: the dart at which the drawing begins, if the map is drawn by itself.
        other: the map that has a drawing.
        drawn: the drawing of the other map.
    """
    whole = len(ties) == len(map_.sigma) == len(other.sigma)
    if not whole or any(ties[map_.alpha[d]] != other.alpha[e] for d, e in ties.items()):
        return layout(map_, root)
    ways = tuple(drawn.ways[ties[dart]] for dart in map_.darts)
    if any(ties[map_.sigma[d]] != other.sigma[e] for d, e in ties.items()):
        if any(other.sigma[ties[map_.sigma[d]]] != e for d, e in ties.items()):
            return layout(map_, root)
        ways = tuple(tuple(-point.conjugate() for point in way) for way in ways)
    letters = {d: drawn.letters[e] for d, e in ties.items() if e in drawn.letters}
    return Layout(tuple(ways[vertex[0]][0] for vertex in map_.vertices), ways, letters)
