"""A map drawn and named like another one, as far as the two agree."""

from __future__ import annotations

from collections.abc import Mapping

from allworlds.document.struct import replace
from allworlds.maps.canonical import Mismatch, isomorphism
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.reports.drawing.layout import Layout, layout
from allworlds.reports.drawing.scene import Names
from allworlds.reports.parts import View


def drawn_beside(
    first: View, other: View, drawn: Layout, agreement: int
) -> tuple[View, View, Layout]:
    """Both views with their first difference ringed, the other in the numbers of the first.

    Args:
        first: what is to be seen in one map, and the trail there.
        other: the same of the other one.
        drawn: how the first is laid out.
        agreement: the number of steps, the start included, in which both go along alike.
    """
    world, answer = first.scene, other.scene
    ties = _ties(first, other, agreement)
    beside = layout_like(ties, answer.map, answer.start, world.map, drawn)
    if agreement < len(first.trail):
        world = replace(world, ringed=first.trail[agreement])
        answer = replace(answer, ringed=other.trail[agreement])
    answer = replace(answer, names=names_like(ties, answer.map, world.map, world.names))
    return replace(first, scene=world), replace(other, scene=answer), beside


def named_like(first: View, other: View, agreement: int) -> View:
    """The other view with the names of the first one's vertices, if these are not their numbers."""
    scene, called = other.scene, first.scene.names
    if called is None:
        return other
    names = names_like(_ties(first, other, agreement), scene.map, first.scene.map, called)
    return replace(other, scene=replace(scene, names=Names((*scene.dart_names,), names.vertices)))


def _ties(first: View, other: View, agreement: int) -> dict[Dart, Dart]:
    """Each dart of the other view with that of the first, as far as the two agree."""
    world, answer = first.scene.map, other.scene.map
    ties: dict[Dart, Dart] = {}
    for robot, belief in zip(first.trail[:agreement], other.trail[:agreement], strict=True):
        for k in range(world.degree_at[robot]):
            ties[answer.turn(belief, k)] = world.turn(robot, k)
    return mirror_of(answer, world) or extended(ties, answer, world)


def extended(
    tied: Mapping[Dart, Dart], map_: CombinatorialMap, other: CombinatorialMap
) -> dict[Dart, Dart]:
    """Match darts of two maps by following sigma and alpha from the tied pairs.

    Where they do not, a dart keeps the one that it has first: no dart of the other is used twice.

    Args:
        tied: darts that belong together to begin with; whole vertices of equal degree.
        map_: whose darts are the keys.
        other: whose darts are the values.

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


def names_like(
    ties: Mapping[Dart, Dart],
    map_: CombinatorialMap,
    other: CombinatorialMap,
    called: Names | None = None,
) -> Names:
    """Names for a map's darts and vertices from another map; unmatched ones get new names."""
    own = dict(enumerate(called.vertices if called else ()))
    fresh = iter(range(len(other.sigma), len(other.sigma) + len(map_.sigma)))
    darts = tuple(str(ties[d] if d in ties else next(fresh)) for d in map_.darts)
    new = iter(range(other.vertex_count, other.vertex_count + map_.vertex_count))
    taken: set[int] = set()
    vertices = []
    for vertex in map_.vertices:
        known = next((other.vertex_of[ties[d]] for d in vertex if d in ties), None)
        if known is None or known in taken:
            known = next(new)
        taken.add(known)
        fresh_name = f"new {known - other.vertex_count + 1}" if called else f"v{known}"
        vertices.append(own.get(known, fresh_name))
    return Names(darts, tuple(vertices))


def mirror_of(map_: CombinatorialMap, other: CombinatorialMap) -> dict[Dart, Dart]:
    """Each dart with its mirror image; empty if the map is not the mirror image of the other.

    A map that is the other one is no mirror image here, even if it is its own.
    """
    if not isinstance(isomorphism(map_, other), Mismatch):
        return {}
    names = isomorphism(map_.mirrored(), other)
    return {} if isinstance(names, Mismatch) else dict(enumerate(names))


def layout_like(
    ties: Mapping[Dart, Dart],
    map_: CombinatorialMap,
    root: Dart,
    other: CombinatorialMap,
    drawn: Layout,
) -> Layout:
    """Draw a map like another one if it is that map or its mirror image; else by itself.

    Args:
        ties: darts with those of the other map that they belong to.
        map_: what is to be drawn.
        root: the dart at which its drawing begins, where it is drawn by itself.
        other: the map that is drawn already.
        drawn: as which.
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
