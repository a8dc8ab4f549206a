"""The formula of a search: two different worlds, and a bisimulation between their darts.

*One world*: the models are exactly the rooted maps of a class, each once.  The darts carry their
canonical numbers (see :mod:`allworlds.maps.combinatorial`): in the order of steps
``t = 0, 1, 2, ...`` the map is asked for ``sigma(0), alpha(0), sigma(1), ...``, and an answer is
either a number that has been given already or the next free one.  So a model is a canonical code,
and the number of models is the number of rooted maps.

*Bisimulation*: a relation of darts that holds between the two starts, that sigma and alpha keep,
and whose darts sense the same.  It exists exactly if no motion tells the two worlds apart: every
motion is a product of sigmas and one alpha.

*Different* starts from canonical codes that differ.  Two codes may differ and yet be one map
that is entered at two darts which look alike; :func:`forbid_other_start` excludes, dart by
dart, that the second world is the first one started elsewhere.
"""

from collections.abc import Mapping, Sequence
from itertools import chain, combinations, product
from math import prod
from pathlib import Path
from typing import TypeAlias

from msgspec import Struct

from allworlds.studies.ambiguity.question import Question, Size, Sizes
from allworlds.world.lighthouses.base import Where

Literal: TypeAlias = int
"""A variable ``1, 2, ...``, or its negative."""

Clause: TypeAlias = tuple[Literal, ...]
"""A disjunction of literals."""


class Block(Struct, frozen=True):
    """Consecutive variables, one for each index within a shape.

    Attributes:
        name: for example ``sigma1``.
        first: the variable of index 0, or ``(0, 0)``.
        shape: the numbers of indices, one or two; the last index runs fastest.
        meaning: a sentence over the indices ``[x][y]``.
    """

    name: str
    first: int
    shape: tuple[int, ...]
    meaning: str

    def __getitem__(self, index: int | tuple[int, int]) -> int:
        """The variable of an index."""
        if isinstance(index, int):
            return self.first + index
        return self.first + index[0] * self.shape[1] + index[1]

    def rows(self) -> list[range]:
        """The variables of a two-dimensional block, row by row."""
        rows, width = self.shape
        return [range(self.first + i * width, self.first + (i + 1) * width) for i in range(rows)]

    @property
    def variables(self) -> range:
        """Every variable of the block."""
        return range(self.first, self.first + prod(self.shape))


class Formula:
    """Clauses, and the blocks of variables that they are about.

    Attributes:
        title: what the formula says, line by line.
        blocks: of variables, in the order in which they were made.
        variable_count: the number of variables in all blocks.
        clauses: a list of tuples of literals.
    """

    def __init__(self, title: Sequence[str] = ()) -> None:
        self.title = title
        self.variable_count = 0
        self.clauses: list[Clause] = []
        self.blocks: list[Block] = []
        self._sections: list[tuple[int, str]] = []

    def block(self, name: str, shape: tuple[int, ...], meaning: str) -> Block:
        """Return new variables of a shape."""
        block = Block(name, self.variable_count + 1, shape, meaning)
        self.blocks.append(block)
        self.variable_count += prod(shape)
        return block

    def section(self, text: str) -> None:
        """Begin a section of clauses, whose meaning is written into the file as a comment."""
        self._sections.append((len(self.clauses), text))

    def add(self, *literals: Literal) -> None:
        """Add one clause, a disjunction of literals."""
        self.clauses.append(literals)

    def exactly_one(self, variables: Sequence[Literal]) -> None:
        """Require exactly one of these variables to be true."""
        self.clauses.append(tuple(variables))
        self.at_most_one(variables)

    def at_most_one(self, variables: Sequence[Literal]) -> None:
        """Require at most one of these variables to be true."""
        self.clauses += [(-a, -b) for a, b in combinations(variables, 2)]

    def equivalent(self, a: Literal, b: Literal, *unless: Literal) -> None:
        """Require both of two literals or neither to be true, unless another one is."""
        self.clauses += [(-a, *unless, b), (a, *unless, -b)]

    def write(self, path: Path) -> None:
        """The formula as a DIMACS file; comments say what each variable and clause means.

        Cost: about a microsecond a literal.
        """
        lines = [f"c {line}" for line in self.title]
        lines += [
            f"c variables {b.variables[0]}..{b.variables[-1]} "
            f"{b.name}{''.join(f'[{size}]' for size in b.shape)}: {b.meaning}"
            for b in self.blocks
            if b.variables
        ]
        header, *written = dimacs(self.variable_count, self.clauses)
        lines.append(header)
        ends = [start for start, _ in self._sections[1:]] + [len(written)]
        for (start, text), end in zip(self._sections, ends, strict=True):
            if start < end:
                lines.append(f"c clauses {start + 1}..{end}: {text}")
            lines += written[start:end]
        path.write_text("\n".join(lines) + "\n", encoding="ascii")


