"""The clauses of a search: there are two different worlds that no motion tells apart.

The checkers write every formula themselves, here, from this statement, and accept a file only
if it has exactly these clauses.  So this module is all that has to be trusted about a formula;
it shares no code with the package that wrote the files.

Two worlds *look alike* if there is a relation between their darts with three properties: it holds
between the starts; sigma and alpha keep it; related darts have equal percepts.  This suffices,
since a motion is a number of sigmas and one alpha.  The relation meant is 'some walk, made in both
worlds, leads the robot of world 1 to x and that of world 2 to y'.

===========================  ==========================================================
``related[x][y]``            dart x of world 1 and dart y of world 2 are related
``sigma_related[x][z]``      x is related to the y with sigma(y) = z
``alpha_related[x][z]``      x is related to the y with alpha(y) = z
``pointed1[x]``              x is a reference dart of world 1; ``pointed2`` of world 2
``pointed_at1[v][x]``        x is the reference dart of vertex v (compass)
``equal[t]``                 the two worlds' codes agree before place t
``beyond[x][k]``             alpha(x) is at a vertex of degree k, in world 1
``at[i][x]``                 after i turns and traversals of the walk: dart x of world 1
``carriedD[x][y]``           F takes x to y: F is the walk through world 1, copied in
                             world 2 from dart D
``image0_D``, ``image1_D``   ``[x][z]``: sigma(F(x)) = z, alpha(F(x)) = z
``breaksD[i][x]``            F is no isomorphism at x: sigma (0), alpha (1), marks (2)
===========================  ==========================================================
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from clauses import Clauses, Row, Table
from world_clauses import Asked, Size, WorldTables, a_world, having

Two = tuple[WorldTables, WorldTables]


def twin_clauses(
    asked: Asked, sizes: tuple[Size, Size], other_starts: Sequence[int] = ()
) -> Clauses:
    """The formula: two worlds of these sizes, as asked for, that look alike and differ.

    ``other_starts``: for these darts it also says that world 2 entered there is not world 1.
    It holds of different worlds for every dart, so any may be named.
    """
    clauses = Clauses()
    worlds = a_world(clauses, "1", sizes[0], asked), a_world(clauses, "2", sizes[1], asked)
    pointed = _reference_darts(clauses, worlds, asked)
    related = _related(clauses, worlds)
    _sense_the_same(clauses, worlds, related, pointed, asked)
    if sizes[0].edges == sizes[1].edges:
        _smaller_code(clauses, worlds, pointed)
    if asked.lighthouse == "position" and not asked.walk:
        _best_start(clauses, worlds[0])
    if asked.walk:
        _walk(clauses, worlds[0], asked)
    for start in other_starts:
        _not_from(clauses, worlds, pointed, start, asked)
    return clauses


def _reference_darts(clauses: Clauses, worlds: Two, asked: Asked) -> list[Row]:
    """The rows ``pointed1`` and ``pointed2``; none where no direction is sensed."""
    if asked.lighthouse not in {"directional", "compass"}:
        return []
    pointed = []
    for name, world in zip("12", worlds, strict=True):
        row = clauses.row(f"pointed{name}", world.size.darts)
        if asked.lighthouse == "directional":
            clauses.say("there is one reference dart, and it is at the start's vertex")
            clauses.exactly_one(row)
            for x, points in enumerate(row):
                clauses.implies([points], [world.vertex[x][0]])
        else:
            _compass(clauses, name, world, row)
        pointed.append(row)
    if not asked.walk:
        clauses.say("turning is free: both robots face the reference dart first")
        for row in pointed:
            clauses.always(row[0])
    return pointed


def _compass(clauses: Clauses, name: str, world: WorldTables, row: Row) -> None:
    at = clauses.table(f"pointed_at{name}", world.size.most, world.size.darts)
    clauses.say("every vertex has one reference dart")
    for v, here in enumerate(at):
        clauses.at_most_one(here)
        for x, points in enumerate(row):
            there = world.vertex[x][v]
            clauses.implies([here[x]], [points])
            clauses.implies([here[x]], [there])
            clauses.implies([points, there], [here[x]])
            clauses.implies([there], here)


def _related(clauses: Clauses, worlds: Two) -> Table:
    one, two = worlds
    ones, twos = range(one.size.darts), range(two.size.darts)
    related = clauses.table("related", len(ones), len(twos))
    clauses.say("the starts are related")
    clauses.always(related[0][0])
    for name, mine, theirs in (("sigma", one.sigma, two.sigma), ("alpha", one.alpha, two.alpha)):
        image = clauses.table(f"{name}_related", len(ones), len(twos))
        clauses.say(f"x and y are related exactly if {name}(x) and {name}(y) are")
        for x, y, z in product(ones, twos, twos):
            clauses.equivalent([theirs[y][z]], related[x][y], image[x][z])
        for x, w, z in product(ones, ones, twos):
            clauses.equivalent([mine[x][w]], image[x][z], related[w][z])
    return related


def _sense_the_same(
    clauses: Clauses, worlds: Two, related: Table, pointed: list[Row], asked: Asked
) -> None:
    one, two = worlds
    clauses.say("related darts sense the same")
    for (x, row), y in product(enumerate(related), range(two.size.darts)):
        alike = row[y]
        for k in range(max(len(one.degree[x]), len(two.degree[y]))):
            mine, theirs = having(one, x, k), having(two, y, k)
            for degree in mine:
                clauses.implies([alike, degree], theirs)
            for degree in theirs:
                clauses.implies([alike, degree], mine)
        if asked.v0_is_marked:
            clauses.equivalent([alike], one.vertex[x][0], two.vertex[y][0])
        if pointed:
            clauses.equivalent([alike], pointed[0][x], pointed[1][y])


def _smaller_code(clauses: Clauses, worlds: Two, pointed: list[Row]) -> None:
    """A world's code: its answers, then for each dart whether it is a reference dart.

    Worlds in canonical numbers that differ have different codes; looking alike is symmetric, so
    the first world may be the one with the smaller code.
    """
    one, two = worlds
    questions = 2 * one.size.darts
    marks = list(zip(*pointed, strict=True))
    equal = clauses.row("equal", questions + len(marks) + 1)
    clauses.say("the codes agree before place 0 and do not agree throughout")
    clauses.always(equal[0])
    clauses.never(equal[-1])
    clauses.say("they agree before t + 1 exactly if they do before t and at t; else one is smaller")
    for t in range(questions + len(marks)):
        clauses.implies([equal[t + 1]], [equal[t]])
    for t, y in product(range(questions), range(one.size.darts)):
        mine, theirs = one.answer(t, y), two.answer(t, y)
        larger = [two.answer(t, z) for z in range(y + 1, one.size.darts)]
        clauses.implies([equal[t + 1], mine], [theirs])
        clauses.implies([equal[t], mine, theirs], [equal[t + 1]])
        clauses.implies([equal[t], mine], [theirs, *larger])
    for t, (mine, theirs) in enumerate(marks, questions):
        clauses.equivalent([equal[t + 1]], mine, theirs)
        clauses.implies([equal[t], mine, theirs], [equal[t + 1]])
        clauses.implies([equal[t]], [mine, theirs, equal[t + 1]])
        clauses.implies([equal[t], mine], [theirs])


def _best_start(clauses: Clauses, world: WorldTables) -> None:
    """Turning both robots alike changes neither whether they look alike nor whether they differ."""
    darts, degrees = range(world.size.darts), range(len(world.degree[0]))
    beyond = clauses.table("beyond", len(darts), len(degrees))
    clauses.say("turning is free: no dart of v0 leads to a larger degree than the start")
    for x, y, k in product(darts, darts, degrees):
        clauses.implies([world.alpha[x][y], world.degree[y][k]], [beyond[x][k]])
    for x, larger in product(darts, degrees):
        for k in range(larger):
            clauses.never(world.vertex[x][0], beyond[x][larger], beyond[0][k])


def _walk(clauses: Clauses, world: WorldTables, asked: Asked) -> None:
    """The walk through world 1.  In world 2, which looks alike, the same is sensed."""
    steps = sum(abs(motion) + 1 for motion, _, _ in asked.walk)
    darts = range(world.size.darts)
    at = clauses.table("at", steps + 1, len(darts))
    clauses.say("the walk begins at the start, and senses what is asked for")
    clauses.always(at[0][0])
    i = 0
    for motion, degree, at_v0 in asked.walk:
        turn = (
            world.sigma
            if motion > 0
            else [list(column) for column in zip(*world.sigma, strict=True)]
        )
        for step in [*[turn] * abs(motion), world.alpha]:
            for x, y in product(darts, darts):
                clauses.implies([at[i][x], step[x][y]], [at[i + 1][y]])
            i += 1
        for x in darts:
            clauses.implies([at[i][x]], having(world, x, degree))
            if asked.v0_is_marked and at_v0:
                clauses.implies([at[i][x]], [world.vertex[x][0]])
            elif asked.v0_is_marked:
                clauses.never(at[i][x], world.vertex[x][0])


def _not_from(clauses: Clauses, worlds: Two, pointed: list[Row], start: int, asked: Asked) -> None:
    """World 2 entered at this dart is not world 1; where v0 is marked only if it is at v0."""
    one, two = worlds
    darts = range(one.size.darts)
    carried = clauses.table(f"carried{start}", len(darts), len(darts))
    breaks = clauses.table(f"breaks{start}", 3, len(darts))
    clauses.say(f"F takes the root to dart {start}, and a dart that world 1 meets to the one met")
    clauses.always(carried[0][start])
    steps = ((one.sigma, two.sigma), (one.alpha, two.alpha))
    for which, (mine, theirs) in enumerate(steps):
        image = clauses.table(f"image{which}_{start}", len(darts), len(darts))
        for x, y, z in product(darts, darts, darts):
            met_before = one.given[2 * x + which][y + 1]
            clauses.implies([carried[x][y], theirs[y][z]], [image[x][z]])
            clauses.implies([mine[x][y], image[x][z]], [met_before, carried[y][z]])
            clauses.never(breaks[which][x], mine[x][y], image[x][z], carried[y][z])
    clauses.say(f"entered at dart {start} world 2 is not world 1: F is no isomorphism somewhere")
    for x in darts:
        if not pointed:
            clauses.never(breaks[2][x])
        for y in darts if pointed else ():
            marks = pointed[0][x], pointed[1][y]
            clauses.implies([breaks[2][x], carried[x][y]], marks)
            clauses.never(breaks[2][x], carried[x][y], *marks)
    elsewhere = [two.vertex[start][0]] if asked.v0_is_marked else []
    clauses.implies(elsewhere, [b for row in breaks for b in row])
