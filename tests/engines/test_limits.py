"""Limits of the effort: the largest and the least legal values, and the first that are not."""

from math import inf, nan

import pytest

from allworlds.engines.limits import Limits, TimeIsUp, check_deadline, positive, worker_count
from allworlds.inputs.checks import InputError

LARGEST = {
    "workers": 10_000,
    "answer-timeout": 1_000_000,
    "start-timeout": 1_000_000,
    "time-limit": 1_000_000_000,
    "memory": 1_000_000_000,
    "max-findings": 1_000_000_000,
}


@pytest.mark.parametrize(("name", "most"), LARGEST.items())
def test_a_limit_is_positive_and_has_a_largest_value(name, most):
    limit = positive(name)
    assert limit(most) == most
    assert limit(1) == 1
    with pytest.raises(InputError, match=f"{name} = {most + 1} is too big; at most {most:,} is le"):
        limit(most + 1)
    for wrong in (0, -1):
        with pytest.raises(InputError, match=f"{name} {wrong} is not positive and finite"):
            limit(wrong)
    for wrong in ("1", True, [1]):
        with pytest.raises(InputError, match="is not a number"):
            limit(wrong)


@pytest.mark.parametrize("name", LARGEST)
def test_time_and_memory_alone_may_be_without_a_limit(name):
    if name in ("time-limit", "memory"):
        assert positive(name)(None) is None
    else:
        with pytest.raises(InputError, match=f"{name} = None is not a number"):
            positive(name)(None)


@pytest.mark.parametrize("name", LARGEST)
def test_what_is_counted_is_an_integer_and_times_are_finite(name):
    if "time" in name:
        assert positive(name)(1.5) == 1.5
        for wrong in (inf, nan):
            with pytest.raises(InputError, match="is not positive and finite"):
                positive(name)(wrong)
    else:
        with pytest.raises(InputError, match=r"1\.5"):
            positive(name)(1.5)


def test_the_least_time_for_an_answer_is_a_tenth_of_a_second():
    assert positive("answer-timeout")(0.1) == 0.1
    assert positive("start-timeout")(0.01) == 0.01
    told = "answer-timeout 0.0999 s is shorter than silence is noticed; the least is 0.1 s"
    with pytest.raises(InputError, match=told):
        positive("answer-timeout")(0.0999)


def test_the_limits_of_a_job_are_checked():
    limits = Limits()
    assert (limits.answer_timeout, limits.start_timeout, limits.workers) == (10.0, 60.0, 1)
    assert (limits.time_limit, limits.memory) == (None, None)
    with pytest.raises(InputError, match="workers = 10001 is too big"):
        Limits(workers=10_001)


def test_a_number_of_workers_has_nine_digits_at_most():
    assert [worker_count(text) for text in ("1", "01", "999999999")] == [1, 1, 999_999_999]
    assert worker_count("auto") >= 1
    for wrong in ("0", "1000000000", "-1", "1.0", "", "many"):
        with pytest.raises(InputError, match="is neither auto nor a positive number"):
            worker_count(wrong)


def test_time_is_up_after_the_deadline_and_not_at_it(monkeypatch):
    monkeypatch.setattr("time.monotonic", lambda: 5.0)
    check_deadline(None)
    check_deadline(5.0)
    with pytest.raises(TimeIsUp):
        check_deadline(4.999)
