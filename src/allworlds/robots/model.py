"""The base of every model: a world that changes, and what its robots sense and do in it."""

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

State: TypeAlias = Hashable
"""The state of a world, whatever its model makes of it."""

Scheduler: TypeAlias = Literal["fsync", "ssync", "central", "async"]
"""Who is activated: all at once, any set, one at a time; or any set makes its next step, Look with
Compute or Move."""

SCHEDULERS: tuple[Scheduler, ...] = "fsync", "ssync", "central", "async"


class Liveness(NamedTuple):
    """The conditions of every infinite fair run of automata.

    Attributes:
        name: in words, as ``robot 0 at vertex 3``.
        forever: whether it must be so at last and stay so (FG); else again and again (GF).
        holds: of a state; None: nobody acts.
    """

    name: str
    forever: bool
    holds: Callable[[Any], bool] | None


QUIET = Liveness("quiet", forever=True, holds=None)
"""At last nobody acts any more."""


class Assumption(NamedTuple):
    """The acts of the adversary that come again and again in the runs that count.

    Attributes:
        name: in words, as ``the edge 3 is there``.
        holds: of a state, the one that follows it, and the words of the step.
    """

    name: str
    holds: Callable[[Any, Any, str], bool]


class Model:
    """A world that changes.  A model of one's own is a frozen dataclass with this base.

    All that a state holds is the model's: any value that is hashable and never changed.  A model
    is asked in any order, and more than once; it must answer the same.  A field that is an integer,
    a boolean or a text with a default is an option, as in ``--model FILE.py:Class:faults=1``.

    Attributes:
        schedulers: those that it has; the first is the default.
        rounds: whether a world with ``fsync`` and ``ssync`` changes from round to round, so that
            other schedulers mean nothing in it.
    """

    schedulers: ClassVar[tuple[Scheduler, ...]] = SCHEDULERS

    def starts(self, map_: CombinatorialMap, robots: int) -> Iterable[tuple[Dart, ...]]:
        """The starts to try, a dart for each robot: by default all with robot 0 at dart 0."""
        return every_start(map_, robots)

    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterable[State]:
        """The states at the start; of several the adversary chooses one."""
        raise NotImplementedError

    def told(self, map_: CombinatorialMap, robot: int) -> Any:  # noqa: ARG002  # nothing
        """The value that a robot is told; robots that are told alike are anonymous."""
        return None

    def sensed(self, map_: CombinatorialMap, state: Any, robot: int) -> Any:
        """The percept of a robot that looks now: a Percept, or a value that JSON has.

        None: it is no more, and is never activated again.
        """
        raise NotImplementedError

    def step(
        self, map_: CombinatorialMap, state: Any, acts: Mapping[int, Any]
    ) -> Iterable[tuple[State, str]]:
        """Each state that can follow these actions at once, with what the adversary did, in words.

        Args:
            map_: the map.
            state: before.
            acts: the actions by robot; who waits, watches or has ended is not among them.  In
                ``fsync`` and ``ssync`` there is a step in each round, though nobody acts.

        Raises:
            IllegalAction: for an action that means nothing here, which is a finding.
        """
        raise NotImplementedError

    def looked(
        self,
        map_: CombinatorialMap,  # noqa: ARG002  # nothing
        state: Any,
        robot: int,  # noqa: ARG002  # nothing
        action: Any,  # noqa: ARG002  # nothing
    ) -> Iterable[tuple[State, str]]:
        """Each state after a look whose action is done later, which is so in ``async`` alone.

        By default the world is as before.  What is decided in the look goes into the state here:
        for example the dart that the action means, while others change what it would mean later.

        Raises:
            IllegalAction: as ``step``.
        """
        return ((state, ""),)

    def bad(self, map_: CombinatorialMap, state: Any) -> str:  # noqa: ARG002  # nothing
        """The wrong in a state, in words; empty if all is well."""
        return ""

    def over(self, map_: CombinatorialMap, state: Any) -> bool:  # noqa: ARG002  # never
        """Whether the goal is reached, and the run ends."""
        return False

    def flaw(self, map_: CombinatorialMap, state: Any, answers: Sequence[Any]) -> str:  # noqa: ARG002
        """The flaw when all robots have ended, or wait for what will never be.

        Args:
            map_: the map.
            state: the last one.
            answers: of each robot; None of one that has not ended.
        """
        conditions = [each for each in self.progress(map_) if each.holds is not None]
        lacking = [each.name for each in conditions if each.holds and not each.holds(state)]
        return f"{lacking[0]} was not reached" if lacking else ""

    def progress(self, map_: CombinatorialMap) -> Iterable[Liveness]:
        """The conditions of every infinite fair run: by default the goal is reached."""
        yield Liveness("the goal", forever=False, holds=lambda state: self.over(map_, state))

    @property
    def says_progress(self) -> bool:
        """Whether the model has conditions of its own."""
        return type(self).progress is not Model.progress

    def assumes(self, map_: CombinatorialMap) -> Iterable[Assumption]:  # noqa: ARG002  # nothing
        """The acts of the adversary that come again and again: by default none need."""
        return ()

    def places(self, map_: CombinatorialMap, state: Any) -> Places:  # noqa: ARG002
        """The content of a picture of a state: by default the darts of ``state.darts``."""
        return Places(tuple(getattr(state, "darts", ())))


