"""The exhaustive check as a whole: its numbers, its order, its verdicts."""

import importlib
import json
import os
from functools import cache, partial
from time import monotonic
from types import SimpleNamespace

import pytest
from msgspec.structs import force_setattr

from allworlds.documents.document import replace
from allworlds.engines.hash_seeds import GOES_BY_HASHES
from allworlds.engines.listeners import Listener
from allworlds.engines.tally import Tally
from allworlds.engines.units import Scope
from allworlds.inputs.checks import InputError
from allworlds.judging.rules import Rules
from allworlds.maps import CombinatorialMap, MapClass, rooted_code, rooted_maps
from allworlds.maps.classes import Extent
from allworlds.maps.counting import CountSource
from allworlds.outcome import Verdict
from allworlds.protocol.actions import Estimate
from allworlds.studies.check import exhaustive as checker
from allworlds.studies.check.report import CheckRequest, _remarks
from allworlds.studies.check.tally_sweep import Confirmation, is_inside
from allworlds.studies.run import run
from allworlds.words import size
from allworlds.world import Directional, World, worlds
from bruteforce import rooted_maps_by_permutations as every_rooted_map
from listeners import Hears

pytestmark = pytest.mark.usefixtures("no_orphans")
check = partial(checker.check, engine="python")


def document(report):
    return json.dumps(report.to_json())


def test_algorithm_1_holds_in_all_small_worlds():
    report = check(edges=4)
    # Rooted maps by edges: 2, 10, 74, 706 (A000698); runs: one for each bearing.
    assert (report.worlds, report.runs) == (792, 3684)
    assert (report.verdict, report.exit_code, report.complete) == (Verdict.HOLDS, 0, True)
    assert report.tally.left_out == 0
    by_edges = {}
    for row in report.rows:
        by_edges[row.edges] = by_edges.get(row.edges, 0) + row.worlds
        assert row.max_cost <= row.bound
        assert row.traversals_rooted <= row.traversals
    assert by_edges == {1: 2, 2: 10, 3: 74, 4: 706}
    assert all(cell.agrees and cell.source for cell in report.cells)


@pytest.mark.parametrize("vertices", [4])
def test_vertices_alone_bound_the_simple_classes(vertices):
    report = check(map_class="simple", vertices=vertices, workers=2)
    # Rooted simple maps on 2..5 vertices: 1, 3, 32, 3965; with a bearing: 1, 5, 79, 14239.
    rows = {n: [0, 0] for n in range(2, vertices + 1)}
    for row in report.rows:
        rows[row.vertices][0] += row.worlds
        rows[row.vertices][1] += row.runs
    counted = {2: [1, 1], 3: [3, 5], 4: [32, 79], 5: [3965, 14239]}
    assert rows == {n: counted[n] for n in rows}
    assert report.verdict is Verdict.HOLDS


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("edges", [4, 5])
def test_the_witnesses_of_algorithm_1_occur(edges):
    # Simple worlds with 4 edges know no mismatch of the direction under every policy.
    seen = check(edges=edges, map_class="simple", policy="lifo").tally.witnesses
    assert bool(seen["case-2"]) == (edges == 5)


@pytest.mark.usefixtures("without_workers")
def test_a_missing_witness_is_no_success(monkeypatch):
    explorers = importlib.import_module("allworlds.explorers.builtin.explorer_table")
    built_in = explorers.BUILT_IN["algorithm1"]
    forgetful = explorers.BuiltIn(
        built_in.explore, "directional", {**built_in.witnesses, "case-4": ((2, 2), None)}
    )
    monkeypatch.setitem(explorers.BUILT_IN, "algorithm1", forgetful)
    assert check(edges=1).missing_witnesses == ()
    report = check(edges=2)
    assert (report.verdict, report.exit_code) == (Verdict.VACUOUS, 4)
    assert [*report.missing_witnesses] == report.to_json()["missing_witnesses"] == ["case-4"]
    assert check(edges=2, map_class="simple").missing_witnesses == ()


@pytest.mark.processes
def test_an_interrupt_of_a_closure_interrupts_the_check_and_that_of_a_worker_is_a_crash(tmp_path):
    file = tmp_path / "rude.py"
    file.write_text("def explore(first):\n    raise KeyboardInterrupt\n    yield\n")
    assert check(f"{file}:explore", edges=1).findings[0].law == "crash"

    def explore(first):
        raise KeyboardInterrupt
        yield

    report = check(explore, edges=1)
    assert (report.verdict, report.exit_code) == (Verdict.INCONCLUSIVE, 130)


