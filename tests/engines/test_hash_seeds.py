"""Explorers that go by hashes: told from others, and judged so that a report is always the same."""

import pytest

from allworlds.engines.batch import SECOND
from allworlds.engines.limits import Limits
from allworlds.engines.single import played_again, subject_of
from allworlds.judging.differences import side_by_side
from allworlds.studies.check.exhaustive import check

pytestmark = pytest.mark.processes


def test_an_answer_that_is_no_map_is_not_confirmed_by_one_that_is(tmp_path):
    module = tmp_path / "mended.py"
    head = "from allworlds.explorers.builtin.algorithm1 import algorithm1\n\ndef explore(first):\n"
    walk = f"{head}    estimate = yield from algorithm1(first)\n"
    module.write_text(f"{walk}    return 7\n")
    (found,) = check(f"{module}:explore", edges=1).findings
    assert (found.law, found.confirmed) == ("no-estimate", True)
    module.write_text(f"{walk}    return estimate\n")
    explore = f"{module}:explore"
    again = played_again(found, subject_of(explore, Limits()), Limits())
    assert again.law == "nondeterministic"


def test_a_run_is_played_under_more_than_the_two_seeds_that_every_run_has(tmp_path):
    module = tmp_path / "seeded.py"
    module.write_text(
        "import os\nfrom allworlds.explorers.builtin.algorithm1 import algorithm1\n\n"
        "def explore(first):\n    estimate = yield from algorithm1(first)\n"
        f"    return estimate if os.environ['PYTHONHASHSEED'] in ('0', '{SECOND}') else 7\n"
    )
    (found,) = check(f"{module}:explore", edges=1).findings
    assert (found.law, found.hash_seed) == ("no-estimate", SECOND + 1)


def test_two_plays_stand_side_by_side_from_eight_steps_before_they_differ():
    first, second = [*"aaaaaaaaaaaabcdefgh"], [*"aaaaaaaaaaaaxcd"]
    assert side_by_side((first, "ends"), (second, "stops")).splitlines() == [
        "first play, from step 5 on: a, a, a, a, a, a, a, a, b, c, d, e, and 3 more",
        "second play, from step 5 on: a, a, a, a, a, a, a, a, x, c, d, stops",
    ]
