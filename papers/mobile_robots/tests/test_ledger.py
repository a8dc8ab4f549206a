"""The ledger of the claims on mobile robots: its laws, small scopes, and the checks beside it."""

import ast

import pytest

import check
from allworlds.robots import named_model
from companions import across
from exploring import as_steps, collisions
from paper_claims import CLAIMS, PAPER
from paper_laws import (
    really_fails_when_changed,
    test_a_statement_says_by_itself_what_is_claimed,  # noqa: F401
    test_each_expected_verdict_and_number_matters,  # noqa: F401
    test_every_claim_has_its_function_and_every_function_its_claim,  # noqa: F401
    test_no_function_reads_what_is_expected,  # noqa: F401
    test_the_quick_ledger_is_as_expected_and_no_number_of_it_is_idle,  # noqa: F401
    verdict,
)
from perpetual import new, old
from worlds import SCHEDULERS, named, places_of, ring, steps_by


def test_there_are_as_many_claims_as_were_made():
    assert len(CLAIMS) == 33


@pytest.mark.parametrize("name", ["shrink-named", "lights", "hole-lost-update"])
def test_each_expected_number_matters_beside_what_is_really_found(name):
    assert really_fails_when_changed(name) >= 2


SMALL = {
    "shrink-worlds": {"edges": 5},
    "shrink-positive": {"rings": [3], "edges": 3},
    "delays": {"rings": [5], "most": 2},
    "tokens-facing": {"vertices": 5},
    "rotor-worst": {"edges": 3},
    "lcm-counts": {"least": 5, "most": 6},
    "rule-sets-all": {"vertices": 4, "towers": False},
    "perpetual-none": {"one": 3, "two": 4, "three": 4},
    "stopping": {"cases": [[4, 2]]},
    "dynamic-two": {"vertices": 3},
    "hole-lost-update": {"vertices": 4},
}


@pytest.mark.parametrize("name", SMALL)
def test_a_claim_holds_in_a_small_scope_too(name):
    assert verdict(name, **SMALL[name]) == "holds"


def test_the_program_of_reasons_imports_nothing_of_the_package():
    tree = ast.parse((PAPER / "check.py").read_text(encoding="utf-8"))
    imports = [each for each in ast.walk(tree) if isinstance(each, ast.Import | ast.ImportFrom)]
    modules = {getattr(each, "module", "") for each in imports}
    assert modules == {"__future__", "collections.abc", "fractions", "itertools"}


def test_two_that_look_alike_on_a_square_are_kept_apart_and_on_a_path_of_three_are_not():
    square, path = ring(4), ((0, 2, 1, 3), (1, 0, 3, 2))
    assert check.never_together(square.sigma, square.alpha, 0, 4)
    assert check.never_together(square.sigma, square.alpha, 0, 4, delay=1)
    assert not check.never_together(square.sigma, square.alpha, 0, 4, delay=2)
    assert check.kept_apart(square.sigma, square.alpha, (0, 4))
    assert not check.never_together(*path, 0, 3)
    assert not check.kept_apart(*path, (0, 3))


@pytest.fixture(scope="module")
def collision():
    """The start of a collision, and its events."""
    start, found = collisions(10)[0]
    return places_of(start), as_steps(found)


def test_a_replay_takes_no_event_away_and_no_other_decision(collision):
    start, events = collision
    assert check.replayed(10, start, events, steps_by(old))
    assert not check.replayed(10, start, events[:-1], steps_by(old))
    assert not check.replayed(10, start, events, steps_by(new))
    wrong = [[(robot, step and -step) for robot, step in event] for event in events]
    assert not check.replayed(10, start, wrong, steps_by(old))
    assert not check.replayed(10, start, [*events, []], steps_by(old))


def test_a_ring_with_a_missing_edge_is_walked():
    right, no_edge = {0: 0}, (None, [])
    on = [(right, *no_edge), ({0: 1}, *no_edge)]
    assert check.left_out(3, [0], on) == 0
    assert check.left_out(3, [0], [(right, 0, []), (right, 0, [])]) == 2
    assert check.left_out(3, [0], [(right, None, [0]), (right, None, [0])]) == 2


def test_a_whole_activation_is_a_look_and_a_move_and_else_each_is_a_step():
    def on(memory, _percept):
        return memory, None, 0

    assert check.swallowed(3, 1, [None, None], on, [[0], [1]], whole=True) == 2
    assert check.swallowed(3, 1, [None, None], on, [[0], [1]]) == 0
    assert check.swallowed(3, 1, [None, None], on, [[0], [1], [0, 1]]) == 2


def test_two_that_swap_on_a_ring_of_two_do_not_gather_unless_one_moves_alone():
    met = [check.gathers((0, 1), 2, across, scheduler) for scheduler in SCHEDULERS]
    assert met == [False, False, True, False]


def test_lights_that_change_at_once_do_not_come_back():
    rules = {("b", "b"): ("w", "0"), ("b", "w"): None, ("w", "b"): ("w", "1"), ("w", "w"): None}
    assert not check.apart_for_ever(rules, [[0], [0], [0], [0]], "b")


def test_models_are_named():
    assert named("tokens:movable=false") == named_model("tokens:movable=false").model
