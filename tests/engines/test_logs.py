"""The bytes of a log that is judged: choices are passed over, unknown codes are strange."""

import pytest

from allworlds.engines.compiled_engine import level_of
from allworlds.engines.kernel.arrays import Stretch
from allworlds.engines.kernel.engine import UnitJudge
from allworlds.engines.players import Logs
from allworlds.judging.differences import difference_of
from allworlds.judging.rules import Rules
from allworlds.log import ANSWERED, BEYOND as STRANGE, CHOICE, SHOWN, Log
from allworlds.maps.classes import Extent, MapClass

pytestmark = pytest.mark.usefixtures("compiled")


def entry(code, sigma, alpha, here):
    return bytes((code, len(sigma), here, *sigma, *alpha))


# In the world with one edge and two vertices.
EDGE = entry(SHOWN, (0, 1), (1, 0), 1)
ANSWER = entry(ANSWERED, (0, 1), (1, 0), 1)
CHOSEN = bytes((CHOICE, 1, 2))
PLAIN = bytes((0,)) + EDGE + ANSWER


def judged(log, laws=("map", "pose")):
    """The judge of the one run, its rows, and whether the log could be judged."""
    rules = Rules(step_budget=9, laws=laws, bound="none")
    level = level_of("", rules, Extent(MapClass.MAPS, 1), 1)
    first, second = (Stretch.of(level.edges) for _ in range(2))
    judge = UnitJudge(level, (-1,), 1, first, second)
    batch = judge.lay_out(10)
    assert batch.runs == 1
    rows, good = judge.judge(batch, first.put(Logs.of([log])))
    return judge, second, rows, good


def test_choices_are_passed_over_wherever_they_stand():
    plain = judged(PLAIN)[2]
    assert plain.broken == ()
    for log in (CHOSEN + PLAIN, bytes((0,)) + CHOSEN + EDGE + CHOSEN + CHOSEN + ANSWER):
        _, _, rows, good = judged(log)
        assert good
        assert rows == plain


@pytest.mark.parametrize(
    ("again", "differ"),
    [
        (PLAIN, False),
        (CHOSEN + PLAIN, False),
        (bytes((0,)) + ANSWER, False),
        (bytes((CHOICE, 0, 2)) + PLAIN, False),
        (CHOSEN + bytes((0, 0)) + ANSWER, True),
        (bytes((0,)) + entry(ANSWERED, (0, 1), (1, 0), 0), True),
    ],
)
def test_the_second_log_is_compared_without_its_choices_and_checkpoints(again, differ):
    assert (difference_of(Log(PLAIN), Log(again)) is not None) is differ


@pytest.mark.parametrize("code", [STRANGE, *(code for code in range(206, 256) if code != CHOICE)])
def test_a_code_that_means_nothing_is_strange(code):
    _, _, rows, good = judged(bytes((code, 0, 2)) + PLAIN)
    assert not good
    assert [each.law for each in rows.broken] == ["illegal-action"]


def test_a_choice_that_is_cut_off_is_strange():
    assert not judged(CHOSEN[:2])[3]


def test_an_edge_that_is_open_on_one_side_counts_as_explored():
    alone, half_open = entry(SHOWN, (0,), (0,), 0), entry(SHOWN, (0, 1), (0, 0), 1)
    log = alone + bytes((0,)) + half_open + ANSWER
    assert judged(log, ("variant",))[2].broken == ()
    (broken,) = judged(log, ("variant", "invariant-2"))[2].broken
    assert broken.law == "invariant-2"
    (again,) = judged(half_open + log, ("variant",))[2].broken
    assert again.law == "variant"
