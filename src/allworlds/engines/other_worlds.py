"""A finding, confirmed, and the explorer in another world if its own leaves the slip open."""

from __future__ import annotations

from itertools import islice

from allworlds.document import replace
from allworlds.engines.isolation.confirm import played_again
from allworlds.engines.single import single_run
from allworlds.engines.units.effort import Limits
from allworlds.explorers import Subject
from allworlds.judging import (
    Answered,
    Chirality,
    Fault,
    Finding,
    chiral_worlds,
    chirality_in,
    needs_a_chiral_world,
)
from allworlds.protocol import Schedule

TRIED = 8
"""The number of chiral worlds that are tried before the question stays open."""


def confirmed(finding: Finding, subject: Subject, limits: Limits, schedules: Schedule) -> Finding:
    """The finding with everything that further plays of its explorer add; see its attributes."""
    again = played_again(finding, subject, limits, schedules)
    return replace(again, chirality=shown_chirality(again, subject, limits))


def shown_chirality(finding: Finding, subject: Subject, limits: Limits) -> Chirality | None:
    """The explorer's sense of rotation in a chiral world; None if the finding does not need one.

    The explorer plays under the rules of the finding.
    """
    if not needs_a_chiral_world(finding):
        return None
    broken = ""
    for world in islice(chiral_worlds(finding), TRIED):
        ending = single_run(subject, world, finding.rules, (), limits).ending
        if isinstance(ending, Fault):
            broken = ending.law
            if broken == "timeout":  # the others would be waited for as long
                break
        if isinstance(ending, Answered) and (shown := chirality_in(world, ending.estimate.map)):
            return shown
    if broken:
        return Chirality("unknown", f"there the explorer breaks the law '{broken}'")
    return Chirality("unknown", "there its map is neither right nor a mirror image")
