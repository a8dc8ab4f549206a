"""Checks of other tasks than to find the map."""

import json
import sys

import pytest

import allworlds
from allworlds.inputs.checks import InputError
from allworlds.judging.findings.finding import Finding
from allworlds.protocol.actions import Move
from allworlds.reports.formats import text

EXPLORERS = """
from allworlds import Move


def goes_on(first):
    while True:
        yield Move(1)


def gives_up(first):
    for _ in range(3):
        yield Move(1)
    return "done"


def knows(first, *, told):
    return told["n"]
    yield


def counts_too_few(first, *, told):
    return told["n"] - (told["n"] > 2)
    yield


def returns_an_object(first):
    return object()
    yield


def wants(answer):
    return lambda world, transcript, given: None if given == answer else f"{given} is not {answer}"
"""

PROGRAM = """
import json, sys

for line in sys.stdin:
    if "episode" in json.loads(line):
        print(json.dumps({"answer": json.loads(line)["told"]["m"]}), flush=True)
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "mine.py").write_text(EXPLORERS)
    (tmp_path / "program.py").write_text(PROGRAM)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def checked(explorer, task, **options):
    return allworlds.check(f"mine.py:{explorer}", task=task, **{"workers": 1, **options})


@pytest.mark.parametrize("workers", [1, 2])
def test_the_right_hand_rule_covers_what_has_one_face(folder, workers):
    report = checked("goes_on", "cover:edges", edges=2, lighthouse="none", workers=workers)
    (finding,) = report.findings
    assert finding.law == "budget"
    assert finding.expected.startswith("every edge walked along within ")
    assert "checkpoint" not in str(report)
    assert len(finding.world.map.faces) > 1
    assert finding.confirmed
    trees = checked("goes_on", "cover", edges=3, map_class="planar-simple", vertices=4, bound="2*m")
    assert trees.verdict.value in ("holds", "refuted")


def test_a_run_that_is_over_costs_what_it_has_cost_by_then(folder):
    report = checked("goes_on", "cover", edges=1, lighthouse="none")
    assert report.verdict.value == "holds"
    assert [(row.vertices, row.traversals) for row in report.rows] == [(1, 0), (2, 1)]
    bounded = checked("goes_on", "cover", edges=1, lighthouse="none", bound="m-1")
    assert [finding.law for finding in bounded.findings] == ["bound"]
    assert bounded.findings[0].confirmed


@pytest.mark.parametrize("workers", [1, 2])
def test_a_judge_of_ones_own_ends_a_run_as_ours_do(folder, workers):
    (folder / "covers.py").write_text(
        "def judge(world, transcript, answer):\n"
        "    left = world.map.vertex_count - len(transcript.visited)\n"
        "    return f'{left} left' if left else None\n\n\n"
        "judge.over = lambda world, transcript: "
        "len(transcript.visited) == world.map.vertex_count\n"
    )
    asked = {"lighthouse": "none", "where": "trees", "workers": workers}
    ours = checked("goes_on", "cover", edges=4, **asked)
    theirs = checked("goes_on", "covers.py:judge", edges=4, **asked)
    assert ours.verdict.value == theirs.verdict.value == "holds"
    assert ours.to_json()["rows"] == theirs.to_json()["rows"]
    loops = {**asked, "where": None, "edges": 2}
    (one,), (other,) = (
        checked("goes_on", task, **loops).findings for task in ("cover", "covers.py:judge")
    )
    assert (one.law, one.world, one.transcript) == (other.law, other.world, other.transcript)
    assert other.confirmed
    assert allworlds.replay(other).outcome == "reproduced"


def test_an_end_before_all_is_visited_breaks_the_task(folder):
    report = checked("gives_up", "stop", edges=4)
    (finding,) = report.findings
    assert (finding.law, finding.confirmed, finding.minimal) == ("task", True, True)
    assert finding.expected.startswith("every vertex visited")
    again = Finding.from_json(finding.to_json())
    assert again.to_json() == finding.to_json()
    assert allworlds.replay(again).outcome == "reproduced"
    assert "--task stop" in finding.reproduce
    assert "did not do what the task asks for" in text(allworlds.explain(finding), 100)
    assert text(report, 100)


def test_any_answer_gets_to_the_judge(folder):
    assert checked("knows", "count:n", edges=3, lighthouse="told").verdict.value == "holds"
    (finding,) = checked("counts_too_few", "count:n", edges=3, lighthouse="told").findings
    assert finding.seen == "the answer 2, and the number of vertices is 3"
    assert finding.world.map.vertex_count == 3
    (other,) = checked("returns_an_object", "count:n", edges=1).findings
    assert other.law == "no-estimate"


def test_a_program_says_an_answer(folder):
    for task, verdict in (("count:m", "holds"), ("count:n", "refuted")):
        report = allworlds.check(
            f"exec:{sys.executable} program.py", task=task, edges=2, lighthouse="told", workers=1
        )
        assert report.verdict.value == verdict
    assert report.findings[0].law == "task"


def test_a_judge_of_ones_own_is_known_by_its_content(folder):
    task = "judges.py:wants?answer=done"
    (folder / "judges.py").write_text(EXPLORERS)
    assert checked("gives_up", task, edges=2).verdict.value == "holds"
    report = checked("gives_up", "judges.py:wants?answer=home", edges=1, run="rd")
    (finding,) = report.findings
    assert finding.seen == "done is not home"
    assert finding.to_json()["options"]["task"] == "judges.py:wants?answer=home"
    assert "shared_file" not in report.to_json()["scope"]
    assert checked("gives_up", "mine.py:wants?answer=done", edges=1).scope.shared_file == "mine.py"
    (folder / "judges.py").write_text(EXPLORERS + "\n")
    with pytest.raises(InputError, match="has another text now"):
        Finding.from_json(json.dumps(finding.to_json()))
    with pytest.raises(InputError, match="is of another text of 'judges"):
        checked("gives_up", "judges.py:wants?answer=home", edges=1, run="rd")


def test_the_compiled_engine_leaves_other_tasks_to_the_other(folder):
    with pytest.raises(InputError, match="judges the task map alone, not 'stop'"):
        allworlds.check(edges=3, task="stop", engine="kernel")
    report = allworlds.check(edges=5, task="cover", map_class="simple", vertices=4)
    assert (report.engine, report.verdict.value) == ("python", "holds")


def test_one_run_says_what_the_task_made_of_it(folder):
    world = next(w for w in allworlds.worlds(edges=1) if w.map.vertex_count == 2)
    over = allworlds.run("mine.py:goes_on", world, task="cover")
    assert over.outcome.episode.transcript.actions == (Move(0),)
    assert "ended      as the task was done: every vertex visited\n" in text(over, 100)
    said = allworlds.run("mine.py:gives_up", world, task="stop")
    assert 'answer     "done"' in text(said, 100)
    assert allworlds.run("mine.py:gives_up", world, task="home").finding.law == "task"


def test_a_judge_in_the_explorers_file_can_let_it_pass_and_the_scope_says_so(folder):
    (folder / "attack.py").write_text(
        EXPLORERS + "\n\ndef blind(world, transcript, answer):\n    return None\n"
    )
    report = allworlds.check("attack.py:gives_up", task="attack.py:blind", edges=3, workers=1)
    assert report.verdict.value == "holds"
    assert report.scope.shared_file == "attack.py"
    assert "attack.py holds the explorer, and code that judges it" in text(report, 100)
