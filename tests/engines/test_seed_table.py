"""The meaning of hash seeds, row by row of its table; no process is started."""

from itertools import product
from operator import ne
from types import SimpleNamespace

import pytest

from allworlds.engines import hash_seeds
from allworlds.judging.laws.law_table import Violation
from allworlds.judging.referee import Outcome

WRONG = Violation("map", "that map", "another one")


def outcome(violation):
    return Outcome(SimpleNamespace(), violation, "", (), None)


@pytest.mark.parametrize("seeds", [(0, 1), (0, 0)])
@pytest.mark.parametrize("fresh", [*product("ab", repeat=4)])
def test_seeds_explain_what_fresh_players_repeat_each_time_under_two_seeds(seeds, fresh):
    plays = [("a", fresh[:2]), ("b", fresh[2:])]
    explained = seeds == (0, 1) and fresh == ("a", "a", "b", "b")
    assert hash_seeds.explain(seeds, plays, ne) is explained


@pytest.mark.parametrize(
    ("first", "second", "seed"),
    [(None, None, None), (WRONG, None, 0), (None, WRONG, 2), (WRONG, WRONG, 0)],
)
def test_a_run_is_right_if_it_is_with_each_seed(first, second, seed):
    found = hash_seeds.by_seed((0, 2), outcome(first), outcome(second))
    assert (found and found.hash_seed) == seed
    assert (found is None) == (first is None and second is None)


@pytest.mark.parametrize(
    ("from_user", "importable", "compiled", "seeds"),
    [
        (from_user, importable, compiled, (0, int(from_user and importable and not compiled)))
        for from_user, importable, compiled in product([True, False], repeat=3)
    ],
)
def test_a_player_has_a_seed_of_its_own_if_it_is_a_process_with_python(
    from_user, importable, compiled, seeds
):
    subject = SimpleNamespace(
        name="mine:explore", from_user=from_user, importable=importable, compiled=compiled
    )
    assert hash_seeds.seeds_of(subject) == seeds
    assert hash_seeds.across(seeds) == (0, 2 * seeds[1])
    assert hash_seeds.are_more_tried(subject, seeds) is (seeds == (0, 1))


def test_no_more_seeds_are_tried_of_a_program_or_with_a_seed_that_was_told():
    subject = SimpleNamespace(name="exec:mine", from_user=True)
    assert not hash_seeds.are_more_tried(subject, (0, 1))
    subject.name = "mine:explore"
    assert not hash_seeds.are_more_tried(subject, (3, 3))
