"""No clause of the checkers' encoder excludes two worlds that it should not exclude.

Every variable gets the value that its meaning has in two given worlds, from the definitions, and
every clause is evaluated.  For two different worlds of the class, of which the first has the
smaller code, all clauses must then be true except some of 'related darts sense the same'; and
these are all true exactly if the worlds look alike.  So if two worlds look alike, the formula
has a model: what the proofs rest on.
"""

import random
from itertools import product

import pytest

ALIKE = "related darts sense the same"


def ordered(permutation, orbit):
    """For each dart the number of its cycle, cycles numbered by their least darts."""
    least = [min(orbit(permutation, d)) for d in range(len(permutation))]
    return [sorted(set(least)).index(d) for d in least]


def code_of(world):
    """sigma(0), alpha(0), sigma(1), ..., and then whether a dart is a reference dart."""
    steps = [y for both in zip(world.sigma, world.alpha, strict=True) for y in both]
    points = world.lighthouse in {"directional", "compass"}
    return steps, [d in world.darts for d in range(len(world.sigma))] if points else []


def one_world(world, orbit):
    """Where each variable about one world is true, by its name."""
    sigma, alpha, darts = world.sigma, world.alpha, range(len(world.sigma))
    vertex, face = ordered(sigma, orbit), ordered([sigma[e] for e in alpha], orbit)
    first = [vertex.index(vertex[d]) for d in darts]
    asked, pointed = code_of(world)
    given = [max([1, *(y + 1 for y in asked[:t])]) for t in range(len(asked) + 1)]
    return {
        "sigma": list(enumerate(sigma)),
        "alpha": list(enumerate(alpha)),
        "given": [(t, j) for t, most in enumerate(given) for j in range(most + 1)],
        "vertex": list(enumerate(vertex)),
        "used": [(x, v) for x in darts for v in range(max(vertex[: x + 1]) + 1)],
        "first": [(d,) for d in darts if first[d] == d],
        "degree": [(d, len(orbit(sigma, d))) for d in darts],
        "place": [(d, orbit(sigma, first[d]).index(d)) for d in darts],
        "target": [(d, vertex[alpha[d]]) for d in darts],
        "face": list(enumerate(face)),
        "ahead": [(d, face[alpha[d]]) for d in darts],
        "met": [(x, f) for x in darts for f in range(max(face[: x + 1]) + 1)],
        "pointed": [(d,) for d in darts if any(pointed[d : d + 1])],
        "pointed_at": [(vertex[d], d) for d in world.darts],
    }


def two_worlds(one, two, orbit, walk):
    related = [(0, 0)]
    for x, y in related:
        steps = ((one.sigma[x], two.sigma[y]), (one.alpha[x], two.alpha[y]))
        related += [pair for pair in dict.fromkeys(steps) if pair not in related]
    (mine, my_marks), (theirs, their_marks) = code_of(one), code_of(two)
    mine, theirs = [*mine, *my_marks], [*theirs, *their_marks]
    degree = [len(orbit(one.sigma, d)) for d in range(len(one.sigma))]
    at = [0]
    back = [one.sigma.index(d) for d in range(len(one.sigma))]
    for motion, _, _ in walk:
        turns = [one.sigma if motion > 0 else back] * abs(motion)
        for step in [*turns, one.alpha]:
            at.append(step[at[-1]])
    return {
        "related": related,
        "sigma_related": [(x, two.sigma[y]) for x, y in related],
        "alpha_related": [(x, two.alpha[y]) for x, y in related],
        "equal": [(t,) for t in range(len(mine) + 1) if mine[:t] == theirs[:t]],
        "beyond": [(d, degree[e]) for d, e in enumerate(one.alpha)],
        "at": list(enumerate(at)),
    }


def other_start(one, two, start):
    """F takes 0 to the start, and a dart that the first world meets to what is met there."""
    carried = {0: start}
    steps = ((one.sigma, two.sigma), (one.alpha, two.alpha))
    for x in range(len(one.sigma)):
        for mine, theirs in steps:
            carried.setdefault(mine[x], theirs[carried[x]])
    my_marks, their_marks = code_of(one)[1], code_of(two)[1]
    breaks = [(2, x) for x, y in carried.items() if my_marks and my_marks[x] != their_marks[y]]
    facts = {f"carried{start}": list(carried.items()), f"breaks{start}": breaks}
    for place, (mine, theirs) in enumerate(steps):
        facts[f"image{place}_{start}"] = [(x, theirs[y]) for x, y in carried.items()]
        breaks += [(place, x) for x, y in carried.items() if carried[mine[x]] != theirs[y]]
    return facts


def false_clauses(clauses, facts):
    """The clauses that are false where the variables have these values."""
    true = [False] * (2 * clauses.variables + 1)
    for name, table in clauses.tables.items():
        flat = [v for entry in table for v in (entry if isinstance(entry, list) else [entry])]
        for variable in flat:
            true[-variable] = True
        for index in facts[name]:
            cells = table
            for i in index:
                cells = cells[i] if i < len(cells) else None
                if cells is None:
                    break
            else:
                true[cells], true[-cells] = True, False
    return [c for c in clauses.sentences if not any(map(true.__getitem__, c))]


