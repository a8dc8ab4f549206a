"""Maps that somebody has chosen, from the explorer's first run in them to the smallest finding."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from allworlds.engines import (
    PythonEngine,
    Scope,
    Silent,
    Tally,
    confirmed,
    gather,
    subject_of,
    workers_for,
)
from allworlds.judging import Finding
from allworlds.maps import CombinatorialMap, Extent, MapClass
from allworlds.studies.check import ManyRuns
from allworlds.studies.fuzz.drive import shrink_found
from allworlds.studies.fuzz.shrink import in_chunks, rootings
from allworlds.world import Lighthouse, World


def refuted_in(maps: Iterable[CombinatorialMap], request: ManyRuns) -> Finding | None:
    """The smallest finding that the shrinker reaches from these maps; None where no law is broken.

    The explorer starts at every dart of each map, with every place of the lighthouse.  Maps
    that are not of the class are left out.

    Args:
        maps: of any size.
        request: for an explorer, the class, rules and limits.

    Raises:
        InputError: naming the offending option and what would be legal.
        TimeIsUp: at the time limit.
        Unsettled: if what happened to the explorer cannot be told.

    Cost: O(m) runs for each map with m edges.
    """
    limits, map_class = request.limits, request.map_class
    subject = subject_of(request.explore, limits)
    rules = request.rules(subject)
    given = [*_rooted(maps, map_class, rules.kind)]
    if not given:
        return None
    largest = max(world.map.edge_count for world, _ in given)
    scope = Scope(Extent(map_class, largest), rules)
    tally = Tally(keep=1)
    with workers_for(subject, limits, limits.deadline()) as workers:
        gather(workers, PythonEngine(scope, tally.keep), in_chunks(given), tally, Silent())
        shrink_found(workers, scope, tally)
    for found in tally.findings:
        return confirmed(found, subject, limits, scope.schedules)
    return None


def _rooted(
    maps: Iterable[CombinatorialMap], map_class: MapClass, kind: type[Lighthouse]
) -> Iterator[tuple[World, int]]:
    """Each rooted map once, smallest first, with every place."""
    for *_, code in rootings(maps, map_class):
        map_ = CombinatorialMap.trusted(*code)
        for place, lighthouse in enumerate(kind.places(map_, 0)):
            yield World(map_, lighthouse), place
