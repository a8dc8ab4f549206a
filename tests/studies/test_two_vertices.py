"""The explorers without a direction, as a whole: checked, refuted, replayed and explained."""

import json
from functools import partial
from pathlib import Path

import pytest

from allworlds.explorers.builtin.algorithm1 import Algorithm1, TwoVertices
from allworlds.inputs.checks import InputError
from allworlds.judging.belief import believed_percepts
from allworlds.judging.findings.finding import Finding
from allworlds.judging.walk import Walk
from allworlds.maps import from_cycles, named_map
from allworlds.outcome import Verdict
from allworlds.protocol.actions import Move, Percept
from allworlds.reports.formats import text as text_of
from allworlds.studies.check import exhaustive as checker
from allworlds.studies.explain import explain
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.run import replay, run
from allworlds.world import Cluster, Natural, World, worlds

pytestmark = pytest.mark.usefixtures("no_orphans", "without_workers")
check = partial(checker.check, max_findings=1)

CLUSTER, NATURAL = "algorithm1-cluster", "algorithm1-natural"
LAWS = ["map", "pose", "invariant-1", "invariant-2", "variant", "bound"]


def links(map_):
    """How many darts of the root's vertex lead elsewhere, and to how many vertices by one edge."""
    v0 = map_.vertex_of[0]
    ends = [map_.vertex_of[map_.alpha[d]] for d in map_.vertices[v0]]
    away = [v for v in ends if v != v0]
    return len(away), sum(away.count(v) == 1 for v in away)


@pytest.mark.parametrize(("edges", "all_worlds"), [(3, 86)])
@pytest.mark.parametrize("policy", ["fifo", "lifo", "nearest", "random:1"])
def test_the_cluster_explorer_holds_where_one_edge_joins_v0_and_v1(policy, edges, all_worlds):
    report = check(CLUSTER, edges=edges, policy=policy)
    assert (report.verdict, report.exit_code, report.missing_witnesses) == (Verdict.HOLDS, 0, ())
    counted = [links(world.map)[1] for world in worlds(edges=edges)]
    assert report.worlds == len(counted) == all_worlds
    assert report.runs == sum(counted)
    assert report.tally.left_out == counted.count(0) > 0
    scope = report.to_json()["scope"]
    assert (scope["lighthouse"], scope["bound"]) == ("cluster:single=true", "two-vertices")
    assert scope["laws"] == LAWS
    assert all(row.max_cost <= row.bound for row in report.rows if row.runs)


@pytest.mark.parametrize(
    ("explorer", "options"), [(CLUSTER, {"lighthouse": "cluster"}), (NATURAL, {})]
)
def test_with_two_edges_between_v0_and_v1_the_smallest_finding_has_three(explorer, options):
    report = check(explorer, edges=3, **options)
    assert (report.verdict, report.exit_code) == (Verdict.REFUTED, 1)
    (finding,) = report.findings
    map_ = finding.world.map
    assert (map_.vertex_count, map_.edge_count, finding.minimal) == (2, 3, True)
    assert links(map_) == (2, 0)
    assert finding.confirmed
    assert (finding.rules.the_bound.name, finding.rules.bound) == ("two-vertices", None)


def test_a_finding_is_a_value_that_replays_and_can_be_explained(tmp_path):
    (finding,) = check(NATURAL, edges=3).findings
    again = Finding.from_json(json.dumps(finding.to_json()))
    assert again.to_json() == finding.to_json()
    assert again.place == finding.place
    replayed = replay(again)
    assert replayed.outcome == "reproduced"
    assert replayed.again.outcome.episode.transcript == finding.transcript
    assert str(finding.rules.budget(finding.world.map)) in str(again.expected)
    wrong, how = explain(again).sentences[:2]
    assert "is already wrong" in wrong
    assert "did not end within its step budget" in how
    assert "told before the start: 2" in text_of(replayed.again, 100)
    # The corpus of a user keeps it, and tries it first.
    first = check(NATURAL, edges=3, corpus=Path(tmp_path))
    second = check(NATURAL, edges=3, corpus=Path(tmp_path))
    assert len(first.corpus.written) == len(second.corpus.reproduced) == 1


def test_a_run_by_itself_is_that_of_the_check_though_an_option_leaves_places_out():
    alone = [
        run(CLUSTER, world, policy="random:7").outcome.cost
        for world in worlds(edges=3, lighthouse="cluster:single=true", places="all")
    ]
    report = check(CLUSTER, edges=3, policy="random:7")
    assert (report.runs, report.tally.traversals) == (len(alone), sum(alone))


