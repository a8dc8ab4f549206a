"""Unit, engine and transport: the protocols of work that is done piece by piece."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, Generic, Protocol, Self, TypeVar

from msgspec import Struct
from typing_extensions import override


class Unit(Protocol):
    """A piece of work, which does not depend on the workers or their number."""

    @property
    def key(self) -> str:
        """Its name among the units of one job."""


class Sum(Protocol):
    """A result whose parts can be added up in any order; a dataclass, kept by its fields."""

    @property
    def worlds(self) -> int:
        """The number of worlds in it."""

    def add(self, other: Any, /) -> None:
        """Take in another part."""


U = TypeVar("U", bound=Unit)
R = TypeVar("R")
U_contra = TypeVar("U_contra", bound=Unit, contravariant=True)
R_co = TypeVar("R_co", covariant=True)
E_contra = TypeVar("E_contra", contravariant=True)


class PartialResult(Struct, Generic[U, R], frozen=True):
    """A part of a unit's result; ``last``: whether it completes the unit."""

    unit: U
    result: R
    last: bool


class KeptUnits(Protocol):
    """The store of finished units, so that no unit is done twice."""

    def result(self, unit: Unit) -> Any:
        """Return the result of a unit that is finished; None if it is not."""

    def keep(self, unit: Unit, result: Any) -> None:
        """Store the whole result of a unit; errors of the disk do not end the job."""


class NothingKept(KeptUnits):
    """A store that keeps no units."""

    @override
    def result(self, unit: Unit) -> None:
        pass

    @override
    def keep(self, unit: Unit, result: Any) -> None:
        pass


NOTHING_KEPT = NothingKept()


class UnitEngine(Protocol[U_contra, R_co]):
    """The engine that does a unit."""

    def parts(self, unit: U_contra) -> Iterator[R_co]:
        """Yield the unit's result in parts, at least one; they add up to the whole."""


class Transport(Protocol[E_contra]):
    """A transport brings units to engines; a context, after which no work goes on."""

    def __enter__(self) -> Self: ...

    def __exit__(self, *_: object) -> None: ...

    def map(self, engine: E_contra, units: Iterable[Any]) -> Iterator[PartialResult[Any, Any]]:
        """Yield the parts of all units, as they come.

        Raises:
            TimeIsUp: when the time limit has been reached.
        """
