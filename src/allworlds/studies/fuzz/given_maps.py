"""Runs in given maps, and the smallest finding that shrinking reaches from these maps.

*Shrinking* replaces the world of a finding by smaller worlds in which the explorer breaks a law,
too (:mod:`allworlds.studies.fuzz.shrinking`).
"""

from collections.abc import Iterable

from allworlds.engines import lanes, single, sweep
from allworlds.engines.limits import deadline_after
from allworlds.engines.listeners import NOBODY
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import Scope
from allworlds.explorers import sources
from allworlds.judging.findings.finding import Finding
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.studies.check import hints
from allworlds.studies.check.report import ManyWorlds
from allworlds.studies.fuzz.shrinking import in_chunks, placed_rootings, smallest_from
from allworlds.world import selection


class MapsRequest(ManyWorlds, sources.ExplorerOptions, selection.WhereOptions):
    """Request for runs in given maps: explorer, class, condition, rules of the runs, and limits."""


def refuted_in(maps: Iterable[CombinatorialMap], request: MapsRequest) -> Finding | None:
    """The smallest finding that shrinking reaches from these maps; None if no law is broken.

    The explorer starts at every dart of each map, with every place of the lighthouse.  Maps that
    are not in the class, or do not satisfy the condition, are left out.

    Args:
        maps: maps of any size.
        request: the explorer, the class, the condition, the rules and the limits.

    Raises:
        InputError: naming the offending option and what would be legal.
        TimeIsUp: at the time limit.
        Unsettled: if the explorer's process ended, and the cause cannot be decided.

    Cost: O(m) runs for each map with m edges.
    """
    limits = request.limits
    subject = single.subject_of(request.explore, limits)
    rules = request.rules(subject)
    tried = [*maps]
    most = max((map_.edge_count for map_ in tried), default=1)
    scope = Scope(Extent(request.map_class, most, where=request.where), rules)
    given = [world for _, world in placed_rootings(tried, scope)]
    if not given:
        return None
    tally = Tally(keep=1)
    with lanes.workers_for(subject, limits, deadline_after(limits.time_limit)) as workers:
        sweep.gather(workers, RunCounter(scope, tally.keep), in_chunks(given), tally, NOBODY)
        for found in tally.findings:
            smallest = smallest_from(found, workers, scope)
            return hints.located(single.played_again(smallest, subject, limits), subject, limits)
    return None
