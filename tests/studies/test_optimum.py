"""Minimax: the best that any explorer can do, and the strategy that does it."""

from functools import cache
from itertools import product

import pytest
from allworlds.studies.optimum import OptimumReport, OptimumRow, minimax, optimum_table
from allworlds.studies.optimum.bracket import Bracket
from allworlds.studies.optimum.in_every_world import most_expensive
from allworlds.studies.optimum.minimax_of_worlds import Solved
from allworlds.studies.optimum.strategy import Branch, Strategy, StrategyLeaf, StrategyStep

import allworlds
from allworlds.document import replace
from allworlds.engines import TimeIsUp
from allworlds.inputs import InputError
from allworlds.maps import rooted_code
from allworlds.outcome import COMPLETED, Exit, Interrupted
from allworlds.protocol import Estimate, Move, Percept
from allworlds.reports import text
from allworlds.world import Directional, World
from small import EDGE, LOOP, all_maps, long, slow


def worlds(edges):
    return [
        World(map_, place)
        for map_ in all_maps(edges)
        if map_.edge_count == edges
        for place in Directional.places(map_, 0)
    ]


def given(worlds):
    return [(world.map, world.start, world.lighthouse.dart) for world in worlds]


# Found by an independent program, too.
@pytest.mark.parametrize(("edges", "best"), [(1, 0), (2, 1), (3, 4), slow(4, 9)])
def test_the_optimum_over_all_worlds_is_that_of_its_strategy(edges, best):
    found = minimax(given(worlds(edges)))
    assert found.at_least == best
    assert most_expensive(found.strategy, worlds(edges)) == best


def brute_force(group, most):
    """Whether so many traversals are enough, by trying every strategy in worlds as they are."""
    codes = {rooted_code(world.map.sigma, world.map.alpha, state.dart) for world, state in group}
    if len(codes) == 1:
        return True
    if most == 0:
        return False
    degree = group[0][0].sensed(group[0][1]).degree
    for k in range(degree):
        parts = {}
        for world, state in group:
            after, percept = world.step(state, Move(k))
            parts.setdefault(percept, []).append((world, after))
        if all(brute_force(part, most - 1) for part in parts.values()):
            return True
    return False


@pytest.mark.parametrize(("edges", "best"), [(1, 0), (2, 1), (3, 4)])
def test_a_search_without_any_memory_finds_the_same(edges, best):
    starts = {}
    for world in worlds(edges):
        starts.setdefault(world.first, []).append((world, world.initial))
    assert all(brute_force(group, best) for group in starts.values())
    assert best == 0 or not all(brute_force(group, best - 1) for group in starts.values())


@cache
def best_for_three():
    return minimax(given(worlds(3))).strategy


def test_every_spoilt_strategy_is_noticed():
    strategy = best_for_three()
    first = next(i for i, node in enumerate(strategy.nodes) if isinstance(node, StrategyStep))
    leaf = next(i for i, node in enumerate(strategy.nodes) if isinstance(node, StrategyLeaf))
    step = strategy.nodes[first]
    answer = strategy.nodes[leaf].answer
    mirrored = Estimate(answer.map.mirrored(), answer.map.sigma[answer.here])
    spoilt = [
        (first, replace(step, then=step.then[1:])),
        (first, replace(step, then=tuple(replace(one, node=first) for one in step.then))),
        (leaf, StrategyLeaf(answer=Estimate(LOOP, 0))),
        (leaf, StrategyLeaf(answer=mirrored)),
    ]
    for number, node in spoilt:
        nodes = [*strategy.nodes]
        nodes[number] = node
        assert most_expensive(replace(strategy, nodes=tuple(nodes)), worlds(3)) is None
    assert most_expensive(replace(strategy, start=()), worlds(3)) is None


def test_a_strategy_for_fewer_worlds_is_none_for_more():
    found = minimax([(EDGE, 0, 0)])
    assert found == Solved(0, 0, found.strategy, 0)
    assert most_expensive(found.strategy, [World(EDGE, Directional(0))]) == 0
    assert most_expensive(found.strategy, worlds(1)) is None


def test_what_is_known_of_the_bearing_does_not_matter_but_the_place_does():
    for edges in (1, 2):
        strategy = minimax(given(worlds(edges))).strategy
        answers = [node.answer for node in strategy.nodes if isinstance(node, StrategyLeaf)]
        assert all(answer.here in answer.map.darts for answer in answers)


def test_relabelling_the_worlds_changes_nothing():
    shifted = [
        (world.map.relabelled(names), names[world.start], names[world.lighthouse.dart])
        for world in worlds(2)
        for names in [[(dart + 1) % 4 for dart in world.map.darts]]
    ]
    assert minimax(shifted).strategy == minimax(given(worlds(2))).strategy


@pytest.mark.parametrize("edges", [2, long(4)])
def test_the_table_has_every_directional_explorer_and_none_is_better(edges):
    report = allworlds.optimum(edges=edges)
    assert [row.optimum for row in report.rows] == [0, 1, 4, 9][:edges]
    for row, most in zip(report.rows, [1, 4, 11, 22], strict=False):
        assert row.explorers["algorithm1"] == most
        assert {"remembering", "greedy", "folding"} < set(row.explorers)
        assert all(cost >= row.optimum for cost in row.explorers.values())
    assert report.exit_code == Exit.ANSWERED
    told = text("optimum", report, 100)
    assert "followed in every world" in told


