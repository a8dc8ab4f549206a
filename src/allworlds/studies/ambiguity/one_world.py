"""The formula of one world: its models are exactly the rooted maps of a class, each once.

The darts have their canonical numbers (see :mod:`allworlds.maps.combinatorial`): in the steps
``t = 0, 1, 2, ...`` the values ``sigma(0), alpha(0), sigma(1), ...`` are found, and each value is
either a number that was given before or the next free one.  So a model is a canonical code, and the
number of models is the number of rooted maps.

A *label* of a dart is a number, for example that of its vertex or of its face, or the degree of its
vertex.  A block of labels gives each dart exactly one label: its variable ``[x, v]`` says that dart
x has the label v.
"""

from itertools import product

from msgspec import Struct

from allworlds.studies.ambiguity.clauses import Atoms, Clause, Formula
from allworlds.studies.ambiguity.question import Question, Size


class OneWorld(Struct, frozen=True):
    """The variables of one rooted map; dart 0 is the root, vertex 0 is the vertex of the root.

    Vertices are numbered in the order of their first darts; the first dart of a vertex is the one
    with the smallest number.  Each attribute but ``size`` is a block of variables; the texts below
    say what a variable of the block means.

    Attributes:
        size: the number of edges, and the bounds on the number of vertices.
        sigma: ``[x, y]``: sigma(x) = y.
        alpha: ``[x, y]``: alpha(x) = y.
        given: ``[t, j]``: before step t, at least j darts have their numbers.  Step 2x finds
            sigma(x), step 2x + 1 finds alpha(x).
        vertex: ``[x, v]``: dart x is at vertex v.
        used: ``[x, v]``: one of the darts 0 to x is at vertex v.
        first: ``[x]``: dart x is the first dart of its vertex.
        degree: ``[x, k]``: the vertex of dart x has degree k.
        offset: ``[x, k]``: dart x is sigma^k of its vertex's first dart.
    """

    size: Size
    sigma: Atoms
    alpha: Atoms
    given: Atoms
    vertex: Atoms
    used: Atoms
    first: Atoms
    degree: Atoms
    offset: Atoms

    def step(self, t: int, y: int) -> int:
        """The variable of the statement 'the value found in step t is y'."""
        return (self.alpha if t % 2 else self.sigma)[t // 2, y]

    def has_degree(self, x: int, degree: int) -> Clause:
        """The literal 'the vertex of dart x has this degree', as a part of a clause.

        The part is empty if no vertex can have this degree.
        """
        return (self.degree[x, degree],) if degree < self.degree.shape[1] else ()


def one_world(formula: Formula, name: str, size: Size, question: Question) -> OneWorld:
    """Add variables and clauses of one rooted map, and return the variables.

    Every model, restricted to sigma and alpha, is a rooted map of this size.  It has the class and
    the degrees that the question of the search asks for.  Every rooted map with these properties is
    exactly one model.  ``name`` is appended to the names of the variables.

    Cost: O(N^3) clauses for N = 2m darts.
    """
    darts, most = size.darts, size.most
    largest = _largest_degree(size, question)
    block = formula.block
    world = OneWorld(
        size,
        sigma=block(f"sigma{name}", (darts, darts), "sigma(x) = y"),
        alpha=block(f"alpha{name}", (darts, darts), "alpha(x) = y"),
        given=block(
            f"given{name}",
            (2 * darts + 1, darts + 1),
            "at least j numbers are given before step t; steps are sigma(0), alpha(0), sigma(1)..",
        ),
        vertex=block(f"vertex{name}", (darts, most), "dart x is at vertex v"),
        used=block(f"used{name}", (darts, most), "some dart 0..x is at vertex v"),
        first=block(f"first{name}", (darts,), "x is the first dart of its vertex"),
        degree=block(f"degree{name}", (darts, largest + 1), "the vertex of x has degree k"),
        offset=block(f"place{name}", (darts, largest), "x is sigma^k of its vertex's first"),
    )
    _permutations(formula, world)
    _canonical_numbers(formula, world)
    _vertices(formula, world)
    _degrees(formula, world, question)
    if question.map_class.simple:
        _simple(formula, world, name)
    if question.map_class.planar:
        _planar(formula, world, name)
    return world


def _largest_degree(size: Size, question: Question) -> int:
    limit = min(size.edges, size.most - 1) if question.map_class.simple else size.darts
    if question.degree_marked is not None and question.degree_others is not None:
        limit = min(limit, max(question.degree_marked, question.degree_others))
    return max(limit, 1)


def _permutations(formula: Formula, world: OneWorld) -> None:
    sigma, alpha, darts = world.sigma, world.alpha, range(world.size.darts)
    formula.section("sigma is a permutation, alpha an involution without fixed points")
    for row in sigma.slices():
        formula.exactly_one(row)
    for y in darts:
        formula.exactly_one([sigma[x, y] for x in darts])
    for x, row in enumerate(alpha.slices()):
        formula.exactly_one(row)
        formula.add(-alpha[x, x])
        for y in range(x):
            formula.equivalent(alpha[x, y], alpha[y, x])


def _canonical_numbers(formula: Formula, world: OneWorld) -> None:
    given, darts = world.given, world.size.darts
    formula.section("an answer is a number that has been given, or the next free one")
    for j in range(darts + 1):
        formula.add(given[0, j] if j <= 1 else -given[0, j])
    for t in range(2 * darts):
        for y in range(darts):
            formula.add(-world.step(t, y), given[t, y])
            formula.add(-given[t, y + 1], given[t, y])
            formula.add(-given[t, y + 1], given[t + 1, y + 1])
            formula.add(-world.step(t, y), given[t + 1, y + 1])
            formula.add(-given[t + 1, y + 1], given[t, y + 1], world.step(t, y))
        formula.add(given[t + 1, 0])
    formula.section("a dart has its number before it is asked: the map is connected")
    for x in range(darts):
        formula.add(given[2 * x, x + 1])


def _vertices(formula: Formula, world: OneWorld) -> None:
    darts, most = world.size.darts, world.size.most
    sigma, vertex, first = world.sigma, world.vertex, world.first
    formula.section("sigma stays at the vertex")
    for row in vertex.slices():
        formula.exactly_one(row)
    _constant(formula, sigma, vertex, vertex)
    _in_order(formula, vertex, world.used)
    formula.add(first[0])
    for x, v in product(range(1, darts), range(most)):
        formula.equivalent(first[x], -world.used[x - 1, v], -vertex[x, v])
    formula.section(f"at least {world.size.fewest} vertices")
    formula.add(world.used[darts - 1, world.size.fewest - 1])


def _constant(formula: Formula, step: Atoms, here: Atoms, there: Atoms) -> None:
    """Require that dart y has the same label as dart x if ``step[x, y]`` is true.

    ``here`` is the block with the label of x, and ``there`` the block with the label of y.  They
    are one block, or two: for example the block of the faces of darts, and the block of the faces
    of their other ends.
    """
    labels = range(here.shape[1])
    for x, y in product(*map(range, step.shape)):
        formula.clauses += [(-step[x, y], -here[x, v], there[y, v]) for v in labels]


def _in_order(formula: Formula, label: Atoms, used: Atoms) -> None:
    """Require that vertices, or faces, are numbered in the order of their first darts.

    The block ``label`` has the number v of the vertex or face of each dart x.  The variable
    ``used[x, v]`` says that one of the darts 0 to x is at the vertex, or on the face, with the
    number v.
    """
    formula.section(f"{label.name} is numbered in the order of first darts")
    formula.add(label[0, 0])
    for x, v in product(*map(range, label.shape)):
        formula.add(-label[x, v], used[x, v])
        if x == 0:
            formula.add(-used[0, v], label[0, v])
            continue
        formula.add(-used[x - 1, v], used[x, v])
        formula.add(-used[x, v], used[x - 1, v], label[x, v])
        if v > 0:
            formula.add(-label[x, v], used[x - 1, v - 1])


def _degrees(formula: Formula, world: OneWorld, question: Question) -> None:
    darts, sigma, first, degree = world.size.darts, world.sigma, world.first, world.degree
    largest, offset = degree.shape[1] - 1, world.offset
    formula.section("places count from the first dart, so each vertex is one cycle of sigma")
    for x, row in enumerate(offset.slices()):
        formula.exactly_one(row)
        formula.equivalent(first[x], offset[x, 0])
    for x, y, k in product(range(darts), range(darts), range(largest)):
        after = [offset[y, k + 1]] if k + 1 < largest else []
        formula.add(-sigma[x, y], -offset[x, k], first[y], *after)
    formula.section("the degree is one more than the place of the last dart")
    for x, row in enumerate(degree.slices()):
        formula.exactly_one(row)
        formula.add(-degree[x, 0])
        for y, k in product(range(darts), range(largest)):
            formula.add(-sigma[x, y], -first[y], -offset[x, k], degree[x, k + 1])
    _constant(formula, sigma, degree, degree)
    formula.section("the degrees that were asked for")
    if question.degree_marked is not None:
        formula.add(*world.has_degree(0, question.degree_marked))
    if question.degree_others is not None:
        for x in range(1, darts):
            formula.add(world.vertex[x, 0], *world.has_degree(x, question.degree_others))


def _simple(formula: Formula, world: OneWorld, name: str) -> None:
    darts, most = world.size.darts, world.size.most
    alpha, vertex = world.alpha, world.vertex
    target = formula.block(f"target{name}", (darts, most), "alpha(x) is at vertex v")
    formula.section("no loop")
    for row in target.slices():
        formula.exactly_one(row)
    _constant(formula, alpha, vertex, target)
    for x, v in product(range(darts), range(most)):
        formula.add(-vertex[x, v], -target[x, v])
    formula.section("no two edges with the same ends")
    for x in range(darts):
        for y, v, w in product(range(x), range(most), range(most)):
            if w != v:
                formula.add(-vertex[x, v], -vertex[y, v], -target[x, w], -target[y, w])


def _planar(formula: Formula, world: OneWorld, name: str) -> None:
    """Require that the map is planar, by the inequality ``n + f >= m + 2``.

    Each face gets a number; f is how many numbers occur.  The clauses allow two faces with the same
    number.  But no map has more than ``m + 2 - n`` faces; so if the inequality holds, the map is
    planar, and different faces have different numbers.  ``name`` is the number of the world, for
    the names of variables.
    """
    size, darts = world.size, world.size.darts
    most_faces = size.edges + 2 - size.fewest
    face = formula.block(f"face{name}", (darts, most_faces), "x is on face f")
    ahead = formula.block(f"ahead{name}", (darts, most_faces), "alpha(x) is on face f")
    met = formula.block(f"met{name}", (darts, most_faces), "some dart 0..x is on face f")
    formula.section("phi = sigma . alpha stays at the face")
    for block in (face, ahead):
        for row in block.slices():
            formula.exactly_one(row)
    _constant(formula, world.alpha, face, ahead)
    _constant(formula, world.sigma, ahead, face)
    _in_order(formula, face, met)
    formula.section("Euler's formula of the sphere: with n vertices there are m + 2 - n faces")
    for n in range(size.fewest, size.most + 1):
        more_vertices = [world.used[darts - 1, n]] if n < size.most else []
        formula.add(*more_vertices, met[darts - 1, size.edges + 1 - n])
