"""An explorer's statements about the world, at the end and on the way."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, TypeAlias

from allworlds.document.struct import Document, Entries, Natural, Positive, WrittenByFields, about
from allworlds.inputs.checks import InputError, show
from allworlds.maps.combinatorial import Alpha, CombinatorialMap, Dart, Sigma


class RootedMap(Document):
    """Rooted map.

    A map, and where the robot is in it.
    """

    sigma: Sigma
    alpha: Alpha
    here: Annotated[Dart, about("the robot's dart")]


@dataclass(frozen=True, slots=True)
class Estimate:
    """A map of the world and the robot's place in it.

    ``here`` is the dart of ``map`` that stands for the dart the robot arrived by last (at
    the start: the dart it faces).  Nothing is validated here: the judge does that.
    """

    map: CombinatorialMap
    here: int

    def to_json(self) -> dict[str, Any]:
        """The document :class:`RootedMap`."""
        return RootedMap(sigma=self.map.sigma, alpha=self.map.alpha, here=self.here).to_json()

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
class Ambiguous(WrittenByFields):
    """Rooted quotient.

    The most that a robot with position only can know of its world, and where it is in it.
    Nothing is validated here.
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

    The darts known so far: ``alpha[d] == d`` marks an open dart, and U is the set of those;
    ``here`` is the robot's dart.  Yielding it costs nothing, is answered with None, stands
    in no transcript, and must not influence the walk.
    """

    sigma: Sequence[int]
    alpha: Sequence[int]
    here: int


Answer: TypeAlias = Estimate | Ambiguous
"""Everything that an explorer may return."""
