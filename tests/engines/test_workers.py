"""Whatever an explorer does to its process, the check ends soon and says what was wrong."""

import pytest

import small
from allworlds.engines import losses
from allworlds.inputs.checks import InputError
from allworlds.studies.check.exhaustive import check
from allworlds.studies.run import run
from allworlds.world import Directional, World
from processes import PATIENCE, SOON

EDGE = World(small.EDGE, Directional(0))
LOOP = World(small.LOOP, Directional(0))
SILENT = (
    *("hang", "hang_gil", "hang_regex", "hang_in_the_middle", "hang_after_choices"),
    *("chooses_for_ever", "chooses_for_ever_whatever_is_raised"),
)
RUNS = 3  # with one edge: one run in the edge, two in the loop

pytestmark = [pytest.mark.processes, pytest.mark.usefixtures("no_orphans", "clock")]


def only_finding(name, **options):
    limit = SOON if name.partition(":")[2] in SILENT else PATIENCE
    # The clock leaps for all players, for those that are being started, too.
    waits = {"answer_timeout": limit, "start_timeout": 10**6, **options}
    report = check(name, edges=1, **waits)
    assert report.exit_code == 1
    assert report.runs == RUNS
    (finding,) = report.findings
    assert finding.minimal
    return finding


def test_silent_runs_of_a_level_are_not_all_waited_for(wrong, monkeypatch):
    monkeypatch.setattr(losses, "SILENT_RUNS", 2)
    waits = {"answer_timeout": PATIENCE, "start_timeout": 10**6}
    report = check(wrong("hang"), edges=2, max_findings=9, **waits)
    assert (report.exit_code, report.runs) == (1, RUNS)
    assert "silent in 2 runs, for 300 s each" in report.ending.reason
    assert [found.world.map.edge_count for found in report.findings] == [1, 2]
    assert {found.law for found in report.findings} == {"timeout"}


def test_a_limit_of_memory_beyond_all_memory_is_none(wrong):
    assert check(wrong("right"), edges=1, memory=10**9, bound="none").exit_code == 0


@pytest.mark.parametrize("name", ["foreign", "built-in"])
def test_a_limit_of_memory_in_which_no_worker_can_live_is_refused(wrong, name):
    explorer = wrong("right") if name == "foreign" else "algorithm1"
    with pytest.raises(InputError, match="memory 1 MB is probably too small"):
        check(explorer, edges=1, memory=1, engine="python")


def test_an_explorer_that_finds_no_memory_to_be_imported_tells_the_limit(tmp_path):
    module = tmp_path / "large.py"
    module.write_text("KEPT = bytearray(1 << 29)\ndef explore(first): yield\n")
    with pytest.raises(InputError, match=r"memory 300 MB is .* does not import: MemoryError$"):
        check(f"{module}:explore", edges=1, memory=300)


@pytest.mark.parametrize("timeout", [1e-9, 0.05])
def test_a_timeout_that_could_not_be_kept_is_refused(wrong, timeout):
    with pytest.raises(InputError, match=r"least is 0\.1 s"):
        check(wrong("right"), edges=1, answer_timeout=timeout)
    with pytest.raises(InputError, match=r"least is 0\.1 s"):
        run(wrong("right"), EDGE, answer_timeout=timeout)


@pytest.mark.early
def test_a_program_that_is_silent(program):
    # It never says anything, so whatever it is given is too little on every machine.
    finding = only_finding(program("silent"), answer_timeout=0.2)
    assert (finding.law, finding.seen, finding.world) == ("timeout", "silent for 0.2 s", LOOP)
    assert (finding.transcript.steps, finding.confirmed) == ((), True)


def test_one_run_of_a_program_that_is_silent(program, tmp_path, gone):
    told = run(program("silent", tmp_path / "pids"), EDGE, answer_timeout=0.2)
    assert told.finding.law == "timeout"
    assert gone(tmp_path / "pids")
