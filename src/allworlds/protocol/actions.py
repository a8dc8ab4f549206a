"""Percepts, actions, and an explorer's statements about the world, at the end and on the way."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, TypeAlias

from allworlds.document import Document, Entries, Natural, Positive, WrittenByFields, about
from allworlds.inputs.checks import InputError, show
from allworlds.maps.combinatorial import Alpha, CombinatorialMap, Dart, Sigma


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

    def marked(self, markers: int) -> "Percept":
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
    def from_json(cls, document: Mapping[str, Any]) -> "Estimate":
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
