"""A distribution that offers an explorer, a lighthouse, a task and a predicate as entry points."""

import json

import pytest

from doors import test_entry_points as quick
from doors.test_entry_points import CHECK

installed = quick.installed


@pytest.mark.long
def test_run_directories_and_the_census_take_them(installed):
    words = [*CHECK, "--task", "my-word?word=here", "--run", "rd"]
    assert installed(*words)[0] == 0
    code, out, _ = installed("merge", "rd", "--json")
    assert (code, json.loads(out)["verdict"]) == (0, "holds")
    code, out, _ = installed(
        *("ambiguity", "census", "--lighthouse", "my-parity", "--where", "my-small?degree=3"),
        *("--edges", 2, "--json"),
    )
    assert (code, json.loads(out)["scope"]["lighthouse"]) == (0, "my-parity")
