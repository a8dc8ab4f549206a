"""The command line from outside: exit codes, what is on stdout, what is on stderr."""

import json
import shlex

import pytest

from cli.test_cli import WRONG


def test_a_finding_is_replayed_from_its_report_and_from_its_command(cli, tmp_path):
    code, out, _ = cli("check", f"{WRONG}:here_of_another", "--edges", "3", "--json")
    report = json.loads(out)
    assert (code, report["exit_code"], report["verdict"]) == (1, 1, "refuted")
    finding = report["findings"][0]
    assert (finding["version"], finding["law"], finding["confirmed"]) == (2, "pose", True)
    for name, document in (("report", report), ("finding", finding)):
        (tmp_path / name).write_text(json.dumps(document))
        code, out, _ = cli("replay", tmp_path / name, "--json")
        assert (code, json.loads(out)["outcome"]) == (0, "reproduced")
        code, out, _ = cli("replay", tmp_path / name, "--explorer", "algorithm1", "--json")
        assert (code, json.loads(out)["outcome"]) == (5, "fixed")
    command = shlex.split(finding["reproduce"])
    assert command[0] == "allworlds"
    code, out, _ = cli(*command[1:], "--json")
    again = json.loads(out)["finding"]
    for key in ("law", "world", "transcript", "choices", "expected", "seen", "options"):
        assert again[key] == finding[key]


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("one_schedule", ["--schedules", "all", "--edges", "1"]),
        ("here_of_another", ["--edges", "3", "--class", "planar", "--policy", "random:5"]),
        ("everywhere", ["--edges", "2", "--laws", "folding"]),
        ("right", ["--edges", "2", "--bound", "m", "--laws", "bound,map", "--step-budget", "20"]),
        ("right", ["--edges", "2", "--bound", "m", "--class", "planar"]),
    ],
)
def test_the_command_of_a_finding_shows_the_same_law(cli, name, options):
    code, out, _ = cli("check", f"{WRONG}:{name}", *options, "--json")
    assert code == 1
    (finding,) = json.loads(out)["findings"]
    code, out, _ = cli(*shlex.split(finding["reproduce"])[1:], "--json")
    again = json.loads(out)["finding"]
    assert code == 1
    for key in ("law", "world", "transcript", "choices", "expected", "seen"):
        assert again[key] == finding[key]
