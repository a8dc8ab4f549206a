"""Damaged tables and damaged lists of work: each dies by name, and none as a crash."""

from collections import Counter
from types import SimpleNamespace

import pytest

from allworlds import Estimate, check
from allworlds.documents.document import replace
from allworlds.engines import compiled_engine as compiled
from allworlds.engines.compiled_engine import AGREED, UNBOUNDED, bounds_of
from allworlds.engines.kernel.arrays import BrokenRun, Counts
from allworlds.engines.kernel.capabilities import POLICIES
from allworlds.engines.kernel.engine import judge, walk
from allworlds.engines.kernel.runs import UNDEFINED
from allworlds.engines.tally import EnginesDisagree, Tally
from allworlds.engines.units import LevelUnit, Scope, units_of_level
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.loading import in_process_subject, load
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent, condition_named
from allworlds.maps.combinatorial import CombinatorialMap, rooted_code
from allworlds.maps.enumeration import FINGERPRINTS, fingerprint, history, prefixes, rooted_maps
from allworlds.studies.check.report import known_fingerprints
from allworlds.world import Directional, World
from small import EDGE, PLANE

pytestmark = pytest.mark.usefixtures("compiled")


LEVEL_OF = compiled.level_of


@pytest.fixture(autouse=True)
def fresh_comparison():
    AGREED.clear()
    LEVEL_OF.cache_clear()
    yield
    AGREED.clear()
    LEVEL_OF.cache_clear()


def table_of(bounds):
    """The table of the kernel of these largest costs, by vertices from 0 on."""
    return [[[bound]] for bound in bounds]


def test_a_judge_that_is_wrong_is_found_out_before_the_first_level(monkeypatch):
    honest = judge

    def forgetful(*arguments, **options):
        rows = honest(*arguments, **options)
        return replace(rows, met=rows.met[:-1])

    monkeypatch.setattr("allworlds.engines.kernel.engine.judge", forgetful)
    report = check(edges=2, engine="kernel")
    assert report.exit_code == 70
    assert "the kernel and the python engine count differently in the unit" in report.ending.reason


def test_what_the_judge_blames_is_asked_of_the_python_engine(monkeypatch):
    monkeypatch.setattr(compiled, "compare_engines", lambda *_: None)
    honest = compiled.level_of

    def stricter(*arguments):
        level = honest(*arguments)
        return replace(level, bounds=table_of([0] * (arguments[-1] + 2)))

    monkeypatch.setattr(compiled, "level_of", stricter)
    report = check(edges=2, engine="kernel")
    assert report.exit_code == 70
    assert "bound is broken, the python engine that none is" in report.ending.reason