def test_a_finished_shard_may_hold_no_world(explorers):
    report = check(explorers("right"), shard=(5, 6), edges=1)
    assert (report.verdict, report.exit_code, report.runs) == (Verdict.HOLDS, 0, 0)


@cache
def brute_force(name, edges):
    """The smallest finding of each law and map, level by level.

    It judges every run of the other enumerator; maps are the same if they have a rooting in common.
    """
    import wrong

    explore = getattr(wrong, name)
    found = []
    for m in range(1, edges + 1):
        level, kinds = [], {}
        for map_ in every_rooted_map(m):
            code = rooted_code(map_.sigma, map_.alpha, 0)
            for bearing in range(map_.degree_at[0]):
                world = World(map_, Directional(map_.turn(0, bearing)))
                told = run(lambda first: (yield from explore(first)), world)
                if told.finding:
                    assert told.finding.place == bearing
                    level.append((m, map_.vertex_count, code, bearing, told.finding.law))
                    kinds[code] = frozenset(
                        rooted_code(map_.sigma, map_.alpha, d) for d in map_.darts
                    )
        firsts = {(kinds[one[2]], one[4]): one for one in sorted(level, reverse=True)}
        found.append(sorted(firsts.values()))
    return found


@pytest.mark.parametrize("name", ["everywhere", "here_of_another"])
@pytest.mark.parametrize("keep", [1, 2, 7, 40, 1000])
def test_the_findings_are_the_smallest(explorers, wrong, name, keep):
    explorers(name)
    levels, expected = brute_force(name, 3), []
    for level in levels:
        expected += level
        if len(expected) >= keep:
            break
    report = check(explorers(name), edges=3, max_findings=keep)
    assert [(*finding.key[:4], finding.law) for finding in report.findings] == expected[:keep]
    assert report.complete == (len(expected) < keep or [*report.levels] == [1, 2, 3])
    assert all(finding.minimal and not finding.confirmed for finding in report.findings)


def test_unless_more_are_asked_for_a_check_ends_with_its_first_finding(explorers):
    (first,) = check(explorers("everywhere"), edges=3).findings
    second = check(explorers("everywhere"), edges=3, max_findings=2).findings
    assert (len(second), second[0].key) == (2, first.key)


@pytest.mark.processes
@pytest.mark.parametrize("edges", [3])
def test_one_worker_and_three_say_the_same_of_algorithm_1(edges):
    assert document(check(edges=edges, workers=3)) == document(check(edges=edges))


@pytest.mark.processes
def test_unknown_keys_checkpoints_and_large_motions_are_legal(program):
    report = check(program("chatty"), edges=2, laws=["map", "pose", "bound", "folding"])
    assert (report.verdict, report.runs) == (Verdict.HOLDS, 30)
    assert report.tally.checkpoints == 30


@pytest.mark.processes
def test_a_shell_script_can_be_an_explorer():
    from pathlib import Path

    script = Path(__file__).parents[1] / "support" / "explorers_for_tests" / "edge.sh"
    report = check(f"exec:{script}", edges=1, max_findings=5)
    assert [(finding.law, finding.world.map.loop_count) for finding in report.findings] == [
        ("map", 1)
    ]
    assert report.runs == 3


@pytest.mark.usefixtures("without_workers")
def test_every_schedule_of_algorithm_1():
    report = check(edges=2, schedules="all")
    assert report.verdict is Verdict.HOLDS
    # The worst schedule of Algorithm 1 costs 1 and 4 with 1 and 2 edges.
    worst = {}
    for row in report.rows:
        worst[row.edges] = max(worst.get(row.edges, 0), row.max_cost)
        assert row.episodes >= row.runs
    assert worst == {1: 1, 2: 4}


def test_schedules_need_an_explorer_that_asks(wrong):
    with pytest.raises(InputError, match="schedules 'all' needs an explorer with choices"):
        check(wrong("right"), schedules="all", edges=1)


def test_the_gate_notices_a_class_that_is_mixed_up(explorers, monkeypatch):
    monkeypatch.setattr(
        "allworlds.engines.units.rooted_maps",
        lambda edges, _class, *rest: rooted_maps(edges, MapClass.MAPS, *rest),
    )
    assert check(explorers("right"), edges=4, map_class="planar").exit_code == 70


