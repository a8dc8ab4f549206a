"""What a robot with a wrong answer would have done and sensed if the answer were right."""

from __future__ import annotations

from allworlds.inputs import InputError
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import Move, Percept, Transcript
from allworlds.world import BelievedWalk, IllegalAction, World


def true_trail(world: World, transcript: Transcript) -> list[Dart]:
    """The robot's dart in the world at the start and after each step."""
    trail = [world.start]
    for action in transcript.actions:
        trail.append(world.step(trail[-1], action)[0])
    return trail


def recorded_trail(world: World, transcript: Transcript) -> list[Dart]:
    """The same for a transcript from elsewhere, which may be no walk in the world.

    Raises:
        InputError: naming the first step that does not fit.
    """
    try:
        trail = true_trail(world, transcript)
    except IllegalAction as error:
        raise InputError(f"the finding's transcript is no walk in its world: {error}") from None
    sensed = transcript.percepts
    for step, (dart, percept) in enumerate(zip(trail, sensed, strict=True)):
        if percept != world.percepts[dart]:
            raise InputError(
                f"the finding's transcript is no walk in its world: at step {step} it has "
                f"{percept!s}, where the world has {world.percepts[dart]!s}"
            )
    return trail


def believed_trail(estimate: CombinatorialMap, here: Dart, transcript: Transcript) -> list[Dart]:
    """The robot's dart in the estimated map at the start and after each step.

    Motion is reversible: from ``here`` the walk is traced back to the dart where it must have
    begun.
    """
    trail = [here]
    for action in reversed(transcript.actions):
        dart = trail[-1]
        if type(action) is Move:
            dart = estimate.turn(estimate.alpha[dart], -action.k)
        trail.append(dart)
    trail.reverse()
    return trail


def believed_percepts(
    world: World, estimate: CombinatorialMap, here: Dart, transcript: Transcript
) -> list[Percept] | None:
    """The percepts, first one included, of the same walk in the estimated map.

    The lighthouse stands where the robot must believe it; None where the answer has no such place.
    """
    trail = believed_trail(estimate, here, transcript)
    walk = BelievedWalk(estimate, trail, transcript.percepts)
    lighthouse = world.lighthouse.believed(world.map, world.start, walk)
    if lighthouse is None:
        return None
    percepts = lighthouse.percepts(estimate)
    return [percepts[dart] for dart in trail]
