"""Wrong explorers with another task than to find the map, and weakened judges of such tasks."""

from __future__ import annotations

from collections.abc import Callable, Generator
from functools import wraps
from typing import Any

from msgspec import Struct

from allworlds.judging.tasks import TASKS, Complaint, Task
from allworlds.judging.walk import Walk
from allworlds.protocol.actions import Move, Percept, Told
from allworlds.world import World


def stays_at_home(_first: Percept) -> Generator[Any, Any, None]:
    """Ends at once, and has visited its own vertex alone."""
    yield from ()


def does_not_come_home(_first: Percept) -> Generator[Any, Any, None]:
    """Walks along one edge, and stays there."""
    yield Move(0)


def counts_one_too_few(_first: Percept, *, told: Told) -> Generator[Any, Any, int]:
    """Says one vertex less than it was told, from 3 vertices on."""
    yield from ()
    assert isinstance(told, dict)
    vertices = int(told["n"])
    return vertices - (vertices > 2)


class WrongErrand(Struct, frozen=True):
    """An explorer that does another task wrong.

    Attributes:
        errand: the generator function.
        task: the name of its task.
        lighthouse: the name of its lighthouse.
        equivalent: why it is right all the same; empty for one that must be killed.
    """

    errand: Callable[..., Generator[Any, Any, Any]]
    task: str
    lighthouse: str = "none"
    equivalent: str = ""

    @property
    def name(self) -> str:
        """The name of the errand, with hyphens."""
        return self.errand.__name__.replace("_", "-")

    @property
    def breaks(self) -> str:
        """The explorer's mistake, in words."""
        return (self.errand.__doc__ or "").strip()

    def explorer(self) -> Callable[..., Generator[Any, Any, Any]]:
        """The generator function, which runs in this process."""
        errand = self.errand

        @wraps(errand)
        def explore(*percept: Percept, **told: Told) -> Generator[Any, Any, Any]:
            return (yield from errand(*percept, **told))

        explore.__module__, explore.__qualname__ = "mutants", self.name
        return explore


WRONG_ERRANDS = (
    WrongErrand(stays_at_home, "home"),
    WrongErrand(does_not_come_home, "home"),
    WrongErrand(counts_one_too_few, "count:n", "told"),
)
"""The explorers that must be refuted by the law ``task``."""


def home_is_enough(world: World, walk: Walk, answer: object) -> str | None:
    """Only the end of the walk is looked at, and not what was visited."""
    told = _complaint("home")(world, walk, answer)
    return told if told and "where it began" in told else None


def visits_are_enough(world: World, walk: Walk, answer: object) -> str | None:
    """Only what was visited is looked at, and not where the walk ended."""
    return _complaint("stop")(world, walk, answer)


def _complaint(task: str) -> Complaint:
    complaint = TASKS[task].complaint
    assert complaint is not None
    return complaint


class WeakTaskJudge(Struct, frozen=True):
    """A judge of tasks that is softened, or left out.

    Attributes:
        name: for the kill matrix.
        breaks: what it lets through.
        softer: what judges its task; None where nothing judges any.
        task: the name of the task; of all where nothing judges.
    """

    name: str
    breaks: str
    softer: Complaint | None = None
    task: str = ""

    law = "task"

    def accepts(self, task: Task, walk: Walk) -> bool:
        """Whether it accepts a finished run that the sound judge refuses."""
        if self.softer is None:
            return True
        return task.name == self.task and self.softer(walk.world, walk, None) is None


WEAK_TASK_JUDGES = (
    WeakTaskJudge("task-not-judged", "Any end of a walk does every task."),
    *(
        WeakTaskJudge(
            softer.__name__.replace("_", "-"), (softer.__doc__ or "").strip(), softer, "home"
        )
        for softer in (home_is_enough, visits_are_enough)
    ),
)
"""The judges of tasks each of which must accept something that the sound one refuses."""
