"""The base of every model: a world that changes, and its robots' percepts and actions."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from itertools import product
from typing import Any, ClassVar, Literal, NamedTuple, TypeAlias

from msgspec.json import encode

from allworlds.inputs.checks import InputError, integer, let_users_interrupt, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import IllegalAction, Percept
from allworlds.protocol.turns import Sensed

ModelState: TypeAlias = Hashable
"""The state of a world: any hashable value of its model."""

Scheduler: TypeAlias = Literal["fsync", "ssync", "central", "async"]
"""The rule that says which robots are activated at once.

``fsync``: all robots; ``ssync``: any set of robots; ``central``: one robot; ``async``: any set of
robots, each of which makes its next step, which is Look with Compute, or Move.
"""

SCHEDULERS: tuple[Scheduler, ...] = "fsync", "ssync", "central", "async"


class Liveness(NamedTuple):
    """A condition on every fair run of automata that never ends.

    A run is fair if no robot that can always be activated is left out for ever.

    Attributes:
        name: the condition in words, such as ``robot 0 at vertex 3``.
        forever: whether the condition must hold at all times from some time on (FG); else it must
            hold again and again (GF).
        holds: the function that says whether the condition holds in a state. None stands for the
            condition that no robot acts any more.
    """

    name: str
    forever: bool
    holds: Callable[[Any], bool] | None


QUIET = Liveness("quiet", forever=True, holds=None)
"""The condition that from some time on no robot acts."""


class Assumption(NamedTuple):
    """Choices that the adversary is assumed to make again and again.

    Attributes:
        name: the choices in words, such as ``the edge 3 is there``.
        holds: the function that says whether the adversary has made such a choice in a step.  Its
            arguments are the state before the step, the state after it, and the choice in words.
    """

    name: str
    holds: Callable[[Any, Any, str], bool]


class Model:
    """A world that changes.  A model of your own is a frozen dataclass with this base.

    A state is any hashable value that never changes.  The methods are called in any order, and more
    than once with equal arguments; then they must return equal values.  In the methods ``map_`` is
    the map, ``state`` a state, and ``robot`` the number of a robot, from 0 on.  A field that is an
    integer, a boolean or a text with a default is an option, as in
    ``--model FILE.py:Class:faults=1``.

    Attributes:
        schedulers: the schedulers that make sense in this world; the first is the default.
    """

    schedulers: ClassVar[tuple[Scheduler, ...]] = SCHEDULERS

    def starts(self, map_: CombinatorialMap, robots: int) -> Iterable[tuple[Dart, ...]]:
        """The starts to try, each with a dart for each robot; ``robots`` is the number of robots.

        By default robot 0 is at dart 0, and the other robots are at any darts.
        """
        return every_start(map_, robots)

    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterable[ModelState]:
        """The states at the start, of which the adversary chooses one.

        ``starts`` has the dart of each robot.
        """
        raise NotImplementedError

    def told(self, map_: CombinatorialMap, robot: int) -> Any:  # noqa: ARG002  # nothing
        """The value that a robot is told at the start.

        Robots that are told equal values are anonymous: their programs cannot tell them apart.
        """
        return None

    def sensed(self, map_: CombinatorialMap, state: Any, robot: int) -> Any:
        """The percept of a robot that looks now: a Percept, or a JSON value.

        None stands for a robot that is gone, and is never activated again.
        """
        raise NotImplementedError

    def step(
        self, map_: CombinatorialMap, state: Any, acts: Mapping[int, Any]
    ) -> Iterable[tuple[ModelState, str]]:
        """Each state that can follow these simultaneous actions, with the adversary's choice.

        Args:
            map_: the map.
            state: the state before.
            acts: the actions that are done now, by robot.  A robot is missing if it is not
                activated, if its program has ended, or if its action is ``Wait`` or ``Watch``,
                which do nothing in the world.  In ``fsync`` and ``ssync`` the world makes a step in
                each round; then ``acts`` may be empty.

        Returns:
            Pairs of a state and the adversary's choice in words, which may be empty.

        Raises:
            IllegalAction: for an action that has no meaning in this model; this makes a finding.
        """
        raise NotImplementedError

    def looked(
        self,
        map_: CombinatorialMap,  # noqa: ARG002  # nothing
        state: Any,
        robot: int,  # noqa: ARG002  # nothing
        action: Any,  # noqa: ARG002  # nothing
    ) -> Iterable[tuple[ModelState, str]]:
        """Each state after the look of a robot that acts later, with the adversary's choice.

        ``action`` is the action that the robot has chosen at its look.  Only in ``async`` an action
        is done later than its look.  By default the look does not change the world.  A model can
        store in the state what the look decides: for example the dart that the action means, if
        steps of other robots can change this meaning.

        Raises:
            IllegalAction: as for ``step``.
        """
        return ((state, ""),)

    def bad(self, map_: CombinatorialMap, state: Any) -> str:  # noqa: ARG002  # nothing
        """The reason why a state must never be reached, in words; empty for a legal state."""
        return ""

    def over(self, map_: CombinatorialMap, state: Any) -> bool:  # noqa: ARG002  # never
        """Whether the goal is reached, and the run ends."""
        return False

    def flaw(self, map_: CombinatorialMap, state: Any, answers: Sequence[Any]) -> str:  # noqa: ARG002
        """The flaw, in words, of a run in which each robot has ended or waits for ever.

        The text is empty if the run has no flaw.

        Args:
            map_: the map.
            state: the last state.
            answers: the answer of each robot; None for a robot that has not ended.
        """
        conditions = [each for each in self.progress(map_) if each.holds is not None]
        lacking = [each.name for each in conditions if each.holds and not each.holds(state)]
        return f"{lacking[0]} was not reached" if lacking else ""

    def progress(self, map_: CombinatorialMap) -> Iterable[Liveness]:
        """The conditions on every infinite fair run; by default that the goal is reached."""
        yield Liveness("the goal", forever=False, holds=lambda state: self.over(map_, state))

    @property
    def says_progress(self) -> bool:
        """Whether the model has its own conditions on infinite runs, in its :meth:`progress`."""
        return type(self).progress is not Model.progress

    def assumes(self, map_: CombinatorialMap) -> Iterable[Assumption]:  # noqa: ARG002  # nothing
        """The choices that the adversary is assumed to make again and again: by default none."""
        return ()

    def places(self, map_: CombinatorialMap, state: Any) -> Places:  # noqa: ARG002
        """The content of a picture of a state: by default the darts of ``state.darts``."""
        return Places(tuple(getattr(state, "darts", ())))


class Places(NamedTuple):
    """The content of a picture of a state.

    Attributes:
        darts: the dart of each robot; None for a robot that is gone.
        vertices: words at vertices, by the number of the vertex.
        edges: words at edges, by the smaller dart of the edge.
    """

    darts: tuple[Dart | None, ...] = ()
    vertices: Mapping[int, str] = {}
    edges: Mapping[int, str] = {}


def every_start(map_: CombinatorialMap, robots: int) -> Iterator[tuple[Dart, ...]]:
    """Every start with robot 0 at dart 0, the root of the map, and the other robots at any darts.

    ``robots`` is the number of robots.  The enumeration of maps yields each map with every dart as
    the root, up to isomorphism.  So starts with robot 0 at other darts are not needed: they are the
    starts in the same map with another root.
    """
    return ((0, *others) for others in product(map_.darts, repeat=robots - 1))


def joined(words: str, more: str) -> str:
    """The words for two choices of the adversary, joined to one text; each may be empty."""
    return f"{words}; {more}" if words and more else words or more


class ModelError(InputError):
    """Raised if a method of a model raises an error, or returns an illegal value."""


class ModelInMap:
    """A model in one map; every value that the model returns is checked.

    Args:
        model: the model.
        map_: the map.
        name: the name of the model.

    Attributes:
        says_bad, says_over, says_progress: whether the model overrides ``bad``, ``over``, and
            ``progress``.
        decides_at_looks: whether the model overrides ``looked``.

    Each method raises ModelError if the model's method raises an error or returns an illegal value.
    """

    def __init__(self, model: Model, map_: CombinatorialMap, name: str) -> None:
        self.model, self.map, self.name = model, map_, name
        kind = type(model)
        self.says_bad, self.says_over = kind.bad is not Model.bad, kind.over is not Model.over
        self.says_progress = model.says_progress
        self.decides_at_looks = kind.looked is not Model.looked

    def starts(self, robots: int) -> list[tuple[Dart, ...]]:
        """The starts to try for ``robots`` robots, each with a dart for each robot."""
        made = self._list("starts", robots)
        for start in made:
            darts = isinstance(start, tuple) and len(start) == robots
            if not darts or any(dart not in self.map.darts for dart in start):
                last = len(self.map.sigma) - 1
                legal = f"a tuple of {robots} darts, each from 0 to {last}"
                raise self._wrong("starts", f"yields {show(start)}, which is not {legal}")
        return made

    def initial(self, starts: Sequence[Dart]) -> list[ModelState]:
        """The states at the start, of which the adversary chooses one."""
        made = self._list("initial", starts)
        for state in made:
            self._ensure_hashable("initial", state)
        return made

    def told(self, robot: int) -> bytes | None:
        """The value that a robot is told, as canonical JSON; None if it is told nothing."""
        value = self._ask("told", robot)
        return None if value is None else self._json("told", value)

    def sensed(self, state: Any, robot: int) -> Sensed | None:
        """The percept of a robot in the form of messages to programs; None if the robot is gone."""
        value = self._ask("sensed", state, robot)
        if value is None:
            return None
        return self._numbers(value) if type(value) is Percept else self._json("sensed", value)

    def step(self, state: Any, acts: Mapping[int, Any]) -> list[tuple[ModelState, str]]:
        """Each state that can follow the actions ``acts``, with the adversary's choice in words.

        Raises:
            IllegalAction: if the model refuses an action.
        """
        return self._following("step", dict(acts), self._list("step", state, acts))

    def looked(self, state: Any, acts: Mapping[int, Any]) -> list[tuple[ModelState, str]]:
        """Each state after looks whose actions are done later, with the adversary's choice.

        ``acts`` has these actions, by robot.

        Raises:
            IllegalAction: if the model refuses an action.
        """
        made: list[tuple[ModelState, str]] = [(state, "")]
        for robot, action in acts.items():
            every = []
            for before, words in made:
                after = self._list("looked", before, robot, action)
                for to, more in self._following("looked", action, after):
                    every.append((to, joined(words, more)))
            made = every
        return made

    def _following(self, method: str, acts: Any, made: list[Any]) -> list[tuple[ModelState, str]]:
        for each in made:
            if not isinstance(each, tuple) or len(each) != 2 or not isinstance(each[1], str):
                legal = "a pair of a state and words"
                raise self._wrong(method, f"yields {show(each)}, which is not {legal}")
            self._ensure_hashable(method, each[0])
        if not made:
            raise self._wrong(method, f"yields no state after {show(acts)}")
        return made

    def bad(self, state: Any) -> str:
        """The reason why a state must never be reached; empty for a legal state."""
        return self._text("bad", state)

    def over(self, state: Any) -> bool:
        """Whether the goal is reached, and the run ends."""
        return bool(self._ask("over", state))

    def flaw(self, state: Any, answers: Sequence[Any]) -> str:
        """The flaw, in words, of a run with this last state and these answers; empty if none."""
        return self._text("flaw", state, answers)

    def progress(self) -> list[Liveness]:
        """The conditions on every infinite fair run."""
        return [Liveness(*each) for each in self._list("progress")]

    def assumes(self) -> list[Assumption]:
        """The choices that the adversary is assumed to make again and again."""
        return [Assumption(*each) for each in self._list("assumes")]

    def holds(self, condition: Liveness, state: Any) -> bool:
        """Whether a condition holds in a state."""
        assert condition.holds is not None
        try:
            return bool(condition.holds(state))
        except Exception as error:  # noqa: BLE001  # the model is the user's
            raise self._raised("progress", error) from None

    def places(self, state: Any) -> Places:
        """The content of a picture of this state."""
        return Places(*self._ask("places", state))

    # ---------------------------------------------------------------- mistakes

    def _ask(self, method: str, *values: Any) -> Any:
        try:
            return getattr(self.model, method)(self.map, *values)
        except Exception as error:  # noqa: BLE001  # the model is the user's
            raise self._raised(method, error) from None

    def _list(self, method: str, *values: Any) -> list[Any]:
        try:
            return [*getattr(self.model, method)(self.map, *values)]
        except IllegalAction:
            raise
        except Exception as error:  # noqa: BLE001  # the model is the user's
            raise self._raised(method, error) from None

    def _text(self, method: str, *values: Any) -> str:
        found = self._ask(method, *values)
        if not isinstance(found, str):
            raise self._wrong(method, f"returns {show(found)}, which is not a text")
        return found

    def _numbers(self, percept: Percept) -> tuple[int, ...]:
        """The degree, the marks and the bearing of a percept; the bearing may be None.

        A boolean raises ModelError: it would be taken for an integer, since True is equal to 1.
        """
        parts = percept.degree, percept.marks, percept.bearing
        try:
            return tuple([None if part is None else integer(part) for part in parts])  # type: ignore[misc]  # a bearing may be None
        except TypeError:
            raise self._wrong("sensed", f"returns {show(percept)}, not of integers") from None

    def _json(self, method: str, value: Any) -> bytes:
        try:
            return encode(value, order="deterministic")
        except (TypeError, ValueError, RecursionError):
            legal = "neither a Percept nor a value that JSON has"
            raise self._wrong(method, f"returns {show(value)}, which is {legal}") from None

    def _ensure_hashable(self, method: str, state: Any) -> None:
        try:
            hash(state)
        except TypeError:
            kind = type(state).__name__
            raise self._wrong(
                method,
                f"yields a state that is not hashable, of the type {kind}; legal are "
                "tuples, frozen dataclasses and the like",
            ) from None

    def _raised(self, method: str, error: Exception) -> InputError:
        let_users_interrupt(error)
        if isinstance(error, InputError):
            return error
        frames = traceback.extract_tb(error.__traceback__)
        inside = [frame for frame in frames if frame.filename != __file__]
        where = f", line {inside[-1].lineno}" if inside else ""
        return self._wrong(method, f"raises {type(error).__name__}{where}: {error}")

    def _wrong(self, method: str, what: str) -> ModelError:
        world = f"sigma={[*self.map.sigma]} alpha={[*self.map.alpha]}"
        return ModelError(f"the model {show(self.name)} {what}, in its method {method}; {world}")
