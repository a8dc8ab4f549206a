"""Both plays have hash seeds of their own, and there are not too many of them."""

import pytest

from allworlds import run, worlds
from allworlds.documents.document import replace
from allworlds.judging.findings.finding import Finding
from allworlds.studies.check.exhaustive import check
from allworlds.studies.run import replay
from engines import test_seeds as quick
from engines.test_seeds import GOES_BY_ORDER

pytestmark = pytest.mark.processes


@pytest.mark.slowest
@pytest.mark.parametrize(("edges", "workers"), [(1, 1), (2, 2), (4, 1)])
def test_there_are_two_plays_a_run_and_more_under_other_seeds(tmp_path, edges, workers):
    quick.test_there_are_two_plays_a_run_and_more_under_other_seeds(tmp_path, edges, workers)


def test_a_finding_carries_the_hash_seed_that_decides_and_replay_sets_it(tmp_path):
    module = tmp_path / "order.py"
    module.write_text(GOES_BY_ORDER)
    report = check(f"{module}:explore", edges=1)
    (found,) = report.findings
    assert (found.law, found.confirmed) == ("no-estimate", True)
    assert found.hash_seed in (0, 1)
    assert found.reproduce.startswith(f"PYTHONHASHSEED={found.hash_seed} allworlds run ")
    again = Finding.from_json(found.to_json())
    assert again.hash_seed == found.hash_seed
    assert replay(again).outcome == "reproduced"
    other = replay(Finding.from_json({**found.to_json(), "hash_seed": 1 - found.hash_seed}))
    assert other.outcome == "fixed"


COUNTS_ITS_RUNS = """
from pathlib import Path
from allworlds.explorers.builtin.algorithm1 import algorithm1

RUNS = Path({file!r})

def explore(first):
    with RUNS.open("a") as runs:
        runs.write("x")
    estimate = yield from algorithm1(first)
    return 7 if {wrong} else estimate
"""


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("later", "outcome", "plays"),
    [("len(RUNS.read_text()) >= 6", ("reproduced", 0), 6), ("False", ("not-reproduced", 3), 16)],
)
def test_a_run_that_is_the_same_again_does_not_show_that_it_always_is(
    tmp_path, later, outcome, plays
):
    module, runs = tmp_path / "counts.py", tmp_path / "runs"
    module.write_text(COUNTS_ITS_RUNS.format(file=str(runs), wrong="RUNS.stat().st_size == 2"))
    (found,) = check(f"{module}:explore", edges=1).findings
    found = replace(found, law="nondeterministic")  # or no-estimate, as the plays happen to come
    module.write_text(COUNTS_ITS_RUNS.format(file=str(runs), wrong=later))
    runs.write_text("")
    again = replay(found)
    assert (again.outcome, again.exit_code) == outcome
    assert len(runs.read_text()) >= plays


def test_a_run_has_the_hash_seed_of_the_environment(tmp_path, monkeypatch):
    module = tmp_path / "order.py"
    module.write_text(GOES_BY_ORDER)
    codes = set()
    for seed in ("0", "1"):
        monkeypatch.setenv("PYTHONHASHSEED", seed)
        codes.add(run(f"{module}:explore", next(worlds(edges=1))).exit_code)
    assert codes == {0, 1}
