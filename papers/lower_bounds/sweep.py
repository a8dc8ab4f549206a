"""Words that serve many hypotheses at once: an explorer that is right, and gains nothing for sure.

    allworlds compare explorers.py:greedy sweep.py:sweep --family corridor --to 325 --draws 3

It is ``prudent`` with *sweeps* between the passes, where all settled vertices but v0 have one
degree.  A sweep walks one word from behind every open dart of S.  *Walkers* plan it: robots that
came by open darts, and follow it on known edges.  First it makes one motion r times; at each step a
walker starts from every open dart.  Then a beam search brings many of them to v0.  Right: sweeps
only add percepts.  It ends: a sweep that closes no dart gives up its motion, or a pass follows.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import exp
from typing import Any, NamedTuple

import numpy as np

from allworlds import Percept
from explorers import Prudent
from unforgetting import OPEN, nobody

Word = tuple[int, ...]
BEAM, TRIED = 6, 8  # words that are kept in the search, and beginnings that get a tail
WORTH, STILL_WORTH = 1.7, 1.4  # the gain for which a sweep begins, and goes on
FEWEST = 8  # open darts


def sweep(first: Percept) -> Iterator[Any]:
    """Explore from a directional lighthouse; return an estimate equal to the world."""
    return (yield from Sweep(first, nobody).explore())


class Prices(NamedTuple):
    """The open darts, the mean length of their home words, the probability that one leads to S."""

    darts: int
    home: float
    inside: float

    def gain(self, hit: float, length: float) -> float:
        """The cost of tests divided by that of a word that leads home with a probability."""
        cost = (1 - hit) * 2 * length + hit * (0.6 * length + 2 * self.home)
        return hit * self.darts * self.home / cost

    def guess(self, length: float, met: float) -> float:
        """The gain of a word that brings so many walkers home."""
        return self.gain(self.inside * (1 - exp(-met / self.darts)), length)


class Walkers:
    """The search for a word; ``came[k, d]`` is the dart from which motion k leads to dart d."""

    def __init__(self, came: Any, is_open: Any, level: Any, prices: Prices) -> None:
        self.came, self.is_open, self.prices = came, is_open, prices
        self.at_v0 = np.flatnonzero(level == 0)
        self.top = int(level.max()) + 2
        self.near = np.append(self.top - level, 0)

    def best_word(self, failed: set[int]) -> tuple[float, Word]:
        """The largest gain that is found, and its word; none begins with a motion that failed."""
        begun = sorted((b for b in self.beginnings() if b[1] not in failed), key=lambda b: b[:3])
        return max((self.completed(*b[1:]) for b in begun[:TRIED]), default=(0, ()))

    def beginnings(self) -> Iterator[tuple[float, int, int, Any, int]]:
        """Minus the gain that is guessed, the motion, how often; walkers left, and come home."""
        degree, darts = len(self.came), self.prices.darts
        often = {degree // 4, degree // 2, degree, darts // 2, darts, 3 * darts // 2}
        walkers = np.repeat(self.is_open[None], degree - 1, 0)
        met = np.zeros(degree - 1, int)
        for r in range(1, max(often) + 1):
            walkers = np.take_along_axis(walkers, self.came[1:], 1)
            met += self.taken_home(walkers)
            if r in often:
                left = walkers & ~self.is_open
                for i, number in enumerate(left.sum(1)):
                    way = (self.top - self.near)[left[i]].sum() / max(number, 1) + number
                    guess = self.prices.guess(r + int(way), met[i] + 0.85 * number)
                    yield -guess, i + 1, r, left[i], int(met[i])
            walkers |= self.is_open

    def completed(self, k: int, r: int, walkers: Any, met: int) -> tuple[float, Word]:
        """The best gain with a tail, and the word."""
        begun, letters = (k,) * r, len(self.came) - 1
        beam, mets, tails = walkers[None], np.array([met]), [()]
        best, since = (self.prices.guess(r, met), begun), 0
        while since <= 3 * self.top and beam.any():
            after = beam[:, self.came[1:]]
            mets = (mets[:, None] + self.taken_home(after)).ravel()
            worth = mets * self.top + (after @ self.near).ravel()
            after = after.reshape(-1, after.shape[-1])
            kept: dict[bytes, int] = {}
            for i in np.argsort(-worth, kind="stable")[: 3 * BEAM]:
                kept.setdefault(after[i].tobytes(), int(i))
            first = [*kept.values()][:BEAM]
            tails = [(*tails[i // letters], i % letters + 1) for i in first]
            beam, mets, since = after[first], mets[first], since + 1
            word = (*begun, *tails[most := int(mets.argmax())])
            if (gain := self.prices.guess(len(word), mets[most])) > best[0]:
                best, since = (gain, word), 0
        return best

    def taken_home(self, walkers: Any) -> Any:
        """Take away the walkers that left the known edges or are at v0; how many are at v0."""
        walkers[..., -1] = False
        met = walkers[..., self.at_v0].sum(-1)
        walkers[..., self.at_v0] = False
        return met


class Sweep(Prudent):
    """The state; *credit* is the cost of passes, and of the tests that sweeps have saved."""

    credit, steps, loops, prices = 0.0, 0, 0, Prices(0, 0, 0)
    planned = (0, 0, 0.0)  # sizes of S and U at the last plan, and the credit that makes a new one

    def lost(self) -> list[int]:
        """The open darts, but those of v0."""
        return [dart for dart in self.unexplored() if self.log.node[dart]]

    def explore(self) -> Iterator[Any]:
        """Make sweeps and passes until no dart is open."""
        self.failed: set[int] = set()  # the motions of sweeps that were given up since S grew
        while self.unexplored():
            if self.is_settled(self.here):
                yield from self._show()
            word = self.word()
            if word and (yield from self.sweep(word)):
                continue
            before, size = self.steps, len(self.rank)
            entry = yield from self._cross(self.next_dart(self.unexplored()))
            if entry != OPEN:
                yield from self._resolve(entry)
            self._look_home()
            grown = len(self.rank) > size
            self.loops, self.failed = (0, set()) if grown else (self.loops + 1, self.failed)
            self.credit += self.steps - before
        yield from self._show()
        return self._answer()

    def _step(self, dart: int) -> Iterator[Any]:
        self.steps += 1
        return (yield from super()._step(dart))

    def word(self) -> Word:
        """A word that is worth a sweep, or the empty one."""
        log, darts = self.log, self.lost()
        size, number, enough = self.planned
        same = len(self.rank) == size and len(darts) > 0.9 * number and self.credit < enough
        degrees = {log.degree[v] for v in self.rank if v}
        if len(degrees) != 1 or len(darts) < FEWEST or self.credit <= 0 or same:
            return ()
        home = sum(self.distance[log.node[dart]] for dart in darts) / len(darts)
        self.prices = Prices(len(darts), home, (self.loops + 0.5) / (self.loops + 1.5))
        possible = home * log.degree[0] >= WORTH  # each dart of v0 takes in one walker a step
        gain, word = self.walkers(darts, *degrees).best_word(self.failed) if possible else (0, ())
        first = 10 * len(word) if gain >= WORTH else 0
        enough = first if self.credit < first else 2 * self.credit
        self.planned = len(self.rank), len(darts), enough
        return word if 0 < first <= self.credit else ()

    def walkers(self, darts: list[int], degree: int) -> Walkers:
        """The search in S, with its darts numbered from 0."""
        log, opened = self.log, {*darts}
        of_s = [log.base[v] + i for v in self.rank for i in range(log.degree[v])]
        number = {dart: i for i, dart in enumerate(of_s)}
        came = np.full((degree, len(of_s) + 1), len(of_s))
        for dart in of_s:
            for k in range(degree) if log.node[dart] else ():
                if (leaving := log.turn(dart, k)) not in opened:
                    came[k, number[log.beyond(leaving)]] = number[dart]
        level = np.array([self.distance[log.node[dart]] for dart in of_s])
        is_open = np.array([*(dart in opened for dart in of_s), False])
        return Walkers(came, is_open, level, self.prices)

    def sweep(self, word: Word) -> Iterator[Any]:
        """Walk the word from behind open darts; whether to plan again, else a pass is due."""
        tried: set[int] = set()
        hits, at_first = 0, len(self.lost())
        while self.credit >= 2 * len(word):
            darts = self.lost()
            left = [dart for dart in darts if dart not in tried]
            likely = (hits + 4 / 3) / (len(tried) + 2)
            if not left:
                break
            if len(tried) >= 4 and self.prices.gain(likely, len(word)) < STILL_WORTH:
                self.failed.add(word[0])
                self.planned = (0, 0, 0.0)
                return True
            dart, before = self.next_dart(left), self.steps
            tried.add(dart)
            hit = yield from self.walk(dart, word)
            self.credit -= self.steps - before
            if hit:
                hits += 1
                self._look_home()
                closed = len(darts) - len(self.lost())
                self.credit += closed / 2 * len(darts) * self.prices.home
        return len(self.lost()) < at_first

    def walk(self, dart: int, word: Word) -> Iterator[Any]:
        """Walk the word from behind a dart; whether that is explored, or the word led to v0."""
        log = self.log
        at = yield from self._cross(dart)
        if at == OPEN:
            return True
        degree = log.degree[log.node[dart]]
        for k in word:
            if log.node[at] == 0 or log.degree[log.node[at]] != degree:
                break
            leaving = log.turn(at, k)
            if (at := log.beyond(leaving)) == OPEN:
                yield from self._go_to(log.node[leaving])
                yield from self._step(leaving)
                at = self.here
        return log.node[at] == 0
