"""The exhaustive check as a whole: its numbers, its order, its verdicts."""

import itertools

import pytest

from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.maps import rooted_code, rooted_maps
from allworlds.outcome import Verdict
from allworlds.protocol.actions import Move
from allworlds.studies.run import run
from allworlds.world import worlds
from small import slowest
from studies import test_exhaustive as quick
from studies.test_exhaustive import check, document

pytestmark = pytest.mark.usefixtures("no_orphans")


@pytest.mark.slowest
def test_the_default_job_has_8954_worlds():
    report = check(workers=2)
    assert (report.worlds, report.runs, report.verdict) == (8954, 50727, Verdict.HOLDS)


@pytest.mark.slowest
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize(
    "policy", ["fifo", "random:1", *map(slowest, ("lifo", "nearest", "random:2", "random:3"))]
)
@pytest.mark.parametrize(
    ("map_class", "most"),
    [("maps", 3), ("planar", 3), slowest("planar", 4), ("simple", 5), ("planar-simple", 5)],
)
def test_no_witness_is_asked_for_that_cannot_occur(policy, map_class, most):
    for edges in range(1, most + 1):
        for vertices in (None, *range(2, edges + 1)):
            options = {"edges": edges, "vertices": vertices, "map_class": map_class}
            report = check(policy=policy, **options)
            if not report.runs:
                assert report.verdict is Verdict.VACUOUS, options
                continue
            assert report.missing_witnesses == (), options
            assert report.verdict is Verdict.HOLDS, options


@pytest.mark.slowest
@pytest.mark.parametrize(("edges", "keep"), [(3, 3), slowest(4, 12)])
@pytest.mark.parametrize("name", ["everywhere", "here_of_another"])
def test_one_worker_and_three_say_the_same(wrong, name, edges, keep):
    reports = [
        check(wrong(name), edges=edges, workers=workers, max_findings=keep) for workers in (1, 3)
    ]
    assert document(reports[0]) == document(reports[1])
    assert reports[0].exit_code == 1
    assert all(finding.minimal for finding in reports[0].findings)


@pytest.fixture(params=[(3, 309, 271), (4, 3684, 2718)])
def planted(request, explorers, monkeypatch):
    """A world in which the explorer ``planted`` is wrong, and in no other; edges and runs."""
    import wrong

    edges, runs, number = request.param
    explorers("planted")
    every = list(worlds(edges=edges, places="all"))
    assert len(every) == runs
    world = every[number]
    transcript = run(
        lambda first: (yield from wrong.right(first)), world
    ).outcome.episode.transcript
    log = [(None, transcript.first), *((move.k, seen) for move, seen in transcript.steps)]
    assert all(type(move) is Move for move, _ in transcript.steps)
    monkeypatch.setenv("PLANTED", wrong.signature(log))
    return world, edges, runs


@pytest.mark.slowest
def test_an_explorer_that_is_wrong_in_one_run_is_refuted_there(planted, wrong):
    world, edges, runs = planted
    reports = [check(wrong("planted"), edges=edges, workers=workers) for workers in (1, 3)]
    assert document(reports[0]) == document(reports[1])
    assert (reports[0].runs, reports[0].complete) == (runs, True)
    (finding,) = reports[0].findings
    assert (finding.law, finding.confirmed, finding.minimal) == ("map", True, True)
    told = run(wrong("planted"), world)
    assert told.finding.world == finding.world
    # The walk determines the world: no other run has the same log.
    assert check(wrong("planted"), edges=edges, workers=3, max_findings=2).findings == (finding,)


@pytest.mark.parametrize("policy", ["fifo", slowest("nearest")])
def test_a_folding_explorer_of_somebody_else_holds(folding, policy):
    report = check(folding, edges=3, policy=policy, bound="none", workers=2)
    assert (report.verdict, report.worlds, report.runs) == (Verdict.HOLDS, 86, 309)
    assert [row.bound for row in report.rows] == [None] * len(report.rows)


@pytest.mark.slowest
@pytest.mark.parametrize(("edges", "all_worlds", "runs"), [(3, 86, 309), (4, 792, 3684)])
def test_a_program_of_somebody_else_holds(program, edges, all_worlds, runs):
    report = check(program("right"), edges=edges, workers=3)
    assert (report.verdict, report.worlds, report.runs) == (Verdict.HOLDS, all_worlds, runs)
    ours = check(edges=edges)
    # First in, first out: it is the same walk in every world.
    assert report.rows == ours.rows


