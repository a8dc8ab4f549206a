"""Schedules that a user gives."""

from pathlib import Path

import pytest

PROGRAMS = Path(__file__).parents[1] / "support" / "teams.py"

SCHEDULES = {
    "0x": "'0x' is no event",
    "0+1:1": "event 1 has 1 ways of the adversary",
    "0L 0L": "in event 2 robot 0 moves",
    "2": "in event 1 robot 2 cannot act",
}


@pytest.mark.parametrize("schedule", SCHEDULES)
def test_a_schedule_that_cannot_be_is_refused(schedule, refused):
    world = '{"sigma":[0,1],"alpha":[1,0]}'
    words = [f"{PROGRAMS}:other_end", "--world", world, "--starts", "0,1"]
    said = refused("team", *words, "--scheduler", "async", "--schedule", schedule)
    assert SCHEDULES[schedule] in said