def dimacs(variables: int, clauses: Sequence[Clause]) -> list[str]:
    """The lines of a DIMACS file without comments."""
    lines = [" ".join(map(str, clause)) + " 0" for clause in clauses]
    return [f"p cnf {variables} {len(clauses)}", *lines]


def read_dimacs(path: Path, leave_out: str = "") -> tuple[int, list[Clause]]:
    """The number of variables and the clauses of a DIMACS file that :class:`Formula` wrote.

    Args:
        path: of the file.
        leave_out: the section whose clauses are left out.

    Raises:
        ValueError: if there is no such section.
    """
    variables, clauses, section, found = 0, list[Clause](), "", False
    for line in path.read_text(encoding="ascii").splitlines():
        if line.startswith("p cnf "):
            variables = int(line.split()[2])
        elif line.startswith("c clauses "):
            section = line.partition(": ")[2]
            found = found or section == leave_out
        elif not line.startswith("c") and not (leave_out and section == leave_out):
            clauses.append(tuple(map(int, line.split()[:-1])))
    if leave_out and not found:
        raise ValueError(f"{path} has no section {leave_out!r}")
    return variables, clauses


class OneWorld(Struct, frozen=True):
    """The variables of one rooted map; dart 0 is the root, vertex 0 is the root's.

    Their meanings stand where they are made, in :func:`one_world`.  Vertices are numbered by their
    first darts.
    """

    size: Size
    sigma: Block
    alpha: Block
    given: Block
    vertex: Block
    used: Block
    first: Block
    degree: Block
    place: Block

    def step(self, t: int, y: int) -> int:
        """The variable for: step t is answered by y."""
        return (self.alpha if t % 2 else self.sigma)[t // 2, y]

    def has_degree(self, x: int, degree: int) -> Clause:
        """The part of a clause for: the vertex of x has this degree; empty if none can."""
        return (self.degree[x, degree],) if degree < self.degree.shape[1] else ()


def one_world(formula: Formula, name: str, size: Size, asked: Question) -> OneWorld:
    """Add variables and clauses of one rooted map, and return the variables.

    Every model restricted to sigma and alpha is a rooted map of that size, with the class and
    degrees that are asked for, and every such map is one model.  ``name`` is appended to the names
    of the variables.

    Cost: O(N^3) clauses for N = 2m darts.
    """
    darts, most = size.darts, size.most
    largest = _largest_degree(size, asked)
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
        place=block(f"place{name}", (darts, largest), "x is sigma^k of its vertex's first"),
    )
    _permutations(formula, world)
    _canonical_numbers(formula, world)
    _vertices(formula, world)
    _degrees(formula, world, asked)
    if asked.map_class.simple:
        _simple(formula, world, name)
    if asked.map_class.planar:
        _planar(formula, world, name)
    return world


def _largest_degree(size: Size, asked: Question) -> int:
    limit = min(size.edges, size.most - 1) if asked.map_class.simple else size.darts
    if asked.degree_marked is not None and asked.degree_others is not None:
        limit = min(limit, max(asked.degree_marked, asked.degree_others))
    return max(limit, 1)


