"""The walk of a log in a wrong answer, begun where it agrees with the world for longest."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from msgspec import Struct

from allworlds.judging.findings.divergence import Parting, find_parting
from allworlds.judging.findings.walks import believed_percepts, trail_from, trail_to, true_trail
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Estimate, Percept, Transcript
from allworlds.world import World


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
