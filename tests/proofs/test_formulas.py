"""The checkers' own encoder: its models are counted, its answers compared with enumeration.

That it excludes no worlds is in test_meaning.py.
"""

import pytest

from allworlds.studies.ambiguity.formulas import forbid_other_start, pair_formula
from searches import question

solvers = pytest.importorskip("pysat.solvers", reason="python-sat is not installed")


@pytest.fixture
def world(checkers):
    return checkers("world_clauses")


@pytest.fixture
def twins(checkers):
    return checkers("twin_clauses")


def literals(clauses):
    return [list(clause) for clause in clauses.sentences]


def models_of_one_world(checkers, map_class, edges, **asked):
    """Every model, over all variables, as sigma and alpha."""
    module = checkers("world_clauses")
    asked = module.Asked("none", map_class, **asked)
    clauses = checkers("clauses").Clauses()
    size = module.size_of(asked, edges)
    if size is None:
        return []
    tables = module.a_world(clauses, "", size, asked)
    with solvers.Solver("g4", bootstrap_with=literals(clauses)) as solver:
        found = []
        for model in solver.enum_models():
            true = set(model)
            found.append(
                tuple(
                    tuple(next(y for y, v in enumerate(row) if v in true) for row in table)
                    for table in (tables.sigma, tables.alpha)
                )
            )
    return found


def rooted_maps(checkers, map_class, edges):
    """The canonical codes of an enumeration that knows nothing of clauses."""
    maps = checkers("maps")
    listed = maps.rooted_maps(edges, simple="simple" in map_class)
    return [
        maps.code(*map_, 0) for map_ in listed if "planar" not in map_class or maps.is_planar(map_)
    ]


# Rooted maps by edges: A000698 shifted; planar: Tutte 1963; simple: rotation systems of
# connected simple graphs, counted over the graph atlas.
@pytest.mark.parametrize(
    ("map_class", "counts"),
    [
        ("maps", [2, 10, 74, 706]),
        ("simple", [1, 2, 6, 23]),
        ("planar", [2, 9, 54, 378]),
        ("planar-simple", [1, 2, 6, 23]),
    ],
)
def test_each_rooted_map_of_the_class_is_one_model_of_the_clauses_about_one_world(
    checkers, map_class, counts
):
    for edges, count in enumerate(counts, 1):
        models = models_of_one_world(checkers, map_class, edges)
        assert len(models) == count
        assert sorted(models) == sorted(rooted_maps(checkers, map_class, edges))


@pytest.mark.parametrize(("marked", "others"), [(2, None), (None, 2), (2, 2), (4, 1), (9, None)])
def test_degrees_that_are_asked_for_leave_exactly_the_maps_that_have_them(checkers, marked, others):
    orbit = checkers("maps").orbit
    models = models_of_one_world(checkers, "maps", 3, marked=marked, others=others)
    wanted = []
    for sigma, alpha in rooted_maps(checkers, "maps", 3):
        home = orbit(sigma, 0)
        elsewhere = {len(orbit(sigma, d)) for d in range(6) if d not in home}
        if marked in {None, len(home)} and (others is None or elsewhere <= {others}):
            wanted.append((sigma, alpha))
    assert sorted(models) == sorted(wanted)


def producer_says(asked, level, starts):
    """The package's formula, in which ``starts`` are excluded."""
    formula, pair = pair_formula(asked, level)
    for start in starts:
        forbid_other_start(formula, pair, start)
    return formula


@pytest.mark.parametrize(
    ("lighthouse", "map_class", "edges"),
    [
        ("directional", "maps", 1),
        ("directional", "planar", 2),
        ("directional", "simple", 3),
        ("directional", "planar-simple", 3),
        ("compass", "maps", 2),
        ("position", "maps", 2),
    ],
)
def test_two_encoders_write_the_same_clauses_about_small_worlds(
    world, twins, lighthouse, map_class, edges
):
    """Also those that follow from others, by which no model is lost and none is won."""
    asked = question(lighthouse, map_class, edges + 1, edges)
    for level in asked.sizes():
        mine = world.Asked(lighthouse, map_class)
        sizes = tuple(world.size_of(mine, size.edges) for size in level)
        clauses = twins.twin_clauses(mine, sizes)
        formula = producer_says(asked, level, [])
        assert set(clauses.sentences) == set(map(frozenset, formula.clauses))


# The fewest vertices by edges: complete graphs, and in the plane triangulations.
FEWEST = {
    "simple": [2, 3, 3, 4, 4, 4, 5, 5, 5, 5, 6, 6, 6, 6, 6, 7],
    "planar-simple": [2, 3, 3, 4, 4, 4, 5, 5, 5, 6, 6, 6, 7, 7, 7, 8],
}


@pytest.mark.parametrize("map_class", FEWEST)
def test_no_world_has_fewer_vertices_than_its_edges_need(world, map_class):
    for edges, fewest in enumerate(FEWEST[map_class], 1):
        assert world.size_of(world.Asked("none", map_class), edges).fewest == fewest
        (level,) = (
            level
            for level in question("position", map_class, edges + 1, edges).sizes()
            if level.one.edges == edges
        )
        assert (level.one.fewest, level.two.fewest) == (fewest, fewest)


@pytest.fixture
def small(checkers, world, twins):
    """A small formula, and a function that compares another with it."""
    asked = world.Asked("directional", "maps")
    size = world.size_of(asked, 1)
    clauses = twins.twin_clauses(asked, (size, size))
    return clauses, checkers("clauses").require_same, checkers("lrat").Refused


def test_order_and_repetition_of_clauses_and_literals_make_no_difference(small):
    clauses, require_same, _ = small
    formula = [[*clause, *clause][::-1] for clause in clauses.sentences]
    require_same(clauses, clauses.variables, [*formula[::-1], *formula])


def test_a_clause_that_is_missing_is_named_in_words(small):
    clauses, require_same, refused = small
    formula = literals(clauses)
    related = clauses.tables["related"][0][0]
    formula.remove([related])
    with pytest.raises(refused) as error:
        require_same(clauses, clauses.variables, formula)
    assert str(error.value) == (
        "the formula does not say 'always => related[0][0]' (the starts are related)"
    )


@pytest.mark.parametrize("extra", [[], [1], [-1, 2], [1, -1]])
def test_a_clause_too_many_is_named_by_its_number(small, extra):
    clauses, require_same, refused = small
    formula = literals(clauses)
    formula.insert(7, extra)
    with pytest.raises(refused, match=r"clause 8 of the formula says what it should not: \["):
        require_same(clauses, clauses.variables, formula)


def test_another_number_of_variables_is_refused(small):
    clauses, require_same, refused = small
    with pytest.raises(refused, match=f"has {clauses.variables + 1} variables"):
        require_same(clauses, clauses.variables + 1, literals(clauses))


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        (("gps", "maps"), "lighthouse 'gps' is not one of none, position, directional, compass"),
        (("none", "trees"), "class 'trees' is not one of maps, simple, planar, planar-simple"),
        (("none", "maps", 0), "degree 0, but every vertex has at least one dart"),
    ],
)
def test_what_there_is_no_formula_for_is_refused(checkers, world, asked, message):
    with pytest.raises(checkers("lrat").Refused, match=message):
        world.Asked(*asked)