def _permutations(formula: Formula, world: OneWorld) -> None:
    sigma, alpha, darts = world.sigma, world.alpha, range(world.size.darts)
    formula.section("sigma is a permutation, alpha an involution without fixed points")
    for row in sigma.rows():
        formula.exactly_one(row)
    for y in darts:
        formula.exactly_one([sigma[x, y] for x in darts])
    for x, row in enumerate(alpha.rows()):
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
    for row in vertex.rows():
        formula.exactly_one(row)
    _constant(formula, sigma, vertex, vertex)
    _in_order(formula, vertex, world.used)
    formula.add(first[0])
    for x, v in product(range(1, darts), range(most)):
        formula.equivalent(first[x], -world.used[x - 1, v], -vertex[x, v])
    formula.section(f"at least {world.size.fewest} vertices")
    formula.add(world.used[darts - 1, world.size.fewest - 1])


def _constant(formula: Formula, step: Block, here: Block, there: Block) -> None:
    """Require that ``step`` takes a dart with a label in ``here`` to one with it in ``there``."""
    labels = range(here.shape[1])
    for x, y in product(range(step.shape[0]), repeat=2):
        formula.clauses += [(-step[x, y], -here[x, v], there[y, v]) for v in labels]


def _in_order(formula: Formula, label: Block, used: Block) -> None:
    """Require labels to be given in the order of their first darts, as ``used`` records."""
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


def _degrees(formula: Formula, world: OneWorld, asked: Question) -> None:
    darts, sigma, first, degree = world.size.darts, world.sigma, world.first, world.degree
    largest, place = degree.shape[1] - 1, world.place
    formula.section("places count from the first dart, so each vertex is one cycle of sigma")
    for x, row in enumerate(place.rows()):
        formula.exactly_one(row)
        formula.equivalent(first[x], place[x, 0])
    for x, y, k in product(range(darts), range(darts), range(largest)):
        after = [place[y, k + 1]] if k + 1 < largest else []
        formula.add(-sigma[x, y], -place[x, k], first[y], *after)
    formula.section("the degree is one more than the place of the last dart")
    for x, row in enumerate(degree.rows()):
        formula.exactly_one(row)
        formula.add(-degree[x, 0])
        for y, k in product(range(darts), range(largest)):
            formula.add(-sigma[x, y], -first[y], -place[x, k], degree[x, k + 1])
    _constant(formula, sigma, degree, degree)
    formula.section("the degrees that were asked for")
    if asked.degree_marked is not None:
        formula.add(*world.has_degree(0, asked.degree_marked))
    if asked.degree_others is not None:
        for x in range(1, darts):
            formula.add(world.vertex[x, 0], *world.has_degree(x, asked.degree_others))


def _simple(formula: Formula, world: OneWorld, name: str) -> None:
    darts, most = world.size.darts, world.size.most
    alpha, vertex = world.alpha, world.vertex
    target = formula.block(f"target{name}", (darts, most), "alpha(x) is at vertex v")
    formula.section("no loop")
    for row in target.rows():
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
    """Require ``n + f >= m + 2``.

    More faces are impossible, so the labels are exactly the faces.
    """
    size, darts = world.size, world.size.darts
    most_faces = size.edges + 2 - size.fewest
    face = formula.block(f"face{name}", (darts, most_faces), "x is on face f")
    ahead = formula.block(f"ahead{name}", (darts, most_faces), "alpha(x) is on face f")
    met = formula.block(f"met{name}", (darts, most_faces), "some dart 0..x is on face f")
    formula.section("phi = sigma . alpha stays at the face")
    for block in (face, ahead):
        for row in block.rows():
            formula.exactly_one(row)
    _constant(formula, world.alpha, face, ahead)
    _constant(formula, world.sigma, ahead, face)
    _in_order(formula, face, met)
    formula.section("Euler's formula of the sphere: with n vertices there are m + 2 - n faces")
    for n in range(size.fewest, size.most + 1):
        more_vertices = [world.used[darts - 1, n]] if n < size.most else []
        formula.add(*more_vertices, met[darts - 1, size.edges + 1 - n])


