"""Experiments that are never made twice: the tree of all walks, and the robot in it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from allworlds.explorers.builtin.algorithm1 import Walk
from allworlds.protocol import Move, Percept


class TreeDart(NamedTuple):
    """A dart of the tree: the dart ``turn`` places clockwise of a node's dart of entry."""

    node: int
    turn: int


class Experiments:
    """The tree of all walks from the start: each arrival that is not a way back is a new node.

    The tree does not know which nodes are one vertex.  Node 0 is the start.

    Attributes:
        start: the dart that the robot faces at the start.
        here: the robot's place.

    Cost: a step that was made before costs nothing, unless the robot must go where a new one
    is to be made: then as many traversals as the tree has edges between.
    """

    def __init__(self, first: Percept) -> None:
        self.start = self.here = TreeDart(0, 0)
        self._percept = [first]
        self._beyond: list[dict[int, int]] = [{}]
        # The dart of the parent by which a node was found; the root has none.
        self._from = [self.start]

    def sensed(self, place: TreeDart) -> Percept:
        """The percept of the robot at a dart of the tree."""
        return self._percept[place.node]

    def walk(self, word: Sequence[str], place: TreeDart | None = None) -> Walk[TreeDart]:
        """Walk a word of ``s`` (turn) and ``a`` (go through), by default from the start."""
        at = self.start if place is None else place
        for letter in word:
            if letter == "s":
                at = TreeDart(at.node, (at.turn + 1) % self.sensed(at).degree)
            else:
                at = yield from self._through(at)
        return at

    def word_to(self, place: TreeDart) -> tuple[str, ...]:
        """The word that leads from the start to a place along the tree."""
        word: list[str] = []
        while True:
            word = [*"s" * place.turn, *word]
            if not place.node:
                return tuple(word)
            word = ["a", *word]
            place = self._from[place.node]

    def _through(self, at: TreeDart) -> Walk[TreeDart]:
        known = self._known(at)
        if known is not None:
            return known
        yield from self._go(at.node)
        seen = yield Move(at.turn - self.here.turn)
        node = len(self._percept)
        self._percept.append(seen)
        self._beyond.append({})
        self._from.append(at)
        self._beyond[at.node][at.turn] = node
        self.here = TreeDart(node, 0)
        return self.here

    def _known(self, at: TreeDart) -> TreeDart | None:
        """The other end, if it was reached; a node's dart of entry leads back to its parent."""
        if at.node and at.turn == 0:
            return self._from[at.node]
        node = self._beyond[at.node].get(at.turn)
        return None if node is None else TreeDart(node, 0)

    def _go(self, goal: int) -> Walk[None]:
        """Walk to a node: up to where the ways from the root part, and down."""
        below = self._line(goal)
        while self.here.node not in below:
            yield from self._step(TreeDart(self.here.node, 0))
        for node in reversed(below[: below.index(self.here.node)]):
            yield from self._step(self._from[node])

    def _line(self, node: int) -> list[int]:
        """The node, its parent, and so on to the root."""
        line = [node]
        while line[-1]:
            line.append(self._from[line[-1]].node)
        return line

    def _step(self, dart: TreeDart) -> Walk[None]:
        yield Move(dart.turn - self.here.turn)
        other = self._known(dart)
        assert other is not None
        self.here = other
