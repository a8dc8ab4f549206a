"""The most expensive run of each size is the least of those that cost most, in every engine."""

from allworlds.engines.tally import AtRun, Row
from allworlds.explorers.loading import load
from allworlds.judging.referee import Examiner
from allworlds.judging.rules import Rules
from allworlds.maps import rooted_code, rooted_maps
from allworlds.studies.check.exhaustive import check
from allworlds.studies.check.report import most_expensive_runs
from allworlds.world import World


def most_expensive(report):
    """By size the cost, the map and the place; the choices are told by the python engine alone."""
    return {
        size: (row.max_cost, row.most_expensive and row.most_expensive[:3])
        for size, row in report.tally.rows.items()
    }


def test_it_is_the_least_of_all_that_cost_most():
    report, examiner = check(edges=3), Examiner(load("algorithm1"), Rules())
    found = {}
    for edges in (1, 2, 3):
        for map_ in rooted_maps(edges):
            for place, lighthouse in enumerate(Rules().kind.places(map_, 0)):
                cost = examiner.examine(World(map_, lighthouse, 0), Rules().choices("")).cost
                at = (-cost, *rooted_code(map_.sigma, map_.alpha, 0), place)
                size = edges, map_.vertex_count
                found[size] = min(found.get(size, at), at)
    assert most_expensive(report) == {
        size: (-cost, (sigma, alpha, place)) for size, (cost, sigma, alpha, place) in found.items()
    }


def test_rows_that_are_added_up_keep_the_least_of_the_most_expensive():
    few, first, second = (AtRun((0, 1), (1, 0), place, ()) for place in (0, 1, 2))
    for rows in ([(3, few), (4, second), (4, first)], [(4, first), (3, few), (4, second)]):
        total = Row()
        for cost, run in rows:
            total.add(Row(max_cost=cost, most_expensive=run))
        assert (total.max_cost, total.most_expensive) == (4, first)


def test_each_is_played_again_at_its_cost():
    report = check("folding", edges=3)
    played = [*most_expensive_runs(report)]
    rows = sorted(report.tally.rows.items())
    assert len(rows) == len(played) == 9
    for (_, row), run in zip(rows, played, strict=True):
        assert run.outcome.cost == row.max_cost
        assert (run.world.map.sigma, run.world.map.alpha) == row.most_expensive[:2]