ALIKE = "related darts sense the same"
DIFFERENT = "the codes differ, and the first is the smaller one"
"""The sections of the formula that say that the two worlds look alike, and that they differ."""


class Pair(Struct, frozen=True):
    """The variables of two worlds.

    Attributes:
        one, two: the maps, rooted at the starts.
        pointed: for each world ``[x]``: x is a reference dart; empty where there are none.
        letters: for each world ``[x, l]``: x has letter l; empty where there are none.
    """

    question: Question
    one: OneWorld
    two: OneWorld
    pointed: tuple[Block, ...]
    letters: tuple[Block, ...] = ()

    def signs(self, x: int, y: int) -> list[tuple[Literal, Literal]]:
        """Whether dart x of the first world has a mark, and dart y of the second; for each mark."""
        if self.letters:
            one, two = self.letters
            return [(one[x, letter], two[y, letter]) for letter in range(one.shape[1])]
        return [(self.pointed[0][x], self.pointed[1][y])] if self.pointed else []


def pair_formula(question: Question, sizes: Sizes) -> tuple[Formula, Pair]:
    """The formula 'two different worlds of these sizes that no motion tells apart'.

    Cost: O(N^3) clauses for N darts in each world: some 300,000 for N = 28.
    """
    formula = Formula(_title(question, sizes))
    one = one_world(formula, "1", sizes.one, question)
    two = one_world(formula, "2", sizes.two, question)
    pointed: tuple[Block, ...] = ()
    if question.sensing.bearing:
        named = ("1", one), ("2", two)
        where = question.sensing.where
        pointed = tuple(_reference_darts(formula, name, where, world) for name, world in named)
        if not question.walk:
            formula.section("turning is free: the starts are reference darts")
            formula.clauses += [(block[0],) for block in pointed]
    letters: tuple[Block, ...] = ()
    if question.words:
        worlds = enumerate((one, two), 1)
        letters = tuple(_letters(formula, name, question.words, world) for name, world in worlds)
    pair = Pair(question, one, two, pointed, letters)
    _bisimulation(formula, pair)
    if one.size.edges == two.size.edges:
        _smaller_code(formula, pair)
    if question.sensing.marks_v0 and not pointed and not question.walk:
        _best_start(formula, one)
    _walk(formula, question, one)
    return formula, pair


def world_formula(question: Question, sizes: Sizes) -> Formula:
    """The formula 'one world of the second size, with the walk'. It decides whether any exists."""
    formula = Formula(_title(question, sizes))
    _walk(formula, question, one_world(formula, "1", sizes.two, question))
    return formula


def _title(question: Question, sizes: Sizes) -> list[str]:
    worlds = (f"{s.edges} edges, {s.fewest} to {s.most} vertices" for s in sizes)
    return [f"{question.describes}.", *(f"world {i}: {each}" for i, each in enumerate(worlds, 1))]


def _reference_darts(formula: Formula, name: str, where: Where, world: OneWorld) -> Block:
    """Require exactly one reference dart at every vertex, or at v0 alone."""
    darts, most = world.size.darts, world.size.most
    pointed = formula.block(f"pointed{name}", (darts,), "x is a reference dart")
    formula.section(f"world {name} has its reference darts")
    if where is Where.AT_V0:
        for x in range(darts):
            formula.add(-pointed[x], world.vertex[x, 0])
        formula.exactly_one(pointed.variables)
        return pointed
    at = formula.block(f"pointed_at{name}", (most, darts), "x is the reference dart of vertex v")
    for v, row in enumerate(at.rows()):
        formula.at_most_one(row)
        for x, here in enumerate(row):
            formula.add(-here, pointed[x])
            formula.add(-here, world.vertex[x, v])
            formula.add(here, -pointed[x], -world.vertex[x, v])
            formula.add(-world.vertex[x, v], *row)
    return pointed


