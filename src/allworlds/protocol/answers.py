"""What an explorer says about the world, at the end and on the way."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

from allworlds.inputs import InputError, show
from allworlds.maps import CombinatorialMap

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True, slots=True)
class Estimate:
    """A map of the world and the robot's place in it.

    ``here`` is the dart of ``map`` that stands for the dart the robot arrived by last (at
    the start: the dart it faces).  Nothing is validated here: the judge does that.
    """

    map: CombinatorialMap
    here: int

    def to_json(self) -> documents.Rooted:
        """The rooted map ``{"sigma", "alpha", "here"}``."""
        return {**self.map.to_json(), "here": self.here}

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Estimate:
        """The estimate of :meth:`to_json`'s document; other keys are ignored.

        Raises:
            InputError: if there is no map, or ``here`` is none of its darts.
        """
        map_, here = CombinatorialMap.from_json(document), document.get("here")
        if type(here) is not int or here not in map_.darts:
            raise InputError(f"here = {show(here)} is no dart of the rooted map")
        return cls(map_, here)


@dataclass(frozen=True, slots=True)
class Ambiguous:
    """The most that a robot with position only can know: the rooted quotient of its world.

    ``alpha[d] == d`` is a semi-edge; ``degree`` and ``marks`` hold for each dart what is
    sensed there; ``here`` is the robot's dart.  Nothing is validated here.
    """

    sigma: Sequence[int]
    alpha: Sequence[int]
    degree: Sequence[int]
    marks: Sequence[int]
    here: int

    def to_json(self) -> documents.RootedQuotient:
        """The rooted quotient ``{"sigma", "alpha", "degree", "marks", "here"}``."""
        return {
            "sigma": list(self.sigma),
            "alpha": list(self.alpha),
            "degree": list(self.degree),
            "marks": list(self.marks),
            "here": self.here,
        }


@dataclass(frozen=True, slots=True)
class Checkpoint:
    """The paper's S and U after a pass, shown to the judge.

    The darts known so far: ``alpha[d] == d`` marks an open dart, and U is the set of those;
    ``here`` is the robot's dart.  Yielding it costs nothing, is answered with None, stands
    in no transcript, and must not influence the walk.
    """

    sigma: Sequence[int]
    alpha: Sequence[int]
    here: int


Answer: TypeAlias = Estimate | Ambiguous
"""Everything that an explorer may return."""