def test_the_bounds_are_those_of_the_rules():
    rules = Rules(bound="m * n")
    assert bounds_of(rules, 3) == table_of([0, 3, 6, 9, 12])
    assert bounds_of(replace(rules, bound="none"), 3) == table_of([UNBOUNDED] * 5)
    by_degree = [[UNDEFINED], *([3 // d0] for d0 in range(1, 7))]
    assert bounds_of(replace(rules, bound="m // d0"), 3)[1] == by_degree


def with_one_world_twice(honest):
    """With five edges one world comes again in the place of another one of its size."""
    maps = [map_ for map_ in rooted_maps(5, prefix=(-3, 1)) if map_.vertex_count == 3]
    twice, never = map(history, maps[:2])

    def kernel(level, prefix, **options):
        rows = honest(level, prefix, **options)
        if level.edges == 5 and prefix == twice[: len(prefix)]:
            (more,), (less,) = (honest(level, each).counts for each in (twice, never))
            assert (more.vertices, more.runs) == (less.vertices, less.runs)
            rows = replace(rows, counts=tuple(exchanged(each, more, less) for each in rows.counts))
        return rows

    return kernel


def exchanged(counts, more, less):
    """The counts of one size with a world more and another one less, if they are of that size."""
    if counts.vertices != more.vertices:
        return counts
    names = [name for name in Counts.__struct_fields__ if name not in ("vertices", "largest")]
    moved = {
        name: getattr(counts, name) + getattr(more, name) - getattr(less, name) for name in names
    }
    return replace(counts, **moved)


def test_a_world_that_comes_again_in_the_place_of_another_is_seen_by_the_gate(monkeypatch):
    monkeypatch.setattr(compiled, "compare_engines", lambda *_: None)
    monkeypatch.setattr("allworlds.engines.kernel.engine.judge", with_one_world_twice(judge))
    report = check(edges=5, engine="kernel")
    assert report.exit_code == 70
    (wrong,) = [cell for cell in report.cells if not cell.agrees]
    assert (wrong.edges, wrong.enumerated) == (5, wrong.counted)
    assert wrong.fingerprint != wrong.listed


def test_every_engine_has_the_same_worlds():
    explorer = "allworlds.explorers.builtin.algorithm1:algorithm1"
    asked = [{"engine": "python"}, {"engine": "kernel"}, {"explore": explorer, "engine": "kernel"}]
    prints = [[cell.fingerprint for cell in check(edges=3, **each).cells] for each in asked]
    assert prints == [[cell.listed for cell in check(edges=3).cells]] * 3


def test_the_kernel_counts_its_fingerprints_as_its_twin_does():
    for prefix in prefixes(4, depth=2):
        level = LEVEL_OF("algorithm1", Rules(), Extent(MapClass.MAPS, 4), 4)
        found = {row.vertices: row.fingerprint for row in judge(level, prefix).counts}
        sums = Counter()
        for map_ in rooted_maps(4, prefix=prefix):
            sums[map_.vertex_count] += fingerprint(map_)
        assert found == {n: each % FINGERPRINTS for n, each in sums.items()}


@pytest.mark.parametrize("policy", POLICIES)
def test_walks_have_the_fingerprints_of_their_twin_whatever_is_looked_at_first(policy):
    extent = Extent(MapClass.MAPS, 4)
    sums = Counter()
    for prefix in prefixes(4, depth=2):
        for row in walk(LEVEL_OF("algorithm1", Rules(policy=policy), extent, 4), prefix).counts:
            sums[row.vertices] += row.fingerprint
    listed = known_fingerprints(extent, 4)
    assert {n: f"{each % FINGERPRINTS:x}" for n, each in sums.items()} == listed


@pytest.mark.parametrize("policy", POLICIES)
def test_a_map_beyond_all_lists_has_its_fingerprint_whatever_is_looked_at_first(policy):
    bouquet, extent = rose(9), Extent(MapClass.MAPS, 9)
    level = LEVEL_OF("algorithm1", Rules(policy=policy), extent, 9)
    (row,) = walk(level, history(bouquet)).counts
    assert row.fingerprint == fingerprint(bouquet)
    assert not known_fingerprints(extent, 9)


def rose(edges):
    """One vertex with so many loops."""
    darts = range(2 * edges)
    return CombinatorialMap([(dart + 1) % len(darts) for dart in darts], [d ^ 1 for d in darts])


@pytest.mark.parametrize("map_class", MapClass)
def test_of_large_levels_the_corpus_has_the_worlds_of_all_maps_alone(map_class):
    known = known_fingerprints(Extent(map_class, 9), 6)
    assert len(known) == (7 if map_class is MapClass.MAPS else 0)
    assert known_fingerprints(Extent(map_class, 9, where=condition_named("trees")), 6) == {}
    assert known_fingerprints(Extent(map_class, 9), 9) == {}
    assert known_fingerprints(Extent(map_class, 9), 2).keys() <= {1, 2, 3}


# ---------------------------------------------------------------- what two engines say of a world


@pytest.fixture
def edge():
    """The question of the world with one edge and two vertices, with what Python counts."""
    scope, unit = Scope(Extent(MapClass.MAPS, 1), Rules()), LevelUnit(1, (-1,))
    subject = load("algorithm1")
    python = compiled.played_tally(scope, subject, unit)
    return lambda walked: compiled._compare_in(unit, python, scope, subject, walked=walked)


def test_engines_that_agree_are_found_to(edge):
    edge(walked=True)


def test_a_law_that_one_engine_alone_finds_broken_is_told_with_the_world(edge, monkeypatch):
    honest = judge

    def blaming(*question, **options):
        rows = honest(*question, **options)
        return replace(rows, broken=(BrokenRun(2, (0, 1), (1, 0), 0, "map"),))

    monkeypatch.setattr("allworlds.engines.kernel.engine.judge", blaming)
    said = r"that {'map'} is broken, the python engine none, in the world sigma=\[0, 1\] alpha="
    with pytest.raises(EnginesDisagree, match=said):
        edge(walked=False)


def test_another_count_of_one_walk_for_every_bearing_is_told(edge, monkeypatch):
    fewer = SimpleNamespace(counts=())
    monkeypatch.setattr("allworlds.engines.kernel.engine.walk", lambda *_: fewer)
    edge(walked=False)
    with pytest.raises(EnginesDisagree, match=r"for every bearing, .* run by run, in the"):
        edge(walked=True)


@pytest.mark.parametrize(
    ("run", "said"),
    [
        (BrokenRun(2, (0, 1), (0, 1), None, "map"), "the kernel met a world that is none"),
        (
            BrokenRun(2, (0, 1), (1, 0), 0, "map"),
            "says that map is broken, .* that none is, in the",
        ),
        (
            BrokenRun(2, (0, 1), (1, 0), None, ""),
            "says that a law is broken, .* that none is.*place=0",
        ),
    ],
)
def test_what_only_the_kernel_blames_is_told_with_the_world_and_its_place(run, said):
    scope = Scope(Extent(MapClass.MAPS, 1), Rules())
    engine = compiled.CompiledEngine(scope, load("algorithm1"), keep=1)
    with pytest.raises(EnginesDisagree, match=said):
        engine._blame(run, Tally(1))


def wrong_at(bearing):
    """An explorer that errs if v0 lies behind this door, or always."""

    def explore(first):
        if bearing in (first.bearing, "any"):
            return Estimate(EDGE, 0)
        return (yield from algorithm1(first))

    return replace(in_process_subject(explore), explore=explore)


@pytest.mark.parametrize(
    ("bearing", "place", "law", "found"), [(1, 1, "map", 1), ("any", None, "", 0)]
)
def test_what_both_engines_blame_is_a_finding_of_its_place(bearing, place, law, found):
    scope = Scope(Extent(MapClass.MAPS, 2), Rules())
    engine, tally = compiled.CompiledEngine(scope, wrong_at(bearing), keep=1), Tally(1)
    code = rooted_code(PLANE.sigma, PLANE.alpha, 0)
    engine._blame(BrokenRun(1, *code, place, law), tally)
    places = [*Directional.places(PLANE, 0)]
    assert [finding.world for finding in tally.findings] == [World(PLANE, places[found], 0)]


@pytest.mark.parametrize("keep", [1, 3])
def test_the_compiled_engine_has_the_findings_of_the_python_engine(keep):
    scope, subject = Scope(Extent(MapClass.MAPS, 2), Rules(bound="n - 1")), load("algorithm1")
    engine = compiled.CompiledEngine(scope, subject, keep)
    for unit in units_of_level(scope.extent, 2):
        (tally,) = engine.parts(unit)
        python = compiled.played_tally(scope, subject, unit)
        assert tally.findings == python.findings[:keep]
        assert (tally.rows, tally.keep) == (python.rows, keep)
        assert all(tally.witnesses.values())
