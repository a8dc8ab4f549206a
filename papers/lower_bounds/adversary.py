"""An adversary: a corridor that decides as late as possible how its free darts are matched.

A free dart whose edge is not fixed yet is *undecided*.  The adversary keeps the graph of the pairs
that are still *allowed* between undecided darts, and one perfect matching of them.  A robot that
has left the fixed edges by an undecided dart e is *lost*: it is in a tree of words that are read
from the other end of e, the *root* of the tree.  All hubs look alike, so an answer there says only
that the robot is not at vertex 0.  Where the edge {e, y} would make this untrue, the pair is
excluded, and the matching repaired; if that cannot be done, the pair is an edge from now on.  So
every answer is true in every perfect matching of the allowed pairs, at any time, and in the world
that is left at the end.

Where an explorer has settled a root, the edge of e in the matching is fixed at once, as in the
proof of the bound of testers.  Built-in testers tell what they settle, when they do; any other
explorer may show it when the robot is there again (:class:`~allworlds.protocol.Checkpoint`).  If
an answer still depends on a second undecided dart, one of the two edges is fixed, that of the dart
with fewer allowed pairs: all answers stay true, but the bound is not proved then.

Source: ``lower-bounds.md``, 'Testers of home words'.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple, TypeAlias

import explorers
from allworlds import Checkpoint, Choices, Move, Percept, World
from allworlds.claims import Algorithm1
from corridors import Dart, Shape, drawn_corridor
from matching import augmented
from playing import Played, played, run_here

Word: TypeAlias = tuple[int, ...]
"""Motions, each from the dart by which one has arrived; 0, the way back, does not occur."""


class Spot(NamedTuple):
    """A place of the robot: at a fixed dart, or in the tree of an undecided one.

    Attributes:
        dart: the fixed dart; or the undecided dart whose tree it is.
        word: the word from the root of the tree; None at a fixed dart.
        turn: in a tree, how far the robot has turned from the dart by which it has come.
    """

    dart: Dart
    word: Word | None = None
    turn: int = 0


class Deciding:
    """One play of an adversary: the environment of an explorer.

    Args:
        shape: of the corridor.
        seed: of the near loops, and of the matching that is kept at first.

    Attributes:
        excluded: the number of pairs that an answer has excluded.
        forced: the number of edges that are fixed because nothing else is allowed.
        settled: the undecided darts whose edges were fixed since the explorer had settled the
            vertex behind, each with the number of motions before.
        depended: the number of edges that were fixed before an answer that depended on two.
    """

    initial = None
    first = Percept(2, 1, 0)

    def __init__(self, shape: Shape, seed: int = 0) -> None:
        self._corridor = drawn_corridor(shape, seed)
        darts = self._corridor.free
        self._hub = shape.degree
        self._partner = {d: e for d, e in enumerate(self._corridor.alpha) if d != e}
        self._allowed = {d: {*darts} - {d} for d in darts}
        self._mate = {d: darts[i ^ 1] for i, d in enumerate(darts)}
        self._trees: dict[Dart, set[Word]] = {}
        self._at = Spot(0)
        self._motions = 0
        self.excluded = self.forced = self.depended = 0
        self.settled: list[tuple[int, Dart]] = []

    def step(self, state: None, action: Move) -> tuple[None, Percept]:
        """The percept after a motion; this object decides."""
        self._motions += 1
        self._move(action.k)
        return state, self._sensed()

    def heed(self, shown: Checkpoint) -> list[Dart]:
        """Fix the edges behind which the explorer has settled a vertex, and return their darts."""
        return self._settle(shown, at_start=False)

    def hear(self, settled: Checkpoint) -> None:
        """Do the same where the dart that the robot faced at the start stands for its own."""
        self._settle(settled, at_start=True)

    def _settle(self, shown: Checkpoint, *, at_start: bool) -> list[Dart]:
        fixed: list[Dart] = []
        while True:
            root = self._settled_root(shown, Spot(0) if at_start else self._at)
            if root is None:
                return fixed
            self.settle(root)
            fixed.append(root)

    def settle(self, root: Dart) -> None:
        """Fix the edge of a dart behind which the explorer has settled the vertex."""
        if root in self._allowed:
            self.settled.append((self._motions, root))
            self._fix(root)

    def world(self) -> World:
        """The static world in which all answers up to now are true."""
        pairs = [(d, self._partner.get(d, self._mate.get(d, d))) for d in self._corridor.free]
        return World(self._corridor.matched(pairs), "directional")

    def _sensed(self) -> Percept:
        at = self._at
        if at.word is None and at.dart < 2:
            # The offset from the dart of arrival to dart 0, which is the pointed one.
            return Percept(2, 1, at.dart)
        return Percept(self._hub, 0, None)

    def _turned(self, spot: Spot, motion: int) -> Spot:
        if spot.word is None:
            return Spot(self._corridor.turned(spot.dart, motion))
        return spot._replace(turn=(spot.turn + motion) % self._hub)

    def _across(self, spot: Spot) -> Spot | None:
        """The other end of the dart that one faces; None if the robot never went there."""
        dart, word, turn = spot
        if word is None:
            if dart in self._partner:
                return Spot(self._partner[dart])
            return Spot(dart, ()) if dart in self._trees else None
        if turn:
            longer = (*word, turn)
            return Spot(dart, longer) if longer in self._trees[dart] else None
        return Spot(dart, word[:-1], word[-1]) if word else Spot(dart)

    def _move(self, motion: int) -> None:
        facing = self._turned(self._at, motion)
        there = self._across(facing)
        if there is not None:
            self._at = there
        elif facing.word is None:
            self._trees[facing.dart] = set()
            self._at = Spot(facing.dart, ())
        else:
            self._decide(motion, facing.dart, (*facing.word, facing.turn))

    def _decide(self, motion: int, root: Dart, word: Word) -> None:
        """Move on to a node of a tree where the robot has never been."""
        homes = [*self._homes(word)]
        for dart, before, _ in homes:
            if before:
                self.depended += 1
                self._fix(min(root, dart, key=lambda d: (len(self._allowed[d]), d)))
                self._move(motion)
                return
        wanted = {dart: end for dart, _, end in homes if dart in self._allowed[root]}
        if self._exclude(root, wanted):
            self._trees[root].add(word)
            self._at = Spot(root, word)
            return
        end = wanted[self._mate[root]]
        self.forced += 1
        self._fix(root)
        self._at = Spot(end)

    def _homes(self, word: Word) -> Iterator[tuple[Dart, Word, Dart]]:
        """The undecided darts that are met on the way back from vertex 0, against the word.

        Yields:
            for each of the two arrivals at vertex 0 at most one undecided dart, the part of the
            word that is left before it, and the arrival. Where nothing is left, the word leads
            home if the root is that dart.
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
        """Make the pair of an undecided dart in the matching an edge, and fold the trees behind.

        The other allowed pairs of the two darts go: they are in no perfect matching with this edge.
        """
        ends = dart, self._mate[dart]
        trees = [(d, self._trees.pop(d)) for d in ends if d in self._trees]
        for d in ends:
            for y in self._allowed.pop(d):
                self._allowed.get(y, set()).discard(d)
            self._partner[d] = self._mate.pop(d)
        for root, words in trees:
            for word in [(), *sorted(words)]:
                spot = self._folded(Spot(root, word))
                assert spot.word is not None or spot.dart > 1, "an answer was not true"
                if spot.word is not None:
                    tree = self._trees.setdefault(spot.dart, set())
                    if spot.word:
                        tree.add(spot.word)
        self._at = self._folded(self._at)

    def _folded(self, spot: Spot) -> Spot:
        """The spot in the tree in which it lies now, or among the fixed darts."""
        if spot.word is None or spot.dart not in self._partner:
            return spot
        dart = self._partner[spot.dart]
        for i, letter in enumerate(spot.word):
            leaving = self._corridor.turned(dart, letter)
            if leaving not in self._partner:
                return Spot(leaving, spot.word[i + 1 :], spot.turn)
            dart = self._partner[leaving]
        return Spot(self._corridor.turned(dart, spot.turn))

    def _settled_root(self, shown: Checkpoint, here: Spot) -> Dart | None:
        """An undecided dart behind which there is a vertex of S, as the explorer shows it."""
        sigma, alpha, size = shown.sigma, shown.alpha, len(shown.sigma)
        if len(alpha) != size or not all(0 <= d < size for d in (*sigma, *alpha, shown.here)):
            return None  # no S; the judge will say so
        seen: set[int] = set()
        places = [(shown.here, here)]
        for entry, spot in places:
            if spot.word is not None:
                return spot.dart
            dart, facing = entry, spot
            while dart not in seen:
                seen.add(dart)
                other = alpha[dart]
                there = self._across(facing)
                if other not in (dart, *seen) and there is not None:
                    places.append((other, there))
                dart, facing = sigma[dart], self._turned(facing, 1)
        return None


class Decisions(NamedTuple):
    """A play against the adversary, and the judged run in the world that is left.

    Attributes:
        walk: the motions against the adversary.
        deciding: the adversary after them.
        run: in the world that is left.
    """

    walk: Played
    deciding: Deciding
    run: Any

    @property
    def cost(self) -> int:
        """Traversals against the adversary."""
        return len(self.walk.actions)

    @property
    def same(self) -> bool:
        """Whether the explorer walks in the world as against the adversary."""
        return bool(self.run.transcript.actions == self.walk.actions)


def against(name: str, shape: Shape, seed: int = 0) -> Decisions:
    """Play an explorer against the adversary, and run it in the world that is left.

    Those of this folder tell what they settle, when they do; Algorithm 1 shows it.
    """
    deciding = Deciding(shape, seed)

    def explore(first: Percept) -> Any:
        if name == "algorithm1":
            return Algorithm1(first, Choices()).explore()
        return getattr(explorers, name)(first, settled=deciding.hear)

    walk = played(explore, deciding, deciding.heed)
    return Decisions(walk, deciding, run_here(name, deciding.world()))
