"""The ledger of the paper's sentences: its laws, small scopes, and false claims."""

import pytest

import complexity
import position
from allworlds import World
from allworlds.claims import Means, NotChecked
from allworlds.maps import named_map
from paper_claims import BY_NAME, CLAIMS
from paper_laws import (
    really_fails_when_changed,
    test_a_statement_says_by_itself_what_is_claimed,  # noqa: F401
    test_a_theorem_that_a_claim_points_to_stands_there_and_is_pinned,  # noqa: F401
    test_each_expected_verdict_and_number_matters,  # noqa: F401
    test_every_claim_has_its_function_and_every_function_its_claim,  # noqa: F401
    test_no_function_reads_what_is_expected,  # noqa: F401
    test_the_quick_ledger_is_as_expected_and_no_number_of_it_is_idle,  # noqa: F401
    verdict,
)


def test_there_are_claims_from_every_section():
    assert len(CLAIMS) >= 60
    sections = {claim.section for claim in CLAIMS}
    assert sections == {"II", "III", "IV", "V", "VI", "VII", "VIII", "beyond the paper"}


@pytest.mark.parametrize(
    "name", ["printed-3", "printed-limit-of-2", "lower-bound-2m", "natural-multigraphs"]
)
def test_an_erratum_is_expected_to_be_refuted(name):
    assert BY_NAME[name].expected == "refuted"


@pytest.mark.parametrize(
    "name",
    ["fig1", "fig1-caption", "printed-3", "lower-bound-2m", "pass-kinds", "printed-limit-of-2"],
)
def test_each_expected_number_matters_beside_what_is_really_found(name):
    assert really_fails_when_changed(name) >= 2


def test_sympy_is_asked_only_where_it_is(monkeypatch):
    monkeypatch.setattr(complexity, "find_spec", lambda _name: None)
    found = complexity.terms_left_out(Means(1), edges=2)
    assert isinstance(found, NotChecked)
    assert ".[proofs]" in found.reason


SMALL = {
    "marker-tells-entry": {"edges": 2},
    "orders-are-shifts": {"edges": 2},
    "two-door-rooms": {"length": 3},
    "orientation-alone": {"length": 4},
    "position-tells-cycles": {"length": 4},
    "position-not-enough": {"pairs": ["pair-two-loops", "pair-k4"]},
    "lighthouse-suffices": {"edges": 2},
    "every-schedule": {"edges": 1, "most_expensive": 2},
    "signature-readings": {"edges": 2, "policies": ["fifo"]},
    "marker-on-the-way": {"edges": 3},
    "tests-decide": {"edges": 3},
    "not-both": {"edges": 3},
    "direction-needed": {},
    "no-twins-with-direction": {"edges": 2},
    "no-twins-smt": {"edges": 2},
    "invariant-at-start": {"edges": 2},
    "invariant-kept": {"edges": 2},
    "variant-falls": {"edges": 2},
    "every-edge-walked": {"edges": 2},
    "dfs-2m": {"edges": 2},
    "pass-hypotheses": {"edges": 2, "policies": ["fifo"]},
    "pass-tests": {"edges": 3, "policies": ["lifo"]},
    "bound": {"edges": 2},
    "order-reached": {"family": "thick:4", "to": 30, "growing": 0.5},
    "below-bound": {"families": ["lattice:3x3"], "seeds": 1, "share": 1.0},
    "means-above-2m": {
        "families": ["lattice:3x3"],
        "seeds": 1,
        "policies": ["fifo"],
        "times": 2,
    },
    "cluster": {"edges": 4},
    "natural": {"edges": 4},
    "cluster-multigraphs": {"edges": 2},
    "two-vertices-order": {"edges": 3},
}


@pytest.mark.parametrize("name", SMALL)
def test_a_claim_holds_in_a_small_scope_too(name):
    assert verdict(name, **SMALL[name]) == "holds"


@pytest.mark.parametrize(
    ("name", "bounds"),
    [
        ("movable-marker-multigraphs", {"edges": 2}),
        ("natural-multigraphs", {"edges": 4}),
        ("order-reached", {"family": "thick:4", "to": 30, "growing": 9.0}),
    ],
)
def test_a_claim_that_is_false_is_refuted(name, bounds):
    assert verdict(name, **bounds) == "refuted"


def test_two_worlds_that_are_one_are_no_pair(monkeypatch):
    world = World(named_map("k4"), "directional")
    monkeypatch.setattr(position, "pair_of_corpus", lambda _name: (world, world))
    assert verdict("position-not-enough", pairs=["pair-two-loops"]) == "refuted"


def test_the_marker_that_moves_does_well_where_no_world_is_too_hard():
    assert verdict("movable-marker-multigraphs", edges=1) == "holds"


@pytest.mark.parametrize(
    ("claim", "witness", "found"),
    [
        (position.cycles, "pairs", 15),
        (position.position_tells_cycles, "pairs", 15),
        (position.orientation_alone, "pairs", 15),
        (position.two_door_rooms, "cycles", 6),
        (complexity.lower_bound_2m, "cycles", 5),  # from two edges on
    ],
)
def test_a_claim_on_cycles_is_about_all_that_it_names(claim, witness, found):
    assert claim(Means(1), length=6).witnesses[witness] == found
