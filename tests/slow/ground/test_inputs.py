"""Whatever is given, the answer keeps the law of inputs; and a fault that breaks it is found.

Two thousand cases are drawn from a seed: the same every time, on every machine.  Each is named
``SEED/NUMBER`` and drawn from its name alone.  ``INPUTS_SEED=7 pytest tests/ground -m ''``
draws others.
"""

import pytest

from ground import test_inputs as quick
from ground.cases import cases
from ground.law import tried
from ground.test_inputs import ALL, PART, QUICK, SEED
from small import slowest

folder = quick.folder

pytestmark = pytest.mark.usefixtures("without_workers")


@pytest.mark.slowest
@pytest.mark.parametrize("first", [0, *map(slowest, range(PART, ALL, PART))])
def test_every_input_is_answered_or_refused_in_one_line(first, folder):
    keep_the_law(range(first, first + PART), folder)


def keep_the_law(numbers, folder):
    for name, case in cases(SEED, numbers):
        broken = tried(case, folder)
        assert not broken, f"case {name}: {', '.join(broken)}\n{case}"


def test_an_input_is_answered_or_refused_in_one_line(folder):
    keep_the_law(range(QUICK), folder)
