"""What compiled code can do, and in which checks one walk in a map counts for all bearings."""

import os
import sys
from functools import partial
from types import SimpleNamespace

import pytest

from allworlds.engines import engine_table
from allworlds.engines.engine_table import WALKED_FROM, obstacle, walks
from allworlds.engines.kernel import demand_driven
from allworlds.engines.kernel.engine import _walked_events
from allworlds.engines.units import Scope
from allworlds.explorers.loading import Subject
from allworlds.judging.laws.law_table import LAWS
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent

OURS, MINE = Subject("algorithm1", frozenset()), Subject("mine.py:explore", frozenset())


def scope_of(map_class=MapClass.MAPS, lighthouse="directional", **options):
    return Scope(Extent(map_class, WALKED_FROM), Rules(lighthouse, **options))


@pytest.mark.parametrize(
    ("bound", "named"), [("d", "d"), ("n*g", "g"), ("d+g+m", "d and g"), ("n+m+d0+D", None)]
)
def test_the_kernel_knows_no_diameter_and_no_genus(bound, named):
    said = f"does not know {named} of the bound '{bound}'" if named else ""
    assert obstacle(scope_of(bound=bound), OURS) == said


def test_users_explorers_need_memory_that_processes_share(monkeypatch):
    assert obstacle(scope_of(), MINE) == ""
    monkeypatch.delattr(os, "memfd_create")
    assert obstacle(scope_of(), MINE) == "judges users' explorers on Linux alone"
    assert obstacle(scope_of(), OURS) == ""


CHANGED = {
    "explorer": partial(walks, scope_of(), Subject("folding", frozenset())),
    "lighthouse": partial(walks, scope_of(lighthouse="position", bound="n+m"), OURS),
    "class": partial(walks, scope_of(MapClass.PLANAR), OURS),
    "laws": partial(walks, scope_of(laws=("map",)), OURS),
    "budget": partial(walks, scope_of(step_budget=1000), OURS),
    "bound": partial(walks, scope_of(bound="n+m+d0"), OURS),
}


@pytest.mark.parametrize("options", [{}, {"laws": LAWS}, {"bound": "n+m"}, {"bound": "7"}])
def test_one_walk_of_algorithm_1_in_a_large_map_counts_for_all_bearings(options):
    scope = scope_of(**options)
    assert walks(scope, OURS, WALKED_FROM)
    assert not walks(scope, OURS, WALKED_FROM - 1)


@pytest.mark.parametrize("name", CHANGED)
def test_where_anything_else_is_asked_for_every_run_is_played(name):
    assert not CHANGED[name](WALKED_FROM)


def test_the_symmetry_is_told_where_it_is_used(monkeypatch):
    module = "allworlds.engines.compiled_engine"
    monkeypatch.setitem(sys.modules, module, SimpleNamespace(SYMMETRY="by symmetry"))
    kernel = engine_table.ENGINES["kernel"]
    assert kernel.symmetry(scope_of(), OURS) == "by symmetry"
    assert kernel.symmetry(scope_of(step_budget=1000), OURS) == ""


def test_loops_and_other_edges_are_those_of_the_walks_that_have_not_failed():
    row = [0] * (demand_driven.LOOP_EDGE + 9)
    row[demand_driven.WORLDS], row[demand_driven.FAILURES] = 7, 2
    events = _walked_events([[0] * len(row), [0] * len(row), row], edges=3, places=4)
    # A map with 3 edges and 2 vertices: a spanning tree has one edge, so that 2 close a cycle.
    assert (events["loop"], events["non-loop"]) == (4 * 2 * 5, 4 * 1 * 5)
