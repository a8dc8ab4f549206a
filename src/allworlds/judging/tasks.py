"""Tasks: what counts as done, a value like a law.  **The** table of those that come with us.

Each is a judge, a function of the world, the transcript and the answer that returns what is wrong,
or None; one of the user's is the same.  The task ``map`` has no judge of its own: the laws ``map``
and ``pose`` are its judges.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from typing import Any, TypeAlias

from allworlds.inputs import InputError, a_text, let_users_interrupt, show
from allworlds.judging.endings import Answered, Ending, Over, Said, Undecided
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import (
    Action,
    Move,
    Percept,
    Told,
    Transcript,
    UserCode,
    find_code,
    function_of,
    said,
)
from allworlds.world import State, World

Judge: TypeAlias = Callable[[World, Transcript, Any], str | None]
"""A judge: the fault of a finished run, or None."""

ENTRY_POINTS = "allworlds.tasks"
MAP = "map"


@dataclass(frozen=True, slots=True)
class TaskKind:
    """A task that comes with this program.

    Attributes:
        asks: what it asks for, in a sentence.
        judge: what is wrong with a run; None of the task ``map``.
        covers: ``vertices`` or ``edges`` where the run ends when the last one was visited.
    """

    asks: str
    judge: Judge | None
    covers: str = ""


def visits_everything(world: World, transcript: Transcript, _answer: object) -> str | None:
    """Every vertex was visited."""
    unvisited = {*range(world.map.vertex_count)} - {*_vertices(world, transcript)}
    return _left(unvisited, world.map.vertex_count, "vertices not visited")


def walks_everything(world: World, transcript: Transcript, _answer: object) -> str | None:
    """Every edge was walked along."""
    alpha = world.map.alpha
    walked = {min(dart, alpha[dart]) for dart in _arrivals(world, transcript)}
    unwalked = {min(edge) for edge in world.map.edges} - walked
    return _left(unwalked, world.map.edge_count, "edges not walked along")


def comes_home(world: World, transcript: Transcript, answer: object) -> str | None:
    """Every vertex was visited, and the walk ended where it began."""
    last = _vertices(world, transcript)[-1]
    if last != world.map.vertex_of[world.start]:
        return "the walk ended at another vertex than that where it began"
    return visits_everything(world, transcript, answer)


def counts(what: str, number: Callable[[World], int]) -> Judge:
    """The judge of an answer that is to be this number of the world."""

    def judge(world: World, _transcript: Transcript, answer: object) -> str | None:
        right = number(world)
        if type(answer) is int and answer == right:
            return None
        return f"the answer {show(answer)}, and {what} is {right}"

    return judge


def _face(world: World) -> int:
    return next(len(face) for face in world.map.faces if world.start in face)


TASKS: dict[str, TaskKind] = {
    MAP: TaskKind("an Estimate: the map, and where the robot is in it", None),
    "cover": TaskKind("every vertex visited; then the run ends", visits_everything, "vertices"),
    "cover:edges": TaskKind(
        "every edge walked along; then the run ends", walks_everything, "edges"
    ),
    "stop": TaskKind(
        "every vertex visited when the explorer ends, with any answer", visits_everything
    ),
    "home": TaskKind("every vertex visited, and an end at the vertex of the start", comes_home),
    "count:n": TaskKind(
        "the number of vertices", counts("the number of vertices", lambda w: w.map.vertex_count)
    ),
    "count:m": TaskKind(
        "the number of edges", counts("the number of edges", lambda w: w.map.edge_count)
    ),
    "face": TaskKind(
        "the length of the face left of the first dart",
        counts("the length of the face left of the first dart", _face),
    ),
}
"""Every task that comes with this program, by its name."""


@dataclass(frozen=True, slots=True)
class Task:
    """A task: the criterion of a finished run, in a form that other processes can load.

    Attributes:
        name: one of :data:`TASKS`, or that of a judge of the user's.
        code: of the user's judge.
    """

    name: str
    code: UserCode | None = None

    def __str__(self) -> str:
        return self.name

    @property
    def codes(self) -> tuple[UserCode, ...]:
        """The judge of the user's, if it is one."""
        return (self.code,) if self.code else ()

    @property
    def is_map(self) -> bool:
        """The answer is an estimate, which has laws of its own; else it may be any."""
        return self.name == MAP

    @property
    def asks(self) -> str:
        """The requirement of the task, in a sentence."""
        return TASKS[self.name].asks if self.code is None else f"what {self.name} demands"

    def environment(self, world: World) -> World | CoveredWorld:
        """The world as an explorer is run in it: it may end the run."""
        covers = TASKS[self.name].covers if self.code is None else ""
        return CoveredWorld(world, covers) if covers else world

    def flaw(self, world: World, transcript: Transcript, ending: Ending) -> str | None:
        """The fault of a finished run; None if there is none.

        Raises:
            InputError: if the user's judge raises, or returns anything else than a text or None.
        """
        answer = _answer_of(ending)
        if self.code is None:
            kind = TASKS[self.name]
            assert kind.judge is not None
            return kind.judge(world, transcript, answer)
        judge = _judge_of(self.code)
        try:
            wrong = judge(world, transcript, answer)
        except BaseException as error:  # noqa: BLE001  # a judge of the user's may raise anything
            let_users_interrupt(error)
            raise InputError(f"task {show(self.name)} raises {said(error)}") from None
        if wrong is not None and not isinstance(wrong, str):
            raise InputError(f"task {show(self.name)} returns {show(wrong)}, no text and not None")
        return wrong

    def over_at_the_end(self, world: World, transcript: Transcript) -> bool:
        """Whether the harness ended that walk, since all was done."""
        environment = self.environment(world)
        state = environment.initial
        for action in transcript.actions:
            state, _ = environment.step(state, action)
        return environment.over


