"""A lighthouse, a task and a class of the user's own at once, in every way to run a check."""

import json

import pytest

import allworlds
from allworlds.reports.formats import file_of
from allworlds.testing import assert_explores
from studies import test_own_models as quick
from studies.test_own_models import ASKED, WRONG

folder = quick.folder


@pytest.mark.slowest
def test_a_cluster_changes_nothing(folder):
    one = allworlds.check("mine.py:walks", workers=1, **WRONG)
    assert counts(allworlds.check("mine.py:walks", dask="local", workers=1, **WRONG)) == counts(one)


def counts(report):
    """All of a report but what the machine has to do with."""
    told = report.to_json()
    return json.dumps({k: told[k] for k in ("verdict", "scope", "rows", "witnesses", "findings")})


@pytest.mark.slowest
@pytest.mark.parametrize("asked", [ASKED, WRONG], ids=["holds", "refuted"])
def test_workers_and_run_directories_change_nothing(folder, asked):
    one = allworlds.check("mine.py:walks", workers=1, **asked)
    assert one.verdict.value == ("holds" if asked is ASKED else "refuted")
    if asked is ASKED:
        assert counts(assert_explores("mine.py:walks", **asked)) == counts(one)
    assert counts(allworlds.check("mine.py:walks", workers=2, **asked)) == counts(one)
    assert counts(allworlds.check("mine.py:walks", run="rd", **asked)) == counts(one)
    assert counts(allworlds.merge("rd")) == counts(one)
    for shard in (0, 1):
        allworlds.check("mine.py:walks", shard=(shard, 2), run=f"{shard}", **asked)
    assert allworlds.merge("0", "1").to_json()["rows"] == one.to_json()["rows"]


def test_one_run_with_its_page_and_a_pytest_take_them(folder):
    (finding,) = allworlds.check("mine.py:walks", **WRONG).findings
    run = allworlds.run("mine.py:walks", finding.world, task=WRONG["task"])
    assert run.finding.law == "task"
    page = file_of("html", run)
    assert "done is said" in page
    assert "models.py:says?word=home" in page
    with pytest.raises(AssertionError, match="task"):
        assert_explores("mine.py:walks", **WRONG)
