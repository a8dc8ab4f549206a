"""The belief of an explorer: its walk traced back, and where it parts from the world."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from msgspec import Struct

from allworlds.judging.findings.walks import believed_percepts, trail_from, trail_to, true_trail
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Percept
from allworlds.protocol.answers import Estimate
from allworlds.protocol.transcript import Transcript
from allworlds.world.world import World


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


class BelievedWalk(Struct, frozen=True):
    """A walk in an answer beside the walk in the world.

    Attributes:
        trail: the robot's darts in the answer at the start and after each step; the last is
            where the answer says that the robot is.
        percepts: the ones that the answer predicts at each; None if it has no place for the
            lighthouse.
        parting: the first step at which it diverges from the world; None if there is none.
    """

    trail: Sequence[Dart]
    percepts: Sequence[Percept] | None
    parting: Parting | None

    @property
    def agreement(self) -> int:
        """The number of steps, the start included, in which both agree."""
        return self.parting.step if self.parting else len(self.trail)

    def expected(self, map_: CombinatorialMap) -> Sequence[Percept]:
        """The predicted percepts; only the degrees if the answer has no place for the marker."""
        return _said(map_, self.trail, self.percepts)


def believed_walk(world: World, answer: Estimate, transcript: Transcript) -> BelievedWalk:
    """The walk in the answer from the dart from which it agrees for longest.

    Of equals it is the one from which the motions lead to ``here``, if it is among them, else the
    one from the smallest dart: an explorer that errs only at the end was right before.

    Cost: the steps, times the darts of the answer from which the degrees agree that long.
    """
    best = _beside(world, answer.map, trail_to(answer.map, answer.here, transcript), transcript)
    walked, degrees = len(transcript.steps), [percept.degree for percept in transcript.percepts]
    alike = {
        dart: _alike(answer.map, trail_from(answer.map, dart, transcript), degrees)
        for dart in (answer.map.darts if best.agreement < walked else ())
    }
    for dart in sorted(alike, key=lambda dart: -alike[dart]):
        if alike[dart] <= best.agreement:
            break
        trail = [*trail_from(answer.map, dart, transcript)]
        trail[-1] = answer.here
        other = _beside(world, answer.map, trail, transcript)
        if other.agreement > best.agreement:
            best = other
    return best


def _alike(map_: CombinatorialMap, trail: Iterable[Dart], degrees: Sequence[int]) -> int:
    """The number of steps, the start included, before a degree differs."""
    pairs = zip(trail, degrees, strict=True)
    return next(
        (step for step, (dart, degree) in enumerate(pairs) if map_.degree_at[dart] != degree),
        len(degrees),
    )


def _beside(
    world: World, map_: CombinatorialMap, trail: Sequence[Dart], transcript: Transcript
) -> BelievedWalk:
    percepts = believed_percepts(world, map_, trail, transcript)
    pairs = zip(_said(map_, trail, percepts), transcript.percepts, strict=True)
    fits = [expected == sensed for expected, sensed in pairs]
    parting = find_parting(world.map, true_trail(world, transcript), map_, trail, fits)
    return BelievedWalk(trail, percepts, parting)


def _said(
    map_: CombinatorialMap, trail: Sequence[Dart], percepts: Sequence[Percept] | None
) -> Sequence[Percept]:
    return percepts or [Percept(map_.degree_at[dart]) for dart in trail]
