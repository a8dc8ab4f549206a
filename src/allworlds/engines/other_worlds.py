"""A finding, confirmed, and its explorer in other worlds, and behind a translator, for its slip."""

from __future__ import annotations

from itertools import islice

from allworlds.document import replace
from allworlds.engines.isolation.apart import outcomes_apart
from allworlds.engines.isolation.confirm import played_again
from allworlds.engines.python.examiner import Outcome
from allworlds.engines.single import single_run
from allworlds.engines.units.effort import Limits
from allworlds.explorers import CONVENTIONS, Subject, with_translator
from allworlds.judging import (
    Answered,
    Chirality,
    Fault,
    Finding,
    Misreading,
    chiral_worlds,
    chirality_in,
    may_be_misread,
    needs_a_chiral_world,
    small_worlds,
)
from allworlds.protocol import Schedule
from allworlds.world import World

TRIED = 8
"""The number of chiral worlds that are tried before the question stays open."""


def confirmed(finding: Finding, subject: Subject, limits: Limits, schedules: Schedule) -> Finding:
    """The finding with everything that further plays of its explorer add; see its attributes."""
    again = played_again(finding, subject, limits, schedules)
    return played_elsewhere(again, subject, limits)


def played_elsewhere(finding: Finding, subject: Subject, limits: Limits) -> Finding:
    """The finding with what further plays of its explorer show of its slip."""
    return replace(
        finding,
        chirality=shown_chirality(finding, subject, limits),
        misreading=shown_misreading(finding, subject, limits),
    )


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


def shown_misreading(finding: Finding, subject: Subject, limits: Limits) -> Misreading | None:
    """The wrong convention of the explorer; None if it is none that is known.

    An explorer that no other process can import is not tried: it could not be stopped.
    """
    if not (subject.from_user and subject.importable and may_be_misread(finding)):
        return None
    others = [*small_worlds(finding)]
    for convention in CONVENTIONS:
        behind = with_translator(subject, convention)
        if all(_is_right(behind, finding, worlds, limits) for worlds in ([finding.world], others)):
            return Misreading(convention, len(others), max(w.map.edge_count for w in others))
    return None


def _is_right(subject: Subject, finding: Finding, worlds: list[World], limits: Limits) -> bool:
    outcomes = outcomes_apart(subject, finding.rules, worlds, limits, finding.hash_seed)
    return all(isinstance(one, Outcome) and one.violation is None for one in outcomes)