class Places(NamedTuple):
    """The content of a picture of a state.

    Attributes:
        darts: of each robot; None of one that is no more.
        vertices: words at vertices, by their numbers.
        edges: words at edges, by the smaller dart.
    """

    darts: tuple[Dart | None, ...] = ()
    vertices: Mapping[int, str] = {}
    edges: Mapping[int, str] = {}


def every_start(map_: CombinatorialMap, robots: int) -> Iterator[tuple[Dart, ...]]:
    """Every start of the others; robot 0 is at the root of the map.

    The map is taken with every root, so each map with ordered starts comes once.
    """
    return ((0, *others) for others in product(map_.darts, repeat=robots - 1))


def joined(words: str, more: str) -> str:
    """The words for two things that the adversary does at once."""
    return f"{words}; {more}" if words and more else words or more


class ModelError(InputError):
    """Raised if a model raises, or answers with what means nothing."""


class Guarded:
    """A model in one map, whose mistakes are told by their place.

    Args:
        model: the model.
        map_: the map.
        name: by which it is called.

    Attributes:
        says_bad, says_over, says_progress: whether the model has such a method of its own.
        decides_at_looks: whether it decides something when a robot looks.

    Every method raises ModelError naming the method.
    """

    def __init__(self, model: Model, map_: CombinatorialMap, name: str) -> None:
        self.model, self.map, self.name = model, map_, name
        kind = type(model)
        self.says_bad, self.says_over = kind.bad is not Model.bad, kind.over is not Model.over
        self.says_progress = model.says_progress
        self.decides_at_looks = kind.looked is not Model.looked

    def starts(self, robots: int) -> list[tuple[Dart, ...]]:
        """The starts to try."""
        made = self._list("starts", robots)
        for start in made:
            darts = isinstance(start, tuple) and len(start) == robots
            if not darts or any(dart not in self.map.darts for dart in start):
                last = len(self.map.sigma) - 1
                legal = f"a tuple of {robots} darts, each from 0 to {last}"
                raise self._wrong("starts", f"yields {show(start)}, which is not {legal}")
        return made

    def initial(self, starts: Sequence[Dart]) -> list[State]:
        """The states at the start."""
        made = self._list("initial", starts)
        for state in made:
            self._ensure_hashable("initial", state)
        return made

    def told(self, robot: int) -> bytes | None:
        """The value that a robot is told, as canonical JSON."""
        value = self._ask("told", robot)
        return None if value is None else self._json("told", value)

    def sensed(self, state: Any, robot: int) -> Sensed | None:
        """The percept of a robot, on its way."""
        value = self._ask("sensed", state, robot)
        if value is None:
            return None
        return self._numbers(value) if type(value) is Percept else self._json("sensed", value)

    def step(self, state: Any, acts: Mapping[int, Any]) -> list[tuple[State, str]]:
        """Each state that can follow, with the words of the adversary.

        Raises:
            IllegalAction: of the model.
        """
        return self._following("step", dict(acts), self._list("step", state, acts))

    def looked(self, state: Any, acts: Mapping[int, Any]) -> list[tuple[State, str]]:
        """Each state after looks whose actions are done later.

        Raises:
            IllegalAction: of the model.
        """
        made: list[tuple[State, str]] = [(state, "")]
        for robot, action in acts.items():
            every = []
            for before, words in made:
                after = self._list("looked", before, robot, action)
                for to, more in self._following("looked", action, after):
                    every.append((to, joined(words, more)))
            made = every
        return made

    def _following(self, method: str, acts: Any, made: list[Any]) -> list[tuple[State, str]]:
        for each in made:
            if not isinstance(each, tuple) or len(each) != 2 or not isinstance(each[1], str):
                legal = "a pair of a state and words"
                raise self._wrong(method, f"yields {show(each)}, which is not {legal}")
            self._ensure_hashable(method, each[0])
        if not made:
            raise self._wrong(method, f"yields no state after {show(acts)}")
        return made

    def bad(self, state: Any) -> str:
        """The wrong in a state that must never be."""
        return self._text("bad", state)

    def over(self, state: Any) -> bool:
        """Whether the goal is reached."""
        return bool(self._ask("over", state))

    def flaw(self, state: Any, answers: Sequence[Any]) -> str:
        """The flaw at the end."""
        return self._text("flaw", state, answers)

    def progress(self) -> list[Liveness]:
        """The conditions of infinite runs."""
        return [Liveness(*each) for each in self._list("progress")]

    def assumes(self) -> list[Assumption]:
        """The acts of the adversary that come again and again."""
        return [Assumption(*each) for each in self._list("assumes")]

    def holds(self, condition: Liveness, state: Any) -> bool:
        """Whether a condition holds in a state."""
        assert condition.holds is not None
        try:
            return bool(condition.holds(state))
        except Exception as error:  # noqa: BLE001  # the model is the user's
            raise self._raised("progress", error) from None

    def places(self, state: Any) -> Places:
        """The content of a picture of a state."""
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
        """The numbers of a percept; True among them would be taken for 1."""
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
