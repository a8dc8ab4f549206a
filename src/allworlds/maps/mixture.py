"""Distributions of random maps, by name: the parts of the mixtures from which ``fuzz`` draws.

A mixture is a list of such distributions; each of them is a *part* of the mixture.  Each
distribution is a function of ``edges``, the requested number of edges, and ``random``, the source
of all random choices.  The function returns a map with a random root and with about the requested
number of edges, but never more.

To *cross* two edges, one with the darts a and b, one with the darts c and d, is to replace the two
edges by an edge with the darts a and d, and an edge with the darts c and b.  The order of the darts
round each vertex stays.
"""

from collections.abc import Callable, Iterable
from itertools import count
from math import isqrt
from random import Random
from typing import TypeAlias

from allworlds.inputs.checks import InputError, not_one_of, show
from allworlds.maps import build, families
from allworlds.maps.classes import Condition, Extent, MapClass, narrowing
from allworlds.maps.combinatorial import CombinatorialMap, rooted_code, unreached
from allworlds.maps.enumeration import Gluing

Generator: TypeAlias = Callable[[int, Random], CombinatorialMap]
"""A function that draws a map with the requested number of edges, or fewer."""

DEAD_ENDS = 5
"""The number of attempts that may end without a map before a condition is dropped."""


def glued(map_class: MapClass, where: Condition | None = None) -> Generator:
    """The function that draws a map of a class by random decisions of a :class:`Gluing`.

    At each decision all legal decisions are equally likely; but the maps are not all equally
    likely.  If the first :data:`DEAD_ENDS` attempts under the condition ``where`` all end without a
    map, the condition is dropped.
    """

    def generate(edges: int, random: Random) -> CombinatorialMap:
        for tries in count():
            gluing = Gluing(edges, map_class, where=where if tries < DEAD_ENDS else None)
            while not gluing.finished:
                following = list(gluing.successors())
                if not following:
                    break
                gluing = random.choice(following)[1]
            else:
                return gluing.finish()
        raise AssertionError  # it goes on for ever

    return generate


