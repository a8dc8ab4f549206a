"""A lighthouse of the user's own, wherever worlds are made."""

import json

import pytest

import allworlds
from allworlds.inputs.checks import InputError
from allworlds.judging.findings.finding import Finding
from allworlds.reports.formats import text
from models import PARITY
from studies import test_own_lighthouse as quick

folder = quick.folder


@pytest.mark.slowest
def test_the_workers_of_a_cluster_get_its_text(folder):
    one = allworlds.check("mine.py:explore", edges=2, lighthouse="parity.py:Parity", workers=1)
    asked = {"edges": 2, "lighthouse": "parity.py:Parity", "workers": 1}
    assert counts(allworlds.check("mine.py:explore", dask="local", **asked)) == counts(one)


def counts(report):
    """All of a report but what the machine has to do with."""
    told = report.to_json()
    return json.dumps({k: told[k] for k in ("verdict", "scope", "rows", "witnesses", "findings")})


@pytest.mark.slowest
@pytest.mark.parametrize("explorer", ["algorithm1", "mine.py:explore"])
def test_a_check_under_it_is_the_same_with_one_worker_and_with_two(folder, explorer):
    one, two = (
        allworlds.check(explorer, edges=2, lighthouse="parity.py:Parity", workers=workers)
        for workers in (1, 2)
    )
    assert counts(one) == counts(two)
    assert one.verdict.value == "refuted"
    assert one.engine == "python"
    (finding,) = one.findings
    assert finding.confirmed
    assert finding.world.lighthouse.code.name == "parity.py:Parity"
    again = Finding.from_json(finding.to_json())
    assert allworlds.replay(again).outcome == "reproduced"
    assert text(one, 100)


@pytest.mark.slowest
def test_a_run_directory_is_of_its_content(folder):
    asked = {"edges": 2, "lighthouse": "parity.py:Parity", "workers": 1}
    first = allworlds.check("mine.py:explore", run="rd", **asked)
    assert counts(allworlds.check("mine.py:explore", run="rd", **asked)) == counts(first)
    assert counts(allworlds.merge("rd")) == counts(first)
    (folder / "parity.py").write_text(PARITY.replace("modulus: int = 2", "modulus: int = 3"))
    with pytest.raises(InputError, match=r"is of another text of 'parity\.py:Parity'"):
        allworlds.check("mine.py:explore", run="rd", **asked)
    assert counts(allworlds.merge("rd")) == counts(first)  # of the text that was recorded
    with pytest.raises(InputError, match="has another text now"):
        Finding.from_json(first.findings[0].to_json())
