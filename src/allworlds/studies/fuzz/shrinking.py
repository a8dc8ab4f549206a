"""The way from a refuting world to ever smaller ones."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import islice, takewhile
from typing import TypeAlias

from allworlds.documents.document import replace
from allworlds.engines import sweep
from allworlds.engines.limits import TimeIsUp
from allworlds.engines.listeners import NOBODY
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import GivenWorlds, Scope, Transport
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.law_table import LAWS
from allworlds.maps import build
from allworlds.maps.combinatorial import Code, CombinatorialMap, rooted_code
from allworlds.maps.enumeration import rooted_maps
from allworlds.world import world

Refute: TypeAlias = Callable[[Sequence[GivenWorlds]], Finding | None]
"""The smallest finding among these worlds, or None."""

WORLDS_PER_CHUNK = 50
"""The worlds that one worker tries at a time."""

CHUNKS_PER_WAVE = 8
"""The chunks that are tried before the next, larger worlds are begun."""


def shrink(finding: Finding, scope: Scope, refute: Refute) -> Iterator[Finding]:
    """Yield ever smaller refuting worlds, until no neighbour that is tried refutes.

    First pieces of the map are taken away, half of it, a quarter and so on, the start kept.
    Then an edge is deleted or contracted as long as that is possible; then, with as many
    edges, a dart may move and the start and the marker may turn, towards fewer vertices and
    the smaller code.  Every neighbour is rooted everywhere and lit from every place, and the
    smallest refuting one is taken, so the result depends on nothing but the finding.  At last all
    worlds with few edges are tried.

    Cost: O(m^3) runs for each step of small worlds, but at most
    ``NEIGHBOURS_PER_STEP``; large ones are left as they are when no piece of them can go.
    """
    for less in _with_pieces_less(finding, scope, refute):
        yield (finding := less)
    smaller: Finding | None = finding
    while smaller and smaller.world.map.edge_count <= EDGES_OF_FINE_STEPS:
        finding, map_ = smaller, smaller.world.map
        smaller = _smallest(refute, _smaller(scope, finding, _fewer_edges(map_)))
        if smaller is None:
            smaller = _smallest(refute, _smaller(scope, finding, [map_, *build.moved(map_)]))
        if smaller:
            yield smaller
    extent, most = scope.extent, finding.world.map.edge_count
    for edges in range(1, min(EDGES_TRIED_IN_FULL, most) + 1):
        maps = rooted_maps(edges, extent.map_class, where=extent.where)
        smallest = _smallest(refute, _smaller(scope, finding, maps))
        if smallest:
            yield smallest
            return


EDGES_TRIED_IN_FULL = 4
"""The number of edges up to which every world is tried at last."""

EDGES_OF_FINE_STEPS = 16
"""The number of edges above which not every neighbour is tried."""

NEIGHBOURS_PER_STEP = 4000
"""The neighbours that are tried in a step."""

TIMES_AS_FAR = 2
"""The walk after which a smaller world is passed over: so many times that of the finding."""

TRAVERSALS_BESIDES = 100
"""The traversals that it may have more than these."""

LARGE_WORLDS_PER_CHUNK = 4
"""The worlds with a piece less that one worker tries at a time."""

LARGE_CHUNKS_PER_WAVE = 2
"""The chunks of these that are tried before the next ones are begun."""


def _with_pieces_less(finding: Finding, scope: Scope, refute: Refute) -> Iterator[Finding]:
    """Yield ever smaller refuting worlds, of which a piece was deleted or contracted at a time.

    A piece are edges that follow each other breadth-first from the start; the farthest come first.
    As long as one of them can go, others of that size are tried, and then those of half the size.
    The place of the lighthouse keeps its number, if there are so many.

    Cost: O(m) runs for each step, but about O(m log m) in all if few edges are needed.
    """
    piece = finding.world.map.edge_count // 2
    while piece:
        worlds = list(_less_by(piece, finding, scope))
        few = in_chunks(worlds, LARGE_WORLDS_PER_CHUNK)
        found = _smallest(refute, few, at_once=LARGE_CHUNKS_PER_WAVE)
        if found:
            finding = found
            yield finding
        piece = min(piece if found else piece // 2, finding.world.map.edge_count // 2)


def _less_by(piece: int, finding: Finding, scope: Scope) -> Iterator[tuple[world.World, int]]:
    """The finding's world without so many edges, deleted or contracted, and the place."""
    map_, extent = finding.world.map, scope.extent
    for end in range(map_.edge_count, 0, -piece):
        gone = {d for edge in map_.edges[max(0, end - piece) : end] for d in edge}
        deleted, contracted = build.without(map_, gone), build.without(map_.dual(), gone)
        for other in (deleted, contracted and contracted.dual()):
            if other and extent.map_class.includes(other) and extent.admits(other):
                places = [*scope.rules.kind.places(other, 0)]
                for place in {finding.place, finding.place % max(1, len(places))}:
                    if place < len(places):
                        yield world.World(other, places[place]), place


