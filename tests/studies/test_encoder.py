import pytest
import z3

from allworlds.maps import MapClass, named_map
from allworlds.studies.ambiguity.clauses import Formula
from allworlds.studies.ambiguity.formulas import forbid_other_start, pair_formula
from allworlds.studies.ambiguity.one_world import one_world
from allworlds.studies.ambiguity.question import Question, Size, Sizes
from allworlds.studies.ambiguity.solvers import solve_with_z3
from allworlds.studies.ambiguity.twin_search import _fits
from allworlds.world import Position, World
from bruteforce import rooted_maps_by_permutations as rooted_maps
from searches import question


def models(path, formula, world):
    """The maps that are models, each once: found by z3, one after the other."""
    formula.write(path)
    solver = z3.Solver()
    solver.from_file(str(path))
    found = []
    while solver.check() == z3.sat:
        model = solver.model()
        true = [
            [next(v for v in row if z3.is_true(model[z3.Bool(v)])) for row in block.slices()]
            for block in (world.sigma, world.alpha)
        ]
        solver.add(z3.Or([z3.Not(z3.Bool(v)) for row in true for v in row]))
        found.append(
            tuple(
                tuple(v - row[0] for v, row in zip(answers, block.slices(), strict=True))
                for answers, block in zip(true, (world.sigma, world.alpha), strict=True)
            )
        )
    return found


def counted(path, edges, map_class, degrees=(None, None), fewest=1, most=None):
    formula = Formula()
    size = Size(edges, fewest, most or edges + 1)
    asked = Question("none", MapClass(map_class), size.most, edges, *degrees)
    world = one_world(formula, "", size, asked)
    return models(path, formula, world)


# Rooted maps by edges: A000698 shifted; planar: Tutte 1963; simple: rotation systems of
# connected simple graphs, counted over the graph atlas.
@pytest.mark.parametrize(
    ("map_class", "edges", "count"),
    [
        *(("maps", m, count) for m, count in enumerate((2, 10, 74), 1)),
        *(("simple", m, count) for m, count in enumerate((1, 2, 6, 23), 1)),
        *(("planar", m, count) for m, count in enumerate((2, 9, 54), 1)),
        *(("planar-simple", m, count) for m, count in enumerate((1, 2, 6, 23), 1)),
    ],
)
def test_the_models_of_one_world_are_the_rooted_maps_of_the_class(
    tmp_path, map_class, edges, count
):
    found = counted(tmp_path / "f.cnf", edges, map_class, fewest=2 if "simple" in map_class else 1)
    assert len(found) == count
    # z3 gives each model once; the codes are those of the enumeration by all permutations.
    assert sorted(found) == [(m.sigma, m.alpha) for m in rooted_maps(edges, map_class)]


@pytest.mark.parametrize("map_class", ["maps", "planar"])
@pytest.mark.parametrize(("fewest", "most"), [(1, 1)])
def test_bounds_on_the_vertices_leave_exactly_the_maps_within_them(
    tmp_path, map_class, fewest, most
):
    found = counted(tmp_path / "f.cnf", 3, map_class, fewest=fewest, most=most)
    wanted = [m for m in rooted_maps(3, map_class) if fewest <= m.vertex_count <= most]
    assert sorted(found) == [(m.sigma, m.alpha) for m in wanted]


@pytest.mark.parametrize(("root", "others"), [(2, None), (None, 2), (2, 2), (4, 1), (9, None)])
def test_required_degrees_leave_exactly_the_maps_that_have_them(tmp_path, root, others):
    found = counted(tmp_path / "f.cnf", 3, "maps", (root, others))
    wanted = [
        m
        for m in rooted_maps(3)
        if (root is None or m.degree_at[0] == root)
        and (others is None or all(d == others for d in m.degrees[1:]))
    ]
    assert sorted(found) == [(m.sigma, m.alpha) for m in wanted]


def solved(path, formula):
    formula.write(path)
    return solve_with_z3(path, None).status


def test_excluding_other_starts_keeps_a_pair_of_different_worlds(tmp_path):
    asked = question("position", "maps", 3, 2)
    formula, pair = pair_formula(asked, Sizes(Size(2, 1, 3), Size(2, 1, 3)))
    for start in range(1, 4):
        forbid_other_start(formula, pair, start)
    assert solved(tmp_path / "f.cnf", formula) == "sat"


def test_of_four_edges_the_cycle_alone_looks_like_the_loop_without_a_lighthouse(tmp_path):
    # The path of four edges, started in its middle, differs only beyond as many darts as the
    # loop has.
    sizes = Sizes(Size(1, 1, 2), Size(4, 1, 5))
    formula, pair = pair_formula(question("none", "maps", 5, 4), sizes)
    ((sigma, alpha),) = models(tmp_path / "f.cnf", formula, pair.two)
    assert all(sigma[sigma[dart]] == dart != sigma[dart] for dart in range(8))
    assert alpha != sigma


