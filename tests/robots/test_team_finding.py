"""Findings of teams: written, read, replayed, and searched again."""

import json
from pathlib import Path

import pytest

import allworlds
from allworlds.documents.document import replace
from allworlds.inputs.checks import InputError
from allworlds.robots.team_finding import TeamFinding

PROGRAMS = Path(__file__).parents[1] / "support" / "teams.py"


def finding():
    report = allworlds.team(f"{PROGRAMS}:other_end", edges=3, model="meeting", scheduler="async")
    (found,) = report.findings
    return found


def test_a_finding_is_written_and_read():
    found = finding()
    assert TeamFinding.from_json(json.loads(found.text)) == found
    assert found.file_name.startswith("progress-m1n2-")


def test_a_finding_is_replayed_and_fixed():
    found = finding()
    assert allworlds.replay(found).outcome == "reproduced"
    assert allworlds.replay(found, f"{PROGRAMS}:waits").outcome == "reproduced"
    mended = allworlds.replay(replace(found, model="meeting:apart=false"), f"{PROGRAMS}:raises")
    assert (mended.outcome, mended.exit_code) == ("not-reproduced", 3)


def test_its_command_searches_that_world_again(cli):
    import shlex

    words = shlex.split(finding().reproduce)
    code, out, _ = cli(*words[1:], "--json")
    (again,) = json.loads(out)["findings"]
    assert (code, again["law"], again["schedule"]) == (1, "progress", finding().schedule)


@pytest.mark.parametrize(
    ("key", "value", "told"),
    [
        ("law", "map", "law 'map' is not one of "),
        ("version", 2, "finding of a team of version 2; this program reads 1"),
        ("version", None, "finding of a team of version None; this program reads 1"),
    ],
)
def test_a_finding_of_another_law_or_version_is_refused(key, value, told):
    document = json.loads(finding().text) | {key: value}
    with pytest.raises(InputError, match=told):
        TeamFinding.from_json(document)
