"""Whatever an explorer does to its process, the check ends soon and says what was wrong."""

import signal

import pytest

import small
from allworlds.engines.players import GRACE, PlayerProcess
from allworlds.judging.findings.finding import Finding
from allworlds.studies.check.exhaustive import check
from allworlds.studies.run import replay, run
from engines.test_workers import EDGE, LOOP, only_finding
from processes import PATIENCE, SOON

pytestmark = [pytest.mark.processes, pytest.mark.usefixtures("no_orphans", "clock")]


@pytest.mark.parametrize("name", ["prints", "reads_quietly", "child", "thread", "forks"])
def test_what_harms_nobody_is_no_finding(wrong, capfd, name):
    report = check(wrong(name), edges=2, workers=2)
    assert (report.verdict.value, report.worlds, report.runs) == ("holds", 12, 30)
    assert capfd.readouterr().out == ""


@pytest.mark.slowest
def test_the_walk_of_a_killed_explorer_is_known(wrong):
    finding = only_finding(wrong("hang_in_the_middle"))
    assert finding.law == "timeout"
    assert [action.k for action, _ in finding.transcript.steps] == [0]
    assert finding.confirmed


@pytest.mark.slowest
def test_the_choices_of_a_killed_explorer_are_known(wrong, clock):
    # No further than what is allowed where something is still to be heard.
    clock.LEAP = SOON + GRACE / 2
    finding = only_finding(wrong("hang_after_choices"), schedules="all", laws=["map"])
    assert (finding.law, finding.choices) == ("timeout", (0,))  # those of the turns that ended
    assert len(finding.transcript.steps) == 1


@pytest.mark.slowest
@pytest.mark.parametrize(
    "name", ["chooses_for_ever", small.slowest("chooses_for_ever_whatever_is_raised")]
)
def test_an_explorer_that_chooses_for_ever_is_silent(wrong, name):
    finding = only_finding(wrong(name))
    assert (finding.law, finding.confirmed) == ("timeout", True)
    assert len(finding.transcript.steps) == 1
    assert finding.choices == (0,)  # those before the step; of a turn without an end none is told
    told = run(wrong(name), EDGE, answer_timeout=PATIENCE, start_timeout=10**6)
    assert (told.finding.law, told.finding.choices) == ("timeout", finding.choices)


@pytest.mark.slowest
def test_a_program_that_plays_one_episode_is_told_that_there_are_more(program):
    finding = only_finding(program("dies-between"))
    assert finding.law == "nondeterministic"
    assert "one process plays many" in finding.seen


@pytest.mark.slowest
def test_an_explorer_that_takes_its_interpreter_with_it_when_it_is_closed(wrong):
    report = check(wrong("ends_at_its_close"), edges=1)
    assert [finding.law for finding in report.findings] == ["crash"]


@pytest.mark.slowest
@pytest.mark.parametrize("name", ["by_random", "by_time", "by_id", "by_hash", "by_state"])
def test_a_walk_that_is_another_one_the_second_time_is_nondeterministic(wrong, name):
    finding = only_finding(wrong(name))
    assert finding.law == "nondeterministic"
    assert finding.world.map.loop_count == 1
    # What keeps a state may do the same in both plays, and something else when it is confirmed.
    assert "walk differs" in finding.seen or "in some plays only" in finding.seen


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("kind", "law", "seen"),
    [
        ("ends", "crash", "exit code 7"),
        ("no-json", "illegal-action", "no JSON: 'move 0'"),
        ("empty-line", "illegal-action", "no JSON"),
        ("no-object", "illegal-action", "no object: '[1, 2]'"),
        ("bad-utf8", "illegal-action", "no JSON"),
        ("huge-line", "illegal-action", "a line of over"),
        ("deep", "illegal-action", "no JSON"),
        ("bool-move", "illegal-action", '{"move": true}'),
        ("float-move", "illegal-action", '{"move": 1.0}'),
        ("unknown", "illegal-action", '{"jump": 1}'),
        ("drop", "illegal-action", "Drop()"),
        ("checkpoint-no-object", "illegal-action", "checkpoint"),
        ("no-map", "no-estimate", "no map"),
        ("no-object-estimate", "no-estimate", "null"),
        ("here-is-none", "no-estimate", "an estimate without here"),
        ("checkpoint-of-sigma", "illegal-action", "a checkpoint without alpha and here"),
        ("two-estimates", "illegal-action", "after its answer"),
        ("lazy", "map", ""),
    ],
)
@pytest.mark.usefixtures(
    "no_orphans", "without_workers"
)  # that the program is another one suffices
def test_the_law_that_a_program_breaks(program, kind, law, seen):
    finding = only_finding(program(kind))
    assert (finding.law, finding.world) == (law, LOOP)  # fewer vertices than the edge
    assert seen in str(finding.seen)
    assert ("I am tired" in finding.detail) == (kind == "ends")
    assert finding.confirmed == (kind != "dies-between")
    assert len(finding.transcript.steps) == (kind in ("two-estimates", "dies-between"))


