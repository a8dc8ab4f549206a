"""The best worst case of any explorer, by minimax over what a robot can still believe.

A *place* is a world seen from the robot: a map rooted at the robot's dart, in canonical
numbering, with the pointed dart in it.  Where it has come from is nothing to it.  What a robot
*knows* is the set of places that agree with its log; a motion leads each to another, and what is
sensed there parts the set.  Turning is free: at v0 the robot is turned to the pointed dart, so that
what is known does not depend on the dart by which it has come.

The search is iterative deepening: whether t traversals are enough, for t = 0, 1, ...  Bounds found
for a state of knowledge, from above and from below, are kept.  The strategy that it finds is
followed in every world by code that shares nothing with the search (``in_every_world``).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple, TypeAlias

from msgspec import Struct

from allworlds import CombinatorialMap, Estimate, Percept

Code: TypeAlias = tuple[tuple[int, ...], tuple[int, ...]]
"""Of a rooted map: (sigma, alpha) in canonical numbering."""

Known: TypeAlias = tuple[int, ...]
"""The numbers of the places that are possible, ascending; one percept is sensed in all of them."""


ToldApart: TypeAlias = Callable[[Percept, int], int]
"""The largest number of places that can be told apart after a percept with so many traversals."""


class Place(NamedTuple):
    """A world seen from the robot, which stands at dart 0.

    Attributes:
        code: the map rooted there, in canonical numbering.
        pointed: the dart that the marker points at.
    """

    code: Code
    pointed: int


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

    def number(self, map_: CombinatorialMap, robot: int, pointed: int) -> int:
        """The number of the place of a robot in a world."""
        order = numbering(map_, robot)
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


# ---------------------------------------------------------------- the search


class Search:
    """Known values of states of knowledge, and the search for more.

    Attributes:
        places: the places that states are made of.
        states: how many were looked into, each as often as it was.

    Args:
        places: see above.
        told_apart: see :func:`minimax`.
    """

    def __init__(self, places: Places, told_apart: ToldApart | None = None) -> None:
        self.places = places
        self._told_apart = told_apart
        self.states = 0
        self._at_least: dict[Known, int] = {}
        self._enough: dict[Known, tuple[int, int]] = {}
        self._ways: dict[Known, list[tuple[int, list[SensedKnowledge]]]] = {}

    def value(self, known: Known) -> int:
        """The fewest traversals after which the robot knows map and place in every case."""
        most = self.at_least(known)
        while not self.within(known, most):
            most += 1
        return most

    def at_least(self, known: Known) -> int:
        """The largest lower bound found so far for the number of traversals."""
        found = self._at_least.get(known)
        if found is None:
            found = self._at_least[known] = self._needed(known)
        return found

    def _needed(self, known: Known) -> int:
        """A number of traversals that is needed, as counting says."""
        if self.places.settled(known):
            return 0
        least = 1
        if self._told_apart is not None:
            answers, percept = self.places.answers(known), self.places.percept(known[0])
            while self._told_apart(percept, least) < answers:
                least += 1
        return least

    def within(self, known: Known, most: int) -> bool:
        """Whether ``most`` traversals are enough."""
        least = self.at_least(known)
        if least == 0 or least > most:
            return least == 0
        if known in self._enough and self._enough[known][0] <= most:
            return True
        self.states += 1
        for k, parts in self._ways_from(known):
            if all(self.at_least(part.known) < most for part in parts) and all(
                self.within(part.known, most - 1) for part in parts
            ):
                # Further down the same state may have been met, with less left.
                self._enough[known] = min(self._enough.get(known, (most, k)), (most, k))
                return True
        self._at_least[known] = most + 1
        return False

    def _ways_from(self, known: Known) -> list[tuple[int, list[SensedKnowledge]]]:
        """The motions, each with the possible states of knowledge after it.

        The states of a motion are ordered from most possible answers to fewest; the motions by the
        number of answers left in their first state, fewest first.
        """
        ways = self._ways.get(known)
        if ways is None:
            answers = self.places.answers
            ways = []
            for k in range(self.places.degree(known)):
                parts = self.places.moved(known, k)
                parts.sort(key=lambda part: -answers(part.known))
                ways.append((k, parts))
            ways.sort(key=lambda way: answers(way[1][0].known))
            self._ways[known] = ways
        return ways

    def motion(self, known: Known, most: int) -> tuple[int, int] | None:
        """A number of traversals that is enough, at most ``most``, and a first motion; or None."""
        return self._enough[known] if self.within(known, most) else None


# ---------------------------------------------------------------- strategies


class Branch(NamedTuple):
    """The node to go on with, by its place in ``nodes``, after a percept."""

    percept: Percept
    node: int


class StrategyStep(NamedTuple):
    """A node of a strategy: by how many darts the robot turns before it leaves, and what then."""

    move: int
    then: tuple[Branch, ...]


class StrategyLeaf(NamedTuple):
    """A node of a strategy: the end."""

    answer: Estimate


class Strategy(NamedTuple):
    """A motion for every percept, and an answer at the end. Several branches may lead to a node."""

    start: tuple[Branch, ...]
    nodes: tuple[StrategyStep | StrategyLeaf, ...]


class _Maker:
    """The nodes made so far, and the most traversals from each."""

    def __init__(self, search: Search) -> None:
        self.nodes: list[StrategyStep | StrategyLeaf] = []
        self.costs: list[int] = []
        self._places, self._motion = search.places, search.motion
        self._numbers: dict[tuple[Known, int, int], int] = {}

    def branches(self, parts: Sequence[SensedKnowledge], most: int) -> tuple[Branch, ...]:
        """The next nodes, by the percept."""
        return tuple(Branch(percept=part.percept, node=self._number(part, most)) for part in parts)

    def _number(self, part: SensedKnowledge, most: int) -> int:
        """The number of the node for a state, made if it is new."""
        known, turned, places = part.known, part.turned, self._places
        enough, k = 0, 0
        if not places.settled(known):
            found = self._motion(known, most)
            assert found is not None, "the search has found a motion here"
            enough, k = found
        key = known, turned, enough
        if key not in self._numbers:
            node: StrategyStep | StrategyLeaf
            cost = 0
            if enough:
                then = self.branches(places.moved(known, k), enough - 1)
                # Seen from the dart that the robot has come by, not the one it has turned to.
                node = StrategyStep(move=(k + turned) % places.degree(known), then=then)
                cost = 1 + max(self.costs[branch.node] for branch in then)
            else:
                map_ = CombinatorialMap.trusted(*places.places[known[0]].code)
                node = StrategyLeaf(answer=Estimate(map_, map_.turn(0, -turned)))
            self._numbers[key] = len(self.nodes)
            self.nodes.append(node)
            self.costs.append(cost)
        return self._numbers[key]


class Solved(Struct, frozen=True):
    """The fewest traversals that suffice in some worlds, and a strategy that needs no more."""

    traversals: int
    strategy: Strategy


def minimax(
    given: Iterable[tuple[CombinatorialMap, int, int]], told_apart: ToldApart | None = None
) -> Solved:
    """Find the fewest traversals that suffice in all these worlds, and a strategy for them.

    The explorer knows which worlds there are.

    Args:
        given: of each the map, the dart that the robot faces, and the dart of its vertex that
            the marker points at; at least one.
        told_apart: the largest number of places that can be told apart after a percept with so
            many traversals, if that is known.

    Cost: half a minute for all worlds with 3 edges or for bouquets with 4 loops; it grows faster
    than any power.
    """
    search = Search(Places(), told_apart)
    starts = search.places.parted([search.places.number(*world) for world in given])
    most = max(search.value(part.known) for part in starts)
    maker = _Maker(search)
    return Solved(most, Strategy(maker.branches(starts, most), tuple(maker.nodes)))


def numbering(map_: CombinatorialMap, root: int) -> list[int]:
    """The darts by canonical number: breadth-first from the root, sigma first."""
    order, seen = [root], {root}
    for dart in order:
        for other in (map_.sigma[dart], map_.alpha[dart]):
            if other not in seen:
                seen.add(other)
                order.append(other)
    return order
