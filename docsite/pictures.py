"""Figures and the gallery, drawn and run by the program itself when the site is built.

A page asks for a figure of the table by ``<!-- figure NAME -->`` in a line of its own.
"""

from __future__ import annotations

import json
import re
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from html import escape
from itertools import count
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

import allworlds
from allworlds import Estimate, Finding
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.documents.document import replace
from allworlds.judging.walk import Walk
from allworlds.maps.combinatorial import CombinatorialMap, isomorphism
from allworlds.reports.drawing.svg import picture
from allworlds.reports.parts import Scene, scene_of, walk_in_answer, walk_in_world
from allworlds.words import size as words_of_size
from allworlds.world import Directional, World, world_named
from allworlds.world.named import own_corpus

GENUS_2 = World(
    CombinatorialMap((1, 2, 3, 4, 5, 6, 7, 0), (4, 5, 6, 7, 0, 1, 2, 3)), Directional(0)
)
"""One vertex, four loops, each crossing all others: one face."""

FIGURE = re.compile(r"^<!-- figure ([a-z0-9-]+) -->$", re.MULTILINE)
NOT_RUN = re.compile(r"^<!-- not run: ([^\n]*) -->\n(```.*?^```$)", re.MULTILINE | re.DOTALL)
ROOT = Path(__file__).parents[1]
_ids = count(1)


def drawing(*scenes: Scene, caption: str) -> str:
    """Scenes side by side as a part of a page, which has no empty line in it."""
    drawn = []
    for scene in scenes:
        svg = picture(scene, f"figure-{next(_ids)}", caption)
        drawn.append(ET.tostring(svg, encoding="unicode").replace("\n", ""))
    below = f"<figcaption>{escape(caption)}</figcaption>"
    return f'<figure class="worlds"><div>{"".join(drawn)}</div>{below}</figure>'


# ---------------------------------------------------------------- figures


@dataclass(frozen=True, slots=True)
class Figure:
    """A figure: scenes side by side, and the sentence below them."""

    caption: str
    scenes: Callable[[], list[Scene]]


def _plain(*names: str) -> Callable[[], list[Scene]]:
    return lambda: [scene_of(world_named(name, "none")) for name in names]


def _lit(name: str, lighthouse: str) -> Callable[[], list[Scene]]:
    return lambda: [scene_of(world_named(name, lighthouse))]


def _mirrored() -> list[Scene]:
    """The first map with its mirror image that is another one."""
    for world in allworlds.worlds(edges=4, lighthouse="none"):
        map_ = world.map
        if not isomorphism(map_, map_.mirrored()):
            return [Scene(map_), Scene(map_.mirrored())]
    raise PluginError("every map with at most 4 edges is its own mirror image")


def _walked() -> list[Scene]:
    """A robot after its first motion."""
    world = world_named("theta", "directional")
    dart = world.map.alpha[world.start]
    return [replace(scene_of(world), robot=dart, walked={dart})]


FIGURES = {
    "map": Figure(
        "A map with 3 edges and 2 vertices. A number stands at each dart; the darts 0, 1, 2 "
        "follow each other clockwise round v0. The start is the dart in the box.",
        _plain("theta"),
    ),
    "same-graph": Figure(
        "One graph, two maps: on the left in the plane, on the right with another order round v1, "
        "which fits a torus only. Where edges cross, they do not meet.",
        _plain("theta", "theta-torus"),
    ),
    "loops": Figure(
        "Two loops at one vertex, side by side (three faces, the plane) and crossing (one face, "
        "the torus).",
        _plain("two-loops-plane", "two-loops-torus"),
    ),
    "mirror": Figure(
        "A map and its mirror image, which is another map: no bijection of the darts keeps the "
        "clockwise order and the edges.",
        _mirrored,
    ),
    "world": Figure(
        "A world with a directional lighthouse: the marker at v0 points along a dart.",
        _lit("k4", "directional"),
    ),
    "walked": Figure(
        "After Move(0): the robot has left by dart 0, and stands at the other dart of that edge.",
        _walked,
    ),
    "cluster": Figure(
        "A cluster: one marker at v0, two at a neighbour. There is no direction to be sensed.",
        _lit("k4", "cluster"),
    ),
    "compass": Figure(
        "A compass: at every vertex one dart is its north; no vertex is marked.",
        _lit("k4", "compass"),
    ),
    "twins": Figure(
        "Twins: whatever a robot does that senses the marker's position but no direction, it "
        "senses the same in both worlds.",
        lambda: [
            scene_of(world_named(name, "position"))
            for name in ("two-loops-plane", "two-loops-torus")
        ],
    ),
}


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """The page with its figures; below a block that asks much of a machine stands what it asks."""
    return FIGURE.sub(lambda found: figure(found[1]), NOT_RUN.sub(_with_need, markdown))


