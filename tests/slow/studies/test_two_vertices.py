"""The explorers without a direction, as a whole: checked, refuted, replayed and explained."""

import pytest

from allworlds.outcome import Verdict
from allworlds.studies.fuzz.sample_sweep import fuzz
from studies import test_two_vertices as quick
from studies.test_two_vertices import (
    CLUSTER,
    LAWS,
    NATURAL,
    NoQuery,
    NoSearch,
    QueryNotUndone,
    TwoMarksSuffice,
    check,
)

pytestmark = pytest.mark.usefixtures("no_orphans", "without_workers")


@pytest.mark.slowest
@pytest.mark.parametrize("policy", ["fifo", "lifo", "nearest", "random:1"])
def test_the_natural_explorer_holds_in_simple_worlds(policy):
    report = check(NATURAL, edges=6, map_class="simple", policy=policy)
    assert (report.verdict, report.missing_witnesses) == (Verdict.HOLDS, ())
    # Rooted simple maps with m edges: 1, 2, 6, 23, 108, 596; those with a place have 9, 10, 198.
    assert (report.worlds, report.runs) == (736, 217)
    assert report.to_json()["scope"]["lighthouse"] == "natural"
    assert report.to_json()["scope"]["laws"] == LAWS


@pytest.mark.parametrize("explorer", [CLUSTER, NATURAL])
@pytest.mark.parametrize("map_class", ["maps", "planar", "simple", "planar-simple"])
@pytest.mark.parametrize("policy", ["fifo", "lifo", "nearest", "random:1", "random:2"])
def test_no_witness_is_asked_for_that_cannot_occur(explorer, map_class, policy):
    most = 4 if map_class.endswith("simple") else 2
    for edges in range(1, most + 1):
        for vertices in (None, *range(2, edges + 1)):
            options = {"edges": edges, "vertices": vertices, "map_class": map_class}
            report = check(explorer, policy=policy, **options)
            if report.runs:
                assert (report.missing_witnesses, report.verdict) == ((), Verdict.HOLDS), options
            else:
                assert report.verdict is Verdict.VACUOUS, options


@pytest.mark.slowest
def test_every_schedule_holds():
    report = check(CLUSTER, edges=3, schedules="all")
    assert report.verdict is Verdict.HOLDS
    assert report.runs == 67
    assert sum(row.episodes for row in report.rows) > 100 * report.runs
    assert check(NATURAL, edges=4, map_class="simple", schedules="all").verdict is Verdict.HOLDS


def test_an_explorer_under_a_lighthouse_it_is_not_written_for_is_refuted_not_stopped():
    assert check("algorithm1", edges=3, lighthouse="cluster").findings[0].law == "map"
    for explorer in (CLUSTER, NATURAL):
        for lighthouse in ("none", "position", "compass", "directional"):
            report = check(explorer, edges=3, lighthouse=lighthouse)
            assert report.verdict is Verdict.REFUTED
            assert report.findings[0].law != "crash"


@pytest.mark.slowest
@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("explorer", [CLUSTER, NATURAL])
def test_both_engines_do_it_and_say_the_same(explorer):
    options = {"edges": 5, "map_class": "planar-simple", "bound": "two-vertices"}
    played, judged = (check(explorer, engine=name, **options) for name in ("python", "kernel"))
    assert check(explorer, **options).engine == "kernel"
    assert played.tally == judged.tally


@pytest.mark.parametrize(("edges", "all_worlds"), [(4, 792)])
@pytest.mark.parametrize("policy", ["fifo", "lifo", "nearest", "random:1"])
def test_the_cluster_explorer_holds_where_one_edge_joins_v0_and_v1(policy, edges, all_worlds):
    quick.test_the_cluster_explorer_holds_where_one_edge_joins_v0_and_v1(policy, edges, all_worlds)


@pytest.mark.slowest
def test_a_sample_refutes_the_natural_explorer_and_shrinks_to_the_smallest_world():
    report = fuzz(NATURAL, edges=8, runs=300, seed=1)
    assert report.verdict is Verdict.REFUTED
    map_ = report.findings[0].world.map
    assert (map_.edge_count, map_.vertex_count) == (3, 2)


@pytest.mark.parametrize("wrong", [NoQuery, NoSearch, QueryNotUndone, TwoMarksSuffice])
def test_with_one_thing_done_wrong_the_explorer_is_refuted(wrong):
    def explore(first, *, choices):
        marks = [lambda seen, n=n: seen.marks == n for n in (1, 2)]
        return (yield from wrong(first, *marks, choices).explore())

    report = check(explore, edges=3, lighthouse="cluster:single=true")
    assert report.verdict is Verdict.REFUTED
