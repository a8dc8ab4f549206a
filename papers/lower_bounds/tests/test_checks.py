"""The checks in ``checks``, made again: the verdict, what was run, and the largest costs."""

import json
from pathlib import Path

import pytest

from allworlds import check
from playing import named
from small import slow

FOLDER = Path(__file__).parents[1] / "checks"
SLOW = {"remembering-all-schedules"}
NAMES = sorted(file.stem for file in FOLDER.iterdir())


@pytest.mark.parametrize("name", [slow(name) if name in SLOW else name for name in NAMES])
def test_a_check_finds_what_is_recorded(name):
    recorded = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    report = check(named(recorded["explore"]), **recorded["options"], workers=2).to_json()
    dearest = dict.fromkeys(range(1, report["scope"]["edges"] + 1), 0)
    for row in report["rows"]:
        dearest[row["edges"]] = max(dearest[row["edges"]], row["max_cost"])
    told = {**report, "dearest": [*dearest.values()]}
    assert report["scope"]["bound"] == "paper"
    assert {key: told[key] for key in recorded["expected"]} == recorded["expected"]
