"""Draw ``docs/assets/refutation.svg``: how the first explorer of the README is refuted.

``python docs/figures/refutation.py`` runs ``check`` with ``examples/first/mine.py``, and draws the
finding: the world on the left, the explorer's answer on the right.
"""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree as ET

from frame import framed

import allworlds
from allworlds import Estimate, Finding
from allworlds.judging.walk import Walk
from allworlds.reports.drawing.layout import layout
from allworlds.reports.drawing.svg import picture, tag
from allworlds.reports.parts import Scene, walk_in_answer, walk_in_world

ROOT = Path(__file__).parents[2]
FILE = ROOT / "docs" / "assets" / "refutation.svg"

WIDE, HIGH = 640, 300
STYLE = """\
.edge { fill: none; stroke: #5a646d; stroke-width: 2; }
.bridge { fill: none; stroke: #fdfdfb; stroke-width: 11; }
.stub, .robot, .clockwise { display: none; }
.pole { fill: none; stroke: #c26a00; stroke-width: 3; }
.flag { fill: #c26a00; }
.disc { fill: #e4eaf0; stroke: #1c2126; stroke-width: 1.5; }
.marked .disc { fill: #ffe3b0; stroke: #c26a00; stroke-width: 3; }
.name { font-size: 11px; }
.dart text { paint-order: stroke; stroke: #fdfdfb; stroke-width: 4px; }
.box { fill: none; }
.start .box { fill: #fdfdfb; stroke: #1c2126; }
.start text { stroke: none; }
.title { font-size: 15px; }
.wrong { fill: #b3261e; }
"""


def found() -> Finding:
    """The smallest world that refutes the explorer of the README."""
    file = ROOT / "examples" / "first" / "mine.py"
    report = allworlds.check(f"{file}:explore", lighthouse="labels", edges=4, workers=1)
    return report.findings[0]


def figure(finding: Finding) -> ET.Element:
    """The world and the answer, side by side."""
    answer = finding.seen
    assert isinstance(answer, Estimate), f"a finding of the law {finding.law} has no answer"
    edges = finding.world.map.edge_count
    walk = Walk.of(finding.world, finding.transcript.actions)
    world, believed = walk_in_world(walk), walk_in_answer(walk, answer)
    scale = min(map(_scale, (world, believed)))
    return framed(
        "A world that refutes an explorer, and the explorer's answer",
        STYLE,
        WIDE,
        HIGH,
        _half(world, 0, scale, "The world", "world"),
        _half(believed, 1, scale, "The answer", "answer wrong"),
        tag(
            "text",
            f"law '{finding.law}' is broken; no world with fewer than {edges} edges shows it",
            x=WIDE // 2,
            y=HIGH - 22,
        ),
    )


def _scale(scene: Scene) -> float:
    """The largest scale at which a scene fits into its half."""
    _, _, width, height = layout(scene.map, scene.start).box(30)
    return min((HIGH - 90) / height, WIDE / 2 / width)


def _half(scene: Scene, side: int, scale: float, title: str, class_: str) -> ET.Element:
    """One of the two pictures, under its title."""
    left, top, width, height = layout(scene.map, scene.start).box(30)
    x, y = WIDE / 4 * (1 + 2 * side), (HIGH - 20) / 2
    shift = f"{x - scale * (left + width / 2):.1f} {y - scale * (top + height / 2):.1f}"
    drawn = picture(scene, class_.partition(" ")[0], title)
    return tag(
        "g",
        tag("text", title, class_=f"title {class_}", x=round(x), y=24),
        tag("g", *drawn, transform=f"translate({shift}) scale({scale:.3f})"),
    )


def main() -> None:
    """Write the file."""
    FILE.write_text(ET.tostring(figure(found()), "unicode") + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
