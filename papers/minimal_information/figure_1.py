"""Fig. 1: two different worlds that no motion tells apart, with the motions of the caption."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import Any

from msgspec import Struct

from allworlds import Move, Percept, World, ambiguity
from allworlds.maps import named_map
from canvas import FAINT, INK, PAPER, Canvas
from drawn import Table

MOTIONS = (1, 1, 2, 2, 1)
"""M of the caption."""

CAPTION = ((3, 0), (3, 0), (3, 0), (3, 0), (4, 1))
"""P of the caption: degree and markers after each motion."""

CLASSES = ("tab:blue", "tab:green", "tab:red", "tab:purple", "tab:brown", "tab:pink", "tab:cyan")
"""The colours of the classes; the walk's is none of them."""

WALK = "#ff9d1f"

PAIR = ("fig1-left", "fig1-right")


class TwinsFigure(Struct, frozen=True):
    """The pair, the proof that it is one, and the caption's walk in both."""

    compared: Any
    walks: tuple[Sequence[tuple[int, Percept]], Sequence[tuple[int, Percept]]]

    @property
    def right(self) -> bool:
        """Whether the proof is right, the maps differ, and both walks sense what the paper says."""
        said = [[(seen.degree, seen.marks) for _, seen in walk[1:]] for walk in self.walks]
        as_said = all(tuple(senses) == CAPTION for senses in said)
        different = self.compared.relation == "different"
        proved = not self.compared.distinguishable
        return bool(as_said and different and proved)

    def table(self) -> Table:
        """Rows, one for each step: the motion, and the dart and the percept in both worlds."""
        header = ["step", "motion", "left_dart", "left_degree", "left_marks"]
        header += ["right_dart", "right_degree", "right_marks"]
        rows = []
        for step, (left, right) in enumerate(zip(*self.walks, strict=True)):
            motion = MOTIONS[step - 1] if step else None
            sensed = [part for dart, p in (left, right) for part in (dart, p.degree, p.marks)]
            rows.append([step, motion, *sensed])
        return header, rows

    def caption(self) -> Sequence[str]:
        """The lines that stand below the figure."""
        motions = ", ".join(map(str, MOTIONS))
        sensed = " ".join(_sensed(percept) for _, percept in self.walks[0][1:])
        return (
            (
                "Two different maps with 9 vertices and 14 edges, an undirected marker at the "
                "black vertex v0. The darts stand round every vertex in their true cyclic order."
            ),
            (
                "Darts of one colour are of one class of a bisimulation, which was checked: "
                "wherever a motion leads in one map, it leads to a dart of the same colour in the "
                "other, and there the same is sensed. So no motion tells the two worlds apart."
            ),
            (
                f"Orange: the motions {motions} of the paper's caption, numbered in the order of "
                f"the steps, from dart 0 of v0. Sensed in both: {sensed}, as the paper says (A: no "
                "marker, P: marker)."
            ),
            "The two maps differ in two edges, drawn thick.",
        )

    def draw(self, figure: Any) -> None:
        """Draw both worlds side by side."""
        panels = figure.subplots(1, 2)
        figure.set_size_inches(10, 5.6)
        for number, panel in enumerate(panels):
            self._panel(panel, number)
        figure.text(
            0.5,
            0.02,
            f"motions {', '.join(map(str, MOTIONS))}; sensed in both worlds: "
            + " ".join(_sensed(percept) for _, percept in self.walks[0][1:]),
            ha="center",
            fontsize=9,
        )

    def _panel(self, axes: Any, number: int) -> None:
        world, walk = self.compared.worlds[number], self.walks[number]
        other = self.compared.worlds[1 - number].map
        bisimulation = self.compared.bisimulation
        canvas = Canvas.of(axes, world.map, world.start)
        for dart, end in world.map.edges:
            own = other.alpha[dart] != end
            canvas.edges([dart], color=INK if own else FAINT, linewidth=2.6 if own else 1.2)
        steps = defaultdict(list)
        for i, (dart, _) in enumerate(walk[1:], 1):
            canvas.edges([dart], color=WALK, linewidth=2.2, zorder=2)
            steps[world.map.alpha[dart]].append(str(i))
        for dart, label in enumerate(bisimulation[number]):
            colour = CLASSES[label % len(CLASSES)]
            canvas.stubs([dart], color=colour, linewidth=4, solid_capstyle="round", zorder=3)
        canvas.vertices(range(world.map.vertex_count), fill=PAPER)
        canvas.vertices([world.map.vertex_of[world.start]], fill=INK)
        canvas.note(world.start, "start", fontstyle="italic")
        for dart, numbers in steps.items():
            canvas.note(dart, ", ".join(numbers), color="#b35806", fontweight="bold")
        axes.set_title("left" if number == 0 else "right")


def figure_1() -> TwinsFigure:
    """The pair of the paper, from the corpus."""
    left, right = (World(named_map(name), "position") for name in PAIR)
    return TwinsFigure(ambiguity.twins(left, right), (_walk(left), _walk(right)))


def _walk(world: World) -> list[tuple[int, Percept]]:
    """The dart and the percept at the start and after each motion."""
    state, walk = world.initial, [(world.start, world.first)]
    for motion in MOTIONS:
        state, percept = world.step(state, Move(motion))
        walk.append((state.dart, percept))
    return walk


def _sensed(percept: Percept) -> str:
    return f"[{percept.degree},{'P' if percept.marks else 'A'}]"
