"""An adversary: a corridor that decides as late as possible how its far darts are matched.

It keeps the graph of the pairs that are still *allowed* between open darts, and one perfect
matching of them. A robot that has left the fixed edges by an open dart e is *lost*: it is in a tree
of words that are read from the other end of e, the *root* of the tree. All hubs look alike, so an
answer there says only that the robot is not at vertex 0. Where the edge {e, y} would make this
untrue, the pair is excluded, and the matching repaired; if that cannot be done, the pair is an
edge from now on. Where the answer would depend on a second open dart, the edge of one of the two
in the matching is fixed first. So every answer is true in every perfect matching of the allowed
pairs, at any time, and in the world that is left at the end.

Source: ``docs/theory.md``, 'Lower bounds'.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

from allworlds.inputs import InputError, show
from allworlds.maps import Dart, augmented, drawn_corridor
from allworlds.protocol import Action, Move, Percept, Told
from allworlds.world.lighthouses.directional import Directional
from allworlds.world.state import State, without_markers
from allworlds.world.world import IllegalAction, World

Word: TypeAlias = tuple[int, ...]
"""Motions, each from the dart by which one has arrived; 0, the way back, does not occur."""

PREFIX = "adversary:"
FORM = f"{PREFIX}corridor:F"
MOST_FAR = 20
"""The largest F: its worlds have 7,381 edges."""


@dataclass(frozen=True, slots=True)
class Adversary:
    """The adversary in the corridor with F far hubs.

    Attributes:
        far: F.
        seed: of the near loops, and of the matching that is kept at first.
    """

    far: int
    seed: int = 0

    def __str__(self) -> str:
        return f"{PREFIX}corridor:{self.far}"

    @property
    def at_first(self) -> World:
        """The world that is left if the robot does not move."""
        return Deciding(self).world()


def adversary_named(text: str, seed: int = 0) -> Adversary:
    """The adversary of a text ``adversary:corridor:F``.

    Raises:
        InputError: for another text, or an F out of range.
    """
    match = re.fullmatch(rf"{PREFIX}corridor:([0-9]{{1,6}})", text)
    if match is None or not 1 <= int(match[1]) <= MOST_FAR:
        raise InputError(f"{show(text)} is not {FORM} with 1 <= F <= {MOST_FAR}")
    return Adversary(int(match[1]), seed)


class Deciding:
    """One play of an adversary: the environment of an explorer.

    Attributes:
        excluded: the number of pairs that an answer has excluded.
        forced: the number of edges that are fixed because nothing else is allowed.
        settled: the number of edges that were fixed before an answer that depended on them.
    """

    initial = without_markers(0)
    told: Told = None
    over = False

    def __init__(self, adversary: Adversary) -> None:
        self._corridor = drawn_corridor(adversary.far, adversary.seed)
        darts = self._corridor.open
        self._hub = self._corridor.degree
        self._partner = {d: e for d, e in enumerate(self._corridor.alpha) if d != e}
        self._allowed = {d: {*darts} - {d} for d in darts}
        self._mate = {d: darts[i ^ 1] for i, d in enumerate(darts)}
        self._trees: dict[Dart, set[Word]] = {}
        # The robot: at a known dart; or lost below a root, at the end of a word, turned so far.
        self._dart: Dart = 0
        self._root: Dart | None = None
        self._word: Word = ()
        self._turn = 0
        self.excluded = self.forced = self.settled = 0

    @property
    def first(self) -> Percept:
        """The percept at vertex 0 before any motion."""
        return self._sensed()

    def step(self, state: State, action: Action) -> tuple[State, Percept]:
        """The percept after a motion; the state stays as it is, and this object decides.

        Raises:
            IllegalAction: for anything but a motion.
        """
        if type(action) is not Move:
            raise IllegalAction("Move: there are no markers, and nothing is written")
        self._move(action.k)
        return state, self._sensed()

    def world(self) -> World:
        """The static world in which all answers up to now are true."""
        pairs = [(d, self._partner.get(d, self._mate.get(d, d))) for d in self._corridor.open]
        return World(self._corridor.matched(pairs), Directional(0))

    def _sensed(self) -> Percept:
        if self._root is None and self._dart < 2:
            # The offset from the dart of arrival to dart 0, which is the pointed one.
            return Percept(2, 1, self._dart)
        return Percept(self._hub, 0, None)

    def _move(self, motion: int) -> None:
        if self._root is None:
            leaving = self._corridor.turned(self._dart, motion)
            if leaving in self._partner:
                self._dart = self._partner[leaving]
            else:
                self._root, self._word, self._turn = leaving, (), 0
            return
        letter = (self._turn + motion) % self._hub
        if letter == 0 and self._word:
            self._turn, self._word = self._word[-1], self._word[:-1]
        elif letter == 0:
            self._dart, self._root = self._root, None
        else:
            self._decide(motion, letter)

    def _decide(self, motion: int, letter: int) -> None:
        """Move on in a tree: to a node where the robot was before, or to a new one."""
        assert self._root is not None
        root, word = self._root, (*self._word, letter)
        if word not in self._trees.setdefault(root, set()):
            homes = [*self._homes(word)]
            for dart, before, _ in homes:
                if before:
                    self.settled += 1
                    # A tester has settled one of the two ends: that with few pairs left.
                    self._fix(min(root, dart, key=lambda d: (len(self._allowed[d]), d)))
                    self._move(motion)
                    return
            wanted = {dart: end for dart, _, end in homes if dart in self._allowed[root]}
            if not self._exclude(root, wanted):
                end = wanted[self._mate[root]]
                self.forced += 1
                self._fix(root)
                self._dart, self._root = end, None
                return
            self._trees[root].add(word)
        self._word, self._turn = word, 0

    def _homes(self, word: Word) -> Iterator[tuple[Dart, Word, Dart]]:
        """The open darts that are met on the way back from vertex 0, against the word.

        Yields:
            for each of the two arrivals at vertex 0 at most one open dart, the part of the word
            that is left before it, and the arrival. Where nothing is left, the word leads home if
            the root is that dart.
        """
        for arrival in (0, 1):
            dart = arrival
            for length in reversed(range(len(word))):
                leaving = self._partner[dart]
                if leaving < 2:
                    break
                dart = self._corridor.turned(leaving, -word[length])
                if dart in self._allowed:
                    yield dart, word[:length], arrival
                    break

    def _exclude(self, root: Dart, wanted: dict[Dart, Dart]) -> bool:
        """Exclude the pairs of the root with these darts, unless no perfect matching is left."""
        for y in wanted:
            self._allowed[root].discard(y)
            self._allowed[y].discard(root)
        if self._mate[root] in wanted and not self._rematch(root, self._mate[root]):
            for y in wanted:
                self._allowed[root].add(y)
                self._allowed[y].add(root)
            return False
        self.excluded += len(wanted)
        return True

    def _rematch(self, d: Dart, e: Dart) -> bool:
        """Match two darts otherwise; False, and no change, if there is no perfect matching."""
        for a in sorted(self._allowed[d]):
            b = self._mate[a]
            if a != e and b in self._allowed[e]:
                self._mate |= {d: a, a: d, e: b, b: e}
                return True
        rest = {a: b for a, b in self._mate.items() if a not in (d, e)}
        found = augmented(self._allowed, rest, d)
        if found is None:
            return False
        self._mate = found
        return True

    def _fix(self, dart: Dart) -> None:
        """Make the pair of an open dart in the matching an edge, and fold the trees behind it."""
        ends = dart, self._mate[dart]
        trees = [(d, word) for d in ends for word in sorted(self._trees.pop(d, ()))]
        for d in ends:
            for y in self._allowed.pop(d):
                self._allowed.get(y, set()).discard(d)
            self._partner[d] = self._mate.pop(d)
        for root, word in trees:
            at, left, rest = self._folded(root, word)
            assert left is not None or at > 1, "an answer was not true"
            if left is not None and rest:
                self._trees.setdefault(left, set()).add(rest)
        if self._root is not None:
            at, self._root, self._word = self._folded(self._root, self._word)
            if self._root is None:
                self._dart = self._corridor.turned(at, self._turn)

    def _folded(self, root: Dart, word: Word) -> tuple[Dart, Dart | None, Word]:
        """The place at the end of a word: a dart, or an open dart and the word behind it."""
        if root not in self._partner:
            return -1, root, word
        dart = self._partner[root]
        for i, letter in enumerate(word):
            leaving = self._corridor.turned(dart, letter)
            if leaving not in self._partner:
                return -1, leaving, word[i + 1 :]
            dart = self._partner[leaving]
        return dart, None, ()
