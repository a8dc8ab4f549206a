"""Programs of robots that hang, end, flood, or are not the same twice, in other processes."""

import pytest

from allworlds.outcome import Verdict
from small import slowest
from studies.test_team import team


@pytest.mark.parametrize(
    ("program", "law"),
    [slowest("hangs", "timeout"), ("exits", "crash"), ("raises", "crash")],
)
def test_a_process_that_is_lost_is_a_finding_and_takes_nothing_with_it(program, law):
    report = team(program, model="meeting", answer_timeout=2.0)
    (found,) = report.findings
    assert found.law == law
    assert found.robot == 1
    # The same world as for one that raises, and the same counts.
    raised = team("raises", model="meeting")
    assert found.key == raised.findings[0].key
    assert report.total == raised.total


@pytest.mark.parametrize("program", ["changes_its_mind", "remembers", "forgetful"])
def test_what_is_not_the_same_twice_is_found(program):
    laws = {found.law for found in team(program, edges=3, budget=20, max_findings=9).findings}
    assert "nondeterministic" in laws


def test_a_program_that_floods_is_heard_to_its_end():
    report = team("floods", edges=2, budget=5)
    assert report.verdict is Verdict.INCONCLUSIVE
