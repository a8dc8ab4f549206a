"""The numbers of rooted maps, computed without making a map, for the count gate.

An enumeration is exhaustive if its counts equal counts from an independent source.  The sources
in this module are formulas from the literature: generating functions, recurrences and sums.  They
share no code with the enumeration, or with the class ``CombinatorialMap``.

Each source is a function that takes a number of edges ``m >= 1``, and returns the exact numbers of
rooted maps by number of vertices: ``{vertices: rooted maps}``.  A connected map with m edges has
``1..m+1`` vertices; these numbers are the keys.

============================  ===========================================================
all maps                      the logarithm of the series of all pairs of permutations
planar maps                   the recurrence of Carrell and Chapuy at genus 0
simple maps                   a sum over all sequences of degrees
simple planar maps            two equations from the series of the planar maps
trees (of any class)          Catalan numbers
cubic, regular, eulerian      all maps, simple maps: as above; planar maps: the recurrence of Walsh
                              and Lehman; in each case with the legal degrees only
triangulation, quadrangu-     the dual maps, by the recurrence of Walsh and Lehman; simple planar
lation                        triangulations by Tutte's formula
============================  ===========================================================

The tests compare each source with another one.

A polynomial is a tuple of integer coefficients, lowest power first.  In series and polynomials the
power of z is a number of edges, the power of x a number of vertices.  The argument ``legal`` of a
function is the set of legal degrees: only maps in which every vertex has a legal degree are
counted; None allows every degree.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from itertools import combinations, product, zip_longest
from math import comb, factorial, perm, prod
from typing import NamedTuple, TypeAlias

Degrees: TypeAlias = frozenset[int]
"""The legal degrees of the vertices of a map."""

Polynomial: TypeAlias = tuple[int, ...]
Series: TypeAlias = list[Polynomial]
"""The needed coefficients of a power series in z."""

Cells: TypeAlias = dict[int, int]
"""The numbers of maps, by the number of vertices."""


# ---------------------------------------------------------------- polynomials and partitions


def vertex_counts(edges: int) -> range:
    """The numbers of vertices that connected maps with ``edges`` edges can have: 1 to edges + 1.

    Raises: ValueError for edges < 1, like each function that returns ``{vertices: rooted maps}``.
    """
    if edges < 1:
        raise ValueError(f"a map has at least 1 edge, not {edges}")
    return range(1, edges + 2)


def cells(edges: int, polynomial: Polynomial) -> Cells:
    """For each number n of vertices the coefficient of x^n in ``polynomial``.

    n takes all numbers of vertices that connected maps with ``edges`` edges can have.
    """
    return {n: coefficient(polynomial, n) for n in vertex_counts(edges)}


def partitions(total: int, parts: int, largest: int) -> Iterator[tuple[int, ...]]:
    """Yield the partitions of ``total`` into ``parts`` descending numbers from 1 to ``largest``."""
    if parts == 0:
        if total == 0:
            yield ()
        return
    for first in range(min(largest, total - parts + 1), 0, -1):
        if first * parts < total:
            return
        for rest in partitions(total - first, parts - 1, first):
            yield (first, *rest)


def sequences(
    total: int, vertices: int, largest: int, legal: Degrees | None
) -> Iterator[tuple[tuple[int, ...], int]]:
    """Yield the partitions of ``total`` into the legal degrees of ``vertices`` vertices.

    The degrees are at most ``largest``.  Each partition comes in a pair with the number of
    different orders of its degrees.
    """
    for degrees in partitions(total, vertices, largest):
        if legal is None or legal.issuperset(degrees):
            orders = factorial(vertices) // prod(map(factorial, Counter(degrees).values()))
            yield degrees, orders


def exactly(numerator: int, denominator: int) -> int:
    """The quotient of two integers; raise ArithmeticError if there is a remainder."""
    quotient, remainder = divmod(numerator, denominator)
    if remainder:
        raise ArithmeticError(f"{numerator} / {denominator} should be a count, but is no integer")
    return quotient


def coefficient(p: Polynomial, power: int) -> int:
    """The coefficient of the power ``power`` in ``p``; 0 above the degree of ``p``."""
    return p[power] if power < len(p) else 0


def plus(*terms: Polynomial) -> Polynomial:
    """The sum of polynomials."""
    return tuple(map(sum, zip_longest(*terms, fillvalue=0)))


def scaled(factor: int, p: Polynomial) -> Polynomial:
    """A polynomial times an integer."""
    return tuple(factor * c for c in p)


def divided(p: Polynomial, divisor: int) -> Polynomial:
    """A polynomial divided by an integer that divides it."""
    return tuple(exactly(c, divisor) for c in p)


def times(p: Polynomial, q: Polynomial) -> Polynomial:
    """The product of two polynomials."""
    if not p or not q:
        return ()
    result = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return tuple(result)


def series_product(a: Series, b: Series) -> Series:
    """The product of two series of the same length."""
    return [plus(*(times(a[i], b[k - i]) for i in range(k + 1))) for k in range(len(a))]


def geometric(a: Series) -> Series:
    """The series ``1 / (1 - a)``, where a has no constant term."""
    result: Series = [(1,)]
    for k in range(1, len(a)):
        result.append(plus(*(times(a[i], result[k - i]) for i in range(1, k + 1))))
    return result


def catalan(n: int) -> int:
    """The Catalan number ``C(2n, n) / (n+1)``: the number of rooted plane trees with n edges."""
    return comb(2 * n, n) // (n + 1)


# ---------------------------------------------------------------- maps of any genus


def rooted_maps(edges: int, legal: Degrees | None = None) -> Cells:
    """``{vertices: rooted maps}`` with ``edges`` edges, of any orientable genus.

    If ``legal`` is not None, only maps in which all vertices have legal degrees are counted.

    The number is ``2m [z^m x^n] log sum_k (2k-1)!! x(x+1)...(x+2k-1) z^k / (2k)!``.  The term k of
    the sum counts the pairs (sigma, alpha) on 2k labelled darts: ``x(x+1)...(x+2k-1)`` counts every
    sigma, with a factor x for each cycle, and ``(2k-1)!!`` counts every alpha.  The logarithm
    counts only the connected pairs.  Each rooted map is counted ``(2m-1)!`` times, once for each
    labelling with the root as dart 0.  The quotient ``(2m)! / (2m-1)!`` is the factor 2m.  If
    ``legal`` is not None, the sum counts only those sigma whose cycles have legal lengths.
    """
    return cells(edges, _connected(edges, legal))


@cache
def _connected(edges: int, legal: Degrees | None) -> Polynomial:
    # With b_k the permutations of 2k darts the sum is A = sum b_k z^k / (2^k k!), and R = 2 z A'/A.
    numerator = scaled(2 * edges, _permutations(2 * edges, legal))
    for k in range(1, edges):
        weight = 2**k * perm(edges, k)
        term = times(_connected(k, legal), _permutations(2 * (edges - k), legal))
        numerator = plus(numerator, scaled(-weight, term))
    return divided(numerator, 2**edges * factorial(edges))


@cache
def _permutations(length: int, legal: Degrees | None) -> Polynomial:
    """The numbers of permutations of ``length`` darts in which every cycle has a legal length.

    The coefficient of x^n is the number of these permutations with n cycles.
    """
    result: Polynomial = (1,)
    if legal is None:
        for i in range(length):
            result = times(result, (i, 1))
    elif length:
        result = ()
        for degree in legal:
            if degree <= length:
                rest = _permutations(length - degree, legal)
                result = plus(result, scaled(perm(length - 1, degree - 1), (0, *rest)))
    return result


def rooted_of_genus(edges: int, genus: int) -> Cells:
    """``{vertices: rooted maps}`` with ``edges`` edges, of the genus ``genus``.

    The numbers come from the recurrence of Carrell and Chapuy.

    Source: S. R. Carrell and G. Chapuy, Simple recurrence formulas to count maps on
    orientable surfaces, J. Combin. Theory A 133 (2015).
    """
    return cells(edges, carrell_chapuy(edges, genus))


@cache
def carrell_chapuy(n: int, genus: int) -> Polynomial:
    """The polynomial Q_g^n(x), where g is ``genus``.

    The coefficient of x^v is the number of rooted maps of genus g with v vertices and n edges.
    The recurrence of Carrell and Chapuy is used with both sides multiplied by 12, so that all its
    coefficients are integers.
    """
    if genus < 0 or 2 * genus > n:
        return ()
    if n == 0:
        return (0, 1)
    bigger = scaled(4 * (2 * n - 1), times((1, 1), carrell_chapuy(n - 1, genus)))
    handle = scaled((2 * n - 3) * (2 * n - 2) * (2 * n - 1), carrell_chapuy(n - 2, genus - 1))
    pairs = [
        scaled(
            6 * (2 * k - 1) * (2 * (n - k) - 1),
            times(carrell_chapuy(k - 1, i), carrell_chapuy(n - k - 1, genus - i)),
        )
        for k in range(1, n)
        for i in range(genus + 1)
    ]
    return divided(plus(bigger, handle, *pairs), 2 * (n + 1))


def rooted_of_genus_by_contraction(edges: int, genus: int, legal: Degrees | None = None) -> Cells:
    """``{vertices: rooted maps}`` with ``edges`` edges, of the genus ``genus``.

    If ``legal`` is not None, only maps in which all vertices have legal degrees are counted.  The
    numbers come from a recurrence that contracts edges.

    The recurrence counts maps with labelled vertices and a distinguished dart at each vertex.  A
    rooted map yields ``(n-1)!`` such maps, times the degrees of all vertices but the root's.
    Cost: the partitions of 2m, times the ways to split each in two; meant for m <= 9.
    Source: T. R. S. Walsh and A. B. Lehman, Counting rooted maps by genus I,
    J. Combin. Theory B 13 (1972).
    """
    return {n: _rooted_by_contraction(edges, n, genus, legal) for n in vertex_counts(edges)}


def _rooted_by_contraction(edges: int, vertices: int, genus: int, legal: Degrees | None) -> int:
    # Each degree of the partition takes the root in turn: sum d / 2m of the orders do.
    scaled = 0
    for degrees, orders in sequences(2 * edges, vertices, 2 * edges, legal):
        weight = 2 * edges * factorial(2 * edges) // prod(degrees)
        scaled += orders * weight * _dotted(degrees[::-1], genus)
    return exactly(scaled, factorial(vertices) * factorial(2 * edges))


@cache
def _dotted(degrees: tuple[int, ...], genus: int) -> int:
    """The number of maps of the genus ``genus`` with labelled vertices of the degrees ``degrees``.

    The degrees are ascending.  Each vertex also has a distinguished dart.
    """
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
            right = tuple(sorted((b, *(d for i, d in enumerate(rest) if i not in chosen))))
            total += sum(_dotted(left, g) * _dotted(right, genus - g) for g in range(genus + 1))
    return total


# ---------------------------------------------------------------- simple maps


def rooted_planar_simple_by_substitution(edges: int) -> Cells:
    """``{vertices: rooted simple planar maps}`` with ``edges`` edges.

    The series of all planar maps is known.  A first equation determines from this series the series
    of the maps without loops; a second equation then determines the series of the simple maps.

    The first equation: each planar map arises from one map without loops.  A *corner* is the space
    between two neighbouring darts of a vertex, so a map with k edges has 2k corners.  Each corner
    gets a sequence of loops, with a planar map inside each loop.  The root marks one corner, which
    gets two sequences, one on each side of the mark.

    The second equation: each map without loops arises from one simple map.  Each edge e of the
    simple map, independently of the others, is kept or replaced.  To replace e, take a map L
    without loops, and double its root edge.  The two copies join the ends of e; all other edges of
    L lie between the two copies.  The start of L's root comes to that end of e which a fixed rule
    names.

    Source: the compositions of W. T. Tutte, A census of planar maps, Canad. J. Math. 15 (1963).
    """
    vertices = vertex_counts(edges)
    # Series M / x: the vertex at the root, which each part has in common, is not counted.
    planar = [carrell_chapuy(m, 0)[1:] for m in range(edges + 1)]
    sequence = geometric([(), *planar[:-1]])
    square = series_product(sequence, sequence)
    loops = [sequence]
    for _ in range(edges):
        loops.append([(), *series_product(loops[-1], square)[:-1]])
    loopless = _coefficients(planar, loops)
    # One edge has two vertices, and the second is not counted inside a 2-gon either.
    bundle: Series = [(), (1,), *(p[1:] for p in loopless[1:-1])]
    unit: Series = [(1,), *[()] * edges]
    bundles = [unit]
    for _ in range(edges):
        bundles.append(series_product(bundles[-1], bundle))
    simple = _coefficients(loopless, bundles)[edges]
    return {n: coefficient(simple, n - 1) for n in vertices}


def _coefficients(outer: Series, parts: Sequence[Series]) -> Series:
    """The polynomials c with ``outer = sum_k c_k parts[k]``, where ``parts[k] = z^k + ...``."""
    found: Series = []
    for m, polynomial in enumerate(outer):
        known = [times(c, part[m]) for c, part in zip(found, parts, strict=False)]
        found.append(plus(polynomial, *(scaled(-1, p) for p in known)))
    return found


def rooted_simple_by_degrees(edges: int, legal: Degrees | None = None) -> Cells:
    """``{vertices: rooted simple maps}`` with ``edges`` edges, of any orientable genus.

    If ``legal`` is not None, only maps in which all vertices have legal degrees are counted.

    First, connected graphs with labelled vertices are counted for each sequence of degrees.  Such a
    graph has ``prod (deg-1)!`` rotation systems, which are maps with labelled vertices.  Each of
    these maps has 2m darts that can be the root, and each rooted map has ``n!`` labellings of its
    vertices.  So the number of rooted maps is ``2m / n!`` times the number of the labelled maps.

    Cost: the number of partitions of 2m.
    """
    return {
        n: exactly(2 * edges * _connected_rotations(n, edges, legal), factorial(n))
        for n in vertex_counts(edges)
    }


@cache
def _connected_rotations(vertices: int, edges: int, legal: Degrees | None) -> int:
    """The number of rotation systems of all connected simple labelled graphs of this size.

    Only graphs with legal degrees count; ``edges`` is at least 1.
    """
    if not vertices - 1 <= edges <= comb(vertices, 2):
        return 0
    split = sum(
        comb(vertices - 1, k - 1)
        * _connected_rotations(k, j, legal)
        * _rotations(vertices - k, edges - j, legal)
        for k in range(2, vertices)
        for j in range(k - 1, edges)
    )
    return _rotations(vertices, edges, legal) - split


@cache
def _rotations(vertices: int, edges: int, legal: Degrees | None) -> int:
    """The number of rotation systems of all simple labelled graphs of this size.

    Only graphs with legal degrees count.  The graphs may be disconnected, but have no isolated
    vertices.
    """
    if edges > comb(vertices, 2):
        return 0
    return sum(
        orders * _graphs(degrees) * prod(factorial(d - 1) for d in degrees)
        for degrees, orders in sequences(2 * edges, vertices, vertices - 1, legal)
    )


@cache
def _graphs(degrees: tuple[int, ...]) -> int:
    """The number of labelled simple graphs with these degrees (descending, all positive)."""
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


# ---------------------------------------------------------------- the sources


class CountSource(NamedTuple):
    """A source of counts, with its name for reports.

    ``cells(m)`` is ``{vertices: rooted maps}`` for the maps with m edges.
    """

    name: str
    cells: Callable[[int], Cells]


def rooted_trees(edges: int) -> Cells:
    """``{vertices: rooted plane trees}`` with ``edges`` edges, by Catalan numbers."""
    return {n: catalan(edges) if n == edges + 1 else 0 for n in vertex_counts(edges)}


def rooted_with_faces(edges: int, length: int, genera: Iterable[int]) -> Cells:
    """``{vertices: rooted maps}`` with ``edges`` edges, in which each face has ``length`` darts.

    Only maps whose genus is in ``genera`` are counted.
    """
    cells = dict.fromkeys(vertex_counts(edges), 0)
    faces, rest = divmod(2 * edges, length)
    for genus in genera if rest == 0 else ():
        vertices = edges - faces + 2 - 2 * genus
        if vertices > 0:
            duals = rooted_of_genus_by_contraction(edges, genus, frozenset({length}))
            cells[vertices] = duals[faces]
    return cells


def rooted_simple_triangulations(edges: int) -> Cells:
    """``{vertices: rooted simple planar triangulations}`` with ``edges`` edges.

    Such a triangulation has k + 2 vertices and 3k edges; there are none with other numbers.
    Source: W. T. Tutte, A census of planar triangulations, Canad. J. Math. 14 (1962):
    ``2 (4k-3)! / (k! (3k-1)!)``.
    """
    cells = dict.fromkeys(vertex_counts(edges), 0)
    k, rest = divmod(edges, 3)
    if not rest:
        cells[k + 2] = exactly(2 * factorial(4 * k - 3), factorial(k) * factorial(3 * k - 1))
    return cells


def _of_degrees(map_class: str, legal: Callable[[int], bool]) -> CountSource | None:
    """The source of counts for maps of a class in which the degree of every vertex is legal.

    ``legal`` tells whether a degree is legal.  The result is None for the class ``planar-simple``,
    which has no such source.
    """

    def degrees(edges: int) -> Degrees:
        return frozenset(filter(legal, range(1, 2 * edges + 1)))

    known = {
        "maps": CountSource(
            "log-series of permutations with legal cycles", lambda m: rooted_maps(m, degrees(m))
        ),
        "planar": CountSource(
            "Walsh-Lehman recurrence at the legal degrees",
            lambda m: rooted_of_genus_by_contraction(m, 0, degrees(m)),
        ),
        "simple": CountSource(
            "legal degree sequences of labelled graphs",
            lambda m: rooted_simple_by_degrees(m, degrees(m)),
        ),
    }
    return known.get(map_class)


def _of_faces(map_class: str, length: int) -> CountSource | None:
    if map_class in ("maps", "planar"):
        return CountSource(
            "Walsh-Lehman recurrence of the dual maps",
            lambda m: rooted_with_faces(
                m, length, range(1 if map_class == "planar" else m // 2 + 1)
            ),
        )
    if (map_class, length) == ("planar-simple", 3):
        return CountSource("Tutte's census of triangulations", rooted_simple_triangulations)
    return None


def _of_genus(map_class: str, genus: int) -> CountSource | None:
    if map_class == "maps":
        return CountSource("Carrell-Chapuy recurrence", lambda m: rooted_of_genus(m, genus))
    if genus == 0:
        return SOURCES[{"simple": "planar-simple"}.get(map_class, map_class)]
    return None


def _of_girth(map_class: str, least: int) -> CountSource | None:
    if least == 1:
        return SOURCES[map_class]
    if least > 3 or (least == 2 and "simple" not in map_class):
        return None
    return SOURCES[{"maps": "simple", "planar": "planar-simple"}.get(map_class, map_class)]


SOURCES: dict[str, CountSource] = {
    "maps": CountSource("log-series of permutations", rooted_maps),
    "planar": CountSource("Carrell-Chapuy recurrence", lambda m: rooted_of_genus(m, 0)),
    "simple": CountSource("degree sequences of labelled graphs", rooted_simple_by_degrees),
    "planar-simple": CountSource(
        "substitution into planar maps", rooted_planar_simple_by_substitution
    ),
}
"""For each class of maps the source of its counts, for all numbers of edges and vertices."""

NARROWED: dict[str, Callable[[str, int], CountSource | None]] = {
    "cubic": lambda map_class, _: _of_degrees(map_class, lambda d: d == 3),
    "regular": lambda map_class, degree: _of_degrees(map_class, lambda d: d == degree),
    "eulerian": lambda map_class, _: _of_degrees(map_class, lambda d: d % 2 == 0),
    "trees": lambda _class, _: CountSource("Catalan numbers", rooted_trees),
    "girth": _of_girth,
    "genus": _of_genus,
    "triangulation": lambda map_class, _: _of_faces(map_class, 3),
    "quadrangulation": lambda map_class, _: _of_faces(map_class, 4),
}
"""For each kind of condition the function that returns the source of counts.

The function takes the name of a class, and the number in the condition's name.  The function
returns None if there is no source.
"""
