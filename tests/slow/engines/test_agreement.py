"""The engines of the kernel against each other, and against the Python engine."""

import os
import subprocess
import sys
from collections import Counter
from random import Random

import pytest

from allworlds import check
from allworlds.documents.document import replace
from allworlds.engines import compiled_engine as agreement
from allworlds.engines.compiled_engine import AGREED, compare_engines, compared_to, level_of
from allworlds.engines.kernel.engine import judge, walk
from allworlds.engines.units import Scope
from allworlds.explorers.loading import load
from allworlds.judging.rules import RuleOptions, Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.counting import rooted_maps as counted
from allworlds.maps.enumeration import Gluing, prefixes

pytestmark = [pytest.mark.slowest, pytest.mark.usefixtures("compiled")]


@pytest.fixture(autouse=True)
def fresh_comparison():
    AGREED.clear()
    yield
    AGREED.clear()


POLICIES = ["fifo", "lifo", "nearest"]


ALGORITHM1 = load("algorithm1")


@pytest.mark.slowest
@pytest.mark.parametrize("policy", POLICIES)
def test_both_modes_agree_world_by_world(policy):
    for edges in (1, 2, 3, 4):
        for prefix in prefixes(edges, depth=2 * edges):
            assert walk(asked(edges, policy), prefix) == judge(asked(edges, policy), prefix)


@pytest.mark.slowest
@pytest.mark.parametrize("policy", POLICIES)
def test_both_modes_agree_in_every_number_of_a_level(policy):
    assert level(walk, 6, policy) == level(judge, 6, policy)


def test_totals_are_those_of_independent_programs():
    # The sums of four other programs in C, Python and SPIN, first in, first out.
    expected = {2: 25, 3: 344, 4: 5184, 5: 86061, 6: 1569850, 7: 31356255}
    for edges, traversals in expected.items():
        rows, _ = level(walk, edges)
        assert sum(row["rooted"] for row in rows.values()) == traversals
        assert {n: row["worlds"] for n, row in rows.items()} == counted(edges)


@pytest.mark.slowest
def test_the_premise_holds_on_every_bearing(monkeypatch):
    # Raises where anything differs; up to m = 4 each check with the kernel does this itself.
    monkeypatch.setattr(agreement, "AGREEMENT_EDGES", 5)
    compare_engines(Scope(Extent(MapClass.MAPS, 6), Rules()), ALGORITHM1)


DOOR = "allworlds.explorers.builtin.scanning:algorithm1_door"

SETTINGS = {
    "fifo": {"edges": 4},
    "lifo": {"edges": 4, "policy": "lifo"},
    "nearest": {"edges": 4, "policy": "nearest"},
    "simple": {"edges": 5, "map_class": "simple"},
    "planar": {"edges": 4, "map_class": "planar"},
    "planar-simple": {"edges": 5, "map_class": "planar-simple", "vertices": 4},
    "laws": {"edges": 3, "laws": ["map", "invariant-2"]},
    "budget": {"edges": 3, "step_budget": 12, "max_findings": 3},
    "bound": {"edges": 3, "bound": "n + D - d0", "max_findings": 3},
    "cluster": {"explore": "algorithm1-cluster", "edges": 3, "lighthouse": "cluster"},
    "single": {"explore": "algorithm1-cluster", "edges": 4},
    "single-simple": {"explore": "algorithm1-cluster", "edges": 6, "map_class": "simple"},
    "natural": {"explore": "algorithm1-natural", "edges": 4},
    "natural-simple": {"explore": "algorithm1-natural", "edges": 6, "map_class": "simple"},
    "no-direction": {"edges": 2, "lighthouse": "cluster", "max_findings": 3},
    "door": {"explore": DOOR, "edges": 3, "lighthouse": "door"},
    "no-door": {"explore": DOOR, "edges": 3, "lighthouse": "position", "max_findings": 3},
}


@pytest.mark.slowest
@pytest.mark.parametrize("options", SETTINGS.values(), ids=SETTINGS)
def test_both_engines_give_the_same_report(options):
    reports = [check(engine=name, workers=2, **options).to_json() for name in ("python", "kernel")]
    assert [report.pop("engine") for report in reports] == ["python", "kernel"]
    assert [report["scope"]["symmetry"] for report in reports] == [None, None]
    assert reports[0] == reports[1]


@pytest.mark.slowest
@pytest.mark.parametrize("explore", ["algorithm1-cluster", "algorithm1-natural"])
def test_lighthouses_at_two_vertices_are_compared_to_six_edges_in_simple_worlds(explore):
    # Under one of them the explorer is told the degree of v1; few small worlds have it.
    rules = RuleOptions().rules_of(load(explore), load(explore).lighthouse)
    scope = Scope(Extent(MapClass.SIMPLE, 7), rules)
    assert compared_to(scope) == 6
    assert compared_to(replace(scope, extent=Extent(MapClass.MAPS, 7))) == 4
    compare_engines(scope, load(explore))