def test_a_file_says_what_its_variables_and_clauses_mean(tmp_path):
    asked = question("directional", "simple", 3, 2, degree_marked=1)
    formula, _ = pair_formula(asked, next(asked.sizes()))
    formula.write(tmp_path / "f.cnf")
    lines = (tmp_path / "f.cnf").read_text().splitlines()
    assert lines[0].startswith("c Two different worlds that no motion tells apart")
    assert "degree 1 at the start's vertex" in lines[0]
    header = lines.index(f"p cnf {formula.variable_count} {len(formula.clauses)}")
    named = [line.split()[2].split("..") for line in lines[:header] if "c variables" in line]
    told = [line.split()[2].rstrip(":").split("..") for line in lines[header:] if "c cl" in line]
    for ranges, last in ((named, formula.variable_count), (told, len(formula.clauses))):
        covered = [number for a, b in ranges for number in range(int(a), int(b) + 1)]
        assert covered == list(range(1, last + 1))
    assert sum("no two edges with the same ends" in line for line in lines) == 2


@pytest.mark.parametrize(
    ("asked", "fits"),
    [
        ({}, True),
        ({"degree_marked": 1}, True),
        ({"degree_marked": 2}, False),
        ({"degree_others": 1}, False),
        ({"degree_marked": 1, "degree_others": 2}, False),
        ({"map_class": "simple"}, True),
        ({"vertices": 2}, False),
        ({"edges": 1}, False),
        ({"motions": (0, 1), "percepts": ("2A", "1A")}, True),
        ({"motions": (0, 1), "percepts": ("2A", "1P")}, False),
    ],
)
def test_a_world_fits_what_was_asked_or_does_not(asked, fits):
    world = World(named_map("path-3"), Position(0), 0)
    asked = {"map_class": "maps", "vertices": 3, "edges": 2} | asked
    sizes = (asked.pop(name) for name in ("map_class", "vertices", "edges"))
    found = question("position", *sizes, **asked)
    assert _fits(world, found) == fits


def test_of_other_vertices_every_degree_counts():
    middle = World(named_map("path-3"), Position(1), 1)
    assert _fits(middle, question("position", "maps", 3, 2, degree_others=1))


SECTIONS = {
    ("directional", "planar-simple", 4, 3): (
        "sigma is a permutation, alpha an involution without fixed points",
        "an answer is a number that has been given, or the next free one",
        "a dart has its number before it is asked: the map is connected",
        "sigma stays at the vertex",
        "vertex2 is numbered in the order of first darts",
        "at least 2 vertices",
        "places count from the first dart, so each vertex is one cycle of sigma",
        "the degree is one more than the place of the last dart",
        "no loop",
        "no two edges with the same ends",
        "phi = sigma . alpha stays at the face",
        "face1 is numbered in the order of first darts",
        "Euler's formula of the sphere: with n vertices there are m + 2 - n faces",
        "world 2 has its reference darts",
        "turning is free: the starts are reference darts",
        "the starts are related, and what is related stays so under sigma and alpha",
        "related darts sense the same",
        "the codes differ, and the first is the smaller one",
        "started at dart 1, world 2 is not world 1",
    ),
    ("position", "maps", 2, 2): (
        "turning is free: no dart of v0 leads to a larger degree than the start",
    ),
    ("door", "maps", 2, 2): ("world 1 has its letters",),
}


@pytest.mark.parametrize("asked", SECTIONS, ids=lambda asked: asked[0])
def test_no_section_of_clauses_is_without_its_words(asked, tmp_path):
    of = question(*asked)
    formula, pair = pair_formula(of, next(of.sizes()))
    forbid_other_start(formula, pair, 1)
    formula.write(tmp_path / "f.cnf")
    lines = (tmp_path / "f.cnf").read_text().splitlines()
    told = {line.partition(": ")[2] for line in lines if line.startswith("c clauses")}
    assert not {*SECTIONS[asked]} - told


@pytest.mark.parametrize(
    ("lighthouse", "is_free"), [("position", True), ("door", False), ("word:12", False)]
)
def test_letters_fix_the_start_so_that_it_cannot_be_chosen_by_degrees(
    lighthouse, is_free, tmp_path
):
    asked = question(lighthouse, "maps", 2, 2)
    formula, _ = pair_formula(asked, next(asked.sizes()))
    formula.write(tmp_path / "f.cnf")
    chosen = "turning is free: no dart of v0 leads to a larger degree than the start"
    assert (chosen in (tmp_path / "f.cnf").read_text()) is is_free


def test_degrees_and_a_walk_that_are_asked_for_have_sections(tmp_path):
    asked = question("position", "maps", 3, 3, degree_marked=2, motions=(0,), percepts=("1A",))
    formula, _ = pair_formula(asked, next(asked.sizes()))
    formula.write(tmp_path / "f.cnf")
    text = (tmp_path / "f.cnf").read_text()
    assert ": the degrees that were asked for\n" in text
    assert ": the walk and what it senses\n" in text


@pytest.mark.parametrize(("edges", "vertices", "most"), [(3, 3, 2), (6, 4, 3), (2, 4, 2)])
def test_in_a_simple_world_no_degree_is_asked_for_that_none_has(edges, vertices, most):
    asked = question("directional", "simple", vertices, edges)
    world = one_world(Formula([]), "1", Size(edges, vertices, vertices), asked)
    assert world.degree.shape == (2 * edges, most + 1)
