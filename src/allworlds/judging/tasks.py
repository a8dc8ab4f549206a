"""Tasks, which define when a run has done its work.  **The** table of the tasks of this program.

Each task has a *complaint*: a function that returns the fault of a finished run in words, or None.
The arguments of a complaint are the world, the walk and the explorer's answer.  A user's own task
is given as a complaint.  If this function has an attribute ``over``, the task can end a run:
``over`` is a function of the world and the walk, which returns True when the task is done.  The
task ``map`` has no complaint: the laws ``map`` and ``pose`` find the faults of its runs.
"""

from collections.abc import Callable
from typing import Any, TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import InputError, a_text, show
from allworlds.judging.episode import Answered, EpisodeEnding
from allworlds.judging.walk import Walk
from allworlds.protocol.importing import attempted
from allworlds.protocol.user_code import Role, UserCode
from allworlds.world.world import World

Complaint: TypeAlias = Callable[[World, Walk, Any], str | None]
"""A function from the world, the walk and the answer to the fault of a run in words, or None."""

MAP = "map"


class TaskKind(Struct, frozen=True):
    """A task that comes with this program.

    Attributes:
        asks: the requirement of the task, in a sentence.
        complaint: the function that returns the fault of a run, or None for a run without a fault.
            The task ``map`` has no complaint: here the attribute is None.
        ends: whether the run ends as soon as the complaint finds no fault.
    """

    asks: str
    complaint: Complaint | None
    ends: bool = False


def visits_everything(world: World, walk: Walk, _answer: object) -> str | None:
    """The fault that vertices were not visited, in words; None if all vertices were visited."""
    return _left(len(walk.visited), world.map.vertex_count, "vertices not visited")


def walks_everything(world: World, walk: Walk, _answer: object) -> str | None:
    """The fault that edges were not walked along, in words; None if there are no such edges."""
    return _left(len(walk.walked), world.map.edge_count, "edges not walked along")


def comes_home(world: World, walk: Walk, answer: object) -> str | None:
    """The fault that the walk ends at another vertex than the start, or that it left out vertices.

    The fault is a text; the result is None if the run has neither fault.
    """
    if world.map.vertex_of[walk.here] != world.map.vertex_of[world.start]:
        return "the walk ended at another vertex than that where it began"
    return visits_everything(world, walk, answer)


def counts(what: str, number: Callable[[World], int]) -> Complaint:
    """The complaint of a task whose answer must be a number, such as the number of vertices.

    Args:
        what: the name of the number, for the fault in words.
        number: the function that returns the right number for a world.
    """

    def complaint(world: World, _walk: Walk, answer: object) -> str | None:
        right = number(world)
        if type(answer) is int and answer == right:
            return None
        return f"the answer {show(answer)}, and {what} is {right}"

    return complaint


def _face(world: World) -> int:
    return next(len(face) for face in world.map.faces if world.start in face)


TASKS: dict[str, TaskKind] = {
    MAP: TaskKind("an Estimate: the map, and where the robot is in it", None),
    "cover": TaskKind("every vertex visited; then the run ends", visits_everything, ends=True),
    "cover:edges": TaskKind(
        "every edge walked along; then the run ends", walks_everything, ends=True
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


TASK_ROLE = Role(
    "task",
    "allworlds.tasks",
    "def judge(world, transcript, answer), which returns None or what is wrong",
    tuple(TASKS),
)


class Task(Struct, frozen=True):
    """A task: what a finished run must have done, in a form that other processes can load.

    Attributes:
        name: a name in :data:`TASKS`, or the name of a user's function.
        code: the user's function; None for a task of this program.
    """

    name: str
    code: UserCode | None = None

    def __str__(self) -> str:
        return self.name

    @property
    def codes(self) -> tuple[UserCode, ...]:
        """The user's function, as a tuple; empty for a task of this program."""
        return (self.code,) if self.code else ()

    @property
    def is_map(self) -> bool:
        """Whether the task is ``map``: the answer must be an estimate, and laws judge it.

        In any other task any answer is legal, and the task itself judges it.
        """
        return self.name == MAP

    @property
    def asks(self) -> str:
        """The requirement of the task, in a sentence."""
        return TASKS[self.name].asks if self.code is None else f"what {self.name} demands"

    @property
    def _complaint(self) -> Any:
        return TASKS[self.name].complaint if self.code is None else self.code.function

    @property
    def ends_runs(self) -> bool:
        """Whether the task ends a run as soon as it is done."""
        return TASKS[self.name].ends if self.code is None else hasattr(self._complaint, "over")

    @property
    def over(self) -> Callable[[Walk], bool] | None:
        """The function that tells whether the run ends; None if the task ends no run.

        The function is called after each step, with the walk so far.
        """
        return self.is_over if self.ends_runs else None

    def is_over(self, walk: Walk) -> bool:
        """Whether the task ends the run after ``walk``, because the task is done.

        Raises:
            InputError: if the function ``over`` of a user's task raises, returns no boolean, or
                returns different values for the same walk.
        """
        if not self.ends_runs:
            return False
        if self.code is None:
            return self._complaint(walk.world, walk, None) is None
        over = self._asked("over of ", self._complaint.over, walk.world, walk)
        if type(over) is not bool:
            raise InputError(f"over of task {show(self.name)} returns {show(over)}, no boolean")
        return over

    def flaw(self, walk: Walk, ending: EpisodeEnding) -> str | None:
        """The fault of a finished run in words; None if there is no fault.

        ``walk`` is the walk of the run; ``ending`` may hold the explorer's answer.

        Raises:
            InputError: if the complaint of a user's task raises, returns neither a text nor None,
                or returns different values for the same run.
        """
        answer = ending.answer if isinstance(ending, Answered) else None
        wrong = self._asked("", self._complaint, walk.world, walk, answer)
        if wrong is not None and not isinstance(wrong, str):
            raise InputError(f"task {show(self.name)} returns {show(wrong)}, no text and not None")
        return wrong

    def _asked(self, part: str, function: Callable[..., Any], world: World, *run: Any) -> Any:
        """The value of ``function(world, *run)``.

        A user's function is called twice, to find a function whose values vary.

        Args:
            part: the first words of error messages: "over of " if the function is the attribute
                ``over`` of the task; empty if the function is the complaint.
            function: the complaint of the task, or its attribute ``over``.
            world: the world of the run.
            run: the other arguments of the function: the walk; for a complaint also the answer.

        Raises:
            InputError: if a user's function raises, or returns two different values.
        """
        if self.code is None:
            return function(world, *run)
        what = f"{part}task {show(self.name)}"
        said, again = (attempted(f"{what} raises", lambda: function(world, *run)) for _ in range(2))
        if again != said:
            raise InputError(
                f"{what} is no function of the run: asked twice, it says {show(said)} and "
                f"{show(again)} of a run in {world.map}"
            )
        return said


def task_named(given: object) -> Task:
    """The task ``given`` by its name, by a user's function in Python, or as a :class:`Task`.

    Raises:
        InputError: naming the legal tasks.
    """
    if isinstance(given, Task):
        return given
    if callable(given):
        code = TASK_ROLE.of(given)
    else:
        name = a_text("task", given)
        if name in TASKS:
            return Task(name)
        code = TASK_ROLE.find(name)
    if not code.recorded:
        code.function  # noqa: B018  # so that it is refused here, before its use
    return Task(code.name, code)


def _left(done: int, every: int, what: str) -> str | None:
    return f"{every - done} of {every} {what}" if done < every else None