@pytest.mark.usefixtures("without_workers")
def test_the_gate_notices_a_source_that_counts_otherwise(monkeypatch):
    source = CountSource("abacus", lambda edges: {1: 1, 2: 2})
    monkeypatch.setattr("allworlds.maps.count_source.source_of", lambda _class: source)
    report = check(edges=2)
    assert (report.verdict, report.levels) == (Verdict.ERROR, (1,))
    assert {cell.source for cell in report.cells} == {"abacus"}


@pytest.mark.usefixtures("without_workers")
def test_a_bound_without_a_value_is_bad_input():
    with pytest.raises(InputError, match=r"divides by zero at n=.* m=2"):
        check(edges=2, bound="9 // (2 - m)")


@pytest.mark.usefixtures("without_workers")
def test_the_bound_is_a_law():
    report = check(edges=2, bound="m - 1")
    (finding,) = report.findings
    assert (finding.law, finding.expected, finding.seen) == ("bound", 0, 1)
    assert check(edges=2, bound="m*n").verdict is Verdict.HOLDS


@pytest.mark.usefixtures("without_workers")
def test_a_negative_bound_is_reported_as_it_is():
    report = check(edges=1, bound="n - m - 3")
    assert [row.bound for row in report.rows] == [-3, -2]
    assert report.findings[0].expected == -3


@pytest.mark.usefixtures("without_workers")
def test_an_explorer_that_tampers_with_percepts_deceives_nobody(explorers):
    def kept(percept):
        own = replace(percept)
        force_setattr(percept, "degree", 99)
        return own

    def tampering(first):
        reply = None
        walk = explorers("right")(kept(first))
        try:
            while True:
                reply = yield walk.send(reply)
                reply = reply and kept(reply)
        except StopIteration as stop:
            return stop.value

    report = check(tampering, edges=2)
    assert (report.verdict, report.runs) == (Verdict.HOLDS, 30)
    for world in worlds(edges=2):
        told = run(tampering, world).outcome.episode.transcript
        assert told == run("algorithm1", world).outcome.episode.transcript


@pytest.mark.usefixtures("without_workers")
def test_that_nothing_was_walked_is_told():
    class Hears(Listener):
        told = ()

        def notice(self, text):
            self.told += (text,)

    def motionless(first):
        map_ = CombinatorialMap((0, 1), (1, 0))
        return Estimate(map_ if first.degree == 1 else map_.dual(), 0)
        yield

    silent, telling = Hears(), Hears()
    assert check(edges=1, laws=["map"], listener=silent).verdict is Verdict.HOLDS
    assert check(motionless, edges=1, laws=["map"], listener=telling).verdict is Verdict.HOLDS
    assert not silent.told
    assert "walked an edge" in telling.told[0]


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize(("budget", "law"), [(1, None), (4, None), (3, "budget")])
def test_reaching_the_budget_is_legal_and_passing_it_is_not(budget, law):
    edges = 1 if budget == 1 else 2
    report = check(edges=edges, step_budget=budget)
    assert [finding.law for finding in report.findings] == ([law] if law else [])


@pytest.mark.processes
def test_a_closure_runs_in_this_process_and_a_function_elsewhere(explorers):
    import wrong

    assert not check(explorers("everywhere"), edges=1).findings[0].confirmed
    assert check(wrong.everywhere, edges=1).findings[0].confirmed


def test_the_listener_is_told_of_every_world():
    listener = Hears()
    check(edges=3, workers=2, listener=listener)
    assert listener.heard == [(1, 2, 2), (2, 10, 10), (3, 74, 74)]
    assert listener.notices == []


@pytest.mark.parametrize(
    "options",
    [
        {"edges": 0},
        {"edges": -1},
        {"vertices": 0, "edges": 2},
        {"vertices": 3, "edges": None},
        {"map_class": "nonsense"},
        {"lighthouse": "nonsense"},
        {"lighthouse": "directional:x=1"},
        {"policy": "nonsense"},
        {"policy": "random:"},
        {"laws": ["nonsense"]},
        {"laws": ["folding"], "map_class": "planar"},
        {"schedules": "nonsense"},
        {"engine": "nonsense"},
        {"bound": "n +"},
        {"bound": "n / 2"},
        {"step_budget": 0},
        {"shard": (2, 2)},
        {"shard": (-1, 2)},
        {"shard": (0, 0)},
        {"workers": 0},
        {"answer_timeout": 0},
        {"answer_timeout": float("nan")},
        {"answer_timeout": float("inf")},
        {"time_limit": -1},
        {"time_limit": float("inf")},
        {"memory": 0},
        {"max_findings": 0},
    ],
)
def test_options_out_of_their_range_are_refused(options):
    with pytest.raises(InputError) as refusal:
        check(**{"edges": 1, **options})
    assert "\n" not in str(refusal.value)


