"""A walk in a world, and the same walk in an answer, as every picture shows them."""

from __future__ import annotations

from collections.abc import Sequence

from allworlds.judging import believed_walk, true_walk
from allworlds.maps import Dart
from allworlds.protocol import Estimate, Move, Transcript
from allworlds.reports.drawing.scene import Scene, scene_of
from allworlds.world import World

ANSWER = "the answer (R: where it says that the robot is)"
"""The caption of an answer."""

OTHER = "another world, where the robot senses the same"
"""The caption of another world that agrees with the log."""


def walk_in_world(world: World, transcript: Transcript) -> Scene:
    """The world with what is sensed in it, and the robot at the end of its walk."""
    states = [state for state, _ in true_walk(world, transcript)]
    trail = [state.dart for state in states]
    return scene_of(
        world, robot=trail[-1], dropped=states[-1].lying, walked=_arrivals(trail, transcript)
    )


def walk_in_answer(world: World, answer: Estimate, transcript: Transcript) -> Scene:
    """The answer with what it makes expect on the walk; the robot is where the answer says."""
    walk = believed_walk(world, answer, transcript)
    # Where the answer has no place for the lighthouse it says nothing of markers.
    return Scene.sensed(
        answer.map,
        walk.trail[0],
        zip(walk.trail, walk.percepts or [], strict=False),
        robot=answer.here,
        walked=_arrivals(walk.trail, transcript),
    )


def _arrivals(trail: Sequence[Dart], transcript: Transcript) -> set[Dart]:
    """The darts by which an edge was walked; before the first motion there is none."""
    steps = zip(trail[1:], transcript.actions, strict=True)
    return {dart for dart, action in steps if type(action) is Move}
