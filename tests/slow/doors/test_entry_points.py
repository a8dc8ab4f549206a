"""A distribution that offers an explorer, a lighthouse, a task and a predicate as entry points."""

import json

import pytest

from doors import test_entry_points as quick

installed = quick.installed


@pytest.mark.slowest
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


CHECK = [
    *("check", "my-explorer", "--lighthouse", "my-parity:modulus=3"),
    *("--where", "my-small?degree=3", "--edges", 2, "--json"),
]


def test_what_a_distribution_offers_is_used_by_its_name(installed):
    code, out, err = installed(*CHECK, "--task", "my-word?word=there", "--workers", 1)
    report = json.loads(out)
    assert report["scope"]["where"] == "my-small?degree=3"
    assert report["scope"]["lighthouse"] == "my-parity?modulus=3"
    assert report["scope"]["task"] == "my-word?word=there"
    assert "shared_file" not in report["scope"]
    (finding,) = report["findings"]
    assert (code, finding["law"], finding["seen"]) == (1, "task", "here is said"), err
