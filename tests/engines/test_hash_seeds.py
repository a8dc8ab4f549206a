"""Explorers that go by hashes: told from others, and judged so that a report is always the same."""

import json
import random

import pytest

from allworlds.document import replace
from allworlds.engines import GOES_BY_HASHES, GivenWorlds, LevelRuns, Limits, Scope, Silent
from allworlds.engines.isolation.confirm import repeat
from allworlds.engines.isolation.jobs import PlayerSetup
from allworlds.engines.python.hash_seeds import (
    LAYOUTS,
    GoesByHashes,
    SeededPlays,
    seeds_explain,
    with_more_seeds_if_needed,
)
from allworlds.engines.python.other_seeds import SMALL, other_seeds
from allworlds.engines.python.tour import SEEDS
from allworlds.explorers import load
from allworlds.judging import Log, Over, Rules
from allworlds.maps import Extent, MapClass
from allworlds.studies.check import check
from allworlds.studies.fuzz import fuzz
from allworlds.studies.replay import replay


class Seeded:
    """Players of an explorer whose one action follows from hash seed and layout."""

    def __init__(self, action):
        self.action, self.place, self.met = action, (0, 0), []

    def take_places(self, seed, turn, *, alike):
        assert alike
        self.place = seed, turn
        self.met.append(self.place)

    def send_records(self, records, policy):
        assert policy == "fifo"
        self.records = records

    def receive_logs(self):
        return [log(self.action(*self.place)) for _ in self.records]


def log(action):
    return Log((action,), (), Over())


PLAYS = [SeededPlays(record, log(0), log(5)) for record in range(3)]


def test_seeds_explain_plays_that_every_layout_repeats():
    players = Seeded(lambda seed, _: seed)
    assert seeds_explain(players, 5, PLAYS, "fifo")
    assert players.met == [(seed, layout) for layout in range(1, LAYOUTS + 1) for seed in (0, 5)]


@pytest.mark.parametrize("other", [(0, 1), (5, 1), (0, LAYOUTS), (5, LAYOUTS)])
def test_one_layout_that_repeats_a_play_not_shows_that_seeds_explain_nothing(other):
    players = Seeded(lambda seed, layout: 7 if (seed, layout) == other else seed)
    assert not seeds_explain(players, 5, PLAYS, "fifo")


def test_an_explorer_that_goes_by_a_bit_of_an_address_is_seldom_taken_for_one_that_goes_by_hashes():
    draw = random.Random(1)
    taken = sum(
        seeds_explain(Seeded(lambda *_: 5 * draw.getrandbits(1)), 5, PLAYS[:1], "fifo")
        for _ in range(4096)
    )
    assert taken / 4096 == pytest.approx(2 ** (-2 * LAYOUTS), rel=0.5)


def test_small_units_have_every_other_seed_and_larger_ones_one_each_by_their_names():
    every = [*range(1, SEEDS)]
    assert [*other_seeds(LevelRuns(SMALL, (0,)))] == every
    assert [*other_seeds(GivenWorlds(()))] == every
    larger = [LevelRuns(SMALL + 1, (first, second)) for first in range(8) for second in range(8)]
    seeds = [other_seeds(unit) for unit in larger]
    assert {len(some) for some in seeds} == {1}
    assert {seed for (seed,) in seeds} == set(every)
    assert seeds == [other_seeds(unit) for unit in larger]


def test_an_attempt_is_made_once_more_with_more_seeds_where_they_are_needed():
    scope = Scope(Extent(MapClass.MAPS, 1), Rules("directional"))

    def attempt(scope):
        if not scope.more_seeds:
            raise GoesByHashes
        return scope

    assert with_more_seeds_if_needed(attempt, scope) == replace(scope, more_seeds=True)
    assert with_more_seeds_if_needed(lambda scope: scope, scope) == scope


WALKS_BY_HASHES = """
from allworlds import Move
from allworlds.explorers import algorithm1

def explore(first):
    for digit in f"{hash('a word') % 64:b}":
        for step in (int(digit), 0, -int(digit), 0):
            yield Move(step)
    return (yield from algorithm1(first))
"""
WRONG_WITH_SOME = """
from allworlds.explorers import algorithm1

def explore(first):
    estimate = yield from algorithm1(first)
    wrong = next(iter({"ab", "cd", "ef"})) == "cd" and len(estimate.map.sigma) > 4
    return 7 if wrong else estimate
"""
CHECKS = {
    "walks": (WALKS_BY_HASHES, {"laws": ("map", "pose"), "edges": 3}),
    "wrong": (WRONG_WITH_SOME, {"edges": 4}),
}


