"""Percepts, actions, answers, and their log; and the interface of explorers.

Answers are an explorer's statements about the world, at the end and on the way.  The log of a run
consists of its actions and percepts.  :class:`ExplorerFault` is raised by an adapter, the code that
speaks with an explorer outside Python, if no legal message comes from the explorer.
"""

import json
from collections.abc import Generator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any, Literal, Protocol, TypeAlias

from msgspec import Struct

from allworlds.documents.document import (
    Document,
    Entries,
    Natural,
    Positive,
    WrittenByFields,
    about,
)
from allworlds.documents.shown import Paged
from allworlds.inputs.checks import InputError, show
from allworlds.maps.combinatorial import Alpha, CombinatorialMap, Dart, Sigma
from allworlds.protocol.choices import Choices


class Percept(Struct, WrittenByFields, frozen=True, gc=False):
    """Percept.

    All that the robot senses at a vertex.
    """

    degree: Annotated[Positive, about("the number of darts")]
    marks: Annotated[Natural, about("the number of markers that lie here")] = 0
    bearing: Annotated[
        Natural | None,
        about(
            "the offset clockwise from the dart arrived by to the pointed dart; null where no "
            "direction is sensed"
        ),
    ] = None

    def marked(self, markers: int) -> "Percept":
        """Return this percept with ``markers`` more marks."""
        return Percept(self.degree, self.marks + markers, self.bearing) if markers else self

    def __str__(self) -> str:
        """The percept in words: for example ``degree 3, marked, bearing 2``."""
        return self.in_words()

    def in_words(self, *, labels: bool = False) -> str:
        """The percept in words; with ``labels`` the marks are shown as a vertex's label."""
        marks = {0: "", 1: ", marked"}.get(self.marks, f", marks {self.marks}")
        marks = f", label {self.marks}" if labels else marks
        bearing = "" if self.bearing is None else f", bearing {self.bearing}"
        return f"degree {self.degree}{marks}{bearing}"


class Move(Struct, frozen=True, gc=False):
    """Leave by ``sigma^k`` of the robot's dart; one edge traversal.

    ``k`` may be any integer, negative too; it is taken modulo the degree.  ``Move(0)`` goes
    back by the edge of arrival.
    """

    k: int

    def __str__(self) -> str:
        """The action in words: for example ``move 2``."""
        return f"move {self.k}"


class Drop(Struct, frozen=True, gc=False):
    """Lay down one marker at the robot's vertex, at no cost.

    Legal only if the lighthouse gives the robot markers, and one is in the robot's hand.
    """

    def __str__(self) -> str:
        """The action in a word: ``drop``."""
        return "drop"


class Pick(Struct, frozen=True, gc=False):
    """Take up one marker from the robot's vertex, at no cost.

    Legal only if the lighthouse gives the robot markers, and one lies there that may be taken up.
    """

    def __str__(self) -> str:
        """The action in a word: ``pick``."""
        return "pick"


class Write(Struct, frozen=True, gc=False):
    """Write the number ``k`` at the robot's vertex or dart, at no cost.

    Legal only if the lighthouse keeps numbers: ``whiteboard`` keeps one for each vertex,
    ``doormarks`` one for each dart.
    """

    k: int

    def __str__(self) -> str:
        """The action in words: for example ``write 1``."""
        return f"write {self.k}"


class Wait(Struct, frozen=True, gc=False):
    """Do nothing in this activation; legal only in worlds with several robots."""

    def __str__(self) -> str:
        """The action in a word: ``wait``."""
        return "wait"


class Watch(Struct, frozen=True, gc=False):
    """Do nothing, and be activated again once the robot's percept has changed.

    Legal only in worlds with several robots.
    """

    def __str__(self) -> str:
        """The action in a word: ``watch``."""
        return "watch"


class Do(Struct, frozen=True):
    """An action for a user's model of a world: a JSON value that the model understands."""

    value: Any

    def __str__(self) -> str:
        """The action in words: for example ``do first``."""
        return f"do {self.value if isinstance(self.value, str) else json.dumps(self.value)}"


