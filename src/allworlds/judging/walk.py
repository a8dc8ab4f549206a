"""The walk of a run in its world: laws, tasks, findings, and explanations in words depend on walks.

Only the method :meth:`~allworlds.world.world.World.step` knows how a robot moves; every step of a
walk is made by this method.
"""

from collections.abc import Iterable, Iterator
from typing import Self

from msgspec import Struct, field

from allworlds.inputs.checks import InputError
from allworlds.maps.combinatorial import Dart
from allworlds.protocol.actions import Action, IllegalAction, Move, Percept, Transcript
from allworlds.world.state import State
from allworlds.world.world import World


class Walk(Struct):
    """A walk in a world, which grows during the run.

    The elements of a walk are its steps: pairs of an action and the percept after the action.

    Attributes:
        world: the world of the run.
        states: the states of the world at the start and after each step.
        darts: the robot's darts: the dart that the robot faces at the start, and after each step
            the dart where the robot is, by which it has last arrived.
        visited: the vertices where the robot has been.
        steps: the pairs of an action and the percept after the action.
        crossed: the edges that the robot has walked along.  The key is the smaller dart of an edge;
            the value is the number of steps before the first step along the edge.  The edges are
            in the order of these values.
        cost: the number of traversals.
    """

    world: World
    states: list[State]
    darts: list[Dart]
    visited: set[int]
    steps: list[tuple[Action, Percept]] = field(default_factory=list)
    crossed: dict[Dart, int] = field(default_factory=dict)
    cost: int = 0

    @classmethod
    def begin(cls, world: World) -> Self:
        """Return the walk in ``world`` that has no step yet."""
        return cls(world, [world.initial], [world.start], {world.map.vertex_of[world.start]})

    @classmethod
    def of(cls, world: World, actions: Iterable[Action]) -> Self:
        """Return the walk in ``world`` with the actions ``actions``.

        Raises:
            IllegalAction: if an action is illegal where the robot does it.

        Cost: linear in the number of actions.
        """
        walk = cls.begin(world)
        for action in actions:
            walk.step(action)
        return walk

    @classmethod
    def recorded(cls, world: World, transcript: Transcript) -> Self:
        """Return the walk of a finding's transcript, after a check that ``world`` allows this walk.

        Raises:
            InputError: naming the first illegal action, or the first percept that differs from the
                percept in the world.
        """
        try:
            walk = cls.of(world, transcript.actions)
        except IllegalAction as error:
            raise InputError(f"the finding's transcript is no walk in its world: {error}") from None
        pairs = zip(walk.percepts, transcript.percepts, strict=True)
        for step, (truth, percept) in enumerate(pairs):
            if percept != truth:
                raise InputError(
                    f"the finding's transcript is no walk in its world: at step {step} it has "
                    f"{percept!s}, where the world has {truth!s}"
                )
        return walk

    def step(self, action: Action) -> Percept:
        """Add the step of this action to the walk; return the percept after the step.

        Raises:
            IllegalAction: if the robot cannot do the action where it is; the walk is then not
                changed.
        """
        state, percept = self.world.step(self.states[-1], action)
        map_, dart = self.world.map, state.dart
        if type(action) is Move:
            self.crossed.setdefault(min(dart, map_.alpha[dart]), len(self.steps))
            self.cost += 1
        self.states.append(state)
        self.darts.append(dart)
        self.visited.add(map_.vertex_of[dart])
        self.steps.append((action, percept))
        return percept

    def __iter__(self) -> Iterator[tuple[Action, Percept]]:
        return iter(self.steps)

    def __len__(self) -> int:
        return len(self.steps)

    @property
    def first(self) -> Percept:
        """The percept at the start, before any action."""
        return self.world.first

    @property
    def percepts(self) -> list[Percept]:
        """The percepts at the start and after each step."""
        return [self.first, *(percept for _, percept in self.steps)]

    @property
    def actions(self) -> list[Action]:
        """The actions, step by step."""
        return [action for action, _ in self.steps]

    @property
    def here(self) -> Dart:
        """The robot's dart after the last step."""
        return self.darts[-1]

    @property
    def walked(self) -> set[Dart]:
        """The walked edges, each named by its smaller dart."""
        return set(self.crossed)

    @property
    def arrivals(self) -> set[Dart]:
        """The darts by which the robot has arrived at vertices."""
        steps = zip(self.darts[1:], self.actions, strict=True)
        return {dart for dart, action in steps if type(action) is Move}

    @property
    def transcript(self) -> Transcript:
        """The actions and percepts of the walk, without the world."""
        return Transcript(self.first, tuple(self.steps))