class Ends(Silent):
    """Interrupts the job when it has done so many worlds since it has begun anew."""

    def __init__(self, worlds):
        self.left, self.anew = worlds, False

    def notice(self, text):
        self.anew |= text.startswith(GOES_BY_HASHES)

    def progress(self, worlds):
        self.left -= worlds * self.anew
        if self.left < 0:
            raise KeyboardInterrupt


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("name", CHECKS)
def test_a_check_of_an_explorer_that_goes_by_hashes_is_the_same_whenever_that_is_noticed(
    name, tmp_path, monkeypatch
):
    text, options = CHECKS[name]
    tmp_path.joinpath("by_hashes.py").write_text(text)
    monkeypatch.chdir(tmp_path)
    reports = [check("by_hashes.py:explore", workers=workers, **options) for workers in (1, 2, 1)]
    whole = json.dumps(reports[0].to_json())
    assert [json.dumps(report.to_json()) for report in reports[1:]] == [whole] * 2
    assert reports[0].remarks == (GOES_BY_HASHES,)
    if name == "wrong":
        (found,) = reports[0].findings
        assert (found.law, found.minimal, found.confirmed) == ("no-estimate", True, True)
        assert found.world.map.edge_count == 3
        assert replay(found).outcome == "reproduced"
    else:
        assert reports[0].exit_code == 0
    for worlds in (0, 40):
        ended = check(
            "by_hashes.py:explore", workers=1, run="run", listener=Ends(worlds), **options
        )
        assert ended.exit_code in (130, reports[0].exit_code)
    again = check("by_hashes.py:explore", workers=2, run="run", **options)
    assert json.dumps(again.to_json()) == whole


@pytest.mark.slow
@pytest.mark.long
def test_a_sample_of_an_explorer_that_goes_by_hashes_is_shrunk_with_every_seed(tmp_path):
    module = tmp_path / "by_hashes.py"
    # It is right with seed 0, and wrong with seed 1.
    module.write_text(WRONG_WITH_SOME.replace('== "cd"', '!= "ab"'))
    options = {"edges": 5, "runs": 20, "seed": 1, "workers": 1}
    first, second = (fuzz(f"{module}:explore", **options) for _ in range(2))
    assert first.to_json() == second.to_json()
    (found,) = first.findings
    assert found.world.map.edge_count == 3
    assert found.hash_seed is not None


EVERY_OTHER_TIME = """
from pathlib import Path
from allworlds.explorers import algorithm1

def explore(first):
    estimate = yield from algorithm1(first)
    with Path(__file__).with_suffix(".calls").open("a") as calls:
        calls.write(".")
        return 7 if calls.tell() % 2 else estimate
"""


def test_the_finding_of_a_play_that_another_does_not_repeat_has_both(tmp_path):
    module = tmp_path / "chance.py"
    module.write_text(EVERY_OTHER_TIME)
    laws = set()
    for _ in range(3):
        report = check(f"{module}:explore", edges=1)
        (found,) = report.findings
        laws.add(found.law)
        assert (found.confirmed, found.hash_seed) == (True, None)
        assert report.remarks == ()
        assert "first play, from step" in found.detail
        assert "second play, from step" in found.detail
    assert laws == {"nondeterministic"}


def test_an_answer_that_is_no_map_is_not_confirmed_by_one_that_is(tmp_path):
    module = tmp_path / "mended.py"
    head = "from allworlds.explorers import algorithm1\n\ndef explore(first):\n"
    walk = f"{head}    estimate = yield from algorithm1(first)\n"
    module.write_text(f"{walk}    return 7\n")
    (found,) = check(f"{module}:explore", edges=1).findings
    assert (found.law, found.confirmed) == ("no-estimate", True)
    module.write_text(f"{walk}    return estimate\n")
    again = repeat(found, PlayerSetup.of(load(f"{module}:explore"), Limits()))
    assert again.law == "nondeterministic"
