from itertools import product

import pytest

import allworlds
from allworlds.maps import MapClass, rooted_maps
from allworlds.studies.ambiguity import solvers, twin_search as searching
from allworlds.studies.ambiguity.clauses import read_dimacs
from allworlds.studies.ambiguity.formulas import forbid_other_start, pair_formula
from allworlds.studies.ambiguity.proofs import check_lrat
from allworlds.studies.ambiguity.question import Size, Sizes
from allworlds.world import Compass, Directional, Nothing, Position, World
from allworlds.world.bisimulation import same_world_from, sensed
from searches import question
from small import slowest
from studies.test_twin_search import SENSORS, needs_python_sat, sizes

CAPTION = {"motions": (1, 1, 2, 2, 1), "percepts": ("3A", "3A", "3A", "3A", "4P")}


@pytest.mark.slowest
def test_the_caption_of_fig_1_is_found_and_replays_from_every_start(tmp_path):
    bounds = {"vertices": 9, "edges": 14, "map_class": "planar-simple", "out": tmp_path}
    result = allworlds.search(
        lighthouse="position", degree_marked=4, degree_others=3, **CAPTION, **bounds
    )
    assert sizes(result) == [(14, 9), (14, 9)]
    for world in result.pair:
        for start in world.map.vertices[world.map.vertex_of[world.start]]:
            seen = sensed(World(world.map, world.lighthouse, start), CAPTION["motions"])
            assert [(p.degree, p.marks) for p in seen[1:]] == [(3, 0)] * 4 + [(4, 1)]


def placed(kind, map_):
    """Every world with the lighthouse on a rooted map, started at its root."""
    if kind == "compass":
        for darts in product(*map_.vertices):
            yield World(map_, Compass(tuple(sorted(darts))))
    elif kind == "directional":
        for dart in map_.vertices[map_.vertex_of[0]]:
            yield World(map_, Directional(dart))
    else:
        yield World(map_, Position(0) if kind == "position" else Nothing())


def percept(world, dart):
    """Degree, marks, and the bearing where one is sensed, found by turning step by step."""
    around, lighthouse = [dart], world.lighthouse
    while world.map.sigma[around[-1]] != dart:
        around.append(world.map.sigma[around[-1]])
    darts = {
        "none": (),
        "position": [0],
        "directional": [getattr(lighthouse, "dart", None)],
        "compass": getattr(lighthouse, "darts", ()),
    }[lighthouse.kind]
    here = [place for place, other in enumerate(around) if other in darts]
    marks = int(bool(here) and lighthouse.kind in ("position", "directional"))
    bearing = here if lighthouse.kind in ("directional", "compass") else []
    return (len(around), marks, *bearing)


def looks(world):
    """Equal exactly for worlds that no motion tells apart: the rooted quotient, naively."""
    darts = world.map.darts
    label = {d: percept(world, d) for d in darts}
    for _ in darts:
        label = {d: (label[d], label[world.map.sigma[d]], label[world.map.alpha[d]]) for d in darts}
        names = {value: i for i, value in enumerate(sorted(set(label.values())))}
        label = {d: names[value] for d, value in label.items()}
    some = {c: d for d, c in label.items()}
    walk = [label[world.start]]
    for c in walk:
        for step in (world.map.sigma, world.map.alpha):
            if label[step[some[c]]] not in walk:
                walk.append(label[step[some[c]]])
    number = {c: i for i, c in enumerate(walk)}
    steps = (world.map.sigma, world.map.alpha)
    return tuple(
        (percept(world, some[c]), *(number[label[step[some[c]]]] for step in steps)) for c in walk
    )


def smallest_by_enumeration(kind, map_class, edges):
    """The largest number of edges of a pair with the fewest, and with the fewest in the other."""
    known = {}
    for m in range(1, edges + 1):
        found = set()
        for map_ in rooted_maps(m, map_class):
            for world in placed(kind, map_):
                others = known.setdefault(looks(world), [])
                found |= {
                    other.map.edge_count
                    for other in others
                    if same_world_from(other, world) is None
                }
                if all(same_world_from(other, world) != 0 for other in others):
                    others.append(world)
        if found:
            return (min(found), m)
    return None


@pytest.mark.parametrize(
    ("kind", "map_class", "edges"),
    [
        ("none", "maps", 2),
        ("none", "simple", 4),
        ("none", "planar-simple", 4),
        ("position", "maps", 2),
        ("position", "planar", 3),
        ("position", "simple", 5),
        ("compass", "maps", 2),
        ("compass", "simple", 4),
        ("directional", "maps", 3),
    ],
)
def test_search_and_enumeration_give_the_same_answer(tmp_path, monkeypatch, kind, map_class, edges):
    monkeypatch.setattr(searching, "python_sat_is_installed", lambda: False)
    expected = smallest_by_enumeration(kind, MapClass(map_class), edges)
    result = allworlds.search(
        lighthouse=kind, map_class=map_class, vertices=edges + 1, edges=edges, out=tmp_path
    )
    found = None if result.pair is None else tuple(m for m, _ in sizes(result))
    assert found == expected
    assert result.status == ("unsat" if expected is None else "sat")


