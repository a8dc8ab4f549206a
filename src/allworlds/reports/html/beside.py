"""Two maps side by side: in one numbering, and drawn alike where they agree."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from xml.etree import ElementTree as ET

from allworlds.maps import Dart
from allworlds.reports.drawing.alike import extended, layout_like, mirror_of, names_like
from allworlds.reports.drawing.layout import layout
from allworlds.reports.drawing.scene import Scene
from allworlds.reports.html.viewer import figure


def figures_beside(
    world: Scene,
    answer: Scene,
    trails: tuple[Sequence[Dart], Sequence[Dart]],
    agreement: int,
    name: str,
    title: str = "The answer",
) -> list[ET.Element]:
    """The world, and beside it the answer in the world's numbers, with the first difference ringed.

    Args:
        world: what is to be seen in it.
        answer: the same of that.
        trails: the robot's darts in each, step by step.
        agreement: the number of steps, the start included, in which both go along alike.
        name: of the walk, with which the names of the pictures begin.
        title: of the answer.
    """
    walked, believed = trails
    ties: dict[Dart, Dart] = {}
    for robot, belief in zip(walked[:agreement], believed[:agreement], strict=True):
        for k in range(world.map.degree_at[robot]):
            ties[answer.map.turn(belief, k)] = world.map.turn(robot, k)
    ties = mirror_of(answer.map, world.map) or extended(ties, answer.map, world.map)
    drawn = layout(world.map, world.start)
    beside = layout_like(ties, answer.map, answer.start, world.map, drawn)
    if agreement < len(walked):
        world = replace(world, ringed=walked[agreement])
        answer = replace(answer, ringed=believed[agreement])
    answer = replace(answer, names=names_like(ties, answer.map, world.map))
    return [
        figure("The world", world, f"{name}-world", "robot", drawn),
        figure(title, answer, f"{name}-answer", "believed", beside),
    ]
