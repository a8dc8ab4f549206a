"""Standard streams that are closed or full."""

import json

import pytest

from cli.test_streams import VERBS, shell
from printed import without_made_by


@pytest.mark.parametrize("stderr", ["2>&-", "2>/dev/full", "2>&1 >{0} | true; cat {0}"])
def test_without_stderr_an_explorer_prints_into_the_void(stderr, tmp_path):
    file = tmp_path / "loud.py"
    file.write_text(
        "import sys\nprint('imported')\n"
        "from allworlds.explorers.builtin.algorithm1 import algorithm1\n"
        "def explore(first):\n    print('explored')\n    print('!', file=sys.stderr)\n"
        "    return (yield from algorithm1(first))\n"
    )
    stderr = stderr.format(tmp_path / "report")
    code, out, err = shell(f"check {file}:explore --edges 2 --workers 1 --json {stderr}")
    assert (code, err) == (0, "")
    assert json.loads(out)["verdict"] == "holds"


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("verb", "stdout"),
    [
        ("run theta", ">/dev/full"),
        ("count --edges 2", ">&-"),
        *((verb, ">/dev/full") for verb in VERBS),
        # Nobody asked for a help that nobody reads.
        *((verb, to) for verb in VERBS if verb != "--help" for to in (">&-", ">&- <&-")),
    ],
)
def test_a_stdout_that_is_full_or_closed_is_one_line_and_exit_code_70(verb, stdout):
    code, out, err = shell(f"{verb} {stdout}")
    assert (code, out) == (70, "")
    assert err.count("\n") == 1, err
    assert err.startswith("allworlds: ")


@pytest.mark.parametrize("stderr", ["2>/dev/full", "2>&-"])
def test_without_stderr_the_report_is_the_same(cli, stderr):
    code, out, err = cli("check", "--edges", 2, "--workers", 1, "--json")
    assert (code, err) == (0, "")
    code, again, err = shell(f"check --edges 2 --workers 1 --json {stderr}")
    assert (code, err) == (0, "")
    assert without_made_by(again) == without_made_by(out)


def test_all_streams_may_be_closed():
    assert shell("count --edges 2 <&- >&- 2>&-") == (70, "", "")
    assert shell("count --edges x <&- >&- 2>&-") == (2, "", "")