def _letters(
    formula: Formula, name: int, words: Mapping[int, tuple[int, ...]], world: OneWorld
) -> Block:
    """Require the letters of a word at v0, where the start is at bearing 0, and none elsewhere."""
    found, (darts, degrees) = sorted({*chain(*words.values())} - {0}), world.degree.shape
    meaning = f"x has one of {','.join(map(str, found))}"
    has = formula.block(f"letter{name}", (darts, len(found)), meaning)
    formula.section(f"world {name} has its letters")
    formula.clauses += [(-world.degree[0, d],) for d in range(1, degrees) if d not in words]
    for x, (number, letter) in product(range(darts), enumerate(found)):
        formula.add(-has[x, number], world.vertex[x, 0])
        for degree, place in ((d, i) for d in range(1, degrees) for i in range(d) if d in words):
            sensed = has[x, number] if words[degree][-place] == letter else -has[x, number]
            at = -world.vertex[x, 0], -world.degree[x, degree], -world.place[x, place]
            formula.add(*at, sensed)
    return has


def _bisimulation(formula: Formula, pair: Pair) -> None:
    one, two = pair.one, pair.two
    darts = range(one.size.darts), range(two.size.darts)
    shape = (len(darts[0]), len(darts[1]))
    related = formula.block("related", shape, "no motion tells dart x of 1 from dart y of 2")
    formula.section("the starts are related, and what is related stays so under sigma and alpha")
    formula.add(related[0, 0])
    for name, step, other in (("sigma", one.sigma, two.sigma), ("alpha", one.alpha, two.alpha)):
        image = formula.block(f"{name}_related", shape, f"x is related to a y with {name}(y) = z")
        for x in darts[0]:
            for y, z in product(darts[1], darts[1]):
                formula.equivalent(related[x, y], image[x, z], -other[y, z])
            for w, z in product(*darts):
                formula.equivalent(image[x, z], related[w, z], -step[x, w])
    formula.section(ALIKE)
    for x, y in product(*darts):
        _sense_the_same(formula, pair, related[x, y], x, y)


def _sense_the_same(formula: Formula, pair: Pair, related: int, x: int, y: int) -> None:
    ones, twos = pair.one.degree.rows()[x], pair.two.degree.rows()[y]
    shared = min(len(ones), len(twos))
    alone = [(-related, -degree) for degree in (*ones[shared:], *twos[shared:])]
    alike = []
    if pair.question.sensing.marks_v0:
        alike.append((pair.one.vertex[x, 0], pair.two.vertex[y, 0]))
    alike += pair.signs(x, y)
    for a, b in zip(ones, twos, strict=False):
        formula.clauses += [(-related, -a, b), (-related, a, -b)]
    formula.clauses += alone
    for a, b in alike:
        formula.clauses += [(-related, -a, b), (-related, a, -b)]


def _smaller_code(formula: Formula, pair: Pair) -> None:
    """Require the first world's answer to be smaller at the first step with different answers.

    Looking alike is symmetric, so nothing is lost by asking for the smaller code first.
    """
    one, two, darts = pair.one, pair.two, pair.one.size.darts
    steps = 2 * darts
    marks = list(zip(*(block.variables for block in pair.pointed), strict=True))
    equal = formula.block(
        "equal", (steps + len(marks) + 1,), "the two codes agree in everything before step t"
    )
    formula.section(DIFFERENT)
    formula.add(equal[0])
    formula.add(-equal[steps + len(marks)])
    for t in range(steps):
        for y in range(darts):
            larger = [two.step(t, z) for z in range(y + 1, darts)]
            formula.add(-equal[t + 1], -one.step(t, y), two.step(t, y))
            formula.add(-equal[t], -one.step(t, y), two.step(t, y), *larger)
            formula.add(-equal[t], equal[t + 1], -one.step(t, y), -two.step(t, y))
        formula.add(-equal[t + 1], equal[t])
    for t, (mine, theirs) in enumerate(marks, steps):
        formula.add(-equal[t + 1], equal[t])
        formula.add(-equal[t + 1], -mine, theirs)
        formula.add(-equal[t], -mine, theirs)
        formula.add(-equal[t + 1], mine, -theirs)
        formula.add(-equal[t], equal[t + 1], -mine, -theirs)
        formula.add(-equal[t], equal[t + 1], mine, theirs)


