"""No clause of the checkers' encoder excludes two worlds that it should not exclude.

Every variable gets the value that its meaning has in two given worlds, from the definitions, and
every clause is evaluated.  For two different worlds of the class, of which the first has the
smaller code, all clauses must then be true except some of 'related darts sense the same'; and
these are all true exactly if the worlds look alike.  So if two worlds look alike, the formula
has a model: what the proofs rest on.
"""

from itertools import product

import pytest

from proofs import test_meaning as quick
from proofs.test_meaning import code_of, formula, pairs_of, starts_best

meant = quick.meant

LIGHTHOUSES = ["none", "position", "directional", "compass"]


CLASSES = ["maps", "simple", "planar", "planar-simple"]


def require_meaning(checkers, meant, lighthouse, map_class, edges, *, sample=None):
    """The number of pairs that were tried: all, or so many."""
    starts = range(1, 2 * edges[1]) if edges[0] == edges[1] else []
    clauses = formula(checkers, lighthouse, map_class, edges, starts)
    tried = 0
    if clauses is not None:
        for one, two in pairs_of(checkers, lighthouse, map_class, edges, sample=sample):
            assert meant(clauses, one, two, starts=starts) == "", (one, two)
            tried += 1
    return tried


@pytest.mark.parametrize("lighthouse", LIGHTHOUSES)
@pytest.mark.parametrize("map_class", CLASSES)
def test_no_two_worlds_with_one_or_two_edges_are_excluded_unless_a_motion_tells_them_apart(
    checkers, meant, lighthouse, map_class
):
    sizes = [(1, 1), (2, 2)] + ([(1, 2)] if lighthouse in {"none", "compass"} else [])
    tried = [require_meaning(checkers, meant, lighthouse, map_class, s) for s in sizes]
    assert sum(tried) >= 33 or "simple" in map_class


SAMPLED = [
    *(("directional", "maps", m) for m in (3, 4)),
    *(("position", "simple", m) for m in (3, 4, 5)),
    *(("position", "planar-simple", m) for m in (4, 5, 6)),
    ("compass", "planar", 3),
    ("none", "maps", 3),
]


@pytest.mark.slowest
@pytest.mark.parametrize(("lighthouse", "map_class", "edges"), SAMPLED)
def test_nor_any_of_a_sample_of_larger_ones(checkers, meant, lighthouse, map_class, edges):
    assert require_meaning(checkers, meant, lighthouse, map_class, (edges, edges), sample=8) == 8


@pytest.mark.slowest
@pytest.mark.parametrize("lighthouse", LIGHTHOUSES)
@pytest.mark.parametrize("map_class", CLASSES)
def test_nor_any_two_with_three_edges(checkers, meant, lighthouse, map_class):
    sample = 1000 if lighthouse == "compass" else None
    assert require_meaning(checkers, meant, lighthouse, map_class, (3, 3), sample=sample) >= 3


@pytest.mark.slowest
def test_the_pairs_that_look_alike_are_models(checkers, meant, proofs):
    documents, maps = checkers("documents"), checkers("maps")
    pairs = documents.read_json(proofs / "smallest-pairs" / "pairs.json")
    for map_class, entry in pairs.items():
        worlds, _ = documents.pair_of(entry, "position")
        turned = [
            maps.World(*maps.code(*w.map, d), 0, "position", (0,))
            for w in worlds
            for d in maps.orbit(w.sigma, w.start)
        ]
        edges = len(worlds[0].sigma) // 2
        clauses = formula(checkers, "position", map_class, (edges, edges))
        models = [
            (one, two)
            for one, two in product(turned, repeat=2)
            if starts_best(one, maps.orbit)
            and code_of(one) < code_of(two)
            and maps.world_code(one) != maps.world_code(two)
            and maps.quotient_code(one) == maps.quotient_code(two)
        ]
        assert models
        for one, two in models:
            assert meant(clauses, one, two) == ""


def test_a_walk_is_met_by_the_worlds_that_sense_what_it_says(checkers, meant):
    maps = checkers("maps")
    motions = (1, -2, 0)
    tried = 0
    for one, two in pairs_of(checkers, "position", "maps", (2, 2)):
        sensed = maps.replay(one, 0, motions)
        walk = tuple((k, *percept) for k, percept in zip(motions, sensed, strict=True))
        clauses = formula(checkers, "position", "maps", (2, 2), walk=walk)
        assert meant(clauses, one, two, walk) == ""
        wrong = (*walk[:-1], (walk[-1][0], walk[-1][1] % 4 + 1, walk[-1][2]))
        clauses = formula(checkers, "position", "maps", (2, 2), walk=wrong)
        assert "the walk begins at the start" in meant(clauses, one, two, wrong)
        tried += 1
    assert tried > 10