def task_named(given: object) -> Task:
    """The task of a name.

    Raises:
        InputError: naming the legal ones.
    """
    if isinstance(given, Task):
        return given
    name = a_text("task", given)
    if name in TASKS:
        return Task(name)
    task = Task(name, find_code("task", name, ENTRY_POINTS, tuple(TASKS)))
    assert task.code is not None
    _judge_of(task.code)
    return task


@cache
def _judge_of(code: UserCode) -> Judge:
    shape = "def judge(world, transcript, answer), which returns None or what is wrong"
    judge: Judge = function_of("task", code, ENTRY_POINTS, shape)
    return judge


@dataclass(slots=True)
class CoveredWorld:
    """A world in which a run is over when the last vertex, or the last edge, was visited.

    Attributes:
        world: in which one run takes place.
        covers: ``vertices`` or ``edges``.
    """

    world: World
    covers: str
    _left: set[int] = field(init=False)

    def __post_init__(self) -> None:
        map_ = self.world.map
        if self.covers == "edges":
            self._left = {min(edge) for edge in map_.edges}
        else:
            self._left = {*range(map_.vertex_count)} - {map_.vertex_of[self.world.start]}

    @property
    def initial(self) -> State:
        """The state at the start."""
        return self.world.initial

    @property
    def first(self) -> Percept:
        """The percept before any motion."""
        return self.world.first

    @property
    def told(self) -> Told:
        """The value that the lighthouse tells before the start."""
        return self.world.told

    @property
    def over(self) -> bool:
        """Whether no place is left to visit."""
        return not self._left

    def step(self, state: State, action: Action) -> tuple[State, Percept]:
        """The state after the action, and what is sensed there."""
        after, percept = self.world.step(state, action)
        if type(action) is Move:
            self._left.discard(_visited(self.world.map, self.covers, after.dart))
        return after, percept


def _visited(map_: CombinatorialMap, covers: str, dart: Dart) -> int:
    return min(dart, map_.alpha[dart]) if covers == "edges" else map_.vertex_of[dart]


def _arrivals(world: World, transcript: Transcript) -> list[Dart]:
    """The dart of each arrival."""
    map_, dart, arrivals = world.map, world.start, []
    for action in transcript.actions:
        if type(action) is Move:
            dart = map_.alpha[map_.turn(dart, action.k)]
            arrivals.append(dart)
    return arrivals


def _vertices(world: World, transcript: Transcript) -> list[int]:
    """The vertex of the start, and of each arrival."""
    return [world.map.vertex_of[dart] for dart in (world.start, *_arrivals(world, transcript))]


def _left(left: set[int], every: int, what: str) -> str | None:
    return f"{len(left)} of {every} {what}" if left else None


def _answer_of(ending: Ending) -> Any:
    """The answer, as a judge gets it."""
    match ending:
        case Answered(estimate):
            return estimate
        case Undecided(quotient):
            return quotient
        case Said(value):
            return value
        case _:
            assert isinstance(ending, Over)
            return None
