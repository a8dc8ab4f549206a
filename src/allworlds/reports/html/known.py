"""What an explorer knows, growing beside the world: the S that it shows in its checkpoints."""

from __future__ import annotations

from dataclasses import dataclass
from xml.etree import ElementTree as ET

from allworlds.checker import SingleRun
from allworlds.drawing import Layout, Scene
from allworlds.findings import true_trail
from allworlds.maps.combinatorial import Dart
from allworlds.markup import tag
from allworlds.protocol import Checkpoint
from allworlds.reports.html.viewer import figure
from allworlds.world import World


@dataclass(frozen=True, slots=True)
class Known:
    """What has been shown of the world, each with the step after which it was shown first.

    Attributes:
        darts: those in S.
        edges: those of which S knows both ends, by each of their darts.
    """

    darts: dict[Dart, int]
    edges: dict[Dart, int]


def known(run: SingleRun) -> Known | None:
    """What a run has shown in its checkpoints; None if it has shown nothing, or what is not so."""
    episode, world = run.outcome.episode, run.world
    if not episode.checkpoints:
        return None
    trail = true_trail(world, episode.transcript)
    seen = Known({}, {})
    for step, checkpoint in episode.checkpoints:
        place = _embedded(checkpoint, world, trail[step])
        if place is None:
            return None
        for dart, other in enumerate(checkpoint.alpha):
            seen.darts.setdefault(place[dart], step)
            if other != dart:
                seen.edges.setdefault(place[dart], step)
    return seen


def _embedded(checkpoint: Checkpoint, world: World, robot: Dart) -> dict[Dart, Dart] | None:
    """The dart of the world for each dart of S; None if S does not lie so in the world."""
    sigma, alpha, map_ = checkpoint.sigma, checkpoint.alpha, world.map
    place = {checkpoint.here: robot}
    for dart in (queue := [checkpoint.here]):
        around = [(sigma[dart], map_.sigma[place[dart]])]
        if alpha[dart] != dart:
            around.append((alpha[dart], map_.alpha[place[dart]]))
        for near, true in around:
            if near not in place:
                place[near] = true
                queue.append(near)
            elif place[near] != true:
                return None
    return place if len(place) == len(sigma) else None


def known_figure(scene: Scene, seen: Known, name: str, drawn: Layout) -> ET.Element:
    """S as a part of the world: what is not known yet is faint, and open darts are dashed."""
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
    return told


NEVER = 10**9
"""The step after which something is known that never is."""
