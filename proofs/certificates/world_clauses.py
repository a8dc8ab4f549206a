"""The clauses about one world: it is a rooted map of a class, in canonical numbers.

Its darts are ``0 .. N-1``; dart 0 is the root.  Ask for sigma(0), alpha(0), sigma(1), alpha(1)
and so on, and number the darts in the order in which they are answered: these are the canonical
numbers, and two rooted maps are the same exactly if they get the same answers.  So a model is a
rooted map, and each rooted map of the class is one model.  A test counts the models.

========================  =====================================================
``sigma[x][y]``           sigma(x) = y
``alpha[x][y]``           alpha(x) = y
``given[t][j]``           before question t at least j numbers have been given
``vertex[x][v]``          dart x is at vertex v; the root is at vertex 0
``used[x][v]``            one of the darts 0 .. x is at vertex v
``first[x]``              no dart before x is at the vertex of x
``degree[x][k]``          the vertex of x has k darts
``place[x][k]``           x = sigma^k(the first dart of its vertex)
``target[x][v]``          alpha(x) is at vertex v (simple maps)
``face[x][f]``            dart x is on face f (planar maps)
``ahead[x][f]``           alpha(x) is on face f (planar maps)
``met[x][f]``             one of the darts 0 .. x is on face f (planar maps)
========================  =====================================================
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

from clauses import Clauses, Row, Table
from lrat import Refused

LIGHTHOUSES = ("none", "position", "directional", "compass")
CLASSES = ("maps", "simple", "planar", "planar-simple")


@dataclass(frozen=True)
class Asked:
    """Which two worlds are asked for.

    Attributes:
        lighthouse: one of LIGHTHOUSES.
        map_class: one of CLASSES.
        marked: the degree of the start's vertex, where it is fixed.
        others: the degree of all other vertices, where it is fixed.
        walk: motions from the start, each with what is sensed after it: degree, and whether
            the robot is at the marked vertex.
    """

    lighthouse: str
    map_class: str
    marked: int | None = None
    others: int | None = None
    walk: tuple[tuple[int, int, bool], ...] = ()

    def __post_init__(self) -> None:
        for name, value, legal in (
            ("lighthouse", self.lighthouse, LIGHTHOUSES),
            ("class", self.map_class, CLASSES),
        ):
            if value not in legal:
                raise Refused(f"{name} {value!r} is not one of {', '.join(legal)}")
        for degree in (self.marked, self.others):
            if degree is not None and degree < 1:
                raise Refused(f"degree {degree}, but every vertex has at least one dart")

    @property
    def simple(self) -> bool:
        """Without loops and parallel edges."""
        return self.map_class in {"simple", "planar-simple"}

    @property
    def planar(self) -> bool:
        """Of genus 0."""
        return self.map_class in {"planar", "planar-simple"}

    @property
    def v0_is_marked(self) -> bool:
        """Whether the robot senses that it is at the start's vertex."""
        return self.lighthouse in {"position", "directional"}


@dataclass(frozen=True)
class Size:
    """The number of edges, and the least and the largest number of vertices."""

    edges: int
    fewest: int
    most: int

    @property
    def darts(self) -> int:
        """N = 2m."""
        return 2 * self.edges


def size_of(asked: Asked, edges: int, most: int | None = None) -> Size | None:
    """The numbers of vertices that a world with so many edges can have; None if it can have none.

    ``most``: no more vertices than this are asked for.
    """
    limit = edges + 1 if most is None else min(most, edges + 1)
    numbers = [n for n in range(1, limit + 1) if _possible(asked, edges, n)]
    return Size(edges, numbers[0], numbers[-1]) if numbers else None


def _possible(asked: Asked, m: int, n: int) -> bool:
    """No counting argument excludes a connected map with m edges and n vertices."""
    pairs, darts_of_others = n * (n - 1) // 2, (n - 1) * (asked.others or 1)
    if asked.simple and not (n >= 2 and m <= pairs):
        return False  # an edge joins two vertices, and no other edge the same two
    if asked.simple and asked.planar and n >= 3 and m > 3 * n - 6:
        return False  # every face has three edges or more, and n - m + f = 2
    if asked.others and asked.marked:
        return 2 * m == asked.marked + darts_of_others
    return 2 * m >= (asked.marked or 1) + darts_of_others  # every vertex has a dart


