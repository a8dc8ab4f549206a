"""Output of an explorer in the run that is told: ``run`` shows it, and findings keep it."""

import sys

import pytest

from allworlds import Finding, check, replay, run
from engines import test_prints as quick

named = quick.named

pytestmark = pytest.mark.processes


PROGRAM = """
import json, sys
for line in sys.stdin:
    print("hears", line.strip()[:12], file=sys.stderr, flush=True)
    print(json.dumps({"estimate": {"sigma": [0, 1], "alpha": [1, 0], "here": 7}}), flush=True)
"""


@pytest.mark.slowest
def test_replay_does_not_compare_it(named):
    (finding,) = check(named("wrong"), edges=3).findings
    document = finding.to_json() | {"output": "something else"}
    assert replay(Finding.from_json(document)).outcome == "reproduced"


@pytest.mark.slowest
def test_last_words_are_kept(named):
    (finding,) = check(named("dies"), edges=1).findings
    assert (finding.law, finding.output) == ("crash", "last words\n")
    assert run(named("dies"), "theta").finding.output == "last words\n"


@pytest.mark.slowest
def test_what_a_program_writes_to_stderr_is_kept_too(tmp_path):
    file = tmp_path / "program.py"
    file.write_text(PROGRAM, encoding="utf-8")
    (finding,) = check(f"exec:{sys.executable} {file}", edges=1).findings
    assert finding.law == "no-estimate"
    assert finding.output == 'hears {"episode": \n'


@pytest.mark.slowest
def test_a_finding_holds_what_was_printed_in_its_run_alone(named, cli):
    (finding,) = check(named("wrong"), edges=3).findings
    degree = finding.transcript.first.degree
    assert finding.output == f"begins with {degree}\nends\n"
    assert finding.to_json()["output"] == finding.output
    assert Finding.from_json(finding.to_json()).output == finding.output
    _, out, err = cli("check", named("wrong"), "--edges", 3, "-v")
    assert out.count("begins with") == 1
    assert "begins with" not in err
