"""Two maps side by side: in one numbering, and drawn alike where they agree."""

from __future__ import annotations

from allworlds.document import replace
from allworlds.maps import Dart
from allworlds.reports.drawing.alike import extended, layout_like, mirror_of, names_like
from allworlds.reports.drawing.layout import Layout
from allworlds.reports.telling import View


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
    ties: dict[Dart, Dart] = {}
    for robot, belief in zip(first.trail[:agreement], other.trail[:agreement], strict=True):
        for k in range(world.map.degree_at[robot]):
            ties[answer.map.turn(belief, k)] = world.map.turn(robot, k)
    ties = mirror_of(answer.map, world.map) or extended(ties, answer.map, world.map)
    beside = layout_like(ties, answer.map, answer.start, world.map, drawn)
    if agreement < len(first.trail):
        world = replace(world, ringed=first.trail[agreement])
        answer = replace(answer, ringed=other.trail[agreement])
    answer = replace(answer, names=names_like(ties, answer.map, world.map))
    return replace(first, scene=world), replace(other, scene=answer), beside
