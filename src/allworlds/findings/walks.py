"""What a robot with a wrong answer would have done and sensed if the answer were right."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

from allworlds.findings.finding import place_of
from allworlds.inputs import InputError
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import Move, Percept, Transcript
from allworlds.world import Cluster, Compass, IllegalAction, Lighthouse, Natural, World


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

    The lighthouse is put where the walk must have begun, as in the true world; a compass's
    reference darts are those that were sensed when the robot first came to a vertex.  None
    where the estimated start has no such place.  What marks v0 and v1 is put there even where a
    wrong answer breaks what it needs, such as degrees that are unique.
    """
    trail = believed_trail(estimate, here, transcript)
    lighthouse: Lighthouse | None
    match world.lighthouse:
        case Compass():
            lighthouse = _believed_compass(estimate, trail, transcript)
        case Cluster(dart) | Natural(dart) as true:
            bearing = world.map.offset(world.start, dart)
            lighthouse = type(true)(estimate.turn(trail[0], bearing))
        case _:
            places = type(world.lighthouse).places(estimate, trail[0])
            lighthouse = next(islice(places, place_of(world), None), None)
    if lighthouse is None:
        return None
    percepts = lighthouse.percepts(estimate)
    return [percepts[dart] for dart in trail]


def _believed_compass(
    estimate: CombinatorialMap, trail: Sequence[Dart], transcript: Transcript
) -> Compass:
    north = {vertex: darts[0] for vertex, darts in enumerate(estimate.vertices)}
    sensed = transcript.percepts
    for dart, percept in reversed([*zip(trail, sensed, strict=True)]):
        assert percept.bearing is not None
        north[estimate.vertex_of[dart]] = estimate.turn(dart, percept.bearing)
    return Compass(tuple(sorted(north.values())))
