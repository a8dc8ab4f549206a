"""Damaged tables and damaged lists of work: each dies by name, and none as a crash."""

import pytest

from allworlds import check
from allworlds.documents.document import replace
from allworlds.engines import compiled_engine as compiled
from allworlds.engines.compiled_engine import AGREED, UNBOUNDED, bounds_of
from allworlds.engines.kernel.engine import judge
from allworlds.engines.kernel.runs import UNDEFINED
from allworlds.judging.rules import Rules

pytestmark = pytest.mark.usefixtures("compiled")


LEVEL_OF = compiled.level_of


@pytest.fixture(autouse=True)
def fresh_comparison():
    AGREED.clear()
    LEVEL_OF.cache_clear()
    yield
    AGREED.clear()
    LEVEL_OF.cache_clear()


def table_of(bounds):
    """The table of the kernel of these largest costs, by vertices from 0 on."""
    return [[[bound]] for bound in bounds]


def test_a_judge_that_is_wrong_is_found_out_before_the_first_level(monkeypatch):
    honest = judge

    def forgetful(*arguments, **options):
        rows = honest(*arguments, **options)
        return replace(rows, met=rows.met[:-1])

    monkeypatch.setattr("allworlds.engines.kernel.engine.judge", forgetful)
    report = check(edges=2, engine="kernel")
    assert report.exit_code == 70
    assert "the kernel and the python engine count differently in the unit" in report.ending.reason


def test_what_the_judge_blames_is_asked_of_the_python_engine(monkeypatch):
    monkeypatch.setattr(compiled, "compare_engines", lambda *_: None)
    honest = compiled.level_of

    def stricter(*arguments):
        level = honest(*arguments)
        return replace(level, bounds=table_of([0] * (arguments[-1] + 2)))

    monkeypatch.setattr(compiled, "level_of", stricter)
    report = check(edges=2, engine="kernel")
    assert report.exit_code == 70
    assert "bound is broken, the python engine that none is" in report.ending.reason


def test_the_bounds_are_those_of_the_rules():
    rules = Rules(bound="m * n")
    assert bounds_of(rules, 3) == table_of([0, 3, 6, 9, 12])
    assert bounds_of(replace(rules, bound="none"), 3) == table_of([UNBOUNDED] * 5)
    by_degree = [[UNDEFINED], *([3 // d0] for d0 in range(1, 7))]
    assert bounds_of(replace(rules, bound="m // d0"), 3)[1] == by_degree
