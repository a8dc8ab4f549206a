"""Knowledge of a robot: the places that agree with everything it has sensed.

A *place* is a world seen from the robot: a map rooted at the robot's dart, in canonical
numbering, with the pointed dart in it.  Where it has come from is nothing to it.  What a robot
*knows* is the set of places that agree with its log; a motion leads each to another, and what is
sensed there parts the set.  Turning is free: at v0 the robot is turned to the pointed dart, so that
what is known does not depend on the dart by which it has come.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple, TypeAlias

from allworlds.maps import Code, CombinatorialMap, Dart, numbering
from allworlds.protocol import Percept

Known: TypeAlias = tuple[int, ...]
"""The numbers of the places that are possible, ascending; one percept is sensed in all of them."""


class Place(NamedTuple):
    """A world seen from the robot, which stands at dart 0.

    Attributes:
        code: the map rooted there, in canonical numbering.
        pointed: the dart that the marker points at.
    """

    code: Code
    pointed: Dart


class SensedKnowledge(NamedTuple):
    """Knowledge after a percept.

    Attributes:
        percept: what.
        turned: how far the robot has turned clockwise for nothing.
        known: the places that are left, seen from where it stands then.
    """

    percept: Percept
    turned: int
    known: Known


class Places:
    """Places by number, with where motions lead; made when they are first asked for.

    Attributes:
        places: by number.
        answer: for each a number of its map, seen from the robot: what is to be answered.
    """

    def __init__(self) -> None:
        self.places: list[Place] = []
        self.answer: list[int] = []
        self._numbers: dict[Place, int] = {}
        self._percepts: list[Percept] = []
        self._after: dict[tuple[int, int], int] = {}
        self._turned: dict[int, int] = {}
        self._answers: dict[Code, int] = {}

    def number(self, map_: CombinatorialMap, robot: Dart, pointed: Dart) -> int:
        """The number of the place of a robot in a world."""
        order = numbering(map_.sigma, map_.alpha, robot)
        number = {dart: i for i, dart in enumerate(order)}
        code = (
            tuple(number[map_.sigma[dart]] for dart in order),
            tuple(number[map_.alpha[dart]] for dart in order),
        )
        return self._numbered(Place(code, number[pointed]))

    def _numbered(self, place: Place) -> int:
        if place in self._numbers:
            return self._numbers[place]
        self._numbers[place] = number = len(self.places)
        self.places.append(place)
        self._percepts.append(_percept(place))
        self.answer.append(self._answers.setdefault(place.code, len(self._answers)))
        return number

    def percept(self, number: int) -> Percept:
        """The percept at a place."""
        return self._percepts[number]

    def mirrored(self, number: int) -> int:
        """The number of the mirror image of a place."""
        return self.number(self._map(number).mirrored(), 0, self.places[number].pointed)

    def degree(self, known: Known) -> int:
        """The degree of the robot's vertex."""
        return self._percepts[known[0]].degree

    def parted(self, numbers: Iterable[int]) -> list[SensedKnowledge]:
        """The states of knowledge possible after sensing here; by degree, then bearing."""
        parts: dict[Percept, list[int]] = {}
        for number in numbers:
            parts.setdefault(self._percepts[number], []).append(number)
        found = []
        for percept, there in parts.items():
            turned = percept.bearing or 0
            facing = [self._turned_to_pointed(number) for number in there] if turned else there
            found.append(SensedKnowledge(percept, turned, tuple(sorted(facing))))
        return sorted(found, key=_by_percept)

    def moved(self, known: Known, k: int) -> list[SensedKnowledge]:
        """The possible states of knowledge after motion ``k``."""
        after = self._after
        reached = []
        for number in known:
            there = after.get((number, k))
            if there is None:
                map_ = self._map(number)
                robot = map_.alpha[map_.turn(0, k)]
                there = after[number, k] = self.number(map_, robot, self.places[number].pointed)
            reached.append(there)
        return self.parted(reached)

    def _turned_to_pointed(self, number: int) -> int:
        if number not in self._turned:
            pointed = self.places[number].pointed
            self._turned[number] = self.number(self._map(number), pointed, pointed)
        return self._turned[number]

    def _map(self, number: int) -> CombinatorialMap:
        return CombinatorialMap.trusted(*self.places[number].code)

    def answers(self, known: Known) -> int:
        """The number of possible answers."""
        answer = self.answer
        return len({answer[number] for number in known})

    def settled(self, known: Known) -> bool:
        """Whether the map and the robot's dart in it are known; the bearing need not be."""
        answer = self.answer
        return all(answer[number] == answer[known[0]] for number in known)


def _by_percept(part: SensedKnowledge) -> tuple[int, int]:
    """Sort key: degree, then bearing; a missing bearing comes first."""
    degree, bearing = part.percept.degree, part.percept.bearing
    return degree, -1 if bearing is None else bearing


def _percept(place: Place) -> Percept:
    sigma, _ = place.code
    around, bearing = [0], None
    while sigma[around[-1]]:
        around.append(sigma[around[-1]])
    if place.pointed in around:
        bearing = around.index(place.pointed)
    return Percept(len(around), int(bearing is not None), bearing)
