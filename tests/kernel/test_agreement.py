"""Three engines: worlds decided on the way, worlds finished first, and the Python engine."""

import json
import os
import subprocess
import sys
from pathlib import Path
from random import Random

import pytest

import allworlds
from allworlds import check
from allworlds.checker.compiled import (
    AGREEMENT_EDGES,
    compare_engines,
    level_tables,
    listed_costs,
)
from allworlds.findings import Rules
from allworlds.kernel import engine
from allworlds.maps.canonical import rooted_code
from allworlds.maps.classes import MapClass
from allworlds.maps.counting import rooted_maps as counted
from allworlds.maps.enumeration import Gluing, prefixes, rooted_maps
from allworlds.runs import Examiner
from allworlds.subjects import load
from allworlds.world import Directional, World

pytestmark = pytest.mark.usefixtures("compiled")

POLICIES = ["fifo", "lifo", "nearest"]


def python_costs(policy, edges):
    rules = Rules(policy=policy)
    examiner = Examiner(load("algorithm1"), rules)
    for map_ in rooted_maps(edges):
        outcome = examiner.examine(World(map_, Directional(0), 0), rules.choices(""))
        assert outcome.violation is None
        yield rooted_code(map_.sigma, map_.alpha, 0), outcome.cost


def codes(rules, edges, mode):
    """{canonical code: cost} for every world of a level."""
    listed = listed_costs(rules, edges, mode)
    return {rooted_code(map_.sigma, map_.alpha, 0): cost for map_, cost in listed}


def level(edges, policy="fifo", mode="walk", limit=None):
    """{vertices: (worlds, traversals, largest, per walk, per world)}, summed over the units."""
    tables = level_tables(Rules(policy=policy), edges)
    total = {}
    for prefix in prefixes(edges, vertices=limit, depth=2):
        rows = engine.examine(edges, limit or edges + 1, policy, prefix, tables, mode=mode)
        assert not rows.broken
        for new in rows.counts:
            old = total.setdefault(new.vertices, [0, 0, 0, {}, {}])
            old[0] += new.worlds
            old[1] += new.traversals
            old[2] = max(old[2], new.largest)
            for kept, added in ((old[3], new.per_walk), (old[4], new.per_world)):
                for event, count in added.items():
                    kept[event] = kept.get(event, 0) + count
    return total


@pytest.mark.parametrize("policy", POLICIES)
@pytest.mark.parametrize("edges", [1, 2, 3, 4, 5])
def test_all_three_engines_agree_world_by_world(edges, policy):
    rules = Rules(policy=policy)
    walked = codes(rules, edges, "walk")
    assert walked == codes(rules, edges, "thorough")
    if (edges, policy) != (5, "fifo"):
        # There the Python engine does it on every bearing; see below.
        assert walked == dict(python_costs(policy, edges))


@pytest.mark.parametrize("policy", POLICIES)
def test_both_modes_agree_in_every_number_of_a_level(policy):
    assert level(6, policy, "walk") == level(6, policy, "thorough")


def test_totals_are_those_of_independent_programs():
    # The sums of four other programs in C, Python and SPIN, first in, first out.
    expected = {2: 25, 3: 344, 4: 5184, 5: 86061, 6: 1569850, 7: 31356255}
    for edges, traversals in expected.items():
        rows = level(edges)
        assert sum(row[1] for row in rows.values()) == traversals
        assert {n: row[0] for n, row in rows.items()} == counted(edges)


def test_the_premise_holds_on_every_bearing():
    # Raises where a cost differs; up to m = 4 each check with the kernel does this itself.
    compare_engines("fifo", AGREEMENT_EDGES + 1)


@pytest.mark.parametrize("policy", POLICIES)
def test_both_engines_give_the_same_report(policy):
    reports = [
        check(edges=4, policy=policy, engine=name, workers=2).to_json()
        for name in ("python", "kernel")
    ]
    assert [report.pop("engine") for report in reports] == ["python", "kernel"]
    symmetries = [report["scope"].pop("symmetry") for report in reports]
    assert symmetries[0] is None
    assert "bearing" in symmetries[1]
    assert reports[0] == reports[1]


