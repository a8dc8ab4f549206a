"""The hypotheses that are heard in a run, held against the world."""

import pytest

from allworlds.studies.run.hypotheses import TELLING
from studies import test_hypotheses as quick


@pytest.mark.parametrize(
    ("explorer", "edges"),
    [*((name, 4) for name in TELLING)],
)
def test_a_hypothesis_is_right_just_where_it_is_true(explorer, edges):
    quick.test_a_hypothesis_is_right_just_where_it_is_true(explorer, edges)