def test_where_the_time_is_up_there_is_a_lower_bound(monkeypatch):
    monkeypatch.setattr(optimum_table, "_in_time", lambda every, _: every)
    report = allworlds.optimum(edges=2, time_limit=1e-9)
    last = report.rows[-1]
    assert (last.optimum, last.replayed, last.at_least, last.at_most) == (None, None, 1, None)
    assert report.exit_code == Exit.INCONCLUSIVE
    assert "1 or more" in text("optimum", report, 100)


@pytest.mark.timeout(60)
def test_the_time_limit_ends_a_level_that_takes_hours_and_keeps_the_others():
    report = allworlds.optimum(edges=6, time_limit=1)
    assert report.exit_code == Exit.INCONCLUSIVE
    assert len(report.rows) < 6
    assert [row.optimum for row in report.rows[:-1]] == [0, 1, 4, 9][: len(report.rows[:-1])]


def test_a_row_leaves_out_explorers_for_which_there_was_no_time(monkeypatch):
    checked = optimum_table.check

    def late(name, **more):
        if name == "greedy" and more["edges"] == 2:
            more["time_limit"] = 1e-9
        return checked(name, **more)

    monkeypatch.setattr(optimum_table, "check", late)
    monkeypatch.setattr(optimum_table, "_KNOWN", {})
    report = allworlds.optimum(edges=3, time_limit=1000)
    first, last = report.rows
    assert "greedy" in first.explorers
    assert [*last.explorers] == [*first.explorers][: [*first.explorers].index("greedy")]
    assert (last.optimum, report.exit_code) == (1, Exit.INCONCLUSIVE)
    assert [*text("optimum", report, 100).splitlines()[5].split()][-1] == "-"


@pytest.mark.parametrize(("replayed", "seen"), [(None, "wrong in some world"), (7, "costs 7")])
def test_a_replay_that_disagrees_is_an_error(replayed, seen):
    leaf = StrategyLeaf(answer=Estimate(EDGE, 0))
    strategy = Strategy(start=(Branch(percept=Percept(1), node=0),), nodes=(leaf,))
    row = OptimumRow(
        edges=1,
        runs=3,
        at_least=0,
        at_most=0,
        replayed=replayed,
        states=0,
        explorers={"algorithm1": 1},
        strategy=strategy,
    )
    report = OptimumReport(ending=COMPLETED, rows=(row,))
    assert report.exit_code == Exit.DISAGREES
    assert seen in text("optimum", report, 100)


def bouquet_rows(to, **more):
    return allworlds.optimum(family="bouquet", to=to, **more).rows


def test_the_table_of_bouquets_has_the_optimum_between_two_known_bounds():
    rows = bouquet_rows(4)
    assert [(row.loops, row.edges, row.runs) for row in rows] == [
        (1, 2, 1),
        (2, 3, 3),
        (3, 4, 15),
        (4, 5, 105),
    ]
    # Of information: Coq, bouquet_lower_bound; c(2c+1): theory.md, Theorem 3.
    assert [row.information for row in rows] == [0, 4, 9, 14]
    assert [row.optimum for row in rows] == [0, 4, 9, 16]
    assert [row.cautious for row in rows] == [3, 10, 21, 36]
    assert all(row.replayed == row.at_most for row in rows)


def test_of_bouquets_the_text_has_both_bounds_where_the_time_is_up(monkeypatch):
    def close(made, tick):
        turns = made._from_above()
        while made.at_most is None:
            next(turns, None)
        raise TimeIsUp

    monkeypatch.setattr(Bracket, "close", close)
    report = allworlds.optimum(family="bouquet", to=4, time_limit=1000)
    last = report.rows[-1]
    assert last.at_least < 16 <= last.at_most == last.replayed
    assert report.exit_code == Exit.INCONCLUSIVE
    told = text("optimum", report, 100)
    assert f"{last.at_least} to {last.at_most} traversals, with 4" in told


def test_a_run_directory_keeps_finished_rows_of_bouquets(tmp_path):
    first = bouquet_rows(3, run=tmp_path / "kept")
    assert bouquet_rows(3, run=tmp_path / "kept") == first
    with pytest.raises(InputError):
        allworlds.optimum(edges=3, run=tmp_path / "kept")


def test_an_interrupt_keeps_the_rows():
    report = OptimumReport(ending=Interrupted(), rows=())
    assert report.exit_code == Exit.INTERRUPTED
    assert text("optimum", report, 100)


def test_the_document_has_a_node_for_every_branch():
    for row in allworlds.optimum(edges=2).to_json()["rows"]:
        nodes = row["strategy"]["nodes"]
        branches = [row["strategy"]["start"], *(node.get("then", []) for node in nodes)]
        reached = {branch["node"] for branch in [b for some in branches for b in some]}
        assert reached == set(range(len(nodes)))
        assert all(("move" in node) != ("answer" in node) for node in nodes)


def test_no_two_explorations_of_one_percept_are_mixed_up():
    for one, other in product(worlds(1), repeat=2):
        solved = minimax(given([one, other]))
        assert most_expensive(solved.strategy, [one, other]) == solved.at_least == 0
