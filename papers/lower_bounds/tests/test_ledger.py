"""The ledger of the claims on lower bounds: its laws, small scopes, and false claims."""

import pytest

import optima
from allworlds.claims import Means, Unfinished
from paper_claims import CLAIMS
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


def test_there_are_as_many_claims_as_were_made():
    assert len(CLAIMS) == 36


@pytest.mark.parametrize("name", ["smallest-twins", "two-sheets", "every-explorer-mn-log"])
def test_each_expected_number_matters_beside_what_is_really_found(name):
    assert really_fails_when_changed(name) >= 2


SMALL = {
    "exact-worst": {"edges": 2},
    "optimum": {"edges": 2},
    "remembering-never-more": {"edges": 3, "one": "remembering", "other": "algorithm1"},
    "never-forgetting-in-bound": {"edges": 3, "explorers": ["greedy"]},
    "logs-fold": {"edges": 2},
    "folding-explores": {"edges": 2},
    "entries-of-v0": {"edges": 2, "explorers": ["greedy"]},
    "path-lower-bound": {"sizes": [[3, 2]], "explorers": ["algorithm1"]},
    "smallest-twins": {"edges": 2},
    "two-sheets": {"edges": 2},
    "lookalikes-one-size": {"edges": 2},
    "trees-need-none": {"edges": 2},
    "position-robot": {"edges": 2},
}


@pytest.mark.parametrize("name", SMALL)
def test_a_claim_holds_in_a_small_scope_too(name):
    assert verdict(name, **SMALL[name]) == "holds"


@pytest.mark.parametrize(
    ("name", "bounds"),
    [
        ("greedy-never-more", {"edges": 3, "one": "greedy", "other": "algorithm1"}),
        ("smallest-twins", {"edges": 1}),
    ],
)
def test_a_claim_that_is_false_is_refuted(name, bounds):
    assert verdict(name, **bounds) == "refuted"


def test_an_explorer_that_breaks_a_law_is_no_measure_for_another():
    with pytest.raises(Unfinished, match="breaks a law"):
        optima.run_by_run(Means(1), edges=2, one="dudek91", other="algorithm1")
