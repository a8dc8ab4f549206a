"""A finding, confirmed, and its explorer in other worlds, and behind a translator, for its slip."""

from __future__ import annotations

from collections.abc import Callable
from itertools import islice

from allworlds.document.struct import replace
from allworlds.engines.effort import Limits
from allworlds.engines.examiner import Outcome
from allworlds.engines.single import outcomes_of, played_again, single_run
from allworlds.explorers.subject import Subject, with_translator
from allworlds.explorers.translated import CONVENTIONS
from allworlds.judging.endings import Answered, Fault
from allworlds.judging.explanations.explanation import (
    chiral_worlds,
    chirality_in,
    may_be_misread,
    narrowest_class,
    needs_a_chiral_world,
    trial_worlds,
)
from allworlds.judging.findings.finding import Chirality, Finding, Misreading
from allworlds.judging.findings.walks import true_trail
from allworlds.maps.canonical import rooted_isomorphism
from allworlds.maps.classes import DEFAULT_EDGES, Extent
from allworlds.world.lighthouses.options import InvalidWorld
from allworlds.world.world import World

TRIED = 8
"""The number of chiral worlds that are tried before the question stays open."""


def confirmed(
    finding: Finding,
    subject: Subject,
    limits: Limits,
    extent: Extent | None = None,
) -> Finding:
    """The finding with everything that further plays of its explorer add; see its attributes."""
    again = played_again(finding, subject, limits)
    return played_elsewhere(again, subject, limits, extent)


def played_elsewhere(
    finding: Finding, subject: Subject, limits: Limits, extent: Extent | None = None
) -> Finding:
    """The finding with what further plays of its explorer show of its slip.

    They are in worlds of the extent, if it is known in which the finding was found; else in those
    of the narrowest class that holds its world.
    """
    tried = extent or Extent(narrowest_class(finding), DEFAULT_EDGES)
    return replace(
        finding,
        chirality=shown_chirality(finding, subject, limits, tried),
        misreading=shown_misreading(finding, subject, limits, tried),
    )


def shown_chirality(
    finding: Finding, subject: Subject, limits: Limits, extent: Extent
) -> Chirality | None:
    """The explorer's sense of rotation in a chiral world; None if the finding does not need one.

    The explorer plays under the rules of the finding.  It is anticlockwise only if so read the
    answers are right in all worlds of a trial, too.
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
            known = shown.rotations == "clockwise" or _is_mirrored(subject, finding, limits, extent)
            why = "elsewhere its answers are not known to be mirror images"
            return shown if known else Chirality("unknown", why)
    if broken:
        return Chirality("unknown", f"there the explorer breaks the law '{broken}'")
    return Chirality("unknown", "there its map is neither right nor a mirror image")


def shown_misreading(
    finding: Finding, subject: Subject, limits: Limits, extent: Extent
) -> Misreading | None:
    """The wrong convention of the explorer; None if it is none that is known, or may be another.

    Behind the translator it breaks no law in the finding's world, in the mirror image, nor in any
    world of a trial; without, it breaks one in some of them, played in the same way.  An explorer
    that no other process can import is not tried: it could not be stopped.
    """
    if not (subject.from_user and subject.importable and may_be_misread(finding)):
        return None
    for convention in CONVENTIONS:
        behind, own = with_translator(subject, convention), _own_worlds(finding)
        if not _all_right(behind, finding, own, limits):
            continue
        trial = trial_worlds(finding, extent)
        if not trial or all(_all_right(subject, finding, each, limits) for each in (own, trial)):
            return None
        if _all_right(behind, finding, trial, limits):
            where = f", {extent.where}," if extent.where else ""
            most = max(world.map.edge_count for world in trial)
            return Misreading(convention, len(trial), most, f"{extent.map_class}{where}")
    return None


def _own_worlds(finding: Finding) -> list[World]:
    """The finding's world and its mirror image, if the lighthouse can stand there."""
    try:
        return [finding.world, finding.world.mirrored()]
    except InvalidWorld:
        return [finding.world]


def _all_right(
    subject: Subject,
    finding: Finding,
    worlds: list[World],
    limits: Limits,
    right: Callable[[World, Outcome], bool] = lambda _, outcome: outcome.violation is None,
) -> bool:
    """Whether each run in these worlds is right; the first that is not is the last one played."""
    outcomes = outcomes_of(
        subject, finding.rules, worlds, limits, twice=False, hash_seed=finding.hash_seed
    )
    return all(right(world, one) for world, one in outcomes)


def _is_mirrored(subject: Subject, finding: Finding, limits: Limits, extent: Extent) -> bool:
    """Whether each answer in a trial is right as a mirror image; not if there is no trial."""
    trial = trial_worlds(finding, extent)
    worlds = [*_own_worlds(finding), *trial]
    return bool(trial) and _all_right(subject, finding, worlds, limits, _is_right_mirrored)


def _is_right_mirrored(world: World, outcome: Outcome) -> bool:
    """Whether a run's answer is right if its rotations are read anticlockwise."""
    episode = outcome.episode
    if not isinstance(episode.ending, Answered):
        return False
    answer, robot = episode.ending.estimate, true_trail(world, episode.transcript)[-1]
    return bool(rooted_isomorphism(answer.map.mirrored(), answer.here, world.map, robot))