@pytest.fixture
def meant(checkers):
    """A function that names what is wrong with a formula for two worlds; '' if nothing is."""
    maps = checkers("maps")

    def wrong(clauses, one, two, walk=(), starts=()):
        facts = two_worlds(one, two, maps.orbit, walk)
        for name, world in (("1", one), ("2", two)):
            facts |= {f"{k}{name}": v for k, v in one_world(world, maps.orbit).items()}
        for start in starts:
            facts |= other_start(one, two, start)
        false = false_clauses(clauses, facts)
        for clause in false:
            if clauses.sentences[clause] != ALIKE:
                return clauses.in_words(clause)
        alike = maps.quotient_code(one) == maps.quotient_code(two)
        return "" if alike == (not false) else f"alike: {alike}"

    return wrong


def all_worlds(checkers, lighthouse, map_class, edges):
    """Every world of the class in canonical numbers, started where a formula lets it start."""
    maps = checkers("maps")
    for map_ in maps.rooted_maps(edges, simple="simple" in map_class):
        if "planar" in map_class and not maps.is_planar(map_):
            continue
        sigma, alpha = maps.code(*map_, 0)
        vertices = {min(maps.orbit(sigma, d)): maps.orbit(sigma, d) for d in range(2 * edges)}
        if lighthouse == "compass":
            places = product([0], *(around for v, around in vertices.items() if v != 0))
        else:
            places = [(0,)]
        for darts in places:
            yield maps.World(sigma, alpha, 0, lighthouse, darts)


def starts_best(world, orbit):
    beyond = [len(orbit(world.sigma, world.alpha[d])) for d in orbit(world.sigma, 0)]
    return beyond[0] == max(beyond)


def pairs_of(checkers, lighthouse, map_class, edges, *, sample=None):
    """Different worlds, the one with the smaller code first; the first starts as it should.

    All of them, or so many, a fixed random choice.
    """
    maps = checkers("maps")
    ones, twos = (list(all_worlds(checkers, lighthouse, map_class, m)) for m in edges)
    if sample is None:
        candidates = product(ones, twos)
    else:
        chance = random.Random(0)
        candidates = ((chance.choice(ones), chance.choice(twos)) for _ in range(40 * sample))
    found = 0
    for one, two in candidates:
        best = lighthouse != "position" or starts_best(one, maps.orbit)
        first = edges[0] < edges[1] or code_of(one) < code_of(two)
        if found != sample and best and first and maps.world_code(one) != maps.world_code(two):
            found += 1
            yield one, two


def formula(checkers, lighthouse, map_class, edges, starts=(), walk=()):
    module = checkers("world_clauses")
    asked = module.Asked(lighthouse, map_class, walk=walk)
    sizes = tuple(module.size_of(asked, m) for m in edges)
    return None if None in sizes else checkers("twin_clauses").twin_clauses(asked, sizes, starts)


def test_the_clauses_of_a_walk_are_its_turns_and_traversals_in_their_order(checkers):
    """Written out for four motions, two of them anticlockwise: a dart's way is a row of ``at``."""
    walk = ((1, 2, True), (-2, 3, False), (0, 9, True), (-1, 1, False))
    clauses = formula(checkers, "position", "maps", (2, 2), walk=walk)
    tables, darts = clauses.tables, range(4)
    sigma, alpha, at = tables["sigma1"], tables["alpha1"], tables["at"]
    steps = ["sigma", "alpha", "back", "back", "alpha", "alpha", "back", "alpha"]
    assert len(at) == len(steps) + 1
    said = {frozenset([at[0][0]])}
    for i, step in enumerate(steps):
        for x, y in product(darts, darts):
            leads = {"sigma": sigma[x][y], "back": sigma[y][x], "alpha": alpha[x][y]}[step]
            said.add(frozenset([-at[i][x], -leads, at[i + 1][y]]))
    for i, degree, at_v0 in ((2, 2, True), (5, 3, False), (6, 9, True), (8, 1, False)):
        for x in darts:
            has = [tables["degree1"][x][degree]] if degree < 9 else []
            said.add(frozenset([-at[i][x], *has]))
            home = tables["vertex1"][x][0]
            said.add(frozenset([-at[i][x], home if at_v0 else -home]))
    written = [c for c, sentence in clauses.sentences.items() if sentence.startswith("the walk ")]
    assert set(written) == said


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ([("alpha1", 0, 1)], []),  # the root is no loop with its neighbour
        ([], [("vertex2", 3, 0)]),  # the last dart is at v0
        ([("related", 1, 2)], []),  # darts of other numbers are not related
        ([("related", 1, 1)], [("sigma1", 0, 1)]),
        ([("vertex1", 2, 1), ("vertex2", 2, 1)], []),
        # one rooted map of ten is not world 1
        ([("sigma1", 0, 1), ("alpha1", 0, 2), ("sigma1", 2, 3), ("sigma1", 3, 2)], []),
    ],
)
def test_a_clause_that_says_too_much_is_noticed(checkers, meant, left, right):
    clauses = formula(checkers, "position", "maps", (2, 2))

    def variables(names):
        return [clauses.tables[name][x][y] for name, x, y in names]

    clauses.say("too much")
    clauses.implies(variables(left), variables(right))
    found = [meant(clauses, *p) for p in pairs_of(checkers, "position", "maps", (2, 2))]
    assert any("too much" in wrong for wrong in found)


def test_a_sensing_clause_that_says_too_little_or_too_much_is_noticed(checkers, meant):
    pairs = list(pairs_of(checkers, "position", "maps", (2, 2)))
    for damage in ("lost", "too much"):
        clauses = formula(checkers, "position", "maps", (2, 2))
        if damage == "lost":
            for clause in [c for c, said in clauses.sentences.items() if said == ALIKE]:
                del clauses.sentences[clause]
        else:
            clauses.say(ALIKE)
            clauses.never(clauses.tables["related"][1][1])
        assert any(meant(clauses, one, two) for one, two in pairs)