def test_a_corpus_cannot_be_given_with_a_run_directory(tmp_path):
    with pytest.raises(InputError, match="cannot be given with run"):
        check(edges=1, corpus=tmp_path / "corpus", run=tmp_path / "run")
    assert not any(tmp_path.iterdir())


def test_a_corpus_file_that_was_changed_is_refused_by_name(tmp_path, wrong):
    check(wrong("raises"), edges=1, corpus=tmp_path)
    (file,) = tmp_path.glob("*.json")
    file.write_text(file.read_text() + "\n")
    with pytest.raises(InputError, match=f"{file.name}.* has been changed since it was written"):
        check(wrong("raises"), edges=1, corpus=tmp_path)


def test_equal_findings_of_a_corpus_are_tried_in_the_order_of_their_files(tmp_path, wrong):
    check(wrong("raises"), edges=1, corpus=tmp_path)
    (file,) = tmp_path.glob("*.json")
    for name in ("z.json", "a.json"):
        (tmp_path / name).write_bytes(file.read_bytes())
    found = check(edges=1, corpus=tmp_path).corpus
    assert found.fixed == tuple(sorted(("a.json", file.name, "z.json")))


def test_a_corpus_file_that_is_no_finding_is_refused_by_name(tmp_path):
    (tmp_path / "x.json").write_text('{"law": 1}')
    with pytest.raises(InputError, match=r"corpus file 'x\.json': "):
        check(edges=1, corpus=tmp_path)


@pytest.mark.parametrize("kind", ["fifo", "device", "folder"])
def test_a_corpus_file_that_is_no_regular_file_is_refused_and_not_opened(tmp_path, kind):
    file = tmp_path / "x.json"
    make = {"fifo": os.mkfifo, "device": lambda f: f.symlink_to("/dev/zero"), "folder": os.mkdir}
    make[kind](file)
    with pytest.raises(InputError, match=r"^corpus file 'x\.json' is no regular file"):
        check(edges=1, corpus=tmp_path)


def test_no_file_of_the_users_is_taken_for_a_draft_of_a_finding(tmp_path, wrong):
    check(wrong("raises"), edges=1, corpus=tmp_path)
    (file,) = tmp_path.iterdir()
    file.unlink()
    mine = file.with_suffix(".tmp")
    mine.write_text("mine")
    check(wrong("raises"), edges=1, corpus=tmp_path)
    assert {*tmp_path.iterdir()} == {file, mine}
    assert mine.read_text() == "mine"


def test_a_huge_bound_costs_nothing_when_a_finding_ends_the_check(explorers):
    assert check(explorers("everywhere"), edges=100_000).levels == (1,)


def test_a_finding_of_another_policy_is_of_this_check_if_all_schedules_are_tried(wrong):
    (finding,) = check(wrong("raises"), edges=1).findings
    lifo = replace(finding, under=replace(finding.rules, policy="lifo"))
    extent = Extent(MapClass.MAPS, 1)
    inside = [
        is_inside(found, Scope(extent, finding.rules, schedules))
        for found in (finding, lifo)
        for schedules in ("one", "all")
    ]
    assert inside == [True, True, False, True]


@pytest.mark.parametrize(
    ("law", "own", "other"),
    [
        ("bound", {"bound": "0"}, {"bound": "1"}),
        ("budget", {"step_budget": 1}, {"step_budget": 2}),
    ],
)
def test_a_finding_of_another_bound_or_budget_is_of_another_check(law, own, other):
    (finding, *_) = check("algorithm1", edges=2, **own).findings
    assert finding.law == law
    extent = Extent(MapClass.MAPS, 2)
    scopes = [Scope(extent, Rules(**rules)) for rules in (own, other)]
    assert [is_inside(finding, scope) for scope in scopes] == [True, False]


def test_a_remark_is_told_with_its_number_and_that_of_hashes_without():
    tally = Tally(1)
    tally.remarks.update({GOES_BY_HASHES: 3, "x": 2, "y": 1})
    assert [*_remarks(tally)] == [*sorted(["x (2 times)", "y", GOES_BY_HASHES])]


def test_what_a_fresh_process_does_not_repeat_is_remarked_and_is_no_finding(monkeypatch):
    monkeypatch.setattr(Confirmation, "_recorded", lambda *_: "a crash that came once")
    tally = Tally(1)
    tally.findings = ["crash"]
    assert Confirmation(None, None, None, None, None).settle(tally)
    assert (tally.findings, dict(tally.remarks)) == ([], {"a crash that came once": 1})


