"""Both plays have other hash seeds and addresses, and there are not too many of them."""

from itertools import pairwise

import pytest

from allworlds.document import replace
from allworlds.engines.python.tour import APART, BEGINNING, BEHIND, SEEDS, SPELL, Tour
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


def places_of(tour, plays, **options):
    """The places of both players before each of some second plays, made one by one."""
    met = []
    for _ in range(plays):
        tour.change(1, **options)
        met.append(tour.places)
        tour.count(1)
    return met


def test_places_are_held_for_so_many_plays_and_no_longer():
    held, free = Tour(), Tour()
    for tour in (held, free):
        places_of(tour, BEGINNING)
    held.hold(3)
    assert {*places_of(held, 3)} == {Tour().places}
    assert places_of(held, 1)[0] == places_of(free, 1)[0] != Tour().places


def test_every_seed_has_its_turn_in_a_thousand_plays():
    tour = Tour()
    met = places_of(tour, 8 * SPELL)
    assert {first for first, _ in met} == {(0, 0)}
    assert [second for _, second in dict.fromkeys(met)] == [(seed, 0) for seed in range(1, SEEDS)]
    assert met.index(((0, 0), (2, 0))) == BEGINNING
    assert tour.complete


def test_later_layouts_change_less_and_less():
    tour, changes = Tour(), 0
    for _ in range(100_000):
        changes += tour.change()
        tour.count(1)
    assert SEEDS < changes < 4 * SEEDS


def test_players_of_one_seed_meet_every_layout():
    tour = Tour(3, alike=True)
    met = {*places_of(tour, 8 * SPELL)}
    assert met == {((3, 0), (3, copy)) for copy in range(1, SEEDS)}
    assert (tour.hash_seed, tour.differ) == (3, False)


def test_a_tour_that_stays_does_not_change():
    tour = Tour(5, alike=True, stays=True)
    tour.count(10 * BEGINNING)
    assert not tour.change()
    assert (tour.places, tour.complete, tour.upcoming) == (((5, 0), (5, 1)), True, None)


def test_a_library_comes_home_and_visits_other_processes_at_growing_intervals():
    tour, visits = Tour(at_home=True), []
    for play in range(1 << 20):
        if tour.change(1) and not tour.is_home:
            visits.append((play, tour.turn))
        tour.count(1)
        if tour.is_home:
            assert tour.places[1] == (0, 0)
    assert [turn for _, turn in visits[: SEEDS - 2]] == [*range(2, SEEDS)]
    later = visits[SEEDS - 2 :]
    assert [turn for _, turn in later] == [*range(1, len(later) + 1)]
    assert len(later) == 5
    assert all(3 < b / a < 4 for (a, _), (b, _) in pairwise(later))


def test_a_visit_waits_for_a_short_stretch_and_is_left_out_if_compiled_code_must_play():
    tour = Tour(at_home=True)
    while not tour.is_home or tour.complete:
        tour.change(1)
        tour.count(1)
    tour.count(1 << 12)
    assert not tour.change(SPELL << 3)
    assert tour.is_home
    assert tour.change(SPELL << 3, may_visit=False)
    assert tour.is_home
    assert tour.complete


def test_in_the_long_run_both_players_of_a_library_come_from_processes_of_their_own():
    tour = Tour(at_home=True)
    tour.count(APART)
    while not tour.is_home:
        tour.change(1)
        tour.count(1)
    assert tour.places == ((0, 0), (0, BEHIND))


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


@pytest.mark.parametrize("name", ["{}:explore", "{}", "native:{}", "exec:{}", "exec:python3 {}"])
def test_a_loop_of_links_is_no_file_and_is_told_as_what_it_is(tmp_path, name):
    one, other = tmp_path / "one.py", tmp_path / "other.py"
    one.symlink_to(other)
    other.symlink_to(one)
    with pytest.raises(InputError, match=r"one\.py'.* is a loop of links"):
        check(name.format(one), edges=1)


@pytest.mark.parametrize("option", ["where", "task", "lighthouse"])
def test_a_loop_of_links_is_no_model(tmp_path, option):
    loop = tmp_path / "loop.py"
    loop.symlink_to(loop)
    with pytest.raises(InputError, match=r"loop\.py' is a loop of links"):
        check(edges=1, **{option: f"{loop}:Model"})


@pytest.mark.parametrize("option", ["where", "task", "lighthouse"])
@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("while True: pass", "Model"),
        ("import time\ntry: time.sleep(1000)\nexcept Exception: time.sleep(1000)", "Model"),
        ("def make(size):\n    while True: pass", "make?size=1"),
    ],
)
def test_a_model_that_is_too_long_in_being_imported_is_refused_by_name(
    tmp_path, option, text, name
):
    module = tmp_path / "loops.py"
    module.write_text(text)
    said = r"loops\.py:.* does not import: it was at it for 0\.2 s"
    with pytest.raises(InputError, match=said):
        check(edges=1, start_timeout=0.2, **{option: f"{module}:{name}"})


def test_a_model_has_the_time_that_it_needs_to_be_imported(tmp_path):
    module = tmp_path / "slow.py"
    module.write_text("import time\ntime.sleep(0.4)\ndef plain(map_): return True\n")
    with pytest.raises(InputError, match=r"it was at it for 0\.2 s"):
        check(edges=1, start_timeout=0.2, where=f"{module}:plain")
    assert check(edges=1, start_timeout=60, where=f"{module}:plain").exit_code == 0