def sparse(edges: int, random: Random) -> CombinatorialMap:
    """A tree with a few further edges."""
    more = random.randint(0, 1 + edges // 4)
    return families.sparse(max(1, edges + 1 - more), edges, random)


def dense(edges: int, random: Random) -> CombinatorialMap:
    """A map with few vertices, each with many darts.

    The number of vertices is at most 1 more than the square root of the number of edges.
    """
    return families.sparse(random.randint(1, 1 + isqrt(edges)), edges, random)


def regular(edges: int, random: Random) -> CombinatorialMap:
    """A map whose vertices all have the same degree, from 3 to 6; half of the maps are cubic.

    If ``edges`` is too small for the degree, the map is a cycle.
    """
    degree = random.choice((3, 3, 3, 4, 5, 6))
    vertices = 2 * edges // degree
    vertices -= degree * vertices % 2
    return families.regular(degree, vertices, random) if vertices else build.cycle(edges)


def lattice(edges: int, random: Random) -> CombinatorialMap:
    """A nearly square lattice with holes."""
    sides = [(r, edges_along(r, edges)) for r in range(1, edges + 1)]
    return _with_holes(random.choice([(r, c) for r, c in sides if c >= max(r, 2)][-4:]), random)


def strip(edges: int, random: Random) -> CombinatorialMap:
    """A lattice with 1 to 3 rows, and with holes."""
    rows = random.randint(1, 3)
    columns = edges_along(rows, edges)
    return _with_holes((rows, columns) if columns else (1, edges + 1), random)


def edges_along(rows: int, edges: int) -> int:
    """The largest number of columns of a lattice with ``rows`` rows and at most ``edges`` edges."""
    return max(0, (edges + rows) // (2 * rows - 1))


def _with_holes(sides: tuple[int, int], random: Random) -> CombinatorialMap:
    rows, columns = sides
    total = rows * (columns - 1) + columns * (rows - 1)
    # What is left must be connected; often a few are missing, seldom all that can.
    holes = random.randint(0, random.randint(0, total - (rows * columns - 1))) / total
    return build.lattice(rows, columns, holes, random.getrandbits(32))


def bouquet(edges: int, random: Random) -> CombinatorialMap:
    """A map of loops at one vertex, in random order, and one edge from this vertex to a leaf."""
    return families.bouquet(edges - 1, random)


def thick(edges: int, random: Random) -> CombinatorialMap:
    """A path with loops at its vertices; all inner vertices have the same degree, 4, 6 or 8.

    If ``edges`` is too small for such a path, the map is a :func:`bouquet`.
    """
    degree = 2 * random.randint(2, 4)
    length = (edges - 2 * ((degree - 1) // 2) + degree // 2 - 1) // (degree // 2)
    return families.thick(degree, length, random) if length > 0 else bouquet(edges, random)


def corridor(edges: int, random: Random) -> CombinatorialMap:
    """A path with loops that leads to a random part: a :func:`~allworlds.maps.families.lollipop`.

    This part of the mixture does not draw from the family ``corridor`` of the module ``families``.
    Nearly all vertices have the same degree, 4 or 6.  If ``edges`` is too small for such a map, the
    map is a :func:`bouquet`.
    """
    degree = random.choice((4, 6))
    length = (edges - 1) // degree
    return families.lollipop(degree, length, random) if length else bouquet(edges, random)


def cover(edges: int, random: Random) -> CombinatorialMap:
    """A connected covering of a small map, in which edges lead from sheet to sheet at random.

    Each sheet has a copy of each vertex of the small map.  For each edge of the small map outside a
    spanning tree a random permutation p of the sheets is drawn: the copy of the edge that begins in
    sheet s ends in sheet p(s).  Finally one edge may be removed, contracted, or crossed with
    another edge.
    """

    def voltages(sheets: int, free: int) -> list[list[int]]:
        around = random.sample(range(sheets), sheets)
        whole = [0] * sheets
        for i, s in enumerate(around):
            whole[s] = around[i - 1]  # one cycle, so that it is connected
        return [whole, *(random.sample(range(sheets), sheets) for _ in range(free - 1))]

    return _spoiled(_lifted(edges, random, voltages), random)


def ring(edges: int, random: Random) -> CombinatorialMap:
    """A connected covering of a small map, with the sheets in a ring.

    An edge leads to the same sheet or to a neighbouring sheet.  Finally one edge may be removed,
    contracted, or crossed with another edge.
    """

    def voltages(sheets: int, free: int) -> list[list[int]]:
        turns = [1, *(random.choice((0, 0, 1, -1)) for _ in range(free - 1))]
        return [[(s + turn) % sheets for s in range(sheets)] for turn in turns]

    return _spoiled(_lifted(edges, random, voltages), random)


LARGEST_BASE = 6
"""The largest number of edges of a small map of which coverings are made."""


def _lifted(
    edges: int, random: Random, voltages: Callable[[int, int], list[list[int]]]
) -> CombinatorialMap:
    """A covering of a small random map, with the most sheets that ``edges`` edges allow.

    If ``edges`` is at least 3, the small map is cubic with probability 1/2.

    Args:
        edges: the largest number of edges of the covering.
        random: the source of all choices.
        voltages: the function that takes the number of sheets, and the number of those edges of the
            small map that are outside a spanning tree.  It returns for each of these edges one
            permutation of the sheets, called the edge's voltage.  A copy of the edge leads from
            sheet s to sheet p(s), where p is this permutation.  A copy of an edge of the tree leads
            to the same sheet.
    """
    size = random.randint(1, min(LARGEST_BASE, edges))
    base = families.sparse(random.randint(1, size), size, random)
    if edges >= 3 and random.getrandbits(1):
        base = families.cubic(2 * random.randint(1, min(2, edges // 3)), random)
    sheets = edges // base.edge_count
    tree, free = _spanning(base)
    names = {d: i for i, edge in enumerate(base.edges) for d in edge}
    lifts = dict(zip(free, voltages(sheets, len(free)), strict=True))
    lifts |= {d: [*range(sheets)] for d in tree}
    after = {base.alpha[d]: lift for d, lift in lifts.items()}
    return build.from_cycles(
        [
            [(names[d], s if d in lifts else after[d].index(s)) for d in around]
            for around in base.vertices
            for s in range(sheets)
        ]
    )


def _spanning(base: CombinatorialMap) -> tuple[list[int], list[int]]:
    """One dart of each edge in a spanning tree; and one dart of each edge outside the tree."""
    met, tree, owner = {0}, list[int](), base.vertex_of
    for d in (queue := list(base.vertices[0])):
        end = owner[base.alpha[d]]
        if end not in met:
            met.add(end)
            tree.append(d)
            queue.extend(base.vertices[end])
    taken = {*tree, *(base.alpha[d] for d in tree)}
    return tree, [d for d, _ in base.edges if d not in taken]


def _spoiled(map_: CombinatorialMap, random: Random) -> CombinatorialMap:
    """The map after one random change: an edge is removed or contracted, or two edges are crossed.

    The result is ``map_`` itself with probability 1/4, and also if the change would not result in a
    map.
    """
    a, c = random.choice(map_.darts), random.choice(map_.darts)
    b, d = map_.alpha[a], map_.alpha[c]
    crossed = None
    if len({a, b, c, d}) == 4:  # two edges
        alpha = [*map_.alpha]
        alpha[a], alpha[d], alpha[c], alpha[b] = d, a, b, c
        if not unreached(map_.sigma, alpha):
            crossed = CombinatorialMap(map_.sigma, alpha)
    other = random.choice((None, build.deleted(map_, a), build.contracted(map_, a), crossed))
    return other or map_


def mutated(map_: CombinatorialMap, most: int, random: Random) -> CombinatorialMap:
    """The map after one, two or four random changes.

    A change removes, contracts or adds an edge, crosses two edges, or chooses another root.  An
    edge is added to the map or to its dual; an edge added to the dual splits a vertex of the map.

    Args:
        map_: the map to change.
        most: the largest number of edges of the result.
        random: the source of all choices.
    """
    for _ in range(random.choice((1, 1, 2, 4))):
        change = random.randrange(6)
        if change < 2 and map_.edge_count < most:
            map_ = _with_more(map_.dual(), random).dual() if change else _with_more(map_, random)
        else:
            map_ = rerooted(map_, random) if change == 2 else _spoiled(map_, random)
    return map_


def _with_more(map_: CombinatorialMap, random: Random) -> CombinatorialMap:
    """The map with an additional edge; each of its two darts is put after a random dart."""
    sigma = [*map_.sigma]
    for new in (len(sigma), len(sigma) + 1):
        at = random.randrange(new)
        sigma.append(sigma[at])
        sigma[at] = new
    return CombinatorialMap.trusted(sigma, [*map_.alpha, new, new - 1])


PARTS: dict[str, Generator] = {
    "uniform": families.random_map,
    "cover": cover,
    "ring": ring,
    "regular": regular,
    "sparse": sparse,
    "planar": families.planar,
    "thick": thick,
    "dense": dense,
    "strip": strip,
    "lattice": lattice,
    "corridor": corridor,
    "bouquet": bouquet,
}
"""The parts of mixtures, by their names, without :data:`HISTORIES`, which depends on a class."""

HISTORIES = "histories"
"""The name of the part that draws maps by :func:`glued`; every class and every size can have it."""

MIXES: dict[MapClass, tuple[str, ...]] = {
    MapClass.MAPS: tuple(PARTS),
    MapClass.PLANAR: ("planar", HISTORIES, "lattice", "strip"),
    MapClass.SIMPLE: (HISTORIES, "cover", "ring", "lattice", "strip", "regular"),
    MapClass.PLANAR_SIMPLE: (HISTORIES, "lattice", "strip"),
}
"""For each class of maps, the names of the parts of its default mixture."""


def default_mix(extent: Extent) -> tuple[str, ...]:
    """The names of the parts of the default mixture for an extent.

    If the extent's condition is built in, or is several conditions at once of which at least one is
    built in, there is one part: :data:`HISTORIES`, since :func:`glued` tests the condition while
    it draws.  In all other cases the parts follow from the class alone.  One of these cases is a
    condition that consists only of a user's own code.
    """
    return (HISTORIES,) if narrowing(extent.where) else MIXES.get(extent.map_class, (HISTORIES,))


def generator(part: str, extent: Extent) -> Generator:
    """The function that draws maps from the distribution with the name ``part``.

    The maps are made for ``extent``, but some of them may be outside the extent.
    """
    if part == HISTORIES:
        return glued(extent.map_class, extent.where if narrowing(extent.where) else None)
    return PARTS[part]


def mix_named(given: object) -> tuple[str, ...] | None:
    """The names of parts of a mixture in ``given``, one name or several, as a tuple.

    The result is None if ``given`` is None.

    Raises:
        InputError: naming a text that is no name of a part, or occurs twice.
    """
    if given is None:
        return None
    names = (given,) if isinstance(given, str) or not isinstance(given, Iterable) else (*given,)
    for i, name in enumerate(names):
        if name not in (known := (*PARTS, HISTORIES)):
            raise not_one_of("mix", name, known)
        if name in names[:i]:
            raise InputError(f"mix: {show(name)} stands there twice")
    return names


def rerooted(map_: CombinatorialMap, random: Random) -> CombinatorialMap:
    """The map with a random root, which becomes dart 0."""
    code = rooted_code(map_.sigma, map_.alpha, random.choice(map_.darts))
    return CombinatorialMap.trusted(*code)