@pytest.mark.parametrize("bound", ["m * n", "n - m - 3", "0 - 10**30"])
@pytest.mark.parametrize("keep", [1, 4])
def test_both_engines_report_the_same_least_findings(keep, bound):
    # Extent that Algorithm 1 does not keep: the least worlds where it walks more.
    reports = [
        check(edges=4, bound=bound, max_findings=keep, engine=name).to_json()
        for name in ("python", "kernel")
    ]
    assert reports[0]["exit_code"] == reports[1]["exit_code"] == 1
    assert len(reports[0]["findings"]) == keep
    assert reports[0]["findings"] == reports[1]["findings"]
    assert reports[0]["rows"] == reports[1]["rows"]


def test_a_limit_of_vertices_leaves_the_other_worlds_as_they_are():
    whole = level(5)
    for limit in range(1, 6):
        assert level(5, limit=limit) == {n: row for n, row in whole.items() if n <= limit}
        assert level(5, limit=limit, mode="thorough") == level(5, limit=limit)


def test_shards_add_up_to_the_whole():
    whole = check(edges=6, engine="kernel")
    parts = [check(edges=6, engine="kernel", shard=(k, 3), workers=2) for k in range(3)]
    assert sum(part.worlds for part in parts) == whole.worlds
    assert sum(part.tally.traversals for part in parts) == whole.tally.traversals
    assert sum((part.tally.witnesses for part in parts), start=type(whole.tally.witnesses)()) == (
        whole.tally.witnesses
    )


INTERPRETED = """
import json
from allworlds.kernel import schedules, walk
from allworlds.kernel.engine import by_vertices_and_faces, examine, flag
from allworlds.kernel.tables import tables
print(json.dumps([
    hasattr(walk.explore, "py_func"),
    [
        sum(c.traversals for d in range(1, 7)
            for c in examine(3, 4, policy, (-d,), tables(3, 500), mode=mode).counts)
        for policy in ("fifo", "lifo", "nearest") for mode in ("walk", "thorough")
    ],
    sum(sum(by_vertices_and_faces(3, 4, (-d,)).values()) for d in range(1, 7)),
    max(row.worst for d in range(1, 7)
        for row in schedules.dearest_of_unit(3, 4, (-d,), "simple", flag())),
]))
"""


def test_interpreted_where_each_index_is_checked_the_engines_say_the_same():
    source = str(Path(allworlds.__file__).parent.parent)
    paths = [source, *filter(None, [os.environ.get("PYTHONPATH")])]
    environment = {
        **os.environ,
        "NUMBA_DISABLE_JIT": "1",
        "PYTHONPATH": os.pathsep.join(paths),
    }
    done = subprocess.run(
        [sys.executable, "-c", INTERPRETED],
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    compiled, sums, maps, worst = json.loads(done.stdout)
    assert not compiled
    expected = [sum(row[1] for row in level(3, policy).values()) for policy in POLICIES]
    assert sums == [cost for cost in expected for _ in range(2)]
    # 74 rooted maps with 3 edges: OEIS A000698.
    assert maps == 74
    assert worst == 11


@pytest.mark.parametrize("policy", POLICIES)
def test_both_modes_agree_on_random_pieces_of_the_largest_levels(policy):
    # The packed numbers of the walk are fullest there.
    random = Random(policy)
    for edges in (9, 10, 11, 12):
        tables = level_tables(Rules(policy=policy), edges)
        for _ in range(20):
            gluing, prefix = Gluing(edges, MapClass.MAPS), []
            while sum(map(len, gluing.faces)) + gluing.owed > 6 or not prefix:
                # Small degrees are rare in a uniform choice, and make many vertices.
                ways = [(d, g) for d, g in gluing.successors() if d > -5 or not prefix]
                decision, gluing = random.choice(ways or list(gluing.successors()))
                prefix.append(decision)
            walked, thorough = (
                engine.examine(edges, edges + 1, policy, prefix, tables, mode=mode)
                for mode in ("walk", "thorough")
            )
            assert walked == thorough
            assert walked.counts
            assert not walked.broken
