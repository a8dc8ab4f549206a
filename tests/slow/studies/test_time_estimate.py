"""How long a check will take is guessed from its last level."""

import pytest

from allworlds.reports.formats import text as text_of
from allworlds.studies.check.exhaustive import estimate
from studies import test_time_estimate as quick

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("engine", ["python"])
def test_an_estimate_is_about_all_worlds(engine, monkeypatch):
    quick.test_an_estimate_is_about_all_worlds(engine, monkeypatch)


def test_worlds_that_no_source_counts_are_at_most_so_many(tmp_path):
    predicate = tmp_path / "mine.py"
    predicate.write_text("def few(map):\n    return map.vertex_count == 2\n", encoding="utf-8")
    guess = estimate(edges=3, where=f"{predicate}:few")
    told = text_of(guess, 100)
    assert "for at most 86 worlds: a guess" in told
    assert told.startswith("estimate   at most ")
    assert "at most" not in text_of(estimate(edges=3, where="trees"), 100)
