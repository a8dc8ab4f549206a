"""The first step at which a walk in the world and its image in an answer diverge."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from allworlds.maps import CombinatorialMap, Dart


class Parting(Struct, frozen=True):
    """The first step at which the answer diverges from the world.

    Attributes:
        step: the number of the step; 0 is the start.
        robot: the robot's dart in the world.
        taken_for: the dart of the world for which the answer takes it; None if the answer has the
            robot at a vertex where it has not been before.
        fresh: whether in the world the robot has not been at this vertex before.
    """

    step: int
    robot: Dart
    taken_for: Dart | None
    fresh: bool


def find_parting(
    world: CombinatorialMap,
    walked: Sequence[Dart],
    answer: CombinatorialMap,
    believed: Sequence[Dart],
    fits: Sequence[bool],
) -> Parting | None:
    """The first step at which the two walks diverge; None if they never do.

    Every dart that the robot arrives by is tied to the dart by which it arrives in the
    answer, and with the two darts their whole rotations.  The walks diverge where a tie would be
    contradicted.

    Args:
        world: the true map.
        walked: the robot's darts in it, start included.
        answer: the estimated map.
        believed: the robot's darts in that, start included.
        fits: for each step whether the answer predicts the percept.  Where it does,
            both vertices have one degree.

    Cost: linear in the steps and the darts.
    """
    tied: dict[Dart, Dart] = {}
    means: dict[Dart, Dart] = {}
    for step, (robot, belief) in enumerate(zip(walked, believed, strict=True)):
        fresh, taken_for = robot not in tied, means.get(belief)
        if not fits[step] or taken_for != (None if fresh else robot):
            return Parting(step, robot, taken_for, fresh)
        if fresh:
            for k in range(world.degree_at[robot]):
                a, b = world.turn(robot, k), answer.turn(belief, k)
                tied[a], means[b] = b, a
    return None
