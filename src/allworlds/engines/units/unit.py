"""Unit, engine and transport: the protocols of work that is done piece by piece."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Generic, Protocol, Self, TypeVar

from typing_extensions import override


class Unit(Protocol):
    """A piece of work; the same whoever does it, and however many do."""

    @property
    def key(self) -> str:
        """Its name among the units of one job."""


class Sum(Protocol):
    """A result whose parts can be added up in any order."""

    @property
    def worlds(self) -> int:
        """How many worlds it speaks of."""

    def add(self, other: Any, /) -> None:
        """Take in another part."""

    def to_json(self) -> Any:
        """It as a JSON value, from which whoever keeps it can make it again."""


U = TypeVar("U", bound=Unit)
R = TypeVar("R")
U_contra = TypeVar("U_contra", bound=Unit, contravariant=True)
R_co = TypeVar("R_co", covariant=True)
E_contra = TypeVar("E_contra", contravariant=True)


@dataclass(frozen=True, slots=True)
class PartialResult(Generic[U, R]):
    """A part of a unit's result; ``last``: with it the unit is done."""

    unit: U
    result: R
    last: bool


class KeptUnits(Protocol):
    """Where finished units are kept, so that nothing is done twice."""

    def result(self, unit: Unit) -> Any:
        """The result of a unit that is finished; None if it is not."""

    def keep(self, unit: Unit, result: Any) -> None:
        """Take in the whole result of a unit; what is lost then is not the check's fault."""


class NothingKept(KeptUnits):
    """Nobody keeps anything."""

    @override
    def result(self, unit: Unit) -> None:
        pass

    @override
    def keep(self, unit: Unit, result: Any) -> None:
        pass


NOTHING_KEPT = NothingKept()


class UnitEngine(Protocol[U_contra, R_co]):
    """What is done with a unit."""

    def parts(self, unit: U_contra) -> Iterator[R_co]:
        """The unit's result in parts, at least one; they add up to the whole."""


class Transport(Protocol[E_contra]):
    """Where units are done, by engines of some kind; a context, behind which nothing goes on."""

    def __enter__(self) -> Self: ...

    def __exit__(self, *_: object) -> None: ...

    def map(self, engine: E_contra, units: Iterable[Any]) -> Iterator[PartialResult[Any, Any]]:
        """The parts of all units, as they come.

        Raises:
            TimeIsUp: when the time limit has been reached.
        """
