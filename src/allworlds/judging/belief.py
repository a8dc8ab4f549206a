"""The walk of a run in the map of the run's answer, compared with the walk in the world.

The two walks *diverge* at the first step at which the answer and the world contradict each other.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from operator import eq

from msgspec import Struct

from allworlds.judging.walk import Walk
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import actions
from allworlds.protocol.actions import Transcript
from allworlds.world.lighthouses.base import WalkInAnswer
from allworlds.world.state import State


def trail_to(map_: CombinatorialMap, here: Dart, walk: Walk | Transcript) -> list[Dart]:
    """The robot's darts in ``map_``, at the start and after each step of a walk to ``here``.

    The walk in ``map_`` has the actions of ``walk``.  Motions are reversible, so it is traced back
    from ``here``, its last dart, to its beginning.
    """
    trail = [here]
    for action in reversed(walk.actions):
        dart = trail[-1]
        if type(action) is actions.Move:
            dart = map_.turn(map_.alpha[dart], -action.k)
        trail.append(dart)
    trail.reverse()
    return trail


def trail_from(map_: CombinatorialMap, start: Dart, walk: Walk) -> Iterator[Dart]:
    """The robot's darts in ``map_``, at the start and after each step of the walk from ``start``.

    The actions are those of ``walk``.
    """
    yield (dart := start)
    for action, _ in walk.steps:
        if type(action) is actions.Move:
            dart = map_.move(dart, action.k)
        yield dart


def believed_percepts(
    walk: Walk, estimate: CombinatorialMap, trail: Sequence[Dart]
) -> list[actions.Percept] | None:
    """The percepts that the map of an answer predicts, at the start and after each step.

    For this the lighthouse needs a place in the answer's map, whose start is the first dart of
    ``trail``.  The lighthouse's own method ``believed`` chooses the place.  Most kinds of
    lighthouses follow one of two rules.  First: the places of each map are numbered, and the place
    has the same number as in the world.  Second: the lighthouse's dart is as many darts clockwise
    from the start as in the world.  If the answer's map has no such place, the result is None.

    Args:
        walk: the robot's walk in the world.
        estimate: the map of the answer.
        trail: the robot's darts in this map, at the start and after each step.
    """
    world, answered = walk.world, WalkInAnswer(estimate, trail, walk.percepts)
    lighthouse = world.lighthouse.believed(world.map, world.start, answered)
    if lighthouse is None:
        return None
    percepts = lighthouse.percepts(estimate)
    state, expected = State(trail[0], hand=lighthouse.in_hand), [percepts[trail[0]]]
    for dart, action in zip(trail[1:], walk.actions, strict=True):
        state = replace(state, dart=dart)
        lying = state.lying.count(estimate.vertex_of[dart])
        # In a wrong answer the robot may take up a marker that it has never dropped there.
        if type(action) is not actions.Move and not lighthouse.refusal(action, lying, state.hand):
            state = lighthouse.acted(estimate, state, action)
        expected.append(percepts[dart].marked(lighthouse.left_marks(estimate, state)))
    return expected


class Parting(Struct, frozen=True):
    """The first step at which the walk in the answer contradicts the walk in the world.

    Attributes:
        step: the number of the step; 0 is the start.
        robot: the robot's dart in the world.
        taken_for: the dart of the world for which the answer takes ``robot``; None if the answer
            takes the robot's vertex for a new one.  If ``taken_for`` is right, only the percept
            does not fit the answer.
        fresh: whether the robot's vertex is really new: the robot is at this vertex of the world
            for the first time.  Then ``taken_for`` is right if it is None, else if it is ``robot``.
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
    """The first step at which the walks in the world and in the answer diverge; None if at none.

    At the start and after each step the robot stands at a dart of the world and at a dart of the
    answer.  If the robot is at this vertex of the world for the first time, these two darts become
    partners, then the next darts clockwise round the two vertices, and so on.  The walks diverge at
    the first step at which the percept does not fit, or at which one of the robot's two darts
    already has another partner.

    Args:
        world: the true map.
        walked: the robot's darts in the world, at the start and after each step.
        answer: the estimated map.
        believed: the robot's darts in the answer, at the start and after each step.
        fits: for the start and each step whether the answer predicts the sensed percept.  The
            caller must set it to False if the robot's vertices in the world and in the answer have
            different degrees.

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
    """A walk in the map of an answer, compared step by step with the walk in the world.

    Attributes:
        trail: the robot's darts in the answer, at the start and after each step; the last dart is
            the answer's ``here``.
        percepts: the percepts that the answer predicts, at the start and after each step; None if
            the answer's map has no place for the lighthouse.
        expected: equal to ``percepts``; if ``percepts`` is None, percepts that hold nothing but the
            degrees in the answer.
        misfits: the steps at which the sensed percept differs from the expected one; 0 is the
            start.
        parting: the first step at which the walks diverge; None if they never do.
    """

    trail: Sequence[Dart]
    percepts: Sequence[actions.Percept] | None
    expected: Sequence[actions.Percept]
    misfits: Sequence[int]
    parting: Parting | None

    @property
    def agreement(self) -> int:
        """The number of steps before the walks diverge; the start counts as a step."""
        return self.parting.step if self.parting else len(self.trail)


def believed_walk(walk: Walk, answer: actions.Estimate) -> BelievedWalk:
    """The walk in the answer that agrees for longest with ``walk``, the walk in the world.

    Several walks in the answer, the candidates, are compared with ``walk``.  All have the actions
    of ``walk`` and the last dart ``here``, the answer's pose.  The first candidate is the walk that
    really ends at ``here``.  If it diverges from ``walk`` only at the last step, or never, it is
    the result.

    Otherwise the explorer may have been right up to its last step, and then have given a wrong
    ``here``.  So each dart of the answer gives a further candidate: the walk that begins at this
    dart, with its last dart replaced by ``here``.  A further candidate that never diverges is left
    out: its last step is a leap that no motion makes, because the only walk that really ends at
    ``here`` is the first candidate.

    The candidate that diverges latest is the result.  If several diverge latest, the first
    candidate is preferred; then the further candidate whose degrees equal the sensed degrees for
    the most steps from the start; then the one that begins at the smallest dart.

    Cost: for each dart of the answer at most linear in the steps and the darts.
    """
    best = _beside(walk, answer.map, trail_to(answer.map, answer.here, walk))
    degrees = [percept.degree for percept in walk.percepts]
    alike = {
        dart: _alike(answer.map, trail_from(answer.map, dart, walk), degrees)
        for dart in (answer.map.darts if best.agreement < len(walk) else ())
    }
    for dart in sorted(alike, key=lambda dart: -alike[dart]):
        if alike[dart] <= best.agreement:
            break
        trail = [*trail_from(answer.map, dart, walk)]
        trail[-1] = answer.here
        other = _beside(walk, answer.map, trail)
        # If nothing contradicts the leap to `here`, it is no walk: the answer does not fit the log.
        if other.parting and other.agreement > best.agreement:
            best = other
    return best


def _alike(map_: CombinatorialMap, trail: Iterable[Dart], degrees: Sequence[int]) -> int:
    """The number of darts of ``trail`` before the first one whose degree is not the sensed one.

    The degree of a dart is that of its vertex in ``map_``; ``degrees`` holds the sensed degrees.
    """
    pairs = zip(trail, degrees, strict=True)
    return next(
        (step for step, (dart, degree) in enumerate(pairs) if map_.degree_at[dart] != degree),
        len(degrees),
    )


def _beside(walk: Walk, map_: CombinatorialMap, trail: Sequence[Dart]) -> BelievedWalk:
    percepts = believed_percepts(walk, map_, trail)
    expected = percepts or [actions.Percept(map_.degree_at[dart]) for dart in trail]
    fits = [*map(eq, expected, walk.percepts)]
    misfits = [step for step, fit in enumerate(fits) if not fit]
    parting = find_parting(walk.world.map, walk.darts, map_, trail, fits)
    return BelievedWalk(trail, percepts, expected, misfits, parting)
