"""The ledger of a paper: found beside expected, and whatever is changed of that, a claim fails."""

import pytest

import allworlds
from allworlds.inputs.checks import InputError
from allworlds.outcome import Exit
from allworlds.studies.ledger import Unfinished, of_check


@pytest.mark.slowest
def test_a_check_without_a_verdict_decides_no_claim():
    with pytest.raises(Unfinished, match="inconclusive"):
        of_check(allworlds.check("algorithm1", edges=5, time_limit=1e-9))


@pytest.mark.slowest
@pytest.mark.parametrize("budget", ["quick", "full"])
def test_the_ledger_that_init_writes_runs(tmp_path, budget):
    made = allworlds.init(tmp_path / "mine", ledger=True)
    assert made.files == ("claims.py", "ledger.toml")
    report = allworlds.ledger(tmp_path / "mine", budget=budget)
    assert [one.standing for one in report.claims] == ["as-expected", "as-expected"]
    assert report.exit_code == Exit.HOLDS
    with pytest.raises(InputError, match="nothing is overwritten"):
        allworlds.init(tmp_path / "mine", ledger=True)