def test_a_world_needs_no_option_to_be_run():
    world = World(from_cycles(["abb", "a"]), Cluster(0))
    told = run(CLUSTER, world)
    # By hand: see the test of the explorer.
    assert (told.outcome.cost, told.outcome.bound, told.finding) == (7, 21, None)
    assert told.options.bound == "two-vertices"


def test_the_explorers_own_bound_holds_under_its_own_kind_of_lighthouse_only():
    edge = World(named_map("edge"), Cluster(0))
    assert run(CLUSTER, edge).rules.the_bound.name == "two-vertices"
    assert run(CLUSTER, edge, bound="paper").finding.law == "bound"  # 3 traversals, (1)+(2) = 1
    assert run(CLUSTER, edge, bound="none").outcome.bound is None
    assert run(CLUSTER, edge, laws=["map"]).outcome.bound is None
    assert run("algorithm1", edge).rules.the_bound.name == "none"
    report = check(CLUSTER, edges=1, lighthouse="directional")
    assert report.to_json()["scope"]["bound"] == "paper"
    assert check(NATURAL, edges=1, lighthouse="none").to_json()["scope"]["bound"] == "none"


def test_the_law_folding_does_not_apply():
    with pytest.raises(
        InputError, match="'folding' is checked only under the directional lighthouse"
    ):
        check(CLUSTER, edges=2, laws=["folding"])


def test_a_sample_of_larger_worlds_does_not_refute_the_cluster_explorer():
    report = fuzz(CLUSTER, edges=14, runs=60)
    assert report.verdict is Verdict.NOT_REFUTED
    assert report.to_json()["scope"]["lighthouse"] == "cluster:single=true"
    assert report.runs + report.tally.left_out == report.worlds == 60
    assert 0 < report.tally.left_out < 60


def foreign(first, *, told):
    """Wrong everywhere, with what it was told in its last breath."""
    raise ValueError(f"told {told} at degree {first.degree}")
    yield


def test_a_foreign_explorer_is_told_the_degree_too():
    world = World(from_cycles(["abb", "a"]), Natural(0))
    assert run(foreign, world).finding.seen == "ValueError: told 1 at degree 3"
    assert run(foreign, World(world.map, Cluster(0))).finding.seen.startswith("ValueError: told No")


def test_what_was_left_out_is_shown():
    text = text_of(check(CLUSTER, edges=2), 100)
    assert "left out   5 worlds of 12: no place for the lighthouse" in text
    assert "of the lighthouse 'cluster:single=true' in every map" in text
    assert "bound (two-vertices)" in text


def test_a_cluster_is_drawn_with_its_markers():
    text = text_of(run(CLUSTER, World(from_cycles(["abb", "a"]), Cluster(0))), 100)
    assert "v0 ●" in text
    assert "v1 ●2" in text


# ---------------------------------------------------------------- beside the right one, wrong ones


class NoQuery(TwoVertices):
    """Takes any dart of v0 for the one it came by."""

    try_path = Algorithm1.try_path
    confirmed_at = Algorithm1.confirmed_at


class NoSearch(TwoVertices):
    """Takes the dart that it faces at the start for the one that leads to v1."""

    def search(self):
        yield from ()


class QueryNotUndone(TwoVertices):
    """Forgets how it is turned after a query that has failed."""

    def retrace(self, motions):
        self.turned = 0
        yield from super().retrace(motions)


class TwoMarksSuffice(TwoVertices):
    """Confirms a test when it has come to v0, but looks along any dart."""

    def try_path(self, partner, path):
        motions, matched = yield from Algorithm1.try_path(self, partner, path)
        if matched:
            yield Move(0)
            yield Move(0)
        return motions, matched

    confirmed_at = Algorithm1.confirmed_at


# ---------------------------------------------------------------- in a wrong answer


def believed(world, answer):
    (percept,) = believed_percepts(Walk.begin(world), answer, [0])
    return percept


def test_a_wrong_answer_has_the_lighthouse_where_the_truth_has_it():
    # v0 with a loop a and an edge b; in the answer it is the other way round.
    world, answer = (
        World(from_cycles(c), Cluster(d)) for c, d in ((["aab", "b"], 2), (["baa", "b"], 0))
    )
    assert believed(world, world.map) == world.first == Percept(3, 1)
    # There the dart leads back to v0, which is v0 then.
    assert believed(world, answer.map) == Percept(3, 1)
    assert believed(World(world.map, Natural(2)), answer.map) == Percept(3)
    # A place is not asked for: degrees need not be unique in the answer.
    assert believed(World(world.map, Natural(2)), named_map("edge")) == Percept(1)
