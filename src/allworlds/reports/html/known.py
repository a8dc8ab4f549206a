"""What an explorer knows, growing beside the world: the S that it shows in its checkpoints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from xml.etree import ElementTree as ET

from allworlds.engines import SingleRun
from allworlds.judging import true_trail
from allworlds.maps import Dart
from allworlds.reports.drawing.layout import Layout
from allworlds.reports.drawing.scene import Scene
from allworlds.reports.html.viewer import figure
from allworlds.reports.markup import tag
from allworlds.studies.run import Hypothesis, embedded


@dataclass(frozen=True, slots=True)
class ShownMap:
    """What has been shown of the world, each with the step after which it was shown first.

    Attributes:
        darts: those in S.
        edges: those of which S knows both ends, by each of their darts.
    """

    darts: dict[Dart, int]
    edges: dict[Dart, int]


def known(run: SingleRun) -> ShownMap | None:
    """What a run has shown in its checkpoints; None if it has shown nothing, or what is not so."""
    episode, world = run.outcome.episode, run.world
    if not episode.checkpoints:
        return None
    trail = true_trail(world, episode.transcript)
    seen = ShownMap({}, {})
    for step, checkpoint in episode.checkpoints:
        place = embedded(checkpoint, world, trail[step])
        if place is None:
            return None
        for dart, other in enumerate(checkpoint.alpha):
            seen.darts.setdefault(place[dart], step)
            if other != dart:
                seen.edges.setdefault(place[dart], step)
    return seen


def known_figure(
    scene: Scene, seen: ShownMap, name: str, drawn: Layout, tests: Sequence[Hypothesis] = ()
) -> ET.Element:
    """S as a part of the world: what is not known yet is faint, and open darts are dashed.

    If there are tests, the legend says how they are shown.
    """
    told = figure("What the explorer knows (S)", scene, name, "known", drawn)
    map_ = scene.map
    for part in told.iter():
        if (darts := part.get("data-darts")) is not None:
            dart = int(darts.split()[0])
            part.set("data-since", str(seen.edges.get(dart, NEVER)))
        elif (vertex := part.get("data-vertex")) is not None:
            first = map_.vertices[int(vertex)][0]
            part.set("data-since", str(seen.darts.get(first, NEVER)))
        elif (stub := part.get("data-stub")) is not None:
            explored = seen.edges.get(int(stub))
            part.set("class", "stub open" if explored is None else "stub open gone")
            part.set("data-since", str(seen.darts.get(int(stub), NEVER)))
            part.set("data-until", str(NEVER if explored is None else explored))
    legend = told[-1]
    legend.append(tag("span", "open: not explored yet", class_="key known-key"))
    if tests:
        legend.append(tag("span", "under test: has it come by this dart?", class_="key tested-key"))
        legend.append(tag("span", "where it is if so", class_="key supposed-key"))
    return told


NEVER = 10**9
"""The step after which something is known that never is."""
