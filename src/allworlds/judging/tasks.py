"""Tasks: what counts as done, a value like a law.  **The** table of those that come with us.

Each is a judge, a function of the world, the transcript and the answer that returns what is wrong,
or None; one of the user's is the same.  The task ``map`` has no judge of its own: the laws ``map``
and ``pose`` are its judges.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import InputError, a_text, show
from allworlds.judging.endings import Answered, Ending, Over, Said, Undecided
from allworlds.judging.walk_log import WalkLog
from allworlds.protocol.actions import Action, Percept
from allworlds.protocol.importing import attempted
from allworlds.protocol.player import Told
from allworlds.protocol.transcript import Transcript
from allworlds.protocol.user_code import Role, UserCode
from allworlds.world.lighthouses.base import State
from allworlds.world.world import World

Judge: TypeAlias = Callable[[World, WalkLog, Any], str | None]
"""A judge: the fault of a finished run, or None."""

Ends: TypeAlias = Callable[[World, WalkLog], bool]
"""Whether the run is over, after each step."""

MAP = "map"


class TaskKind(Struct, frozen=True):
    """A task that comes with this program.

    Attributes:
        asks: what it asks for, in a sentence.
        judge: what is wrong with a run; None of the task ``map``.
    """

    asks: str
    judge: Judge | None


class EndingJudge(Struct, frozen=True):
    """A judge that ends the run, too; one of the user's has such an attribute ``over``.

    Attributes:
        judge: what is wrong with a run.
        over: whether it ends here.
    """

    judge: Judge
    over: Ends

    def __call__(self, world: World, walk: WalkLog, answer: object) -> str | None:
        """Judge a run."""
        return self.judge(world, walk, answer)


def visits_everything(world: World, walk: WalkLog, _answer: object) -> str | None:
    """Every vertex was visited."""
    return _left(len(walk.visited), world.map.vertex_count, "vertices not visited")


def walks_everything(world: World, walk: WalkLog, _answer: object) -> str | None:
    """Every edge was walked along."""
    return _left(len(walk.walked), world.map.edge_count, "edges not walked along")


def comes_home(world: World, walk: WalkLog, answer: object) -> str | None:
    """Every vertex was visited, and the walk ended where it began."""
    if world.map.vertex_of[walk.here] != world.map.vertex_of[world.start]:
        return "the walk ended at another vertex than that where it began"
    return visits_everything(world, walk, answer)


def counts(what: str, number: Callable[[World], int]) -> Judge:
    """The judge of an answer that is to be this number of the world."""

    def judge(world: World, _walk: WalkLog, answer: object) -> str | None:
        right = number(world)
        if type(answer) is int and answer == right:
            return None
        return f"the answer {show(answer)}, and {what} is {right}"

    return judge


def _face(world: World) -> int:
    return next(len(face) for face in world.map.faces if world.start in face)


TASKS: dict[str, TaskKind] = {
    MAP: TaskKind("an Estimate: the map, and where the robot is in it", None),
    "cover": TaskKind(
        "every vertex visited; then the run ends",
        EndingJudge(
            visits_everything, lambda world, walk: len(walk.visited) == world.map.vertex_count
        ),
    ),
    "cover:edges": TaskKind(
        "every edge walked along; then the run ends",
        EndingJudge(walks_everything, lambda world, walk: len(walk.walked) == world.map.edge_count),
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


JUDGE = Role(
    "task",
    "allworlds.tasks",
    "def judge(world, transcript, answer), which returns None or what is wrong",
    tuple(TASKS),
)


class Task(Struct, frozen=True):
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

    @property
    def _judge(self) -> Any:
        return TASKS[self.name].judge if self.code is None else self.code.function

    @property
    def ends_runs(self) -> bool:
        """Whether the judge ends runs, too."""
        return hasattr(self._judge, "over")

    def environment(self, world: World) -> World | JudgedWorld:
        """The world as an explorer is run in it: it may end the run."""
        return JudgedWorld(world, self) if self.ends_runs else world

    def is_over(self, walk: WalkLog) -> bool:
        """Whether a run ends here, as the judge says.

        Raises:
            InputError: if the user's judge raises, says neither True nor False, or is not the same
                twice.
        """
        asked = self._asked("over of ", self._judge.over)
        found = asked(walk.world, walk)
        if type(found) is not bool:
            raise InputError(f"over of task {show(self.name)} returns {show(found)}, no boolean")
        if self.code is not None:
            self._ensure_same("over of ", walk.world, found, asked(walk.world, walk))
        return found

    def over_at_the_end(self, world: World, transcript: Transcript) -> bool:
        """Whether the harness ended that walk, since all was done."""
        return self.ends_runs and self.is_over(WalkLog.of(world, transcript))

    def flaw(self, world: World, transcript: Transcript, ending: Ending) -> str | None:
        """The fault of a finished run; None if there is none.

        Raises:
            InputError: if the user's judge raises, returns anything else than a text or None, or
                finds a run wrong and is not the same twice.
        """

        def asked() -> Any:
            walk, answer = WalkLog.of(world, transcript), _answer_of(ending)
            return self._asked("", self._judge)(world, walk, answer)

        wrong = asked()
        if wrong is None:
            return None
        if not isinstance(wrong, str):
            raise InputError(f"task {show(self.name)} returns {show(wrong)}, no text and not None")
        if self.code is not None:
            self._ensure_same("", world, wrong, asked())
        return wrong

    def _ensure_same(self, part: str, world: World, found: object, again: object) -> None:
        """Raise InputError unless the judge, asked twice about one run, says the same."""
        if again != found:
            raise InputError(
                f"{part}task {show(self.name)} is no function of the run: asked twice, it says "
                f"{show(found)} and {show(again)} of a run in {world.map}"
            )

    def _asked(self, part: str, function: Callable[..., Any]) -> Callable[..., Any]:
        """The function itself, or one of the user's whose errors name it."""
        what = f"{part}task {show(self.name)} raises"
        return function if self.code is None else lambda *a: attempted(what, lambda: function(*a))


def task_named(given: object) -> Task:
    """The task of a name, or of a judge in Python.

    Raises:
        InputError: naming the legal ones.
    """
    if isinstance(given, Task):
        return given
    if callable(given):
        code = JUDGE.of(given)
    else:
        name = a_text("task", given)
        if name in TASKS:
            return Task(name)
        code = JUDGE.find(name)
    if not code.recorded:
        code.function  # noqa: B018  # it is refused here, and not where it is used
    return Task(code.name, code)


@dataclass(slots=True)
class JudgedWorld:
    """A world in which a judge decides whether the run is over.

    Attributes:
        world: in which one run takes place.
        task: with the judge.
        walk: so far.
    """

    world: World
    task: Task
    walk: WalkLog = field(init=False)

    def __post_init__(self) -> None:
        self.walk = WalkLog(self.world)

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
        """Whether the judge says so."""
        return self.task.is_over(self.walk)

    def step(self, state: State, action: Action) -> tuple[State, Percept]:
        """The state after the action, and what is sensed there."""
        after, percept = self.world.step(state, action)
        self.walk.add(action, percept)
        return after, percept


def _left(done: int, every: int, what: str) -> str | None:
    return f"{every - done} of {every} {what}" if done < every else None


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
