"""What the robot does."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias, assert_never


@dataclass(frozen=True, slots=True)
class Move:
    """Leave by ``sigma^k`` of the dart one stands at; one edge traversal.

    ``k`` may be any integer, negative too; it is taken modulo the degree.  ``Move(0)`` goes
    back where one came from.
    """

    k: int

    def __str__(self) -> str:
        """For example ``move 2``."""
        return f"move {self.k}"


@dataclass(frozen=True, slots=True)
class Drop:
    """Lay down one marker here; free.  Legal only where the lighthouse gives markers."""

    def __str__(self) -> str:
        """``drop``."""
        return "drop"


@dataclass(frozen=True, slots=True)
class Pick:
    """Take up one marker from here; free.  Legal only where the lighthouse gives markers."""

    def __str__(self) -> str:
        """``pick``."""
        return "pick"


Action: TypeAlias = Move | Drop | Pick
"""Everything that an explorer may yield, besides a checkpoint."""

DROP, PICK = -1, -2

_MOVES = tuple(Move(k) for k in range(64))


def number_of(action: Action) -> int:
    """``k`` of a motion modulo the degree, which is not negative; DROP or PICK."""
    match action:
        case Move(k):
            return k
        case Drop():
            return DROP
        case Pick():
            return PICK
        case _:
            assert_never(action)


def action_numbered(number: int) -> Action:
    """The action of a number; equal small motions are one object."""
    if 0 <= number < len(_MOVES):
        return _MOVES[number]
    if number >= 0:
        return Move(number)
    return Drop() if number == DROP else Pick()
