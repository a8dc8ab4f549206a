"""The log of one run: actions and percepts."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any, Literal, assert_never

from allworlds.document import Document, Natural, Paged, about, plain
from allworlds.inputs.checks import integer, show
from allworlds.protocol.actions import Action, Drop, Move, Percept, Pick, Write


class AtStart(Document, forbid_unknown_fields=False):
    """The first row of a transcript."""

    percept: Annotated[Percept, about("what was sensed before any motion")]


class Moved(Document, forbid_unknown_fields=False):
    """A row of a transcript: a motion and the percept after it."""

    move: Annotated[int, about("by how many darts clockwise the robot turned before it left")]
    percept: Annotated[Percept, about("what was sensed then")]


class Dropped(Document, forbid_unknown_fields=False):
    """A row of a transcript: a marker is laid down."""

    drop: Annotated[Literal[True], about("always true")]
    percept: Annotated[Percept, about("what was sensed then")]


class Picked(Document, forbid_unknown_fields=False):
    """A row of a transcript: a marker is taken up."""

    pick: Annotated[Literal[True], about("always true")]
    percept: Annotated[Percept, about("what was sensed then")]


class Wrote(Document, forbid_unknown_fields=False):
    """A number written."""

    write: Annotated[Natural, about("the number")]
    percept: Annotated[Percept, about("what was sensed then")]


@dataclass(frozen=True)
class Transcript(Paged):
    """The first percept, then each action with the percept that answered it.

    Motions stand modulo the degree.  Checkpoints stand in no transcript.
    """

    first: Percept
    steps: tuple[tuple[Action, Percept], ...] = ()

    @cached_property
    def cost(self) -> int:
        """The number of edge traversals."""
        return sum(type(action) is Move for action, _ in self.steps)

    @property
    def percepts(self) -> list[Percept]:
        """The percepts at the start and after each step."""
        return [self.first, *(percept for _, percept in self.steps)]

    @property
    def actions(self) -> tuple[Action, ...]:
        """The actions, step by step."""
        return tuple(action for action, _ in self.steps)

    def to_json(self) -> list[dict[str, Any]]:
        """The rows ``[{"percept": P}, {"move": k, "percept": P}, ...]``."""
        rows: list[dict[str, Any]] = plain([AtStart(percept=self.first), *map(_row, self.steps)])
        return rows

    @classmethod
    def from_json(cls, rows: object) -> "Transcript":
        """The transcript of :meth:`to_json`'s rows.

        Raises:
            ValueError: naming the first row that is none.
        """
        if not isinstance(rows, list) or not rows:
            raise ValueError("a transcript is a list that begins with the first percept")
        steps = []
        for i, row in enumerate(rows[1:], 1):
            action = action_from_json(row)
            if action is None:
                raise ValueError(
                    f"row {i} of the transcript has no move, drop, pick or write: {show(row)}"
                )
            steps.append((action, _percept(i, row)))
        return cls(_percept(0, rows[0]), tuple(steps))


def _row(step: tuple[Action, Percept]) -> Moved | Dropped | Picked | Wrote:
    action, percept = step
    match action:
        case Move(k):
            return Moved(move=k, percept=percept)
        case Drop():
            return Dropped(drop=True, percept=percept)
        case Pick():
            return Picked(pick=True, percept=percept)
        case Write(k):
            return Wrote(write=k, percept=percept)
        case _:
            assert_never(action)


def action_from_json(row: object) -> Action | None:
    """The action of a JSON object, None if it holds none; other keys are ignored."""
    match row:
        case {"move": int() as k} if not isinstance(k, bool):
            return Move(k)
        case {"drop": True}:
            return Drop()
        case {"pick": True}:
            return Pick()
        case {"write": int() as k} if not isinstance(k, bool) and k >= 0:
            return Write(k)
        case _:
            return None


def percept_from_json(value: object) -> Percept:
    """The percept of ``{"degree", "marks", "bearing"}``.

    Raises:
        ValueError: if it is none.
    """
    if not isinstance(value, Mapping):
        raise ValueError(f"a percept is an object with a degree, not {show(value)}")
    try:
        bearing = value.get("bearing")
        return Percept(
            integer(value.get("degree")),
            integer(value.get("marks", 0)),
            None if bearing is None else integer(bearing),
        )
    except TypeError:
        raise ValueError(f"a percept holds integers: {show(value)}") from None


def _percept(i: int, row: object) -> Percept:
    value = row.get("percept") if isinstance(row, Mapping) else None
    try:
        return percept_from_json(value)
    except ValueError as error:
        raise ValueError(f"row {i} of the transcript: {error}") from None
