"""The wrong convention of an explorer, if it is right behind a translator."""

from __future__ import annotations

from itertools import islice

from allworlds.explorers import CONVENTIONS, TRANSLATED
from allworlds.judging.findings.finding import Finding
from allworlds.maps import DEFAULT_EDGES, Extent, rooted_maps
from allworlds.words import plural
from allworlds.world import World

LARGEST = 3
"""The number of edges up to which a trial goes where the finding's world has fewer."""

ENOUGH = 200
"""The number of worlds below which a trial goes on with larger ones, within the extent."""

MOST = 4000
"""The largest number of worlds of a trial, and of maps of a size for them.  Under
the directional lighthouse that is enough for every finding with up to four edges (3684 worlds), and
in simple maps for those with up to six."""

LAWS = ("map", "pose", "budget", "no-estimate", "invariant-1", "invariant-2", "variant")
"""The laws that an explorer with a wrong convention breaks, if it does not crash."""

RAISED = "Traceback (most recent call last)"
"""The beginning of a crash that may be another one behind a translator: an error in Python."""


def may_be_misread(finding: Finding) -> bool:
    """Whether a wrong convention may be the cause."""
    raised = finding.law == "crash" and finding.detail.startswith(RAISED)
    return finding.law in LAWS or raised


def trial_worlds(finding: Finding, extent: Extent) -> list[World]:
    """All worlds up to the finding's size; larger ones, too, until they are enough.

    They are of the extent's class and condition, with every place of the finding's lighthouse.
    The list is empty if these are more than ``MOST``, or the maps of a size are.
    """
    kind, worlds = finding.rules.kind, list[World]()
    due = max(LARGEST, finding.world.map.edge_count)
    for edges in range(1, max(due, min(DEFAULT_EDGES, extent.levels[-1])) + 1):
        if edges > due and len(worlds) >= ENOUGH:
            break
        maps = [*islice(rooted_maps(edges, extent.map_class), MOST + 1)]
        every = (World(m, at, 0) for m in maps if extent.admits(m) for at in kind.places(m, 0))
        level = [*islice(every, MOST + 1)]
        if max(len(maps), len(worlds) + len(level)) > MOST:
            return worlds if edges > due else []
        worlds += level
    return worlds


def misread_name(finding: Finding) -> str:
    """The name of the slip, such as ``bearings anticlockwise``; empty where none is known."""
    return finding.misreading.convention.replace("-", " ") if finding.misreading else ""


def tell_misreading(finding: Finding) -> list[str]:
    """Tell the wrong convention; no sentence where none is known."""
    shown = finding.misreading
    if shown is None:
        return []
    convention = CONVENTIONS[shown.convention]
    name = f"{TRANSLATED}{shown.convention}:{finding.explorer}"
    runs = f"{plural(shown.runs, 'run')} in the class {shown.among}"
    others = f"any of the {runs} with up to {plural(shown.edges, 'edge')}"
    told = f"The explorer {convention.wrong}. Once that is put right for it, it breaks no law here"
    return [
        f"{told}, nor in {others}.",
        convention.right,
        f"To see it so, check '{name}'.",
    ]
