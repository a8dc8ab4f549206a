"""The purposes of traversals, on walks that can be counted by hand."""

import pytest

from allworlds.judging.explanations.story import Spending
from allworlds.reports.plain_text import LONGEST, cost_lines, cost_picture
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
    lines = [line.split() for line in cost_lines(spent, 100)[1:]]
    bars = {" ".join(line[:-2]): (int(line[-2]), len(line[-1])) for line in lines}
    assert bars == {"edge 1": (1, 8), "edge 2": (2, 16), "all": (5, 40), "bound": (3, 24)}
    assert max(map(len, cost_lines(spent, 40))) <= 40


def test_of_many_edges_the_first_and_the_last_are_told():
    lines = cost_lines(Spending(tuple(range(1, 41)), 0, 40, 30), 100)[1:]
    assert len(lines) == LONGEST + 2
    assert lines[0].split()[:3] == ["edge", "1", "1"]
    assert lines[LONGEST - 1].split()[:3] == ["edge", "40", "40"]


def test_the_picture_ends_at_the_cost_and_has_the_bound(spent):
    drawn = cost_picture(spent, "curve")
    (line,) = (path.get("d") for path in drawn.iter("path") if path.get("class") == "cost-line")
    (bound,) = (path.get("d") for path in drawn.iter("path") if path.get("class") == "cost-bound")
    assert line.endswith("H468.0")
    assert line.count("V") == 2
    assert bound.startswith("M300.0 ")
    assert "2 edges found in 5 traversals; the bound is 3." in "".join(drawn.itertext())


def test_a_bound_below_zero_is_drawn_at_zero():
    drawn = cost_picture(Spending((), 0, 0, -3), "curve")
    (bound,) = (path.get("d") for path in drawn.iter("path") if path.get("class") == "cost-bound")
    assert bound.startswith("M48.0 ")
    assert cost_lines(Spending((), 0, 0, -3), 80)
