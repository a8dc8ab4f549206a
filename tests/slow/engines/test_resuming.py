"""Finished units are kept: a job that was ended goes on, and reports as if it had not been."""

import json
import os
import random
import signal
import sqlite3
import subprocess
import sys
from contextlib import suppress

import pytest

import processes
from engines import test_resuming as quick
from engines.test_resuming import units_in
from kept_jobs import EXPLORERS, stable
from small import long

pytestmark = pytest.mark.usefixtures("compiled")


def started(command, directory):
    return subprocess.Popen(
        [sys.executable, "-m", "allworlds", *command.split(), "--run", str(directory), "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )


def count(directory):
    try:
        return len(units_in(directory))
    except sqlite3.Error:
        return 0


def wait_for_units(process, directory, goal):
    assert processes.end(lambda: process.poll() is None and count(directory) < goal)


def killed_often(command, directory, times, seed):
    """How often the command could be killed, each time after some more units."""
    draw, kills = random.Random(seed), 0
    for _ in range(times):
        process = started(command, directory)
        wait_for_units(process, directory, count(directory) + draw.randrange(3))
        with suppress(subprocess.TimeoutExpired):
            process.wait(draw.random() / 10)
        if process.poll() is None:
            os.kill(process.pid, signal.SIGKILL)
            kills += 1
        process.communicate()
    return kills


LONGER = {
    "foreign": f"check {EXPLORERS}/wrong.py:right --edges 6 --class simple --workers 2",
    "compiled": "check --edges 7 --engine kernel",
    "worst": "worst --edges 5",
    "census": "ambiguity census --edges 4",
}


@pytest.mark.parametrize("name", [name if name == "census" else long(name) for name in LONGER])
def test_a_job_that_is_killed_at_random_moments_says_the_same(name, tmp_path):
    command, times = LONGER[name], 20 if name == "foreign" else 4
    whole = subprocess.run(
        [sys.executable, "-m", "allworlds", *command.split(), "--json"],
        check=True,
        capture_output=True,
    )
    kills = killed_often(command, tmp_path / "run", times, seed=13)
    assert kills >= times // 4  # those before the first unit at least
    last = started(command, tmp_path / "run")
    out, err = last.communicate()
    assert last.returncode == 0, err
    assert stable(out) == stable(whole.stdout)
    # Byte for byte: but for the one key the texts are the same, too.
    cut = [json.dumps(stable(text), indent=2) for text in (out, whole.stdout)]
    assert cut[0] == cut[1]


@pytest.mark.no_cover
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("name", ["own", "foreign"])
def test_a_job_that_was_ended_goes_on_and_says_the_same(name, tmp_path):
    quick.test_a_job_that_was_ended_goes_on_and_says_the_same(name, tmp_path)


@pytest.mark.no_cover
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("name", [*("own", "compiled", "foreign", "census")])
def test_a_lock_that_is_removed_by_hand_harms_nobody(name, tmp_path):
    quick.test_a_lock_that_is_removed_by_hand_harms_nobody(name, tmp_path)


@pytest.mark.no_cover
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("name", ["raises", "everywhere"])
def test_a_finding_that_was_kept_is_the_same_finding(name, tmp_path):
    quick.test_a_finding_that_was_kept_is_the_same_finding(name, tmp_path)
