"""The formula of a search: two different worlds, and a bisimulation between their darts.

*One world*: the variables of each world say what its sigma and alpha are.  In each solution of the
formula they give the code of a rooted map (:mod:`allworlds.studies.ambiguity.one_world`).

*Bisimulation*: a relation between the darts of two worlds that relates the two starts, is preserved
by sigma and alpha, and relates only darts with equal percepts.  Such a relation exists exactly if
no motion tells the worlds apart, because every motion is a product of sigmas and one alpha.

*Different*: the canonical codes differ.  Two different codes may still belong to one map that is
entered at two darts which look alike.  A call of :func:`forbid_other_start` excludes this for one
dart: entered at this dart, the second world must not be the first one.
"""

from collections.abc import Mapping
from itertools import chain, product

from msgspec import Struct

from allworlds.studies.ambiguity.clauses import Atoms, Formula, Literal
from allworlds.studies.ambiguity.one_world import OneWorld, one_world
from allworlds.studies.ambiguity.question import Question, Sizes
from allworlds.world.lighthouses.base import Where

ALIKE = "related darts sense the same"
DIFFERENT = "the codes differ, and the first is the smaller one"
"""The texts of two sections of the formula: the worlds look alike, and the worlds differ."""


class PairVariables(Struct, frozen=True):
    """The variables of two worlds, and the question of a search.

    Attributes:
        question: the properties that the two worlds must have.
        one, two: the variables of the maps, rooted at the starts.
        pointed: a block for each world; its variable x says whether dart x is a reference dart, to
            which bearings are counted.  Empty if the robot senses no bearing.
        letters: a block for each world; its variable ``[x, l]`` says whether dart x has the l-th
            letter.  Empty if the lighthouse has no letters.
    """

    question: Question
    one: OneWorld
    two: OneWorld
    pointed: tuple[Atoms, ...]
    letters: tuple[Atoms, ...] = ()

    def signs(self, x: int, y: int) -> list[tuple[Literal, Literal]]:
        """Pairs of literals about dart x of the first world and dart y of the second world.

        There is a pair for each property by which a robot can tell darts of one vertex apart: that
        the dart is a reference dart, or that the dart has a certain letter of v0.  The first
        literal says that x has the property, the second that y has it.  The list is empty if under
        the lighthouse there are no reference darts and no letters.
        """
        if self.letters:
            one, two = self.letters
            return [(one[x, letter], two[y, letter]) for letter in range(one.shape[1])]
        return [(self.pointed[0][x], self.pointed[1][y])] if self.pointed else []


def pair_formula(question: Question, sizes: Sizes) -> tuple[Formula, PairVariables]:
    """The formula 'two different worlds of these sizes that no motion tells apart'.

    Cost: O(N^3) clauses for N darts in each world: some 300,000 for N = 28.
    """
    formula = Formula(_title(question, sizes))
    one = one_world(formula, "1", sizes.one, question)
    two = one_world(formula, "2", sizes.two, question)
    pointed: tuple[Atoms, ...] = ()
    if question.sensing.bearing:
        named = ("1", one), ("2", two)
        where = question.sensing.where
        pointed = tuple(_reference_darts(formula, name, where, world) for name, world in named)
        if not question.walk:
            formula.section("turning is free: the starts are reference darts")
            formula.clauses += [(block[0],) for block in pointed]
    letters: tuple[Atoms, ...] = ()
    if question.words:
        worlds = enumerate((one, two), 1)
        letters = tuple(_letters(formula, name, question.words, world) for name, world in worlds)
    pair = PairVariables(question, one, two, pointed, letters)
    _bisimulation(formula, pair)
    if one.size.edges == two.size.edges:
        _smaller_code(formula, pair)
    if question.sensing.marks_v0 and not (pointed or letters or question.walk):
        _best_start(formula, one)
    _walk(formula, question, one)
    return formula, pair


def world_formula(question: Question, sizes: Sizes) -> Formula:
    """The formula 'in one world of size ``sizes.two``, the robot senses the percepts of the walk'.

    The walk and its percepts are those that the user asked for.
    """
    formula = Formula(_title(question, sizes))
    _walk(formula, question, one_world(formula, "1", sizes.two, question))
    return formula


def _title(question: Question, sizes: Sizes) -> list[str]:
    worlds = (f"{s.edges} edges, {s.fewest} to {s.most} vertices" for s in sizes)
    return [f"{question.describes}.", *(f"world {i}: {each}" for i, each in enumerate(worlds, 1))]


