"""Maps that somebody has chosen, from the explorer's first run in them to the smallest finding."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, Unpack

from allworlds.engines import (
    Limits,
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
from allworlds.studies.check import ManyRunsOptions, refuse_others, rules_for
from allworlds.studies.fuzz.drive import shrink_found
from allworlds.studies.fuzz.shrink import in_chunks, rootings
from allworlds.world import Lighthouse, World


def refuted_in(
    explore: str | Callable[..., Any],
    maps: Iterable[CombinatorialMap],
    **options: Unpack[ManyRunsOptions],
) -> Finding | None:
    """The smallest finding that the shrinker reaches from these maps; None where no law is broken.

    The explorer starts at every dart of each map, with every place of the lighthouse.  Maps
    that are not of the class are left out.

    Args:
        explore: a name or a generator function.
        maps: of any size.
        options: as for :func:`allworlds.check`.

    Raises:
        InputError: naming the offending option and what would be legal.
        TimeIsUp: at the time limit.
        Unsettled: if what happened to the explorer cannot be told.

    Cost: O(m) runs for each map with m edges.
    """
    refuse_others("refuted_in", options, ManyRunsOptions)
    limits = Limits.of(options)
    subject = subject_of(explore, limits)
    map_class, rules = rules_for(subject, options)
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
