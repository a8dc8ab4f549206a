"""Percepts, actions, and answers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, TypeAlias

from allworlds.document.struct import Natural, Positive, WrittenByFields, about


@dataclass(frozen=True, slots=True)
class Percept(WrittenByFields):
    """Percept.

    All that is sensed at a vertex.
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

    def marked(self, markers: int) -> Percept:
        """Return this percept with ``markers`` more marks."""
        return Percept(self.degree, self.marks + markers, self.bearing) if markers else self

    def __str__(self) -> str:
        """The percept in words: for example ``degree 3, marked, bearing 2``."""
        marks = {0: "", 1: ", marked"}.get(self.marks, f", marks {self.marks}")
        bearing = "" if self.bearing is None else f", bearing {self.bearing}"
        return f"degree {self.degree}{marks}{bearing}"


@dataclass(frozen=True, slots=True)
class Move:
    """Leave by ``sigma^k`` of the robot's dart; one edge traversal.

    ``k`` may be any integer, negative too; it is taken modulo the degree.  ``Move(0)`` goes
    back by the edge of arrival.
    """

    k: int

    def __str__(self) -> str:
        """The action in words: for example ``move 2``."""
        return f"move {self.k}"


@dataclass(frozen=True, slots=True)
class Drop:
    """Lay down one marker here; free.  Legal only where the lighthouse gives markers."""

    def __str__(self) -> str:
        """The action in a word: ``drop``."""
        return "drop"


@dataclass(frozen=True, slots=True)
class Pick:
    """Take up one marker from here; free.  Legal only where the lighthouse gives markers."""

    def __str__(self) -> str:
        """The action in a word: ``pick``."""
        return "pick"


@dataclass(frozen=True, slots=True)
class Write:
    """Write the number ``k`` here; free.  Legal only where the lighthouse has room for numbers."""

    k: int

    def __str__(self) -> str:
        """For example ``write 1``."""
        return f"write {self.k}"


Action: TypeAlias = Move | Drop | Pick | Write
"""Everything that an explorer may yield, besides a checkpoint."""

DROP, PICK, WRITE = -1, -2, -3
"""The numbers of actions that are no motions; ``Write(k)`` has the number ``WRITE - k``."""

_MOVES = tuple(Move(k) for k in range(64))


def action_numbered(number: int) -> Action:
    """The action of a number; equal small motions are one object."""
    if 0 <= number < len(_MOVES):
        return _MOVES[number]
    if number >= 0:
        return Move(number)
    if number <= WRITE:
        return Write(WRITE - number)
    return Drop() if number == DROP else Pick()
