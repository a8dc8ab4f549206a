"""The checkers' own encoder: its models are counted, its answers compared with enumeration.

That it excludes no worlds is in test_meaning.py.
"""

from itertools import product

import pytest

from allworlds.studies.ambiguity.formulas import forbid_other_start, pair_formula
from searches import question

solvers = pytest.importorskip("pysat.solvers", reason="python-sat is not installed")

LIGHTHOUSES = ["none", "position", "directional", "compass"]
CLASSES = ["maps", "simple", "planar", "planar-simple"]


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


@pytest.mark.slow
@pytest.mark.parametrize("map_class", CLASSES)
def test_no_number_of_vertices_that_a_world_has_is_left_out(checkers, world, map_class):
    maps = checkers("maps")
    for edges in range(1, 6):
        size = world.size_of(world.Asked("none", map_class), edges)
        counts = {maps.vertex_count(m) for m in rooted_maps(checkers, map_class, edges)}
        if size is None:
            assert not counts
            continue
        # every size that is left in occurs: nothing smaller would do
        assert counts == set(range(size.fewest, size.most + 1))
    assert world.size_of(world.Asked("none", "simple"), 6, 3) is None
    fig_1 = world.Asked("position", "planar-simple", marked=4, others=3)
    sizes = [size for m in range(1, 15) if (size := world.size_of(fig_1, m))]
    assert [(s.edges, s.fewest, s.most) for s in sizes] == [(8, 5, 5), (11, 7, 7), (14, 9, 9)]


def looks_alike(checkers, lighthouse, map_class, edges):
    """Whether two different worlds with so many edges look alike, by enumeration."""
    maps = checkers("maps")
    worlds = []
    for sigma, alpha in rooted_maps(checkers, map_class, edges):
        vertices = {min(maps.orbit(sigma, d)): maps.orbit(sigma, d) for d in range(2 * edges)}
        chosen = product(*vertices.values()) if lighthouse == "compass" else [(0,)]
        worlds += [maps.World(sigma, alpha, 0, lighthouse, darts) for darts in chosen]
    return maps.twins_among(iter(worlds))[1] is not None


@pytest.mark.slow
@pytest.mark.parametrize(
    ("lighthouse", "map_class", "edges", "there_is"),
    [
        *(("none", "maps", m, there) for m, there in ((1, False), (2, True))),
        *(("none", "simple", m, there) for m, there in ((3, False), (5, False), (6, True))),
        *(("position", "maps", m, there) for m, there in ((1, False), (2, True), (3, True))),
        *(("position", "planar", m, there) for m, there in ((1, False), (2, False), (3, True))),
        *(("position", "simple", m, there) for m, there in ((4, False), (5, False), (6, True))),
        # here one world with two starts that look alike has to be excluded
        ("position", "planar-simple", 6, False),
        *(("compass", "maps", m, there) for m, there in ((1, False), (2, False), (3, True))),
        ("compass", "planar", 3, True),
        ("compass", "simple", 4, False),
        *(("directional", "maps", m, False) for m in (1, 2, 3)),
        ("directional", "planar", 3, False),
        ("directional", "simple", 5, False),
    ],
)
def test_a_formula_has_a_model_exactly_if_enumeration_finds_two_worlds_that_look_alike(
    checkers, world, twins, lighthouse, map_class, edges, there_is
):
    assert looks_alike(checkers, lighthouse, map_class, edges) == there_is
    asked = world.Asked(lighthouse, map_class)
    size = world.size_of(asked, edges)
    clauses = twins.twin_clauses(asked, (size, size), range(1, 2 * edges))
    with solvers.Solver("cadical153", bootstrap_with=literals(clauses)) as solver:
        assert solver.solve() == there_is


def producer_says(asked, level, starts):
    """The package's formula, in which ``starts`` are excluded."""
    formula, pair = pair_formula(asked, level)
    for start in starts:
        forbid_other_start(formula, pair, start)
    return formula


VARIANTS = [
    {},
    {"marked": 2},
    {"others": 2},
    {"marked": 2, "others": 3},
    {"motions": (1, -2, 0), "percepts": ("2A", "9A", "3A")},
]


@pytest.mark.slow
@pytest.mark.parametrize("lighthouse", LIGHTHOUSES)
@pytest.mark.parametrize("map_class", CLASSES)
def test_two_encoders_that_share_no_code_write_the_same_formulas(
    world, twins, lighthouse, map_class
):
    """Also between worlds of two sizes, with bounds, degrees, walks, and other starts."""
    levels = 0
    for number, variant in enumerate(VARIANTS):
        edges = 2 if lighthouse in {"none", "compass"} else 3
        walk = {key: variant[key] for key in ("motions", "percepts") if key in variant}
        degrees = {key: variant.get(key) for key in ("marked", "others")}
        asked = question(
            *(lighthouse, map_class, edges + number % 2, edges + number % 3),
            **{f"degree_{key}": value for key, value in degrees.items()},
            **walk,
        )
        mine = world.Asked(
            *(lighthouse, map_class),
            **degrees,
            walk=tuple(
                (motion, *percept)
                for motion, percept in zip(asked.walk.motions, asked.walk.percepts, strict=True)
            ),
        )
        for level in asked.sizes():
            sizes = tuple(world.size_of(mine, s.edges, asked.vertices) for s in level)
            assert [(s.edges, s.fewest, s.most) for s in sizes] == [
                (s.edges, s.fewest, s.most) for s in level
            ]
            same = level.one.edges == level.two.edges
            starts = [3, 1][-level.one.edges :] if same and number < 2 else []
            formula = producer_says(asked, level, starts)
            clauses = twins.twin_clauses(mine, sizes, starts)
            assert clauses.variables == formula.variable_count
            assert set(clauses.sentences) == set(map(frozenset, formula.clauses))
            levels += 1
    assert levels >= 4


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
