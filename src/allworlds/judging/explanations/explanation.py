"""A finding in words, and the wrong conventions that may be behind it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Annotated

from allworlds.document.report import Report
from allworlds.document.struct import Aside, Natural, Positive, Some, Text, about, computed
from allworlds.explorers.names import TRANSLATED
from allworlds.explorers.translated import CONVENTIONS
from allworlds.inputs.checks import InputError, show
from allworlds.judging.explanations.by_law import teller_of
from allworlds.judging.explanations.slips import mirror_image
from allworlds.judging.explanations.story import Belief, Spending, Story
from allworlds.judging.findings.finding import Chirality, Finding
from allworlds.judging.laws.law_table import LawName
from allworlds.maps.canonical import isomorphism
from allworlds.maps.classes import DEFAULT_EDGES, Extent, MapClass
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.maps.enumeration import rooted_maps
from allworlds.protocol.answers import Estimate
from allworlds.words import plural, size
from allworlds.world.world import World

LARGEST_CHIRAL = 5
"""The largest number of edges of the chiral worlds: each class has some."""

NARROWEST = (MapClass.PLANAR_SIMPLE, MapClass.SIMPLE, MapClass.PLANAR, MapClass.MAPS)
"""The classes, each before those that hold it: an explorer may be made for one of them alone."""


def needs_a_chiral_world(finding: Finding) -> bool:
    """Whether the answer is wrong as a mirror image would be, in a world that cannot tell."""
    return finding.law == "pose" and bool(mirror_image(Belief(Story(finding))))


def chiral_worlds(finding: Finding) -> Iterator[World]:
    """Worlds like the finding's that are not their own mirror image, small ones first.

    They have its lighthouse, and are simple or planar where its world is.
    """
    for edges in range(1, LARGEST_CHIRAL + 1):
        for map_ in rooted_maps(edges, narrowest_class(finding)):
            place = next(iter(finding.rules.kind.places(map_, 0)), None)
            if place and not isomorphism(map_, map_.mirrored()):
                yield World(map_, place, 0)


def narrowest_class(finding: Finding) -> MapClass:
    """The narrowest of the usual classes that holds the finding's world."""
    return next(each for each in NARROWEST if each.includes(finding.world.map))


def chirality_in(world: World, answer: CombinatorialMap) -> Chirality | None:
    """The sense that an answer in a chiral world shows; None if it is neither map nor image."""
    edges = size(world.map.edge_count, world.map.vertex_count)
    where = f"a world with {edges}, which is not its own mirror image"
    if isomorphism(answer, world.map):
        return Chirality("clockwise", where)
    if isomorphism(answer.mirrored(), world.map):
        return Chirality("anticlockwise", where)
    return None


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


class Explanation(Report):
    """Report of 'explain'.

    Vertices and darts are those of the world, in the numbering of the finding.

    ``spent`` tells what the traversals were spent on, where they were too many.
    """

    explorer: Annotated[str, about("its name")] = computed(lambda told: told.finding.explorer)
    law: Annotated[LawName, about("the broken one")] = computed(lambda told: told.finding.law)
    step: Annotated[
        Natural | None,
        about(
            "the first at which the walk in the world and the same walk in the answer part; 0 is "
            "the start, null: at none"
        ),
    ]
    sentences: Annotated[Some[Text], about("in plain words")]
    world: Annotated[World, about("that of the finding")] = computed(
        lambda told: told.finding.world
    )
    robot: Annotated[Dart, about("where the robot is at the end")]
    answer: Annotated[Estimate | None, about("the wrong answer; null where the finding holds none")]
    other: Annotated[
        World | None,
        about("under the law `folding` another world that agrees with the log; else null"),
    ]
    slip: Annotated[
        Text | None,
        about(
            "the one difference between answer and world, such as "
            "`mirror image`; null: none that is known"
        ),
    ]
    number: Annotated[Positive, about("the number of the finding in its report; 1: the first")]
    findings: Annotated[Positive, about("how many findings the report holds")]
    finding: Aside[Finding]
    spent: Aside[Spending | None] = None


def explain(
    finding: Finding,
    *,
    number: int = 1,
    findings: int = 1,
) -> Explanation:
    """The finding in plain words.

    Args:
        finding: the one that is explained.
        number: of the finding in its report, from 1 on.
        findings: the number of findings in the report.

    Raises:
        InputError: if its transcript is no walk in its world, or its answer is none.
    """
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    story = Story(finding)
    telling = teller_of(finding.law)(story)
    misread = tell_misreading(finding)
    return Explanation(
        step=telling.step,
        sentences=(*misread, *telling.sentences),
        robot=story.walked[-1],
        answer=telling.answer,
        other=telling.other,
        slip=misread_name(finding) or telling.slip or None,
        number=number,
        findings=findings,
        finding=finding,
        spent=telling.spent,
    )