@pytest.mark.slowest
def test_one_vertex_more_or_less_decides(tmp_path):
    # K4 with its marker: n = 4; with three vertices a simple map has at most three edges.
    bounds = {"lighthouse": "position", "map_class": "simple", "edges": 6, "out": tmp_path}
    assert allworlds.search(vertices=4, **bounds).status == "sat"
    result = allworlds.search(vertices=3, **bounds)
    assert (result.status, result.vacuous) == ("unsat", False)
    assert [found.sizes.two.edges for found in result.levels] == [1, 2, 3]


@pytest.mark.parametrize("kind", ["none", "position", "compass"])
@pytest.mark.parametrize("edges", [2, 3])
def test_with_every_other_start_excluded_a_level_has_a_pair_where_enumeration_has_one(
    tmp_path, kind, edges
):
    known = {}
    for map_ in rooted_maps(edges):
        for world in placed(kind, map_):
            known.setdefault(looks(world), []).append(world)
    there = any(
        same_world_from(group[0], other) is None for group in known.values() for other in group
    )
    size = Size(edges, 1, edges + 1)
    asked = question(kind, "maps", edges + 1, edges)
    formula, pair = pair_formula(asked, Sizes(size, size))
    for start in range(1, 2 * edges):
        forbid_other_start(formula, pair, start)
    formula.write(tmp_path / "f.cnf")
    solved = solvers.solve_with_z3(tmp_path / "f.cnf", None)
    assert solved.status == ("sat" if there else "unsat")


@pytest.mark.slowest
@needs_python_sat
@pytest.mark.parametrize(
    ("lighthouse", "map_class", "edges"),
    [
        ("position", "maps", 1),
        ("position", "simple", 4),
        ("directional", "maps", 3),
        ("position", "planar-simple", 4),
        ("position", "simple", 5),
        ("position", "planar-simple", 5),
        ("directional", "maps", 4),
        slowest("directional", "maps", 5),
    ],
)
def test_where_there_is_no_pair_every_level_has_a_checked_proof(
    tmp_path, lighthouse, map_class, edges
):
    bounds = {"vertices": 9, "edges": edges, "map_class": map_class}
    result = allworlds.search(lighthouse=lighthouse, out=tmp_path, **bounds)
    assert (result.status, result.exit_code, result.certificate) == ("unsat", 0, tmp_path)
    assert [found.sizes.two.edges for found in result.levels] == list(range(1, edges + 1))
    for found in result.levels:
        # With a reader of its own: the producer's is the one that made the proof.
        lines = [line.split() for line in found.formula.read_text().splitlines()]
        clauses = [tuple(map(int, line[:-1])) for line in lines if line[0] not in {"c", "p"}]
        check_lrat(clauses, found.proof.read_text().splitlines())
        assert read_dimacs(found.formula)[1] == clauses


# Smallest pairs with the position marked: any map m = 2, simple m = 6, planar simple m = 8.
@pytest.mark.parametrize(
    ("map_class", "edges", "found"),
    [
        ("maps", 2, (2, 1)),
        ("planar", 3, (3, 1)),
        ("simple", 6, (6, 4)),
        slowest("planar-simple", 8, (8, 7)),
    ],
)
def test_the_smallest_pair_is_found_with_the_position_marked(tmp_path, map_class, edges, found):
    bounds = {"vertices": 9, "map_class": map_class, "out": tmp_path}
    result = allworlds.search(lighthouse="position", edges=edges, **bounds)
    assert (result.status, result.exit_code) == ("sat", 0)
    assert sizes(result) == [found, found]
    assert [found.status for found in result.levels].count("unsat") >= edges - 1


@pytest.mark.parametrize(
    ("sensor", "edges", "status"),
    [
        ("Half", 2, "unsat"),
        ("AtDegree?word=12", 2, "unsat"),  # degrees without a word are no worlds of it
        ("AtDegree?word=123123", 3, "sat"),
        ("DoorBut?degree=2", 2, "sat"),
    ],
)
def test_a_sensor_of_ones_own_is_searched_as_the_census_finds_it(tmp_path, sensor, edges, status):
    name = f"{SENSORS}:{sensor}"
    asked = {"lighthouse": name, "vertices": edges + 1, "edges": edges}
    found = allworlds.search(out=tmp_path, **asked)
    rows = allworlds.ambiguity.census(edges=edges, lighthouse=name).rows
    assert (found.status, any(row.ambiguous_worlds for row in rows)) == (status, status == "sat")
    assert found.lighthouse == name