NEEDS = ("needs", "takes", "goes on")
"""The beginnings of the reasons that readers are told; others are for the tests alone."""


def _with_need(block: re.Match[str]) -> str:
    told = block[1].startswith(NEEDS)
    return block[2] + (f'\n\n<p class="unrun">This {block[1]}.</p>' if told else "")


def figure(name: str) -> str:
    """The figure of that name, as a part of a page.

    Raises:
        PluginError: if the table has none.
    """
    if name not in FIGURES:
        raise PluginError(f"figure {name!r} is not one of {', '.join(FIGURES)}")
    return drawing(*FIGURES[name].scenes(), caption=FIGURES[name].caption)


def refutation(finding: Finding) -> list[Scene]:
    """The world of a finding, and the explorer's answer, if it is a map."""
    walk = Walk.of(finding.world, finding.transcript.actions)
    scenes = [walk_in_world(walk)]
    if isinstance(finding.seen, Estimate):
        scenes.append(walk_in_answer(walk, finding.seen))
    return scenes


# ---------------------------------------------------------------- the gallery


@dataclass(frozen=True, slots=True)
class Live:
    """A page that a command writes: its name, and the command up to ``-o``."""

    name: str
    command: str
    told: str


def _about(kind: str) -> str:
    """The fault of a mutant, in one line."""
    (wrong,) = (wrong for wrong in WRONG_EXPLORERS if wrong.name == kind)
    return wrong.breaks.partition("\n")[0]


def lives() -> list[Live]:
    """The live pages, in the order of the gallery."""
    wrong = [
        Live(
            name,
            f"check allworlds.corpus.explorers:{name.replace('-', '_')} --edges {edges}",
            _about(name),
        )
        for name, edges in (
            ("one-hypothesis-only", 3),
            ("confirmed-too-early", 4),
            ("mirror-image", 4),
            ("orientation-not-restored", 3),
            ("lucky-guess", 4),
            ("marker-ignored", 4),
            ("walks-too-much", 3),
            ("crashes-at-leaves", 4),
        )
    ]
    return [
        *wrong,
        Live(
            "position-alone",
            "check algorithm1 --lighthouse position --edges 3",
            "Algorithm 1 where the marker has no direction: worlds that no motion tells apart.",
        ),
        Live(
            "one-marker",
            "check dudek91 --edges 3",
            "One movable marker, where loops and parallel edges are, for which it was not made.",
        ),
        Live("holds", "check --edges 4", "Algorithm 1: what a page says where nothing is wrong."),
    ]


def walks() -> list[Live]:
    """The live pages of walks without a finding, in the order of the gallery."""
    return [
        Live("be-the-robot", "play theta-torus", "You see what a robot senses, and nothing else."),
        Live(
            "algorithm-1",
            "run algorithm1 k4-torus",
            "Algorithm 1 in K4 on the torus: its map S grows.",
        ),
        Live(
            "genus-2",
            f"run algorithm1 '{json.dumps(GENUS_2.to_json())}'",
            "Four loops on a surface of genus 2: edges that cross do not meet.",
        ),
        Live(
            "figure-1",
            "ambiguity twins fig1-left fig1-right",
            "The twins of the paper's Fig. 1: one walk in both, and the same is sensed.",
        ),
        Live(
            "ambiguity",
            "ambiguity class k4 --class simple",
            "All simple worlds that a robot that senses the marker's position takes for K4.",
        ),
        Live(
            "worst-runs",
            "worst --edges 3",
            "The costs of Algorithm 1, and the most expensive schedule.",
        ),
    ]


