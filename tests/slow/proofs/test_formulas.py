"""The checkers' own encoder: its models are counted, its answers compared with enumeration.

That it excludes no worlds is in test_meaning.py.
"""

from itertools import product

import pytest

from proofs import test_formulas as quick
from proofs.test_formulas import literals, producer_says, rooted_maps, solvers
from searches import question

twins = quick.twins
world = quick.world

LIGHTHOUSES = ["none", "position", "directional", "compass"]


CLASSES = ["maps", "simple", "planar", "planar-simple"]


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


@pytest.mark.slowest
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


VARIANTS = [
    {},
    {"marked": 2},
    {"others": 2},
    {"marked": 2, "others": 3},
    {"motions": (1, -2, 0), "percepts": ("2A", "9A", "3A")},
]


@pytest.mark.slowest
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
            walk=tuple(map(tuple, asked.walk)),
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
