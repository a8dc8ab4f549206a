"""Rules: the numbers and names that are legal, and the first that are not."""

import pytest

from allworlds.inputs.checks import InputError
from allworlds.judging.rules import RuleOptions


@pytest.mark.parametrize(("budget", "legal"), [(1, True), (None, True), (0, False), (-1, False)])
def test_a_step_budget_is_positive(budget, legal):
    if legal:
        assert RuleOptions(step_budget=budget).step_budget == budget
    else:
        with pytest.raises(InputError, match=f"step budget {budget} is not positive"):
            RuleOptions(step_budget=budget)


@pytest.mark.parametrize(
    ("laws", "told"),
    [
        (("map", "pose", "map"), "law 'map' is named twice"),
        (("map", "mop"), "law 'mop' is not one of "),
        ((), r"laws = .* names no law; legal are "),
        ("map", "laws = 'map' is not a list of names of "),
        (5, "laws = 5 is not a list of names of "),
    ],
)
def test_laws_are_a_list_of_different_names(laws, told):
    assert RuleOptions(laws=("map",)).laws == ("map",)
    assert RuleOptions(laws=None).laws is None
    with pytest.raises(InputError, match=told):
        RuleOptions(laws=laws)
