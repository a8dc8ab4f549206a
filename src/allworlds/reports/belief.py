"""What a robot with a wrong answer would have sensed if the answer were right."""

from __future__ import annotations

from itertools import islice

from allworlds.checker.finding import place_of
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import Move, Percept, Transcript
from allworlds.world import World


def believed_percepts(
    world: World, estimate: CombinatorialMap, here: Dart, transcript: Transcript
) -> list[Percept] | None:
    """The percepts, first one included, of the same walk in the estimated map.

    Motion is reversible: from ``here`` the walk is traced back to the dart where it must have
    begun, and the lighthouse is put there as in the true world.  None where the estimated
    start has no such place.
    """
    trail = [here]
    for action, _ in reversed(transcript.steps):
        dart = trail[-1]
        if type(action) is Move:
            dart = estimate.turn(estimate.alpha[dart], -action.k)
        trail.append(dart)
    trail.reverse()
    places = type(world.lighthouse).places(estimate, trail[0])
    lighthouse = next(islice(places, place_of(world), None), None)
    if lighthouse is None:
        return None
    percepts = World(estimate, lighthouse, trail[0]).percepts
    return [percepts[dart] for dart in trail]
