"""How many rooted maps there are: the count gate, computed without making a single map.

An enumeration is exhaustive if its counts equal counts from somewhere else.  Here is the
somewhere else: generating functions, recurrences and sums over graphs from the literature.
Nothing is shared with the code that enumerates maps, nor with that of the maps themselves.

All functions return exact integers by number of vertices (or genus) for one number of edges
``m >= 1``.  A connected map with m edges has ``1..m+1`` vertices; a key in that range with
value 0 says that there is no such map, a missing key that the source does not know.

============================  ===========================================================
all maps                      pairs of permutations, the recurrences of Carrell and Chapuy
                              and of Walsh and Lehman
planar maps                   the same two recurrences at genus 0; Tutte's closed form
simple maps                   degree sequences; for up to 7 vertices the graph atlas
simple planar maps            substitution into planar maps; for up to 7 vertices and few
                              rotations the graph atlas
trees (one class in all)      Catalan numbers
============================  ===========================================================

A polynomial is a tuple of integer coefficients, lowest power first.  In the comments z marks
edges and x vertices.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cache
from itertools import combinations, pairwise, permutations, product, zip_longest
from math import comb, factorial, perm, prod
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

__all__ = [
    "ATLAS_VERTICES",
    "ROTATIONS_LIMIT",
    "Source",
    "catalan",
    "labelled_simple",
    "rooted_maps",
    "rooted_maps_by_genus",
    "rooted_of_genus",
    "rooted_of_genus_by_contraction",
    "rooted_planar",
    "rooted_planar_simple",
    "rooted_planar_simple_by_substitution",
    "rooted_planar_total",
    "rooted_simple",
    "rooted_simple_by_degrees",
    "source_for",
    "sources",
]

ATLAS_VERTICES = 7
"""The graph atlas holds all graphs with at most this many vertices."""

ROTATIONS_LIMIT = 50_000
"""A cell of simple planar maps is left out where its graphs have more rotation systems."""

Polynomial: TypeAlias = tuple[int, ...]
Series: TypeAlias = list[Polynomial]
"""A power series in z, cut off; entry k is the polynomial in x at ``z^k``."""

Graph: TypeAlias = tuple[frozenset[int], ...]
"""Entry v is the set of neighbours of v."""


@dataclass(frozen=True, slots=True)
class Source:
    """Where counts come from: ``cells(m)`` is ``{vertices: rooted maps}`` with m edges."""

    name: str
    cells: Callable[[int], dict[int, int]]


def sources(map_class: str) -> tuple[Source, ...]:
    """The independent sources for a class of maps; they agree wherever two know a cell.

    The first knows every cell and is fast.  Raises: ValueError for an unknown class.
    """
    known = {
        "maps": (
            Source("log-series of permutations", rooted_maps),
            Source("Carrell-Chapuy recurrence", _over_all_genera(rooted_of_genus)),
            Source("Walsh-Lehman recurrence", _over_all_genera(rooted_of_genus_by_contraction)),
        ),
        "planar": (
            Source("Carrell-Chapuy recurrence", rooted_planar),
            Source("Walsh-Lehman recurrence", lambda m: rooted_of_genus_by_contraction(m, 0)),
        ),
        "simple": (
            Source("degree sequences of labelled graphs", rooted_simple_by_degrees),
            Source("graph atlas and Catalan numbers", rooted_simple),
        ),
        "planar-simple": (
            Source("substitution into planar maps", rooted_planar_simple_by_substitution),
            Source("graph atlas with genus-0 rotations and Catalan numbers", rooted_planar_simple),
        ),
    }
    if map_class not in known:
        raise ValueError(f"unknown class of maps {map_class!r}; the classes are {', '.join(known)}")
    return known[map_class]


def source_for(map_class: str) -> Source:
    """The source that knows every cell of a class.  Raises: ValueError for an unknown class."""
    return sources(map_class)[0]


def _over_all_genera(
    cells: Callable[[int, int], dict[int, int]],
) -> Callable[[int], dict[int, int]]:
    def summed(edges: int) -> dict[int, int]:
        by_genus = [cells(edges, genus) for genus in range(edges // 2 + 1)]
        return {n: sum(cell[n] for cell in by_genus) for n in _vertex_counts(edges)}

    return summed


def catalan(n: int) -> int:
    """The Catalan number ``C(2n, n) / (n+1)``: rooted plane trees with n edges.

    Raises: ValueError for n < 0.
    """
    return comb(2 * n, n) // (n + 1)


# Maps of any genus


def rooted_maps(edges: int) -> dict[int, int]:
    """``{vertices: rooted maps}`` with that many edges, of any orientable genus.

    It is ``2m [z^m x^n] log sum_k (2k-1)!! x(x+1)...(x+2k-1) z^k / (2k)!``: all sigma by
    cycles, times all alpha, on labelled darts; log keeps the connected pairs, and a rooted
    map has ``(2m-1)!`` labellings.  Raises: ValueError for edges < 1.
    """
    return _cells(edges, _rooted_by_permutations(edges))


@cache
def _rooted_by_permutations(edges: int) -> Polynomial:
    # With b_k = x(x+1)...(x+2k-1) the sum is A = sum b_k z^k / (2^k k!), and R = 2 z A' / A.
    numerator = _scaled(2 * edges, _rising(2 * edges))
    for k in range(1, edges):
        weight = 2**k * perm(edges, k)
        term = _times(_rooted_by_permutations(k), _rising(2 * (edges - k)))
        numerator = _plus(numerator, _scaled(-weight, term))
    return _divided(numerator, 2**edges * factorial(edges))


@cache
def _rising(length: int) -> Polynomial:
    result: Polynomial = (1,)
    for i in range(length):
        result = _times(result, (i, 1))
    return result


def rooted_of_genus(edges: int, genus: int) -> dict[int, int]:
    """``{vertices: rooted maps}`` of one genus, by the recurrence of Carrell and Chapuy.

    Raises: ValueError for edges < 1 or genus < 0.
    Source: S. R. Carrell and G. Chapuy, Simple recurrence formulas to count maps on
    orientable surfaces, J. Combin. Theory A 133 (2015).
    """
    _check_genus(genus)
    return _cells(edges, _carrell_chapuy(edges, genus))


def rooted_maps_by_genus(edges: int) -> dict[int, int]:
    """``{genus: rooted maps}`` with that many edges; genus ``0..m//2``, all that occur.

    Raises: ValueError for edges < 1.  Source: as :func:`rooted_of_genus`.
    """
    _check_edges(edges)
    return {g: sum(_carrell_chapuy(edges, g)) for g in range(edges // 2 + 1)}


def rooted_planar(edges: int) -> dict[int, int]:
    """``{vertices: rooted planar maps}`` with that many edges.

    Raises: ValueError for edges < 1.  Source: as :func:`rooted_of_genus`.
    """
    return rooted_of_genus(edges, 0)


def rooted_planar_total(edges: int) -> int:
    """Rooted planar maps with that many edges: ``2 * 3^m C(2m, m) / ((m+1)(m+2))``.

    Raises: ValueError for edges < 1.
    Source: W. T. Tutte, A census of planar maps, Canad. J. Math. 15 (1963).
    """
    _check_edges(edges)
    power: int = 3**edges
    return 2 * power * comb(2 * edges, edges) // ((edges + 1) * (edges + 2))


@cache
def _carrell_chapuy(n: int, genus: int) -> Polynomial:
    """The polynomial Q_g^n(x) of maps with n edges; their recurrence, times 12."""
    if genus < 0 or 2 * genus > n:
        return ()
    if n == 0:
        return (0, 1)
    bigger = _scaled(4 * (2 * n - 1), _times((1, 1), _carrell_chapuy(n - 1, genus)))
    handle = _scaled((2 * n - 3) * (2 * n - 2) * (2 * n - 1), _carrell_chapuy(n - 2, genus - 1))
    pairs = [
        _scaled(
            6 * (2 * k - 1) * (2 * (n - k) - 1),
            _times(_carrell_chapuy(k - 1, i), _carrell_chapuy(n - k - 1, genus - i)),
        )
        for k in range(1, n)
        for i in range(genus + 1)
    ]
    return _divided(_plus(bigger, handle, *pairs), 2 * (n + 1))


def rooted_of_genus_by_contraction(edges: int, genus: int) -> dict[int, int]:
    """``{vertices: rooted maps}`` of one genus, by contracting edges at every vertex degree.

    Counted first are maps whose vertices are labelled and have a distinguished dart each;
    of these a rooted map has ``(n-1)!`` times the product of the degrees away from the root.
    Raises: ValueError for edges < 1 or genus < 0.
    Cost: the partitions of 2m, each with the ways to split it in two; meant for m <= 9.
    Source: T. R. S. Walsh and A. B. Lehman, Counting rooted maps by genus I,
    J. Combin. Theory B 13 (1972).
    """
    _check_edges(edges)
    _check_genus(genus)
    return {n: _rooted_by_contraction(edges, n, genus) for n in _vertex_counts(edges)}


def _rooted_by_contraction(edges: int, vertices: int, genus: int) -> int:
    # Each degree of the partition takes the root in turn: sum d / 2m of the orders do.
    scaled = 0
    for degrees in _partitions(2 * edges, vertices, 2 * edges):
        orders = factorial(vertices) // prod(map(factorial, Counter(degrees).values()))
        weight = 2 * edges * factorial(2 * edges) // prod(degrees)
        scaled += orders * weight * _dotted(degrees[::-1], genus)
    return _exactly(scaled, factorial(vertices) * factorial(2 * edges))


@cache
def _dotted(degrees: tuple[int, ...], genus: int) -> int:
    """Maps on labelled vertices of these degrees (rising), each with a distinguished dart."""
    edges = sum(degrees) // 2
    if genus < 0 or len(degrees) - edges + 1 > 2 - 2 * genus:
        return 0
    if degrees[0] == 0:
        return int(degrees == (0,) and genus == 0)
    first, rest = degrees[0], degrees[1:]
    total = 0
    for j, d in enumerate(rest):
        # The distinguished edge of the first vertex leads to any of d darts: contract it.
        merged = sorted((first + d - 2, *rest[:j], *rest[j + 1 :]))
        total += d * _dotted(tuple(merged), genus)
    for a in range(first - 1):
        # It is a loop: split the vertex in two, in a map with a handle less or in two maps.
        b = first - 2 - a
        total += _dotted(tuple(sorted((a, b, *rest))), genus - 1)
        total += _dotted_pairs(a, b, rest, genus)
    return total


def _dotted_pairs(a: int, b: int, rest: tuple[int, ...], genus: int) -> int:
    total = 0
    for size in range(len(rest) + 1):
        for chosen in combinations(range(len(rest)), size):
            left = tuple(sorted((a, *(rest[i] for i in chosen))))
            if sum(left) % 2:
                continue
            right = tuple(sorted((b, *(d for i, d in enumerate(rest) if i not in chosen))))
            total += sum(_dotted(left, g) * _dotted(right, genus - g) for g in range(genus + 1))
    return total


# Simple maps, all of them


def rooted_simple_by_degrees(edges: int) -> dict[int, int]:
    """``{vertices: rooted simple maps}`` with that many edges, of any orientable genus.

    A graph has ``prod (deg-1)!`` rotation systems; labelled graphs are counted by degree
    sequence, and a rooted map has ``n!`` labellings of its vertices.
    Raises: ValueError for edges < 1.  Cost: the partitions of 2m.
    """
    return {
        n: _exactly(2 * edges * _connected_rotations(n, edges), factorial(n))
        for n in _vertex_counts(edges)
    }


def labelled_simple(vertices: int) -> int:
    """Rotation systems of the connected simple graphs on that many labelled vertices.

    Raises: ValueError for vertices < 1.
    """
    if vertices < 1:
        raise ValueError(f"a graph has at least 1 vertex, not {vertices}")
    return sum(_connected_rotations(vertices, m) for m in range(comb(vertices, 2) + 1))


@cache
def _connected_rotations(vertices: int, edges: int) -> int:
    """Rotation systems of connected simple graphs on labelled vertices, with m >= 1 edges."""
    if not vertices - 1 <= edges <= comb(vertices, 2):
        return 0
    split = sum(
        comb(vertices - 1, k - 1) * _connected_rotations(k, j) * _rotations(vertices - k, edges - j)
        for k in range(2, vertices)
        for j in range(k - 1, edges)
    )
    return _rotations(vertices, edges) - split


@cache
def _rotations(vertices: int, edges: int) -> int:
    """As :func:`_connected_rotations`, of all graphs without isolated vertices."""
    if edges > comb(vertices, 2):
        return 0
    total = 0
    for degrees in _partitions(2 * edges, vertices, vertices - 1):
        orders = factorial(vertices) // prod(map(factorial, Counter(degrees).values()))
        total += orders * _graphs(degrees) * prod(factorial(d - 1) for d in degrees)
    return total


@cache
def _graphs(degrees: tuple[int, ...]) -> int:
    """Labelled simple graphs with these degrees (falling, all positive)."""
    if not degrees:
        return 1
    first, rest = degrees[0], Counter(degrees[1:])
    if first > rest.total():
        return 0
    total = 0
    for taken in product(*(range(count + 1) for count in rest.values())):
        if sum(taken) != first:
            continue
        left: Counter[int] = Counter()
        for (d, count), t in zip(rest.items(), taken, strict=True):
            left[d] += count - t
            left[d - 1] += t
        left[0] = 0
        ways = prod(comb(count, t) for count, t in zip(rest.values(), taken, strict=True))
        total += ways * _graphs(tuple(sorted(left.elements(), reverse=True)))
    return total


# Simple planar maps, all of them


def rooted_planar_simple_by_substitution(edges: int) -> dict[int, int]:
    """``{vertices: rooted simple planar maps}`` with that many edges.

    Two substitutions lead from simple to all planar maps.  A planar map is one without loops
    with a sequence of loops, each with a map inside, in each of its 2k corners, the root's
    corner having two sides.  A map without loops is a simple one with each edge kept or
    opened to a 2-gon, and in it a map without loops whose root edge has been opened.  Both
    are solved for the inner series.
    Raises: ValueError for edges < 1.
    Source: the compositions of W. T. Tutte, A census of planar maps, Canad. J. Math. 15 (1963).
    """
    vertices = _vertex_counts(edges)
    # Series M / x: the vertex at the root, which each part has in common, is not counted.
    planar = [_carrell_chapuy(m, 0)[1:] for m in range(edges + 1)]
    sequence = _geometric([(), *planar[:-1]])
    square = _product(sequence, sequence)
    loops = [sequence]
    for _ in range(edges):
        loops.append([(), *_product(loops[-1], square)[:-1]])
    loopless = _coefficients(planar, loops)
    # One edge has two vertices, and the second is not counted inside a 2-gon either.
    bundle: Series = [(), (1,), *(p[1:] for p in loopless[1:-1])]
    unit: Series = [(1,), *[()] * edges]
    bundles = [unit]
    for _ in range(edges):
        bundles.append(_product(bundles[-1], bundle))
    simple = _coefficients(loopless, bundles)[edges]
    return {n: _coefficient(simple, n - 1) for n in vertices}


def _coefficients(outer: Series, parts: Sequence[Series]) -> Series:
    """The polynomials c with ``outer = sum_k c_k parts[k]``, where ``parts[k] = z^k + ...``."""
    found: Series = []
    for m, polynomial in enumerate(outer):
        known = [_times(c, part[m]) for c, part in zip(found, parts, strict=False)]
        found.append(_plus(polynomial, *(_scaled(-1, p) for p in known)))
    return found


# Simple maps by the atlas of graphs


def rooted_simple(edges: int) -> dict[int, int]:
    """``{vertices: rooted simple maps}``: up to 7 vertices, and trees.

    Sum over connected graphs of ``2m prod (deg-1)! / |Aut|``; the trees beyond are counted by
    Catalan numbers.  Raises: ValueError for edges < 1.  Cost: reads the whole atlas once.
    Source: R. C. Read and R. J. Wilson, An Atlas of Graphs (1998).
    """
    counts = {
        n: _rooted(((_rotation_count(graph), graph) for graph in _atlas(n, edges)), edges)
        for n in _atlas_vertices(edges)
    }
    return _with_trees(counts, edges)


def rooted_planar_simple(edges: int) -> dict[int, int]:
    """``{vertices: rooted simple planar maps}``: small cells up to 7 vertices, and trees.

    As :func:`rooted_simple`, with those rotation systems only that have genus 0, found by
    trying all.  A cell whose graphs have more than ROTATIONS_LIMIT of them is left out, unless
    Euler's formula leaves none (``m > 3n - 6`` for n >= 3).
    Raises: ValueError for edges < 1.  Cost: at most ROTATIONS_LIMIT face tracings a cell.
    """
    counts = {}
    for n in _atlas_vertices(edges):
        graphs = _atlas(n, edges)
        if n >= 3 and edges > 3 * n - 6:
            counts[n] = 0
        elif sum(map(_rotation_count, graphs)) <= ROTATIONS_LIMIT:
            counts[n] = _rooted(((_spherical_rotations(graph), graph) for graph in graphs), edges)
    return _with_trees(counts, edges)


def _atlas_vertices(edges: int) -> range:
    return range(1, min(ATLAS_VERTICES, max(_vertex_counts(edges))) + 1)


def _with_trees(counts: dict[int, int], edges: int) -> dict[int, int]:
    return counts | {edges + 1: counts.get(edges + 1, catalan(edges))}


def _rooted(weighed: Iterable[tuple[int, Graph]], edges: int) -> int:
    """Rooted maps on graphs that have so many rotation systems each."""
    scale = factorial(ATLAS_VERTICES)  # a multiple of each |Aut|
    total = sum(weight * (scale // _automorphisms(graph)) for weight, graph in weighed)
    return _exactly(2 * edges * total, scale)


@cache
def _connected_graphs() -> Mapping[tuple[int, int], list[Graph]]:
    from networkx import graph_atlas_g, is_connected  # slow, and rarely needed

    found: dict[tuple[int, int], list[Graph]] = {}
    for g in graph_atlas_g():
        n, m = g.number_of_nodes(), g.number_of_edges()
        if n and is_connected(g):
            graph = tuple(frozenset(g[v]) for v in range(n))
            found.setdefault((n, m), []).append(graph)
    return found


def _atlas(vertices: int, edges: int) -> list[Graph]:
    return _connected_graphs().get((vertices, edges), [])


def _automorphisms(graph: Graph) -> int:
    """The number of automorphisms of a graph.  Cost: one visit for each, 7! at most."""
    images: list[int] = []

    def extensions() -> int:
        v = len(images)
        if v == len(graph):
            return 1
        total = 0
        for w in range(len(graph)):
            if w in images or len(graph[w]) != len(graph[v]):
                continue
            if all((images[u] in graph[w]) == (u in graph[v]) for u in range(v)):
                images.append(w)
                total += extensions()
                images.pop()
        return total

    return extensions()


def _rotation_count(graph: Graph) -> int:
    return prod(factorial(len(neighbours) - 1) for neighbours in graph)


def _spherical_rotations(graph: Graph) -> int:
    """How many rotation systems of a connected graph satisfy ``n - m + f = 2``."""
    faces = 2 - len(graph) + sum(map(len, graph)) // 2
    return sum(_face_count(turn) == faces for turn in _rotation_systems(graph))


def _rotation_systems(graph: Graph) -> Iterator[dict[tuple[int, int], tuple[int, int]]]:
    """Each rotation system as the map from dart (u, v) to the next dart (u, w) round u."""
    choices = []
    for u, neighbours in enumerate(graph):
        first, *others = sorted(neighbours)
        rings = [(first, *order, first) for order in permutations(others)]
        choices.append([[((u, v), (u, w)) for v, w in pairwise(ring)] for ring in rings])
    for chosen in product(*choices):
        yield {dart: following for ring in chosen for dart, following in ring}


def _face_count(turn: Mapping[tuple[int, int], tuple[int, int]]) -> int:
    count = 0
    untraced = set(turn)
    while untraced:
        count += 1
        u, v = start = untraced.pop()
        u, v = turn[v, u]
        while (u, v) != start:
            untraced.remove((u, v))
            u, v = turn[v, u]
    return count


# Arithmetic


def _check_edges(edges: int) -> None:
    if edges < 1:
        raise ValueError(f"a map has at least 1 edge, not {edges}")


def _check_genus(genus: int) -> None:
    if genus < 0:
        raise ValueError(f"a genus is at least 0, not {genus}")


def _vertex_counts(edges: int) -> range:
    _check_edges(edges)
    return range(1, edges + 2)


def _cells(edges: int, polynomial: Polynomial) -> dict[int, int]:
    return {n: _coefficient(polynomial, n) for n in _vertex_counts(edges)}


def _partitions(total: int, parts: int, largest: int) -> Iterator[tuple[int, ...]]:
    """The partitions into so many positive parts, none larger than ``largest``, falling."""
    if parts == 0:
        if total == 0:
            yield ()
        return
    for first in range(min(largest, total - parts + 1), 0, -1):
        if first * parts < total:
            return
        for rest in _partitions(total - first, parts - 1, first):
            yield (first, *rest)


def _exactly(numerator: int, denominator: int) -> int:
    quotient, remainder = divmod(numerator, denominator)
    if remainder:
        raise ArithmeticError(f"{numerator} / {denominator} should be a count, but is no integer")
    return quotient


def _coefficient(p: Polynomial, power: int) -> int:
    return p[power] if power < len(p) else 0


def _plus(*terms: Polynomial) -> Polynomial:
    return tuple(map(sum, zip_longest(*terms, fillvalue=0)))


def _scaled(factor: int, p: Polynomial) -> Polynomial:
    return tuple(factor * c for c in p)


def _divided(p: Polynomial, divisor: int) -> Polynomial:
    return tuple(_exactly(c, divisor) for c in p)


def _times(p: Polynomial, q: Polynomial) -> Polynomial:
    if not p or not q:
        return ()
    result = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return tuple(result)


def _product(a: Series, b: Series) -> Series:
    """The product of two series cut off alike."""
    return [_plus(*(_times(a[i], b[k - i]) for i in range(k + 1))) for k in range(len(a))]


def _geometric(a: Series) -> Series:
    """The series ``1 / (1 - a)``, where a has no constant term."""
    result: Series = [(1,)]
    for k in range(1, len(a)):
        result.append(_plus(*(_times(a[i], result[k - i]) for i in range(1, k + 1))))
    return result