@pytest.mark.slowest
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize(
    ("edges", "shards"), [(3, 1), (3, 2), (3, 5), slowest(4, 1), (4, 2), slowest(4, 5)]
)
def test_the_shards_make_the_whole(edges, shards):
    whole = check(edges=edges)
    parts = [check(edges=edges, shard=(k, shards)) for k in range(shards)]
    assert sum(part.runs for part in parts) == whole.runs
    assert sum(part.tally.traversals for part in parts) == whole.tally.traversals
    assert sum((part.tally.witnesses for part in parts), whole.tally.witnesses.__class__()) == (
        whole.tally.witnesses
    )
    assert all(part.missing_witnesses == () for part in parts)


@pytest.mark.slowest
def test_one_wrong_schedule_of_many_is_found(wrong):
    report = check(wrong("one_schedule"), schedules="all", edges=2, max_findings=100)
    assert {finding.choices for finding in report.findings} == {(1, 0)}
    assert all(finding.world.first.degree == 2 for finding in report.findings)
    assert check(wrong("one_schedule"), edges=2).verdict is Verdict.HOLDS
    # Both loops with one edge, and with two edges every run in which it begins at degree 2
    # and the answer 'one edge' is wrong, which is all of them.
    # Of each map the smallest is reported.
    begins = [world.map for world in worlds(edges=2) if world.first.degree == 2]
    codes = {min(rooted_code(m.sigma, m.alpha, dart) for dart in m.darts) for m in begins}
    assert len(report.findings) == len(codes)


@pytest.mark.parametrize("broken", ["drop", "duplicate"])
@pytest.mark.parametrize("victim", [0, 50])
def test_the_gate_notices_a_broken_enumerator(explorers, monkeypatch, broken, victim):
    def tampered(*arguments):
        for map_ in rooted_maps(*arguments):
            if map_ != target or broken == "duplicate":
                yield map_
            if map_ == target and broken == "duplicate":
                yield map_

    target = list(rooted_maps(3))[victim]
    monkeypatch.setattr("allworlds.engines.units.rooted_maps", tampered)
    report = check(explorers("right"), edges=4)
    assert (report.verdict, report.exit_code, report.levels) == (Verdict.ERROR, 70, (1, 2, 3))
    assert "as the gate says" in report.ending.reason
    wrong_cells = [cell for cell in report.cells if not cell.agrees]
    assert [(cell.edges, cell.vertices) for cell in wrong_cells] == [(3, target.vertex_count)]


@pytest.mark.slowest
@pytest.mark.parametrize("workers", [1, 2])
def test_the_time_limit_leaves_unfinished_levels_out(workers):
    report = check(edges=9, time_limit=2, workers=workers)
    assert (report.verdict, report.exit_code) == (Verdict.INCONCLUSIVE, 3)
    assert "2 s" in report.ending.reason
    assert [*report.levels] == list(range(1, len(report.levels) + 1))
    assert {row.edges for row in report.rows} == set(report.levels)
    assert report.worlds == sum((2, 10, 74, 706, 8162)[: len(report.levels)])
    assert report.to_json()["scope"]["complete"] is False


def wrong_at_leaves_and_interrupted(play):
    """The user interrupts that play; whether leaves were met before is up to the order of units."""
    plays = itertools.count()

    def explore(first):
        if next(plays) == play:
            raise KeyboardInterrupt
        if first.degree == 1:
            raise ZeroDivisionError
        return (yield from algorithm1(first))

    return explore


@pytest.mark.slowest
def test_a_finding_of_an_unfinished_level_is_not_called_minimal():
    levels = set()
    for play in range(120, 600, 20):
        report = check(wrong_at_leaves_and_interrupted(play), edges=3, max_findings=6)
        assert (report.exit_code, report.complete, report.levels) == (130, False, (1, 2))
        for found in report.findings:
            assert found.minimal == (found.key[0] in report.levels)
            levels.add(found.key[0])
    assert levels == {1, 2, 3}


@pytest.mark.parametrize("vertices", [slowest(5)])
def test_vertices_alone_bound_the_simple_classes(vertices):
    quick.test_vertices_alone_bound_the_simple_classes(vertices)


@pytest.mark.slowest
@pytest.mark.processes
@pytest.mark.parametrize("edges", [4])
def test_one_worker_and_three_say_the_same_of_algorithm_1(edges):
    quick.test_one_worker_and_three_say_the_same_of_algorithm_1(edges)