def _reference_darts(formula: Formula, name: str, where: Where, world: OneWorld) -> Atoms:
    """Require exactly one reference dart at each vertex at which the robot senses a bearing.

    ``where`` names these vertices: v0 alone (``AT_V0``), otherwise all vertices.  ``name`` is the
    number of the world, as a text for the names of variables.  The variable x of the returned block
    says whether dart x is a reference dart.
    """
    darts, most = world.size.darts, world.size.most
    pointed = formula.block(f"pointed{name}", (darts,), "x is a reference dart")
    formula.section(f"world {name} has its reference darts")
    if where is Where.AT_V0:
        for x in range(darts):
            formula.add(-pointed[x], world.vertex[x, 0])
        formula.exactly_one(pointed.variables)
        return pointed
    at = formula.block(f"pointed_at{name}", (most, darts), "x is the reference dart of vertex v")
    for v, row in enumerate(at.slices()):
        formula.at_most_one(row)
        for x, here in enumerate(row):
            formula.add(-here, pointed[x])
            formula.add(-here, world.vertex[x, v])
            formula.add(here, -pointed[x], -world.vertex[x, v])
            formula.add(-world.vertex[x, v], *row)
    return pointed


def _letters(
    formula: Formula, name: int, words: Mapping[int, tuple[int, ...]], world: OneWorld
) -> Atoms:
    """Require the letters of v0's word at the darts of v0, and no letters elsewhere.

    A letter is the number of marks that a robot senses at a dart of v0; 0 stands for no mark.

    Args:
        formula: the formula, which gets the clauses.
        name: the number of the world, 1 or 2, which is put at the end of the variables' names.
        words: a word for each degree that v0 can have: the letters at the bearings 0, 1 and so on.
            Here the bearing of a dart is the number of darts, clockwise, from this dart to the
            start; so the start has bearing 0.
        world: the variables of the world.

    Returns:
        A block of variables; ``[x, l]`` says whether dart x has the letter number l.  The letters
            are numbered from 0 on, in ascending order: all letters that occur in ``words``, except
            0.
    """
    found, (darts, degrees) = sorted({*chain(*words.values())} - {0}), world.degree.shape
    meaning = f"x has one of {','.join(map(str, found))}"
    has = formula.block(f"letter{name}", (darts, len(found)), meaning)
    formula.section(f"world {name} has its letters")
    formula.clauses += [(-world.degree[0, d],) for d in range(1, degrees) if d not in words]
    for x, (number, letter) in product(range(darts), enumerate(found)):
        formula.add(-has[x, number], world.vertex[x, 0])
        for degree, offset in ((d, i) for d in range(1, degrees) for i in range(d) if d in words):
            sensed = has[x, number] if words[degree][-offset] == letter else -has[x, number]
            at = -world.vertex[x, 0], -world.degree[x, degree], -world.offset[x, offset]
            formula.add(*at, sensed)
    return has


def _bisimulation(formula: Formula, pair: PairVariables) -> None:
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


def _sense_the_same(formula: Formula, pair: PairVariables, related: int, x: int, y: int) -> None:
    ones, twos = pair.one.degree.slices()[x], pair.two.degree.slices()[y]
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


def _smaller_code(formula: Formula, pair: PairVariables) -> None:
    """Require the first world's code to be smaller, at the first step in which the codes differ.

    No pair of worlds is lost: if the second code is smaller, the formula has a model with the same
    two worlds in the other order.
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


def forbid_other_start(formula: Formula, pair: PairVariables, start: int) -> None:
    """Require that the second world, if it is entered at dart ``start``, is not the first world.

    If it is the first world, an isomorphism F of the maps takes dart 0 of the first map to
    ``start`` in the second map.  There is at most one such F, which follows from F(0): F must take
    the dart sigma(x) to sigma(F(x)), and the dart alpha(x) to alpha(F(x)).  In a code
    (:mod:`allworlds.studies.ambiguity.one_world`) each dart but 0 is met first as sigma(x) or as
    alpha(x) for a dart x with a smaller number; so every dart has its image.  The clauses require
    that F is no isomorphism: that for some dart F does not keep sigma, alpha, the reference dart or
    a letter.

    If a marker shows v0, and ``start`` is a dart of another vertex, F moves the marker, so F is no
    isomorphism in any case.  Then the clauses require nothing.  ``start`` is never 0: other clauses
    require already that the two codes differ.
    """
    one, two, darts = pair.one, pair.two, range(pair.one.size.darts)
    shape = (len(darts), len(darts))
    carried = formula.block(f"carried{start}", shape, f"F takes x to y; F(0) = {start}")
    breaks_shape = 2 + max(len(pair.signs(0, 0)), 1), len(darts)
    breaks = formula.block(f"breaks{start}", breaks_shape, "F fails at x: sigma, alpha, mark")
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
    """Require that in this world a robot senses the user's percepts on the user's walk."""
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
    """Require that of all darts of v0 the start leads to a vertex of the largest degree.

    The solver then has fewer cases to try.  Under the lighthouse ``position`` no pair of worlds
    that look alike is lost.  For if the robots in both worlds turn at v0 by the same number of
    darts, the worlds also look alike from the new darts: a bisimulation is preserved by sigma.  So
    any dart of v0 can be the start.

    Args:
        formula: the formula, which gets the clauses.
        world: the variables of the first world; the start of the second world follows from its
            start.
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
