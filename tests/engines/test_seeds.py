"""Both plays have other hash seeds and addresses, and there are not too many of them."""

import pytest

from allworlds.document import replace
from allworlds.engines.python.tour import BEGINNING, SEEDS, SPELL, Tour
from allworlds.inputs import InputError
from allworlds.judging import Finding
from allworlds.studies.check import check
from allworlds.studies.replay import replay

COUNTS = """
from allworlds.explorers import algorithm1

def explore(first):
    with open({file!r}, "a") as plays:
        plays.write("x")
    return (yield from algorithm1(first))
"""
GOES_BY_ORDER = """
from allworlds.explorers import algorithm1

def explore(first):
    estimate = yield from algorithm1(first)
    return estimate if [*{"left", "right"}] == ["left", "right"] else 7
"""


def test_every_seed_has_its_turn_in_a_thousand_plays():
    tour, met = Tour(), []
    for _ in range(8 * SPELL):
        tour.change()
        tour.count(1)
        met.append(tour.seeds)
    assert {first for first, _ in met} == {0}
    assert [second for _, second in dict.fromkeys(met)] == [*range(1, SEEDS)]
    assert met.index((0, 2)) == BEGINNING
    assert tour.complete


def test_later_seeds_change_less_and_less():
    tour, changes = Tour(), 0
    for _ in range(100_000):
        changes += tour.change()
        tour.count(1)
    assert SEEDS < changes < 4 * SEEDS


def test_players_of_one_seed_have_every_seed():
    tour = Tour(3, alike=True)
    met = {tour.seeds}
    for _ in range(16 * SPELL):
        tour.change()
        tour.count(1)
        met.add(tour.seeds)
    assert met == {(seed, seed) for seed in range(SEEDS)}
    assert tour.hash_seed in range(SEEDS)


def test_a_tour_that_stays_does_not_change():
    tour = Tour(5, alike=True, stays=True)
    tour.count(10 * BEGINNING)
    assert not tour.change()
    assert (tour.seeds, tour.complete, tour.upcoming) == ((5, 5), True, None)


@pytest.mark.parametrize(
    ("edges", "workers"), [(1, 1), (2, 1), (2, 2), pytest.param(4, 1, marks=pytest.mark.slow)]
)
def test_there_are_three_plays_a_run_and_twenty_at_most(tmp_path, edges, workers):
    plays, module = tmp_path / "plays", tmp_path / "counts.py"
    module.write_text(COUNTS.format(file=str(plays)))
    report = check(f"{module}:explore", edges=edges, workers=workers)
    assert report.exit_code == 0
    spare = 20 if report.runs < 1000 else 0
    assert 2 * report.runs <= len(plays.read_text()) <= 3 * report.runs + spare


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
from allworlds.explorers import algorithm1

RUNS = Path({file!r})

def explore(first):
    with RUNS.open("a") as runs:
        runs.write("x")
    estimate = yield from algorithm1(first)
    return 7 if {wrong} else estimate
"""


@pytest.mark.parametrize(
    ("later", "outcome", "plays"),
    [("False", ("not-reproduced", 3), 16), ("len(RUNS.read_text()) == 6", ("reproduced", 0), 6)],
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


def test_an_explorer_that_is_too_long_in_being_imported_is_refused_by_name(tmp_path):
    module = tmp_path / "slow.py"
    module.write_text("import time\ntime.sleep(1000)\ndef explore(first): yield\n")
    said = r"slow.py:explore.* does not import: it was at it for 1 s"
    with pytest.raises(InputError, match=said):
        check(f"{module}:explore", edges=1, start_timeout=1)


@pytest.mark.parametrize("name", ["{}:explore", "native:{}"])
def test_a_loop_of_links_is_no_file(tmp_path, name):
    one, other = tmp_path / "one.py", tmp_path / "other.py"
    one.symlink_to(other)
    other.symlink_to(one)
    with pytest.raises(InputError, match="there is no"):
        check(name.format(one), edges=1)
