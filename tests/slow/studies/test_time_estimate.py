"""How long a check will take is guessed from its last level."""

import pytest

from allworlds.engines.kernel.capabilities import MOST_EDGES
from allworlds.engines.units import level_size
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.reports.formats import text as text_of
from allworlds.studies.check.time_estimate import Guess, estimate, worlds_of

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.slowest
def test_worlds_that_no_source_counts_are_at_most_so_many(tmp_path):
    predicate = tmp_path / "mine.py"
    predicate.write_text("def few(map):\n    return map.vertex_count == 2\n", encoding="utf-8")
    guess = estimate(edges=3, where=f"{predicate}:few")
    told = text_of(guess, 100)
    assert "for at most 86 worlds: a guess" in told
    assert told.startswith("estimate   at most ")
    assert "at most" not in text_of(estimate(edges=3, where="trees"), 100)


WORLDS = {3: 86, 4: 792, 5: 8_954, 6: 119_364}
"""Rooted maps with at most so many edges: the sums of OEIS A053979's rows."""


@pytest.mark.parametrize(
    ("asked", "rates", "expected"),
    [
        (
            {"edges": 3, "engine": "python"},
            (100.0, 50.0),
            [(3, "python", 9, 100.0), (4, "python", 9, 50.0)],
        ),
        (
            {"edges": 4},
            (100.0, 10_000.0),
            [(4, "python", 9, 100.0), (5, "kernel", 9, 10_000.0)],
        ),
        (
            {"edges": 4, "engine": "kernel"},
            (100.0, 300.0),
            [(4, "kernel", 9, 100.0), (5, "kernel", 9, 300.0)],
        ),
        (
            {"edges": 3, "engine": "python"},
            (100.0, None),
            [(3, "python", 9, 100.0), (4, "python", 9, None)],
        ),
        ({"edges": 3, "engine": "python"}, (None,), [(3, "python", 9, None)]),
    ],
    ids=["slower", "another engine", "faster", "one alone", "none"],
)
def test_what_larger_checks_take_is_told_too(asked, rates, expected, monkeypatch):
    monkeypatch.setattr("allworlds.studies.check.time_estimate.estimated", measured(*rates))
    said = estimate(**asked)
    guesses = (said, *said.larger)
    told = [(guess.edges, guess.engine, guess.sampled, guess.rate) for guess in guesses]
    assert told == expected
    assert [guess.worlds for guess in guesses] == [WORLDS[guess.edges] for guess in guesses]
    _, _, rows = text_of(said, 100).partition("\nedges ")
    table = rows.splitlines()
    known = [guess for guess in guesses if guess.rate]
    assert len(table) == (1 + len(known) if said.larger else 0)
    for line, guess in zip(table[1:], known, strict=bool(said.larger)):
        assert line.split()[:2] == [str(guess.edges), f"{guess.worlds:,}"]


@pytest.mark.slowest
@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("engine", ["kernel", "python"])
def test_an_estimate_is_about_all_worlds(engine, monkeypatch):
    monkeypatch.setattr("allworlds.studies.check.time_estimate.SECONDS", 0.05)
    monkeypatch.setattr("allworlds.studies.check.time_estimate.one_larger", lambda _: None)
    guess = estimate(edges=4, engine=engine)
    assert guess.worlds == sum(level_size(Extent(MapClass.MAPS, 4), m) for m in range(1, 5))
    assert guess.sampled > 0
    assert guess.seconds == round(guess.worlds / guess.rate, 1)
    assert "for 792 worlds: a guess" in text_of(guess, 100)
    assert estimate(edges=4, engine=engine, shard=(0, 4)).worlds == guess.worlds // 4


def measured(*rates):
    """A function in place of a sample, which returns these rates one after the other."""
    left = iter(rates)

    def estimated(job, engine):
        edges, worlds = job.scope.extent.levels[-1], worlds_of(job)
        return Guess(edges=edges, engine=engine.name, worlds=worlds, sampled=9, rate=next(left))

    return estimated


def test_nothing_larger_is_told_where_there_is_nothing_or_too_much(monkeypatch):
    for asked in (
        {"map_class": "simple", "vertices": 3},
        {"edges": MOST_EDGES, "engine": "kernel", "vertices": 2},
        {"edges": 16},
        {"map_class": "simple", "vertices": 3, "edges": 3},
    ):
        monkeypatch.setattr("allworlds.studies.check.time_estimate.estimated", measured(1.0, 1.0))
        assert estimate(**asked).larger == ()
