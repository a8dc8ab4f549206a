"""Scenes of a walk: in the world, and in an answer."""

from __future__ import annotations

from collections.abc import Sequence

from allworlds.judging.findings.walks import believed_walk, true_walk
from allworlds.maps.combinatorial import Dart
from allworlds.protocol.actions import Move
from allworlds.protocol.answers import Estimate
from allworlds.protocol.transcript import Transcript
from allworlds.reports.drawing.scene import Scene, scene_of
from allworlds.world.world import World


def walk_in_world(world: World, transcript: Transcript) -> Scene:
    """The world with everything that is sensed, and the robot at the end of its walk."""
    states = [state for state, _ in true_walk(world, transcript)]
    trail = [state.dart for state in states]
    return scene_of(
        world, robot=trail[-1], dropped=states[-1].lying, walked=_arrivals(trail, transcript)
    )


def walk_in_answer(world: World, answer: Estimate, transcript: Transcript) -> Scene:
    """The answer with the percepts that it predicts, and the robot where the answer says."""
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
    """The darts by which the robot arrived, step by step; none before the first motion."""
    steps = zip(trail[1:], transcript.actions, strict=True)
    return {dart for dart, action in steps if type(action) is Move}