@pytest.mark.parametrize("edges", [1, 2])  # all levels; and one, after which it has enough
def test_a_check_of_what_a_fresh_process_does_not_repeat_is_inconclusive(
    explorers, edges, monkeypatch
):
    monkeypatch.setattr(Confirmation, "_recorded", lambda *_: "a crash that came once")
    report = check(explorers("raises"), edges=edges, max_findings=1)
    assert (report.verdict, report.exit_code, report.findings) == (Verdict.INCONCLUSIVE, 3, ())
    told = "what happened to the explorer was not repeated by a fresh process"
    assert report.ending.reason == told


@pytest.mark.parametrize(("engine", "told"), [("auto", ["it lacks numba"]), ("python", [])])
def test_that_auto_takes_no_compiled_code_is_told_with_its_reason(engine, told, monkeypatch):
    monkeypatch.setattr(checker, "why_not_compiled", lambda *_: "it lacks numba")
    notices = []
    checker.job_of(CheckRequest("algorithm1", edges=1, engine=engine), notices.append)
    assert notices == told


@pytest.fixture
def crash(explorers):
    (finding,) = check(explorers("raises"), edges=1).findings
    return replace(finding, law="crash", seen="it is gone", confirmed=False)


IMPORTABLE = SimpleNamespace(importable=True)


@pytest.mark.parametrize(
    ("again", "subject", "law"),
    [
        ({"machine": False}, IMPORTABLE, "nondeterministic"),
        ({"machine": False, "law": "timeout"}, IMPORTABLE, "nondeterministic"),
        ({"machine": False, "confirmed": True}, IMPORTABLE, "crash"),
        ({"machine": False}, SimpleNamespace(importable=False), "crash"),
        ({"machine": True, "law": "map"}, IMPORTABLE, "map"),
    ],
)
def test_who_crashes_here_and_not_in_a_fresh_process_is_nondeterministic(
    crash, again, subject, law, monkeypatch
):
    played = replace(crash, **again)
    monkeypatch.setattr(Confirmation, "_again", lambda *_, number: played)
    settled = Confirmation(subject, None, None, None, None)._settled(crash, number=0)
    assert settled.law == law
    if law == "nondeterministic":
        assert settled.confirmed
        assert f"{played.law} here, but not in a fresh process: it is gone" in settled.seen
    else:
        assert settled == played


def test_a_crash_that_the_machine_may_have_caused_is_a_remark(crash, monkeypatch):
    monkeypatch.setattr(Confirmation, "_again", lambda *_, number: replace(crash, machine=True))
    settled = Confirmation(IMPORTABLE, None, None, None, None)._settled(crash, number=0)
    assert settled == (
        f"a crash in a world with {size(1, crash.key[1])} (it is gone) that a fresh "
        "process did not repeat"
    )


class Kept:
    """A run directory that knows one record, and is told others."""

    def __init__(self, record=None):
        self.record, self.noted = record, []

    def recall(self, name):
        return self.record

    def note(self, name, record):
        self.noted.append(record)


def test_what_was_recorded_is_not_settled_anew(crash):
    kept = Kept({"remark": "it came once"})
    recorded = Confirmation(IMPORTABLE, None, None, None, kept)._recorded("confirmed", crash, None)
    assert recorded == "it came once"
    assert kept.noted == []


def test_after_the_deadline_a_finding_is_left_as_it_is_and_not_recorded(crash):
    kept = Kept()
    late = Confirmation(IMPORTABLE, None, None, monotonic() - 1, kept)
    assert late._recorded("confirmed", crash, None) == crash
    in_time = Confirmation(IMPORTABLE, None, None, monotonic() + 1000, kept)
    assert in_time._recorded("confirmed", crash, lambda _: "it came once") == "it came once"
    assert kept.noted == [{"remark": "it came once"}]


def test_a_finding_is_inside_of_given_worlds_if_one_of_them_is_its_world(wrong):
    (finding,) = check(wrong("raises"), edges=1).findings
    other = World(finding.world.map, Directional(1), 1)
    for worlds_, inside in (([finding.world], True), ([], False)):
        given = SimpleNamespace(like=lambda world, among=worlds_: [w for w in among if w == world])
        extent = SimpleNamespace(include=lambda _: True, given=given)
        scope = SimpleNamespace(
            rules=finding.rules, extent=extent, like=given.like, schedules="one"
        )
        assert is_inside(finding, scope) == inside
    assert other != finding.world