class End(Struct, frozen=True):
    """The action by which an automaton ends; it holds the answer.

    A generator returns its answer instead.
    """

    answer: Any = None

    def __str__(self) -> str:
        """The action in words: ``end``, and the answer unless it is None."""
        return "end" if self.answer is None else f"end: {self.answer}"


Action: TypeAlias = Move | Drop | Pick | Write
"""The values that an explorer may yield, besides a checkpoint."""

DROP, PICK, WRITE = -1, -2, -3
"""The numbers of all actions other than motions; ``Write(k)`` has the number ``WRITE - k``."""

_MOVES = tuple(Move(k) for k in range(64))


def action_numbered(number: int) -> Action:
    """The action that a number stands for.

    A number ``k`` from 0 on stands for ``Move(k)``.  The number -1, :data:`DROP`, stands for
    ``Drop()``; -2, :data:`PICK`, for ``Pick()``.  ``Write(k)`` has the number ``WRITE - k``, where
    :data:`WRITE` is -3.
    """
    if 0 <= number < len(_MOVES):
        return _MOVES[number]
    if number >= 0:
        return Move(number)
    if number <= WRITE:
        return Write(WRITE - number)
    return Drop() if number == DROP else Pick()


class RootedMap(Document):
    """Rooted map.

    A map, and the robot's place in it.
    """

    sigma: Sigma
    alpha: Alpha
    here: Annotated[Dart, about("the robot's dart")]


@dataclass(frozen=True, slots=True)
class Estimate:
    """A map of the world and the robot's dart in it.

    ``here`` is the dart of ``map`` that stands for the robot's latest dart of arrival (at the
    start: for the dart that it faces).  This class does not check ``here``; the judge does.
    """

    map: CombinatorialMap
    here: int

    def to_json(self) -> dict[str, Any]:
        """The estimate as a JSON object, with the keys of :class:`RootedMap`."""
        return RootedMap(sigma=self.map.sigma, alpha=self.map.alpha, here=self.here).to_json()

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> "Estimate":
        """The estimate of a JSON object in the form of :meth:`to_json`; unknown keys are ignored.

        Raises:
            InputError: if there is no map, or ``here`` is not one of its darts.
        """
        map_, here = CombinatorialMap.from_json(document), document.get("here")
        if type(here) is not int or here not in map_.darts:
            raise InputError(f"here = {show(here)} is no dart of the rooted map")
        return cls(map_, here)


@dataclass(frozen=True, slots=True)
class Ambiguous(WrittenByFields):
    """Rooted quotient.

    An answer that is legal only under the lighthouse 'position', where a marker lies at v0 and
    points along no dart.  It is the right answer if the robot's world looks like other worlds.  It
    holds the quotient that all these worlds share, and the robot's place in the quotient.  A dart
    ``d`` of the quotient with ``alpha[d] == d`` is half an edge: it stands for edges of the world
    whose two darts look alike.  This class checks no value; the judge does.
    """

    sigma: Annotated[Entries[Dart], about("for each dart the next one clockwise round its vertex")]
    alpha: Annotated[
        Entries[Dart], about("for each dart the other one of its edge; of half an edge itself")
    ]
    degree: Annotated[Entries[Positive], about("for each dart the degree that is sensed there")]
    marks: Annotated[Entries[Natural], about("for each dart how many markers lie there")]
    here: Annotated[Dart, about("the robot's dart")]


@dataclass(frozen=True, slots=True)
class Checkpoint:
    """The paper's S and U after a pass, shown to the judge.

    S holds the darts known so far: ``alpha[d] == d`` marks an open dart, and U is the set of the
    open darts; ``here`` is the robot's dart.  To yield a checkpoint costs nothing; the reply is
    None.  A transcript does not contain checkpoints, and checkpoints must not influence the walk.
    """

    sigma: Sequence[int]
    alpha: Sequence[int]
    here: int