def test_a_program_that_does_not_end_with_its_input_is_ended(program, tmp_path, gone):
    report = check(program("never-exits", tmp_path / "pids"), edges=2, workers=2)
    assert (report.verdict.value, report.runs) == ("holds", 30)
    assert (tmp_path / "pids").read_text()
    assert gone(tmp_path / "pids")


@pytest.mark.parametrize("time_limit", [0.3, small.slowest(1.5)])
def test_a_program_in_the_middle_of_a_run_is_ended_with_the_check(
    program, tmp_path, gone, time_limit, monkeypatch
):
    close, ended_by = PlayerProcess.close, []

    def closed(player):
        close(player)
        ended_by.append(player._code())

    monkeypatch.setattr(PlayerProcess, "close", closed)
    name = program("silent", tmp_path / "pids")
    report = check(name, edges=1, answer_timeout=PATIENCE, time_limit=time_limit)
    assert (report.exit_code, report.runs) == (3, 0)
    assert gone(tmp_path / "pids")
    assert ended_by == [-signal.SIGTERM]  # it was asked, and nobody waited for it in vain


@pytest.mark.slowest
def test_one_run_of_an_explorer_that_hangs_is_stopped_too(wrong):
    told = run(wrong("hang_in_the_middle"), EDGE, answer_timeout=PATIENCE)
    assert (told.exit_code, told.finding.law, told.outcome.cost) == (1, "timeout", 1)
    again = replay(Finding.from_json(told.finding.to_json()), answer_timeout=PATIENCE)
    assert again.outcome == "reproduced"


@pytest.mark.parametrize("name", ["os_exit", "segfault", "reads", "closes", "orphan", "raises"])
def test_one_run_of_an_explorer_that_dies_is_a_crash(wrong, name):
    told = run(wrong(name), EDGE, answer_timeout=PATIENCE)
    assert (told.exit_code, told.finding.law, told.outcome.cost) == (1, "crash", 0)


@pytest.mark.slowest
def test_an_answer_that_is_another_one_the_second_time_is_nondeterministic(wrong):
    # In three runs both plays may agree by chance; in the 300 of three edges they do not.
    report = check(wrong("by_answer"), edges=3, laws=["map"])
    assert report.exit_code == 1
    (finding,) = report.findings
    assert finding.law == "nondeterministic"
    assert "answer differs" in finding.seen or "in some plays only" in finding.seen


@pytest.mark.slowest
def test_a_crash_in_one_of_two_plays_is_nondeterministic(wrong):
    finding = only_finding(wrong("crashes_the_second_time"))
    assert finding.law == "nondeterministic"
    # Which of the plays crashes depends on the order; it may be one in a fresh process.
    assert "crash" in finding.seen
    assert "ZeroDivisionError" in finding.seen
    assert "Traceback" in finding.detail


@pytest.mark.early
@pytest.mark.parametrize(
    ("name", "law", "seen"),
    [
        ("os_exit", "crash", "exit code 0"),
        ("segfault", "crash", "signal 11"),
        small.slowest("closes", "crash", "end of the process"),
        small.slowest("raises", "crash", "ZeroDivisionError"),
        ("hang", "timeout", "silent for 4 s"),
        small.slowest("hang_gil", "timeout", "silent for 4 s"),
        small.slowest("hang_regex", "timeout", "silent for 4 s"),
        small.slowest("reads", "crash", "EOFError"),
        small.slowest("closes_and_hangs", "crash", "the process's pipe"),
        small.slowest("sys_exit", "crash", "SystemExit"),
        small.slowest("interrupt", "crash", "KeyboardInterrupt"),
        small.slowest("deep", "crash", "RecursionError"),
        small.slowest("orphan", "crash", "exit code 3"),
    ],
)
def test_the_law_that_is_broken_at_a_vertex_of_degree_1(wrong, name, law, seen):
    finding = only_finding(wrong(name))
    assert finding.law == law
    assert finding.world == EDGE
    assert seen in finding.seen
    assert finding.transcript.steps == ()
    assert finding.confirmed


def test_a_program_that_does_not_listen_is_stopped(program, tmp_path, gone):
    finding = only_finding(program("deaf", tmp_path / "pids"))
    assert finding.law == "budget"
    assert (tmp_path / "pids").read_text()
    assert gone(tmp_path / "pids")


def test_memory_beyond_the_limit_is_a_crash(wrong):
    finding = only_finding(wrong("memory"), memory=1000)
    assert (finding.law, finding.world) == ("crash", EDGE)
    assert "MemoryError" in finding.seen
    assert finding.confirmed