def _smallest(
    refute: Refute, chunks: Sequence[GivenWorlds], at_once: int = CHUNKS_PER_WAVE
) -> Finding | None:
    """The smallest finding of the first wave that has one; of later ones none is tried."""
    waves = (refute(chunks[i : i + at_once]) for i in range(0, len(chunks), at_once))
    return next((found for found in waves if found), None)


def _fewer_edges(map_: CombinatorialMap) -> Iterator[CombinatorialMap]:
    for dart, _ in map_.edges:
        for other in (build.deleted(map_, dart), build.contracted(map_, dart)):
            if other is not None:
                yield other


def _smaller(scope: Scope, finding: Finding, maps: Iterable[CombinatorialMap]) -> list[GivenWorlds]:
    """The first rootings and places of these maps that are smaller than the finding, ascending."""
    size = finding.key[:4]
    placed = takewhile(lambda each: each[0] < size, placed_rootings(maps, scope))
    return in_chunks([each for _, each in islice(placed, NEIGHBOURS_PER_STEP)])


def placed_rootings(
    maps: Iterable[CombinatorialMap], scope: Scope
) -> Iterator[tuple[tuple[int, int, Code, int], tuple[world.World, int]]]:
    """Rootings of these maps, each once and with every place; ascending by what is beside them.

    That is: edges, vertices, code, place.  The maps are of the class of the extent, and its
    condition is true of them; its bounds do not matter.
    """
    extent = scope.extent
    rootings = {
        (map_.edge_count, map_.vertex_count, rooted_code(map_.sigma, map_.alpha, start))
        for map_ in maps
        if extent.map_class.includes(map_) and extent.admits(map_)
        for start in map_.darts
    }
    for key in sorted(rootings):
        map_ = CombinatorialMap.trusted(*key[2])
        for place, lighthouse in enumerate(scope.rules.kind.places(map_, 0)):
            yield (*key, place), (world.World(map_, lighthouse), place)


def in_chunks(
    worlds: Sequence[tuple[world.World, int]], length: int = WORLDS_PER_CHUNK
) -> list[GivenWorlds]:
    """Worlds with the numbers of their places, in pieces that one worker tries at a time."""
    starts = range(0, len(worlds), length)
    return [GivenWorlds(tuple(worlds[start : start + length])) for start in starts]


def smallest_from(finding: Finding, workers: Transport, scope: Scope) -> Finding:
    """The smallest finding that the shrinker reaches from this one, or has when the time is up.

    A wrong explorer often walks until its budget is used up.  Unless it is the budget that it
    breaks, worlds are passed over in which it walks more than so many times as far as in the
    finding that is made smaller.
    """
    rules = scope.rules

    def refute(given: Sequence[GivenWorlds]) -> Finding | None:
        tried, found = scope, Tally(keep=len(LAWS))
        if finding.law != "budget":
            far = TIMES_AS_FAR * finding.transcript.cost + TRAVERSALS_BESIDES
            most = min(rules.budget(finding.world.map), far)
            tried = replace(scope, rules=replace(rules, step_budget=most))
        sweep.gather(workers, RunCounter(tried, found.keep), given, found, NOBODY)
        for each in found.findings:
            ends = each.law != "budget" and each.transcript.cost <= rules.budget(each.world.map)
            if ends or tried is scope:
                return replace(each, under=rules, options=rules.recorded)
        return None

    with suppress(TimeIsUp):
        for smaller in shrink(finding, scope, refute):
            finding = smaller
    return finding