def forbid_other_start(formula: Formula, pair: Pair, start: int) -> None:
    """Require that the second world entered at dart ``start`` is not the first world.

    Only where ``start`` could be the start, that is at v0 where a vertex is marked.  Let F be
    the numbering of the second map's darts from ``start`` that the first map's numbering
    prescribes; somewhere F does not carry the first map's sigma, alpha or reference darts to
    the second's.  ``start`` 0 is what the codes say already.
    """
    one, two, darts = pair.one, pair.two, range(pair.one.size.darts)
    shape = (len(darts), len(darts))
    carried = formula.block(f"carried{start}", shape, f"F takes x to y; F(0) = {start}")
    rows = 2 + max(len(pair.signs(0, 0)), 1)
    breaks = formula.block(f"breaks{start}", (rows, len(darts)), "F fails at x: sigma, alpha, mark")
    formula.section(f"started at dart {start}, world 2 is not world 1")
    excused = [-two.vertex[start, 0]] if pair.question.sensing.marks_v0 else []
    formula.add(carried[0, start])
    for parity, (step, other) in enumerate(((one.sigma, two.sigma), (one.alpha, two.alpha))):
        image = formula.block(f"image{parity}_{start}", shape, "y = step(F(x))")
        for x, y, z in product(darts, repeat=3):
            fresh = (-step[x, y], one.given[2 * x + parity, y + 1])
            formula.add(-carried[x, y], -other[y, z], image[x, z])
            formula.add(*fresh, -image[x, z], carried[y, z])
            formula.add(-breaks[parity, x], -step[x, y], -image[x, z], -carried[y, z])
    for x in darts:
        if not pair.signs(x, 0):
            formula.add(-breaks[2, x])
        for y in darts:
            for row, (mine, theirs) in enumerate(pair.signs(x, y), 2):
                formula.add(-breaks[row, x], -carried[x, y], mine, theirs)
                formula.add(-breaks[row, x], -carried[x, y], -mine, -theirs)
    formula.add(*excused, *breaks.variables)


def _walk(formula: Formula, question: Question, world: OneWorld) -> None:
    """Require the robot's walk in the first world, and equal percepts in the second."""
    if not question.walk:
        return
    darts = range(world.size.darts)
    turns = sum(abs(step.motion) + 1 for step in question.walk)
    at = formula.block("at", (turns + 1, len(darts)), "after i turns and traversals: dart x")
    formula.section("the walk and what it senses")
    formula.add(at[0, 0])
    i = 0
    for motion, degree, present in question.walk:
        for step in [*[world.sigma] * abs(motion), world.alpha]:
            back = motion < 0 and step is world.sigma
            for x, y in product(darts, darts):
                arrow = step[y, x] if back else step[x, y]
                formula.add(-at[i, x], -arrow, at[i + 1, y])
            i += 1
        for x in darts:
            formula.add(-at[i, x], *world.has_degree(x, degree))
            if question.sensing.marks_v0:
                at_v0 = world.vertex[x, 0]
                formula.add(-at[i, x], at_v0 if present else -at_v0)


def _best_start(formula: Formula, world: OneWorld) -> None:
    """Require that the start leads to a vertex of the largest degree among v0's darts.

    Turning is free.
    """
    darts, degrees = world.degree.shape
    beyond = formula.block("beyond", (darts, degrees), "alpha(x) is at a vertex of degree k")
    formula.section("turning is free: no dart of v0 leads to a larger degree than the start")
    for x in range(darts):
        for y, k in product(range(darts), range(degrees)):
            formula.add(-world.alpha[x, y], -world.degree[y, k], beyond[x, k])
        for k in range(degrees):
            formula.clauses += [
                (-world.vertex[x, 0], -beyond[x, k], -beyond[0, j]) for j in range(k)
            ]
