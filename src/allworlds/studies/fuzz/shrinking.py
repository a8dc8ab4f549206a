"""Shrinking: the way from a refuting world to smaller and smaller refuting worlds.

A world is *refuting* if the explorer breaks a law in it.
"""

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
"""A function that runs the explorer in some worlds, and returns the smallest finding there.

The result is None if no law is broken in these worlds.
"""

WORLDS_PER_CHUNK = 50
"""The number of worlds that a worker tries at a time."""

CHUNKS_PER_WAVE = 8
"""The number of chunks in a wave; after a wave with a finding, no larger world is tried."""


def shrink(finding: Finding, scope: Scope, refute: Refute) -> Iterator[Finding]:
    """Yield findings in smaller and smaller refuting worlds; the last is the smallest one found.

    One world is smaller than another if it has fewer edges; if these numbers are equal, the number
    of vertices decides, then the code, then the number of the lighthouse's place.

    First, pieces of the map are removed: half of the map, a quarter and so on.  If the world has at
    most :data:`EDGES_OF_FINE_STEPS` edges, small steps follow.

    A small step tries *neighbours* of the present world, in two groups.  The maps of the first
    group arise from the present map by deletion or contraction of one edge.  If none of these
    neighbours refutes, the second group is tried.  Its maps have as many edges as the present map:
    the present map itself, and every map that arises from it if one dart is moved to another
    position.  In both groups each map is combined with every start and every place of the
    lighthouse.  Neighbours are those of these worlds that are smaller than the present world; in
    each group only the :data:`NEIGHBOURS_PER_STEP` smallest ones are tried.  The smallest refuting
    neighbour of the group is the present world of the next step, so the result depends on
    ``finding`` alone.  The small steps end if no tried neighbour refutes.

    A smaller world that is no neighbour may refute, too.  So at last all smaller worlds with at
    most :data:`EDGES_TRIED_IN_FULL` edges are tried.

    Args:
        finding: the finding to begin with; it is not yielded itself.
        scope: the class, the condition and the kind of lighthouse that the smaller worlds must
            have.
        refute: the function that runs the explorer in some worlds, and returns the smallest finding
            there.

    Cost: O(m^3) runs for each small step in a world with m edges, but at most
    :data:`NEIGHBOURS_PER_STEP` runs for each of the two groups.
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
"""The largest number of edges of the worlds that are all tried in the end."""

EDGES_OF_FINE_STEPS = 16
"""The most edges of a world whose neighbours (see :func:`shrink`) are tried.

From larger worlds only pieces are removed.
"""

NEIGHBOURS_PER_STEP = 4000
"""The most worlds with one number of edges that are tried in a step."""

TIMES_AS_FAR = 2
"""The factor by which the traversals of the finding's run may grow in a smaller world."""

TRAVERSALS_BESIDES = 100
"""The number of traversals that a run may have beyond those that :data:`TIMES_AS_FAR` allows."""

LARGE_WORLDS_PER_CHUNK = 4
"""The number of worlds that a worker tries at a time while pieces are removed."""

LARGE_CHUNKS_PER_WAVE = 2
"""The number of chunks that are tried together while pieces are removed."""


def _with_pieces_less(finding: Finding, scope: Scope, refute: Refute) -> Iterator[Finding]:
    """Yield findings in smaller and smaller worlds, by deleting or contracting one piece at a time.

    A piece is a set of consecutive edges in breadth-first order from the start.  The map is cut
    into pieces of one size, at first half of the map.  The pieces are tried one after the other,
    the farthest first; the map without the piece and the map with the piece contracted are tried.
    If a world with such a map refutes, its map is cut into pieces of the same size, and these are
    tried.  If no piece of this size can be removed, pieces of half the size are tried.

    In the smaller map the lighthouse keeps the number of its place; if the smaller map has no place
    with this number, the remainder of its division by the number of places is taken.  A map without
    any place is left out.

    The parameters are those of :func:`shrink`.

    Cost: O(m) runs to remove a piece, or to find that no piece of a size can be removed.
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
    """Yield two smaller worlds for each piece of the finding's world.

    In one of the two the piece is deleted, in the other one the piece is contracted.  The edges of
    the world, in breadth-first order from the start, are cut into pieces of ``piece`` edges (the
    nearest piece may have fewer); the farthest piece comes first.  With each world the number of
    its lighthouse's place is yielded.  A world is left out if nothing remains at the start, if its
    map has no place, or if the map is not in the class, or does not meet the condition, of
    ``scope``.
    """
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
    """The smallest finding of the first wave that has a finding; None if no wave has one.

    A chunk is some worlds, and a wave is ``at_once`` chunks.  ``refute`` gets all chunks of a wave
    in one call, runs the explorer there, and returns the smallest finding in these chunks.  After a
    wave with a finding, no further wave is tried.
    """
    waves = (refute(chunks[i : i + at_once]) for i in range(0, len(chunks), at_once))
    return next((found for found in waves if found), None)


def _fewer_edges(map_: CombinatorialMap) -> Iterator[CombinatorialMap]:
    for dart, _ in map_.edges:
        for other in (build.deleted(map_, dart), build.contracted(map_, dart)):
            if other is not None:
                yield other


def _smaller(scope: Scope, finding: Finding, maps: Iterable[CombinatorialMap]) -> list[GivenWorlds]:
    """The worlds with one of ``maps`` that are smaller than the finding's world, in chunks.

    Every start and every place of the lighthouse makes a world, if the map is in the class of
    ``scope`` and meets its condition.  The worlds ascend, in the order that :func:`shrink`
    describes.  If there are more than :data:`NEIGHBOURS_PER_STEP` worlds, the largest ones are left
    out.
    """
    size = finding.key[:4]
    placed = takewhile(lambda each: each[0] < size, placed_rootings(maps, scope))
    return in_chunks([each for _, each in islice(placed, NEIGHBOURS_PER_STEP)])


def placed_rootings(
    maps: Iterable[CombinatorialMap], scope: Scope
) -> Iterator[tuple[tuple[int, int, Code, int], tuple[world.World, int]]]:
    """Yield the worlds with one of ``maps``: one for each start and each place of the lighthouse.

    An item is a pair: a key, and a second pair, which consists of a world and the number of its
    lighthouse's place.  A key has four entries: the numbers of edges and of vertices, the code of
    the rooted map, and the number of the place.  The keys ascend.  Of worlds that are isomorphic
    only one is yielded.  Maps that are not in the class of ``scope``, or do not satisfy its
    condition, are left out.  The bounds of ``scope`` on edges and vertices are not checked; the
    caller decides how large ``maps`` are.
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
    """The worlds, each with the number of its lighthouse's place, in chunks of ``length`` worlds.

    A worker tries one chunk at a time; the last chunk may have fewer worlds.
    """
    starts = range(0, len(worlds), length)
    return [GivenWorlds(tuple(worlds[start : start + length])) for start in starts]


def smallest_from(finding: Finding, workers: Transport, scope: Scope) -> Finding:
    """The smallest finding that :func:`shrink` reaches from ``finding`` before the deadline.

    In some worlds a wrong explorer walks until its budget is used up, which takes much time.  So a
    run in a smaller world is cut off if it is much longer than the run of the smallest finding so
    far (see :data:`TIMES_AS_FAR`); a run that is cut off so refutes nothing.  For a finding of the
    law ``budget`` this limit does not hold, because a run breaks this law only if it uses up its
    budget.

    Args:
        finding: the finding to begin with; it is the result if no smaller world refutes.
        workers: the workers that run the explorer until the deadline of the job.
        scope: the class, the condition and the rules of the smaller worlds.
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
