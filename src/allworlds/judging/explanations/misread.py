"""The wrong convention of an explorer, if it is right behind a translator."""

from __future__ import annotations

from collections.abc import Iterator

from allworlds.explorers import CONVENTIONS, TRANSLATED
from allworlds.judging.explanations.chirality import narrowest_class
from allworlds.judging.findings.finding import Finding
from allworlds.maps import rooted_maps
from allworlds.words import plural
from allworlds.world import World

LARGEST = 3
"""The largest number of edges of the other worlds in which the explorer is tried."""

LAWS = ("map", "pose", "budget", "no-estimate", "invariant-1", "invariant-2", "variant")
"""The laws that an explorer with a wrong convention breaks, if it does not crash."""

RAISED = "Traceback (most recent call last)"
"""The beginning of a crash that may be another one behind a translator: an error in Python."""


def may_be_misread(finding: Finding) -> bool:
    """Whether a wrong convention may be the cause."""
    raised = finding.law == "crash" and finding.detail.startswith(RAISED)
    return finding.law in LAWS or raised


def small_worlds(finding: Finding) -> Iterator[World]:
    """All small worlds like the finding's, with every place of its lighthouse."""
    kind = finding.rules.kind
    for edges in range(1, LARGEST + 1):
        for map_ in rooted_maps(edges, narrowest_class(finding)):
            for place in kind.places(map_, 0):
                yield World(map_, place, 0)


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
    kind = narrowest_class(finding).value
    runs = f"{plural(shown.runs, 'run')} in the class {kind}"
    others = f"any of the {runs} with up to {plural(shown.edges, 'edge')}"
    told = f"The explorer {convention.wrong}. Once that is put right for it, it breaks no law here"
    return [
        f"{told}, nor in {others}.",
        convention.right,
        f"To see it so, check '{name}'.",
    ]
