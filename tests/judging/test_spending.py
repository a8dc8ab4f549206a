"""The purposes of traversals, on walks that can be counted by hand."""

import pytest

from allworlds.judging.explanations.story import Spending
from allworlds.reports.content.single_run import LONGEST_BARS, _bars
from allworlds.reports.plain_text import bar_lines
from allworlds.studies.explain import explain
from allworlds.studies.run import run
from allworlds.world import Directional, World
from small import PATH


@pytest.fixture
def spent(answering):
    """Along a path to its end, back, and out again."""
    explore = answering(PATH, 1, 0, 1, 0, 1, 0)
    return explain(run(explore, World(PATH, Directional(0)), bound="3").finding).spent


def test_an_edge_is_found_by_the_traversal_that_first_goes_along_it(spent):
    assert spent == Spending(found=(1, 2), back=2, cost=5, bound=3)


def test_no_cost_is_told_of_laws_that_are_not_about_it(told, finding_of):
    assert explain(finding_of("pose-lost")).spent is None
    assert explain(finding_of("walks-too-much")).spent.cost == 3


def test_bars_are_as_long_as_the_numbers(spent):
    lines = [line.split() for line in bar_lines(_bars(spent), 100)[1:]]
    shown = {" ".join(line[:-2]): (int(line[-2]), len(line[-1])) for line in lines}
    assert shown == {"edge 1": (1, 8), "edge 2": (2, 16), "all": (5, 40), "bound": (3, 24)}
    assert [line[-1][0] for line in lines] == ["█", "█", "█", "░"]
    assert max(map(len, bar_lines(_bars(spent), 40))) <= 40


def test_of_many_edges_not_each_has_a_bar():
    entries = _bars(Spending(tuple(range(1, 41)), 0, 40, 30)).entries
    assert [name for name, _ in entries[:3]] == ["edge 1", "edge 5", "edge 9"]
    assert LONGEST_BARS - 2 <= len(entries) <= LONGEST_BARS + 2


def test_a_bound_below_zero_has_no_bar():
    assert bar_lines(_bars(Spending((), 0, 0, -3)), 80)[-1].split() == ["bound", "-3"]