Answer: TypeAlias = Estimate | Ambiguous
"""The values that an explorer may return."""


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
    """A row of a transcript: a number is written."""

    write: Annotated[Natural, about("the number")]
    percept: Annotated[Percept, about("what was sensed then")]


class _Sensed(Document):
    """All rows of a transcript in JSON; of each row only the key ``percept`` is read."""

    transcript: Entries[AtStart]


@dataclass(frozen=True)
class Transcript(Paged):
    """The first percept, then each action with the percept after it.

    Motions are taken modulo the degree.  Checkpoints are left out.
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
        steps = ({**_said(action), "percept": percept.to_json()} for action, percept in self.steps)
        return [{"percept": self.first.to_json()}, *steps]

    @classmethod
    def from_json(cls, rows: Any) -> "Transcript":
        """The transcript of JSON rows in the form of :meth:`to_json`.

        Raises:
            InputError: naming a row that is illegal.
        """
        from allworlds.documents.reading import parse  # which players do not need

        first, *sensed = parse({"transcript": rows}, _Sensed, "transcript").transcript
        steps = []
        for at, row in zip(sensed, rows[1:], strict=True):
            if (action := action_from_json(row)) is None:
                raise InputError(f"{show(row)} in transcript has no move, drop, pick or write")
            steps.append((action, at.percept))
        return cls(first.percept, tuple(steps))


def _said(action: Action) -> dict[str, Any]:
    """The keys and values for an action in a JSON row of a transcript, such as ``{"move": 2}``."""
    match action:
        case Move(k):
            return {"move": k}
        case Write(k):
            return {"write": k}
    return {str(action): True}


def action_from_json(row: object) -> Any:
    """The action that a JSON object holds; None if it holds no action; other keys are ignored."""
    match row:
        case {"move": int() as k} if not isinstance(k, bool):
            return Move(k)
        case {"drop": True}:
            return Drop()
        case {"pick": True}:
            return Pick()
        case {"write": int() as k} if not isinstance(k, bool) and k >= 0:
            return Write(k)
        case {"wait": True}:
            return Wait()
        case {"watch": True}:
            return Watch()
        case {"do": value}:
            return Do(value)
        case _:
            return None


Told: TypeAlias = int | Mapping[str, int] | None
"""The number, or the numbers by their names, that an explorer is told before the start; or None."""


class Player(Protocol):
    """An explorer as a function that begins a run; a process that plays runs calls this function.

    ``choices`` and ``told`` are passed to the explorer if it has these keywords.  All other
    keywords of the explorer have their values already.
    """

    def __call__(self, first: Percept, choices: Choices, told: Told) -> Generator[Any, Any, Any]:
        """Return the generator of one run.

        ``told`` is the value that the lighthouse tells before the start.
        """


ANSWER_TIMEOUT = 10.0
"""The default number of seconds of silence that break the law ``timeout``."""


FaultLaw: TypeAlias = Literal["crash", "timeout", "illegal-action", "no-estimate"]
"""The laws that an explorer outside this process can break by its messages."""


class ExplorerFault(Exception):
    """Raised if no legal message comes from an explorer outside Python.

    The adapter raises this error: the code that speaks with the explorer, for example through a
    pipe.

    Attributes:
        law: the broken law.
        seen: a sentence about what happened instead of a legal message.
        detail: more text, for example the end of the program's stderr; may be empty.
        machine: whether the computer may be the cause, not the program.
    """

    def __init__(
        self, law: FaultLaw, seen: str, detail: str = "", *, machine: bool = False
    ) -> None:
        super().__init__(seen)
        self.law = law
        self.seen = seen
        self.detail = detail
        self.machine = machine


class IllegalAction(ValueError):
    """Raised for an action that is illegal in the world of the run."""


class BeyondRecord(Exception):
    """Raised for an action after the last recorded percept, when an earlier play is repeated.

    In the earlier play the explorer made no action after this percept.
    """