LARGEST = 1_000_000
"""No live page has more bytes."""


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """The gallery, and the live pages in it."""
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        told = list(pool.map(lambda live: _made(live, Path(folder)), [*lives(), *walks()]))
        for live, _ in told:
            text = (Path(folder) / f"{live.name}.html").read_text(encoding="utf-8")
            if len(text.encode()) > LARGEST:
                raise PluginError(f"the page of allworlds {live.command} is larger than 1 MB")
            files.append(File.generated(config, f"gallery/live/{live.name}.html", content=text))
    findings = told[: len(lives())]
    files.append(File.generated(config, "gallery/findings.md", content=_findings(findings)))
    files.append(File.generated(config, "gallery/walks.md", content=_walks(walks())))
    files.append(File.generated(config, "gallery/worlds.md", content=_worlds()))
    return files


def _made(live: Live, folder: Path) -> tuple[Live, dict[str, Any]]:
    """The page is written; what the command says of it."""
    words = [*shlex.split(live.command), "-o", str(folder / f"{live.name}.html"), "--json"]
    done = subprocess.run(
        [sys.executable, "-m", "allworlds", *words], capture_output=True, text=True, check=False
    )
    if done.returncode not in (0, 1):
        raise PluginError(f"allworlds {live.command} ends with {done.returncode}: {done.stderr}")
    return live, json.loads(done.stdout)


def _findings(told: list[tuple[Live, dict[str, Any]]]) -> str:
    return (
        "# Findings\n\nEach of these pages was written by the command above it, with `-o`, "
        "when this site was built. Step along the walk with the arrow keys.\n\n"
        + "".join("\n".join(_card(live, report)) + "\n\n" for live, report in told)
    )


def _walks(told: list[Live]) -> str:
    text = (
        "# Walks\n\nEach of these pages was written by the command above it when this site was "
        "built.\n"
    )
    for live in told:
        command = f"allworlds {live.command} -o {live.name}.html"
        text += (
            f"\n## {live.name.replace('-', ' ').capitalize()}\n\n{live.told}\n\n"
            f"```sh\n{command}\n```\n\n[Open the page](live/{live.name}.html)\n"
        )
    return text


def _card(live: Live, report: dict[str, Any]) -> Iterator[str]:
    words = live.name.replace("-", " ").capitalize()
    command = f"allworlds {live.command} -o {live.name}.html"
    yield f"## {words}\n\n{live.told}\n\n```sh\n{command}\n```\n"
    said = f"Verdict: **{report['verdict']}**."
    for found in report["findings"][:1]:
        finding = Finding.from_json(found)
        size = words_of_size(finding.world.map.edge_count, finding.world.map.vertex_count)
        said = f"Verdict: **{report['verdict']}**, law `{finding.law}`."
        scenes = refutation(finding)
        beside = ", and beside it the answer" if len(scenes) > 1 else ""
        caption = f"The smallest world that refutes it, with {size}{beside}."
        yield drawing(*scenes, caption=caption) + "\n"
    yield f"{said} [Open the page](live/{live.name}.html)"


def _worlds() -> str:
    corpus = own_corpus()
    text = (
        "# Worlds\n\nThe named worlds of the corpus, drawn by `reports.drawing`; `allworlds run "
        "NAME` runs Algorithm 1 in one.\n"
    )
    for entry in corpus.of_kind("world"):
        world = World.from_json(corpus.document(entry))
        map_ = world.map
        size = (
            f"{map_.edge_count} edges, {map_.vertex_count} vertices, {len(map_.faces)} faces, "
            f"genus {map_.genus}"
        )
        told = entry.provenance[0].upper() + entry.provenance[1:]
        text += f"\n## {entry.name}\n\n{told}.\n\n{drawing(scene_of(world), caption=size)}\n"
    return text
