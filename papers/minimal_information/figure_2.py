"""Fig. 2: one pass of Algorithm 1 before and after, for each of the two augmentations of S."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

from msgspec import Struct

from allworlds import Checkpoint, CombinatorialMap, Move, World, run
from allworlds.maps import named_map
from canvas import FAINT, INK, PAPER, Canvas
from drawn import Table

WORLD = "cube"

RED, BLUE, GREEN = "#b2182b", "#2166ac", "#1b7837"


class KnownDarts(Struct, frozen=True):
    """S and U as darts of the world.

    Attributes:
        explored: both darts of every edge of S.
        open: U.
    """

    explored: frozenset[int]
    open: frozenset[int]

    def vertices(self, map_: CombinatorialMap) -> set[int]:
        """The vertices of S in the world."""
        return {map_.vertex_of[dart] for dart in self.explored | self.open}


class PassDrawn(Struct, frozen=True):
    """One round of lines 2 to 21.

    Attributes:
        number: from 1.
        before, after: what is known.
        e: the dart by which the robot left S.
        hypotheses: the darts of U that are sensed alike on arrival (line 6).
        cost: traversals of the pass.
    """

    number: int
    before: KnownDarts
    after: KnownDarts
    e: int
    hypotheses: tuple[int, ...]
    cost: int

    @property
    def added(self) -> frozenset[int]:
        """Both darts of the edge that the pass has explored."""
        return self.after.explored - self.before.explored

    @property
    def is_loop(self) -> bool:
        """Whether a hypothesis was confirmed, so that line 19 ran and not line 21."""
        return self.added <= self.before.open


class Augmentation(Struct, frozen=True):
    """Two passes of one run.

    Attributes:
        told: the run, judged.
        passes: the first that adds a vertex though there were hypotheses, and the first that
            closes a loop though another hypothesis might have been true.
    """

    told: Any
    passes: tuple[PassDrawn, PassDrawn]

    @property
    def right(self) -> bool:
        """Whether the run breaks no law."""
        return self.told.finding is None

    def table(self) -> Table:
        """Rows for the two passes, darts as the world numbers them."""
        header = ["pass", "augmentation", "e", "arrived_by", "hypotheses", "traversals"]
        header += ["vertices_before", "vertices_after", "open_before", "open_after"]
        map_ = self.told.world.map
        rows = [
            [
                p.number,
                "loop" if p.is_loop else "non-loop",
                p.e,
                map_.alpha[p.e],
                " ".join(map(str, p.hypotheses)),
                p.cost,
                len(p.before.vertices(map_)),
                len(p.after.vertices(map_)),
                len(p.before.open),
                len(p.after.open),
            ]
            for p in self.passes
        ]
        return header, rows

    def caption(self) -> Sequence[str]:
        """The lines that stand below the figure."""
        new, closing = self.passes
        cost = self.told.outcome.cost
        return [
            (
                f"Two passes of one run of Algorithm 1 (first in, first out) in the {WORLD}; the "
                f"run, of {cost} traversals, was judged. Black: S; dashed: U, the darts that are "
                "open; grey: what the robot does not know. The marker at v0 points along the arrow."
            ),
            (
                f"Above, pass {new.number}: the robot leaves S by e (red). The "
                f"{len(new.hypotheses)} open darts (blue) with the same signature are the "
                "hypotheses e'; all are rejected, so the vertex is new, and e (green) is added "
                f"with it: {new.cost} traversals."
            ),
            (
                f"Below, pass {closing.number}: of {len(closing.hypotheses)} hypotheses one is "
                "confirmed, so e and e' are one edge (green), and e' leaves U with e: "
                f"{closing.cost} traversals."
            ),
            "The paper draws one beginning for both ends; here each pass has its own, from a run.",
        ]

    def draw(self, figure: Any) -> None:
        """Draw a line for each pass: before, and after."""
        panels = figure.subplots(2, 2)
        figure.set_size_inches(9, 9)
        for line, one in zip(panels, self.passes, strict=True):
            kind = "loop" if one.is_loop else "non-loop"
            self._before(line[0], one)
            line[0].set_title(f"pass {one.number}: before", fontsize=10)
            self._after(line[1], one)
            line[1].set_title(f"pass {one.number}: after ({kind} augmentation)", fontsize=10)

    def _before(self, axes: Any, one: PassDrawn) -> None:
        canvas = self._known(axes, one.before)
        canvas.edges([one.e], color=RED, linewidth=2.4, zorder=2)
        canvas.stubs(one.hypotheses, color=BLUE, linewidth=3.5, zorder=3)
        canvas.note(one.e, "e", color=RED, fontweight="bold")
        for dart in one.hypotheses:
            canvas.note(dart, "e'", color=BLUE)

    def _after(self, axes: Any, one: PassDrawn) -> None:
        canvas = self._known(axes, one.after)
        canvas.edges([one.e], color=GREEN, linewidth=2.8, zorder=2)
        canvas.note(one.e, "e", color=GREEN, fontweight="bold")
        if one.is_loop:
            canvas.note(self.told.world.map.alpha[one.e], "e'", color=GREEN, fontweight="bold")

    def _known(self, axes: Any, known: KnownDarts) -> Canvas:
        world = self.told.world
        canvas = Canvas.of(axes, world.map, world.start)
        seen = known.vertices(world.map)
        canvas.edges((d for d, _ in world.map.edges), color=FAINT, linewidth=0.8, zorder=0)
        canvas.edges((d for d in known.explored), color=INK, linewidth=1.5, zorder=1)
        canvas.stubs(known.open, color=INK, linewidth=2, linestyle=(0, (2, 1)), zorder=2)
        canvas.vertices(set(range(world.map.vertex_count)) - seen, fill=PAPER, ink=FAINT)
        canvas.vertices(seen, fill=PAPER)
        canvas.vertices([world.map.vertex_of[world.start]], fill=INK)
        canvas.pointer(world.map.turn(world.start, world.first.bearing or 0))
        return canvas


def figure_2() -> Augmentation:
    """The passes of a run in the cube."""
    told = run("algorithm1", World(named_map(WORLD), "directional"))
    passes = list(_passes(told))
    adding = next(p for p in passes if not p.is_loop and len(p.hypotheses) > 1)
    closing = next(p for p in passes if p.is_loop and len(p.hypotheses) > 1)
    return Augmentation(told, (adding, closing))


def _passes(told: Any) -> Iterator[PassDrawn]:
    map_, start = told.world.map, told.world.start
    trail = [start]
    actions = told.outcome.episode.transcript.actions
    for action in actions:
        assert isinstance(action, Move)
        trail.append(map_.alpha[map_.turn(trail[-1], action.k)])
    beginning = KnownDarts(frozenset(), frozenset(map_.vertices[map_.vertex_of[start]]))
    stages = [(0, beginning)]
    for steps, shown in told.outcome.episode.checkpoints:
        stages.append((steps, _in_world(shown, map_, trail[steps])))
    told_apart = [stage for stage in pairwise(stages) if stage[0][1] != stage[1][1]]
    for number, ((begun, before), (ended, after)) in enumerate(told_apart, 1):
        left = (map_.alpha[dart] for dart in trail[begun + 1 : ended + 1])
        e = next(dart for dart in left if dart in before.open)
        percepts = told.world.percepts
        alike = [d for d in sorted(before.open - {e}) if percepts[d] == percepts[map_.alpha[e]]]
        yield PassDrawn(number, before, after, e, tuple(alike), ended - begun)


def _in_world(shown: Checkpoint, map_: CombinatorialMap, here: int) -> KnownDarts:
    """The darts of the world that S and U are: S is laid on it from the robot's dart on."""
    place = {shown.here: here}
    queue = [shown.here]
    for dart in queue:
        onwards = [(shown.sigma[dart], map_.sigma[place[dart]])]
        if shown.alpha[dart] != dart:
            onwards.append((shown.alpha[dart], map_.alpha[place[dart]]))
        for other, true in onwards:
            if other not in place:
                place[other] = true
                queue.append(other)
    is_open = {dart for dart in place if shown.alpha[dart] == dart}
    return KnownDarts(
        frozenset(true for dart, true in place.items() if dart not in is_open),
        frozenset(place[dart] for dart in is_open),
    )
