"""Fuzzing in given maps, from the explorer's first run to the smallest finding."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from allworlds.engines import (
    RunCounter,
    Scope,
    Silent,
    Tally,
    confirmed,
    gather,
    subject_of,
    workers_for,
)
from allworlds.judging import Finding
from allworlds.maps import CombinatorialMap, Extent
from allworlds.studies.fuzz.drive import smallest_from
from allworlds.studies.fuzz.fuzz_request import MapsRequest
from allworlds.studies.fuzz.shrink import in_chunks, rootings
from allworlds.world import World


def refuted_in(maps: Iterable[CombinatorialMap], request: MapsRequest) -> Finding | None:
    """The smallest finding that the shrinker reaches from these maps; None where no law is broken.

    The explorer starts at every dart of each map, with every place of the lighthouse.  Maps
    that are not of the class, or of which the condition is not true, are left out.

    Args:
        maps: of any size.
        request: for an explorer, the class, a condition, rules and limits.

    Raises:
        InputError: naming the offending option and what would be legal.
        TimeIsUp: at the time limit.
        Unsettled: if what happened to the explorer cannot be told.

    Cost: O(m) runs for each map with m edges.
    """
    limits = request.limits
    subject = subject_of(request.explore, limits)
    rules = request.rules(subject)
    met = [*maps]
    most = max((map_.edge_count for map_ in met), default=1)
    scope = Scope(Extent(request.map_class, most, where=request.where), rules)
    given = [*_rooted(met, scope)]
    if not given:
        return None
    tally = Tally(keep=1)
    with workers_for(subject, limits, limits.deadline()) as workers:
        gather(workers, RunCounter(scope, tally.keep), in_chunks(given), tally, Silent())
        for found in tally.findings:
            smallest = smallest_from(found, workers, scope)
            return confirmed(smallest, subject, limits, scope.extent)
    return None


def _rooted(maps: Iterable[CombinatorialMap], scope: Scope) -> Iterator[tuple[World, int]]:
    """Rooted maps with every place, each once, smallest first."""
    for *_, code in rootings(maps, scope.extent):
        map_ = CombinatorialMap.trusted(*code)
        for place, lighthouse in enumerate(scope.rules.kind.places(map_, 0)):
            yield World(map_, lighthouse), place