@dataclass(frozen=True)
class WorldTables:
    """The variables of one world; see the module."""

    size: Size
    sigma: Table
    alpha: Table
    given: Table
    vertex: Table
    used: Table
    first: Row
    degree: Table
    place: Table

    def answer(self, question: int, y: int) -> int:
        """The variable for: the question's answer is y.  Questions are sigma(0), alpha(0), ..."""
        dart, which = divmod(question, 2)
        return (self.sigma, self.alpha)[which][dart][y]


def a_world(clauses: Clauses, name: str, size: Size, asked: Asked) -> WorldTables:
    """The variables of a rooted map, with the clauses that make it one; ``name`` ends theirs."""
    darts, degrees = size.darts, largest_degree(size, asked)
    world = WorldTables(
        size,
        sigma=clauses.table(f"sigma{name}", darts, darts),
        alpha=clauses.table(f"alpha{name}", darts, darts),
        given=clauses.table(f"given{name}", 2 * darts + 1, darts + 1),
        vertex=clauses.table(f"vertex{name}", darts, size.most),
        used=clauses.table(f"used{name}", darts, size.most),
        first=clauses.row(f"first{name}", darts),
        degree=clauses.table(f"degree{name}", darts, degrees + 1),
        place=clauses.table(f"place{name}", darts, degrees),
    )
    _permutations(clauses, world)
    _canonical_numbers(clauses, world)
    _vertices(clauses, world)
    _places_and_degrees(clauses, world)
    _degrees_asked_for(clauses, world, asked)
    if asked.simple:
        _simple(clauses, world, name)
    if asked.planar:
        _planar(clauses, world, name)
    return world


def largest_degree(size: Size, asked: Asked) -> int:
    """No vertex has more darts: in a simple map one for each other vertex, or for each edge."""
    limits = [size.darts]
    if asked.simple:
        limits += [size.edges, size.most - 1]
    if asked.marked and asked.others:
        limits.append(max(asked.marked, asked.others))
    return max(1, min(limits))


def _permutations(clauses: Clauses, world: WorldTables) -> None:
    sigma, alpha, darts = world.sigma, world.alpha, range(world.size.darts)
    clauses.say("sigma is a permutation")
    for x in darts:
        clauses.exactly_one(sigma[x])
        clauses.exactly_one([sigma[y][x] for y in darts])
    clauses.say("alpha is an involution without fixed points")
    for x in darts:
        clauses.exactly_one(alpha[x])
        clauses.never(alpha[x][x])
        for y in range(x):
            clauses.equivalent([], alpha[x][y], alpha[y][x])


def _canonical_numbers(clauses: Clauses, world: WorldTables) -> None:
    given, darts = world.given, world.size.darts
    clauses.say("at first the number 0 has been given, and no other")
    for j, so_many in enumerate(given[0]):
        if j <= 1:
            clauses.always(so_many)
        else:
            clauses.never(so_many)
    clauses.say("an answer y is a number given before, or the next: then y + 1 have been given")
    for t, y in product(range(2 * darts), range(darts)):
        answered = world.answer(t, y)
        clauses.implies([answered], [given[t][y]])
        clauses.implies([answered], [given[t + 1][y + 1]])
        clauses.implies([given[t][y + 1]], [given[t][y]])
        clauses.implies([given[t][y + 1]], [given[t + 1][y + 1]])
        clauses.implies([given[t + 1][y + 1]], [given[t][y + 1], answered])
    for row in given[1:]:
        clauses.always(row[0])
    clauses.say("x has a number before sigma(x) is asked for: every dart is reached from the root")
    for x in range(darts):
        clauses.always(given[2 * x][x + 1])


def _vertices(clauses: Clauses, world: WorldTables) -> None:
    sigma, vertex, used, first = world.sigma, world.vertex, world.used, world.first
    darts, vertices = range(world.size.darts), range(world.size.most)
    clauses.say("every dart is at one vertex, and sigma stays there")
    for x in darts:
        clauses.exactly_one(vertex[x])
    for x, y, v in product(darts, darts, vertices):
        clauses.implies([sigma[x][y], vertex[x][v]], [vertex[y][v]])
    clauses.say("vertices are numbered in the order of their first darts")
    _numbered_as_met(clauses, vertex, used)
    clauses.say("the first dart of a vertex is the one that meets it")
    clauses.always(first[0])
    for x, v in product(darts[1:], vertices):
        clauses.never(first[x], vertex[x][v], used[x - 1][v])
        clauses.implies([vertex[x][v]], [first[x], used[x - 1][v]])
    clauses.say("there are at least as many vertices as a world of this class has")
    clauses.always(used[-1][world.size.fewest - 1])


