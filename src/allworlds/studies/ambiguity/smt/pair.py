"""The clauses whose models are two different worlds and a bisimulation between their darts.

A *bisimulation* is a relation of darts that holds between the two starts, that sigma and
alpha keep, and whose darts sense the same.  It exists exactly if no motion tells the two
worlds apart: every motion is a product of sigmas and one alpha.

*Different* starts from canonical codes that differ.  Two codes may differ and yet be one map
that is entered at two darts which look alike; :func:`forbid_other_start` excludes, dart by
dart, that the second world is the first one started elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from allworlds.studies.ambiguity.smt.formula import Block, Formula
from allworlds.studies.ambiguity.smt.one_world import OneWorld, Size, one_world
from allworlds.studies.ambiguity.smt.question import Question, Sensed, Sizes
from allworlds.world.lighthouses.base import Sensing, Where

ALIKE = "related darts sense the same"
DIFFERENT = "the codes differ, and the first is the smaller one"
"""The sections of the formula that say that the two worlds look alike, and that they differ."""


class Pair(Struct, frozen=True):
    """The variables of two worlds.

    Attributes:
        one, two: the maps, rooted at the starts.
        pointed: for each world ``[x]``: x is a reference dart; None where there are none.
    """

    question: Question
    one: OneWorld
    two: OneWorld
    pointed: tuple[Block, Block] | None


def pair_formula(question: Question, sizes: Sizes) -> tuple[Formula, Pair]:
    """The formula 'two different worlds of these sizes that no motion tells apart'.

    Cost: O(N^3) clauses for N darts in each world: some 300,000 for N = 28.
    """
    formula = Formula(_title(question, sizes))
    one = _world(formula, "1", question, sizes.one)
    two = _world(formula, "2", question, sizes.two)
    pointed = None
    if question.sensing.bearing:
        pointed = (
            _reference_darts(formula, "1", question.sensing, one),
            _reference_darts(formula, "2", question.sensing, two),
        )
        if not question.walk.motions:
            formula.section("turning is free: the starts are reference darts")
            formula.add(pointed[0][0])
            formula.add(pointed[1][0])
    pair = Pair(question, one, two, pointed)
    _bisimulation(formula, pair)
    if one.size.edges == two.size.edges:
        _smaller_code(formula, pair)
    if question.sensing.marks_v0 and not pointed and not question.walk.motions:
        _best_start(formula, one)
    _walk(formula, question, one)
    return formula, pair


def world_formula(question: Question, sizes: Sizes) -> tuple[Formula, OneWorld]:
    """The formula 'one world of the second size, with the walk'. It decides whether any exists."""
    formula = Formula(_title(question, sizes))
    world = _world(formula, "1", question, sizes.two)
    _walk(formula, question, world)
    return formula, world


def _title(question: Question, sizes: Sizes) -> list[str]:
    worlds = [
        f"world {i}: {s.edges} edges, {s.fewest} to {s.most} vertices"
        for i, s in enumerate(sizes, 1)
    ]
    return [f"{question.describes}.", *worlds]


def _world(formula: Formula, name: str, question: Question, size: Size) -> OneWorld:
    return one_world(formula, name, size, question.map_class, question.degrees)


def _reference_darts(formula: Formula, name: str, sensing: Sensing, world: OneWorld) -> Block:
    """Require exactly one reference dart at every vertex, or at v0 alone."""
    darts, most = world.size.darts, world.size.most
    pointed = formula.block(f"pointed{name}", (darts,), "x is a reference dart")
    formula.section(f"world {name} has its reference darts")
    if sensing.where is Where.AT_V0:
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
            for y in darts[1]:
                for z in darts[1]:
                    formula.add(-related[x, y], -other[y, z], image[x, z])
                    formula.add(related[x, y], -other[y, z], -image[x, z])
            for w in darts[0]:
                for z in darts[1]:
                    formula.add(-image[x, z], -step[x, w], related[w, z])
                    formula.add(image[x, z], -step[x, w], -related[w, z])
    formula.section(ALIKE)
    for x in darts[0]:
        for y in darts[1]:
            _sense_the_same(formula, pair, related[x, y], x, y)


def _sense_the_same(formula: Formula, pair: Pair, related: int, x: int, y: int) -> None:
    one, two = pair.one, pair.two
    ones, twos = one.degree.rows()[x], two.degree.rows()[y]
    shared = min(len(ones), len(twos))
    for k in range(max(len(ones), len(twos))):
        if k < shared:
            formula.add(-related, -ones[k], twos[k])
            formula.add(-related, ones[k], -twos[k])
        else:
            formula.add(-related, -(ones[k] if k < len(ones) else twos[k]))
    alike = []
    if pair.question.sensing.marks_v0:
        alike.append((one.vertex[x, 0], two.vertex[y, 0]))
    if pair.pointed:
        alike.append((pair.pointed[0][x], pair.pointed[1][y]))
    for a, b in alike:
        formula.add(-related, -a, b)
        formula.add(-related, a, -b)


def _smaller_code(formula: Formula, pair: Pair) -> None:
    """Require the first world's answer to be smaller at the first step with different answers.

    Looking alike is symmetric, so nothing is lost by asking for the smaller code first.
    """
    one, two, darts = pair.one, pair.two, pair.one.size.darts
    steps = 2 * darts
    marks = (
        list(zip(*[block.variables for block in pair.pointed], strict=True)) if pair.pointed else []
    )
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
    breaks = formula.block(f"breaks{start}", (3, len(darts)), "F fails at x: sigma, alpha, mark")
    formula.section(f"started at dart {start}, world 2 is not world 1")
    excused = [-two.vertex[start, 0]] if pair.question.sensing.marks_v0 else []
    formula.add(carried[0, start])
    for parity, (step, other) in enumerate(((one.sigma, two.sigma), (one.alpha, two.alpha))):
        image = formula.block(f"image{parity}_{start}", shape, "y = step(F(x))")
        for x in darts:
            t = 2 * x + parity
            for y in darts:
                fresh = (-step[x, y], one.given[t, y + 1])
                for z in darts:
                    formula.add(-carried[x, y], -other[y, z], image[x, z])
                    formula.add(*fresh, -image[x, z], carried[y, z])
                    formula.add(-breaks[parity, x], -step[x, y], -image[x, z], -carried[y, z])
    for x in darts:
        if pair.pointed is None:
            formula.add(-breaks[2, x])
            continue
        for y in darts:
            mine, theirs = pair.pointed[0][x], pair.pointed[1][y]
            formula.add(-breaks[2, x], -carried[x, y], mine, theirs)
            formula.add(-breaks[2, x], -carried[x, y], -mine, -theirs)
    formula.add(*excused, *breaks.variables)


def _walk(formula: Formula, question: Question, world: OneWorld) -> None:
    """Require the robot's walk in the first world, and equal percepts in the second."""
    if not question.walk.motions:
        return
    darts = range(world.size.darts)
    turns = sum(abs(k) + 1 for k in question.walk.motions)
    at = formula.block("at", (turns + 1, len(darts)), "after i turns and traversals: dart x")
    formula.section("the walk and what it senses")
    formula.add(at[0, 0])
    i = 0
    for motion, percept in zip(question.walk.motions, question.walk.percepts, strict=True):
        for step in [*[world.sigma] * abs(motion), world.alpha]:
            back = motion < 0 and step is world.sigma
            for x in darts:
                for y in darts:
                    arrow = step[y, x] if back else step[x, y]
                    formula.add(-at[i, x], -arrow, at[i + 1, y])
            i += 1
        marked = question.sensing.marks_v0
        _senses(formula, world, at.rows()[i], percept, marked=marked)


def _senses(
    formula: Formula, world: OneWorld, here: Iterable[int], percept: Sensed, *, marked: bool
) -> None:
    for x, arrived in enumerate(here):
        possible = percept.degree < world.degree.shape[1]
        formula.add(-arrived, *([world.degree[x, percept.degree]] if possible else []))
        if marked:
            at_v0 = world.vertex[x, 0]
            formula.add(-arrived, at_v0 if percept.present else -at_v0)


def _best_start(formula: Formula, world: OneWorld) -> None:
    """Require that the start leads to a vertex of the largest degree among v0's darts.

    Turning is free.
    """
    darts, degrees = world.degree.shape
    beyond = formula.block("beyond", (darts, degrees), "alpha(x) is at a vertex of degree k")
    formula.section("turning is free: no dart of v0 leads to a larger degree than the start")
    for x in range(darts):
        for y in range(darts):
            for k in range(degrees):
                formula.add(-world.alpha[x, y], -world.degree[y, k], beyond[x, k])
        for k in range(degrees):
            for j in range(k):
                formula.add(-world.vertex[x, 0], -beyond[x, k], -beyond[0, j])