@pytest.mark.slowest
def test_bearings_are_counted_together_from_six_edges_on_and_the_report_says_so():
    small, large = (check(edges=m, engine="kernel").to_json()["scope"] for m in (5, 6))
    assert small["symmetry"] is None
    assert "from m = 6 on" in large["symmetry"]


@pytest.mark.slowest
@pytest.mark.parametrize("bound", ["m * n", "n - m - 3", "0 - 10**30"])
@pytest.mark.parametrize("keep", [1, 4])
def test_both_engines_report_the_same_least_findings(keep, bound):
    # Bounds that Algorithm 1 does not keep: the least worlds where it walks more.
    reports = [
        check(edges=4, bound=bound, max_findings=keep, engine=name).to_json()
        for name in ("python", "kernel")
    ]
    assert reports[0]["exit_code"] == reports[1]["exit_code"] == 1
    assert len(reports[0]["findings"]) == keep
    assert reports[0]["findings"] == reports[1]["findings"]
    assert reports[0]["rows"] == reports[1]["rows"]


@pytest.mark.slowest
def test_shards_add_up_to_the_whole():
    whole = check(edges=6, engine="kernel")
    parts = [check(edges=6, engine="kernel", shard=(k, 3), workers=2) for k in range(3)]
    assert sum(part.worlds for part in parts) == whole.worlds
    assert sum(part.tally.traversals for part in parts) == whole.tally.traversals
    assert sum((part.tally.witnesses for part in parts), start=type(whole.tally.witnesses)()) == (
        whole.tally.witnesses
    )


WATCHED = """
from allworlds import check, count, worst
for policy, edges in (("fifo", 6), ("lifo", 5), ("nearest", 5)):
    assert check(edges=edges, policy=policy, engine="kernel").exit_code == 0
assert check("algorithm1-cluster", edges=4, map_class="planar", engine="kernel").exit_code == 0
assert check("algorithm1-natural", edges=4, map_class="simple", engine="kernel").exit_code == 0
# 1,708,394 rooted maps with 7 edges: OEIS A000698.
assert count(edges=7).rows[-1].rooted == 1708394
assert max(row.worst for row in worst(edges=3).rows) == 11
"""


@pytest.mark.slowest
def test_where_each_index_is_checked_the_engines_say_the_same(tmp_path):
    environment = {
        **os.environ,
        "NUMBA_BOUNDSCHECK": "1",
        "NUMBA_CACHE_DIR": str(tmp_path),
    }
    done = subprocess.run(
        [sys.executable, "-c", WATCHED],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("policy", POLICIES)
def test_both_modes_agree_on_random_pieces_of_the_largest_levels(policy):
    # The packed numbers of the walk are fullest there.
    random = Random(policy)
    for edges in (9, 10, 11, 12):
        for _ in range(20):
            gluing, prefix = Gluing(edges, MapClass.MAPS), []
            while sum(map(len, gluing.faces)) + gluing.owed > 6 or not prefix:
                # Small degrees are rare in a uniform choice, and make many vertices.
                ways = [(d, g) for d, g in gluing.successors() if d > -5 or not prefix]
                decision, gluing = random.choice(ways or list(gluing.successors()))
                prefix.append(decision)
            walked, judged = (does(asked(edges, policy), prefix) for does in (walk, judge))
            assert walked == judged
            assert walked.counts
            assert not walked.broken


def asked(edges, policy="fifo", limit=None):
    return level_of("algorithm1", Rules(policy=policy), Extent(MapClass.MAPS, edges, limit), edges)


def level(does, edges, policy="fifo", limit=None):
    """{vertices: worlds, runs, traversals, and so on}, and the events, summed over the units."""
    total, events = {}, Counter()
    for prefix in prefixes(edges, vertices=limit, depth=2):
        rows = does(asked(edges, policy, limit), prefix)
        assert not rows.broken
        events.update(rows.events)
        for row in rows.counts:
            total.setdefault(row.vertices, Counter()).update(
                {name: getattr(row, name) for name in ("worlds", "runs", "traversals", "loops")},
                rooted=row.traversals_rooted,
                parallels=row.parallels,
                checkpoints=row.checkpoints,
            )
            kept = total[row.vertices]
            kept["largest"] = max(kept["largest"], row.largest)
    return total, events


@pytest.mark.slowest
def test_a_limit_of_vertices_leaves_the_other_worlds_as_they_are():
    whole, _ = level(walk, 5)
    for limit in range(2, 6):
        walked = level(walk, 5, limit=limit)
        assert walked[0] == {n: row for n, row in whole.items() if n <= limit}
        assert level(judge, 5, limit=limit) == walked