def _numbered_as_met(clauses: Clauses, label: Table, used: Table) -> None:
    """``used[x]`` has the labels of 0 .. x, and a new label is the least that is left."""
    clauses.always(label[0][0])
    for x, v in product(range(len(label)), range(len(label[0]))):
        before = [used[x - 1][v]] if x else []
        clauses.implies([label[x][v]], [used[x][v]])
        clauses.implies([used[x][v]], [*before, label[x][v]])
        if x:
            clauses.implies([used[x - 1][v]], [used[x][v]])
        if x and v:
            clauses.implies([label[x][v]], [used[x - 1][v - 1]])


def _places_and_degrees(clauses: Clauses, world: WorldTables) -> None:
    sigma, first, place, degree = world.sigma, world.first, world.place, world.degree
    darts, places = range(world.size.darts), range(len(place[0]))
    clauses.say("the first dart has place 0, and sigma leads from place k to k + 1 or to the first")
    for x in darts:
        clauses.exactly_one(place[x])
        clauses.equivalent([], first[x], place[x][0])
    for x, y, k in product(darts, darts, places):
        clauses.implies([sigma[x][y], place[x][k]], [first[y], *place[y][k + 1 : k + 2]])
    clauses.say("where sigma leads from place k to the first dart, the vertex has degree k + 1")
    for x, y, k in product(darts, darts, places):
        clauses.implies([sigma[x][y], first[y], place[x][k]], [degree[x][k + 1]])
    clauses.say("every dart has one degree, which is not 0, and sigma keeps it")
    for x in darts:
        clauses.exactly_one(degree[x])
        clauses.never(degree[x][0])
    for x, y, k in product(darts, darts, range(len(degree[0]))):
        clauses.implies([sigma[x][y], degree[x][k]], [degree[y][k]])


def _degrees_asked_for(clauses: Clauses, world: WorldTables, asked: Asked) -> None:
    clauses.say("the start's vertex and all others have the degrees that are asked for")
    if asked.marked:
        clauses.implies([], having(world, 0, asked.marked))
    if asked.others:
        for x in range(1, world.size.darts):
            clauses.implies([], [world.vertex[x][0], *having(world, x, asked.others)])


def having(world: WorldTables, x: int, degree: int) -> list[int]:
    """The variable for: the vertex of x has this degree; none if no vertex can have it."""
    return world.degree[x][degree : degree + 1]


def _simple(clauses: Clauses, world: WorldTables, name: str) -> None:
    vertex, darts, vertices = world.vertex, range(world.size.darts), range(world.size.most)
    target = clauses.table(f"target{name}", len(darts), len(vertices))
    clauses.say("the target of x is the vertex of alpha(x)")
    for x in darts:
        clauses.exactly_one(target[x])
    for x, y, v in product(darts, darts, vertices):
        clauses.implies([world.alpha[x][y], vertex[x][v]], [target[y][v]])
    clauses.say("no edge joins a vertex to itself")
    for x, v in product(darts, vertices):
        clauses.never(vertex[x][v], target[x][v])
    clauses.say("no two edges join the same two vertices")
    for x, y, v, w in product(darts, darts, vertices, vertices):
        if y < x and v != w:
            clauses.never(vertex[x][v], vertex[y][v], target[x][w], target[y][w])


def _planar(clauses: Clauses, world: WorldTables, name: str) -> None:
    """No map has more than m + 2 - n faces; so if it has as many, it lies in the plane."""
    size, darts = world.size, range(world.size.darts)
    faces = range(size.edges + 2 - size.fewest)
    face = clauses.table(f"face{name}", len(darts), len(faces))
    ahead = clauses.table(f"ahead{name}", len(darts), len(faces))
    met = clauses.table(f"met{name}", len(darts), len(faces))
    clauses.say("every dart x is on one face, and so is sigma(alpha(x)), on the same one")
    for x in darts:
        clauses.exactly_one(face[x])
        clauses.exactly_one(ahead[x])
    for x, y, f in product(darts, darts, faces):
        clauses.implies([world.alpha[x][y], face[x][f]], [ahead[y][f]])
        clauses.implies([world.sigma[x][y], ahead[x][f]], [face[y][f]])
    clauses.say("faces are numbered in the order of their first darts")
    _numbered_as_met(clauses, face, met)
    clauses.say("with no more than n vertices there are at least m + 2 - n faces")
    for n in range(size.fewest, size.most + 1):
        more = world.used[-1][n : n + 1]
        clauses.implies([], [*more, met[-1][size.edges + 1 - n]])
