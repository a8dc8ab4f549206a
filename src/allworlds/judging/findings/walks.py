"""The walk and the percepts of a robot if its wrong answer were right."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from allworlds.inputs.checks import InputError
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Drop, Move, Percept, Pick
from allworlds.protocol.faults import IllegalAction
from allworlds.protocol.transcript import Transcript
from allworlds.world.lighthouses.base import State, WalkInAnswer
from allworlds.world.world import World


def true_trail(world: World, transcript: Transcript) -> list[Dart]:
    """The robot's dart in the world at the start and after each step."""
    return [state.dart for state, _ in true_walk(world, transcript)]


def true_walk(world: World, transcript: Transcript) -> list[tuple[State, Percept]]:
    """The world's state at the start and after each step, with the percepts in it."""
    walk = [(world.initial, world.first)]
    for action in transcript.actions:
        walk.append(world.step(walk[-1][0], action))
    return walk


def recorded_trail(world: World, transcript: Transcript) -> list[Dart]:
    """The robot's darts by a transcript from elsewhere, which may be no walk in the world.

    Raises:
        InputError: naming the first step that does not fit.
    """
    try:
        walk = true_walk(world, transcript)
    except IllegalAction as error:
        raise InputError(f"the finding's transcript is no walk in its world: {error}") from None
    sensed = transcript.percepts
    for step, ((_, truth), percept) in enumerate(zip(walk, sensed, strict=True)):
        if percept != truth:
            raise InputError(
                f"the finding's transcript is no walk in its world: at step {step} it has "
                f"{percept!s}, where the world has {truth!s}"
            )
    return [state.dart for state, _ in walk]


def trail_to(map_: CombinatorialMap, here: Dart, transcript: Transcript) -> list[Dart]:
    """The robot's dart at the start and after each step of the walk that ends at ``here``.

    Motion is reversible: the walk is traced back to the dart where it must have begun.
    """
    trail = [here]
    for action in reversed(transcript.actions):
        dart = trail[-1]
        if type(action) is Move:
            dart = map_.turn(map_.alpha[dart], -action.k)
        trail.append(dart)
    trail.reverse()
    return trail


def trail_from(map_: CombinatorialMap, start: Dart, transcript: Transcript) -> Iterator[Dart]:
    """The robot's dart at the start and after each step of the walk that begins at ``start``."""
    yield (dart := start)
    for action, _ in transcript.steps:
        if type(action) is Move:
            dart = map_.alpha[map_.turn(dart, action.k)]
        yield dart


def believed_percepts(
    world: World, estimate: CombinatorialMap, trail: Sequence[Dart], transcript: Transcript
) -> list[Percept] | None:
    """The percepts, first one included, of a walk along these darts of the estimated map.

    The lighthouse stands where the robot must believe it; None if the answer has no such place.
    """
    walk = WalkInAnswer(estimate, trail, transcript.percepts)
    lighthouse = world.lighthouse.believed(world.map, world.start, walk)
    if lighthouse is None:
        return None
    percepts = lighthouse.percepts(estimate)
    dropped: Counter[int] = Counter()
    expected = [percepts[trail[0]]]
    for dart, action in zip(trail[1:], transcript.actions, strict=True):
        vertex = estimate.vertex_of[dart]
        dropped[vertex] += (type(action) is Drop) - (type(action) is Pick)
        # A wrong answer may make the robot take up what it has never dropped there.
        expected.append(percepts[dart].marked(max(dropped[vertex], 0)))
    return expected
