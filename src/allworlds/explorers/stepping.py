"""Explorers as objects: ``step(percept)`` returns the next action, and in the end the answer.

An object that has ``copy()``, or ``__copy__()``, can be copied in the middle of a run.  Then worlds
are decided where the robot looks, and what many worlds have in common is explored once.
"""

from __future__ import annotations

import copy
import inspect
from collections.abc import Callable, Generator
from functools import partial
from typing import Any, Protocol

from msgspec import Struct

from allworlds.inputs import InputError
from allworlds.protocol import Checkpoint, Drop, Move, Percept, Pick, Told, Write

ACTIONS = (Move, Drop, Pick, Write)


class CopyingExplorer(Protocol):
    """An explorer in the middle of a run, of which copies are kept by their numbers."""

    def begin(self, first: Percept, told: Told) -> object:
        """Begin a run; return the first action, or the answer."""

    def step(self, percept: Percept) -> object:
        """Go on; return the next action, or the answer."""

    def store(self, place: int) -> None:
        """Keep a copy of the present state at that place."""

    def restore(self, place: int, *, last: bool) -> None:
        """Go on from the state that is kept at that place; if ``last``, it is not needed again."""


class SteppingExplorer(Struct, frozen=True):
    """An explorer that is an object with a method ``step``.

    Attributes:
        make: makes an object for each run.
        keywords: those of ``told`` that ``make`` takes.
        copies: whether the objects can be copied.
    """

    make: Callable[..., Any]
    keywords: frozenset[str]
    copies: bool

    def new(self, told: Told) -> Any:
        """An object for a run."""
        return self.make(**({"told": told} if self.keywords else {}))

    def explore(self, first: Percept, *, told: Told = None) -> Generator[Any, Percept, Any]:
        """Play one run."""
        explorer, percept = self.new(told), first
        while True:
            message = explorer.step(percept)
            if isinstance(message, ACTIONS):
                percept = yield message
            elif isinstance(message, Checkpoint):
                yield message
            else:
                return message

    def explore_by_copies(
        self, first: Percept, *, told: Told = None
    ) -> Generator[Any, Percept, Any]:
        """Play one run, in which each step is that of a copy of the object before.

        The object that was copied takes the same step then: so a copy that shares its memory does
        not go on as it should.
        """
        explorer, percept = self.new(told), first
        message = explorer.step(percept)
        while True:
            if isinstance(message, ACTIONS):
                percept = yield message
            elif isinstance(message, Checkpoint):
                yield message
            else:
                return message
            before, explorer = explorer, copied(explorer)
            message = explorer.step(percept)
            before.step(percept)


class SteppedRuns:
    """The runs of an explorer that is an object, in a process that plays trees."""

    def __init__(self, explorer: SteppingExplorer) -> None:
        self._explorer = explorer
        self._state: Any = None
        self._kept: dict[int, Any] = {}

    def begin(self, first: Percept, told: Told) -> object:
        """Begin a run; return the first action, or the answer."""
        self._state = self._explorer.new(told)
        return self._state.step(first)

    def step(self, percept: Percept) -> object:
        """Go on; return the next action, or the answer."""
        return self._state.step(percept)

    def store(self, place: int) -> None:
        """Keep a copy of the present state at that place."""
        self._kept[place] = copied(self._state)

    def restore(self, place: int, *, last: bool) -> None:
        """Go on from the state that is kept at that place; if ``last``, it is not needed again."""
        self._state = self._kept.pop(place) if last else copied(self._kept[place])


def copied(explorer: Any) -> Any:
    """A copy of an explorer that is an object."""
    return explorer.copy() if hasattr(explorer, "copy") else copy.copy(explorer)


def stepping(name: str, found: Any, **arguments: Any) -> SteppingExplorer | None:
    """The explorer of a class, or an object, with a method ``step``; None if it is none.

    Args:
        name: of the explorer.
        found: the class or the object.
        arguments: for the class.

    Raises:
        InputError: for an object that cannot be copied, or a class that needs other arguments.
    """
    if not callable(getattr(found, "step", None)):
        return None
    copies = hasattr(found, "copy") or hasattr(found, "__copy__")
    if not inspect.isclass(found):
        if not copies:
            raise InputError(
                f"{name} is one object for all runs, and has no copy(): name its class instead"
            )
        return SteppingExplorer(partial(copied, found), frozenset(), copies=True)
    try:
        parameters = inspect.signature(found).parameters
        keywords = frozenset({"told"} & parameters.keys() - arguments.keys())
        inspect.signature(found).bind(**arguments, **dict.fromkeys(keywords))
    except TypeError as error:
        raise InputError(
            f"{name} must be callable without arguments, or with told: {error}"
        ) from None
    return SteppingExplorer(partial(found, **arguments), keywords, copies)
