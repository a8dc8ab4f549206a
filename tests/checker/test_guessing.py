"""How long a check will take is guessed from its last level."""

import random

import pytest

from allworlds import check
from allworlds.checker import estimate
from allworlds.maps.classes import Extent, MapClass
from allworlds.progress import Silent
from allworlds.reports.check_text import check_text
from allworlds.runs import EnginesDisagree
from allworlds.work import drawn_units, level_size


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("engine", ["python", "kernel"])
def test_an_estimate_is_about_all_worlds(engine, monkeypatch):
    monkeypatch.setattr("allworlds.checker.guessing.SECONDS", 0.05)
    guess = estimate(edges=4, engine=engine)
    assert guess.worlds == sum(level_size(Extent(MapClass.MAPS, 4), m) for m in range(1, 5))
    assert guess.sampled > 0
    assert guess.seconds == pytest.approx(guess.worlds / guess.rate)
    assert "for 792 worlds: a guess" in check_text(guess, 100)
    assert estimate(edges=4, engine=engine, shard=(0, 4)).worlds == guess.worlds // 4


def test_where_nothing_is_finished_there_is_no_guess(monkeypatch):
    def never(*_):
        raise EnginesDisagree("they do not agree")

    monkeypatch.setattr("allworlds.checker.guessing._pieces", never)
    guess = estimate(edges=2, engine="kernel")
    assert (guess.rate, guess.seconds, guess.sampled) == (None, None, 0)
    assert guess.to_json()["seconds"] is None
    assert "takes very long" in check_text(guess, 100)


class Hears:
    """A listener that is there."""

    def __init__(self):
        self.notices, silent = [], Silent()
        self.level, self.stage, self.progress = silent.level, silent.stage, silent.progress
        self.unit, self.finding, self.notice = silent.unit, silent.finding, self.notices.append


@pytest.mark.usefixtures("without_workers")
def test_a_long_check_begins_with_an_estimate(monkeypatch):
    room = "allworlds.checker.guessing"
    monkeypatch.setattr(f"{room}.SECONDS", 0.01)
    monkeypatch.setattr(f"{room}.MANY", {"python": 10})
    monkeypatch.setattr("allworlds.checker.exhaustive.LONG", 1e-9)
    listener = Hears()
    report = check(edges=2, engine="python", listener=listener)
    (said,) = listener.notices
    assert said.startswith("this will take about ")
    assert report.to_json() == check(edges=2, engine="python").to_json()
    listener = Hears()
    check(edges=2, engine="python", listener=listener, time_limit=100)
    monkeypatch.setattr(f"{room}.MANY", {"python": 100})
    check(edges=2, engine="python", listener=listener)
    assert listener.notices == []


@pytest.mark.no_cover
@pytest.mark.parametrize("map_class", list(MapClass))
def test_pieces_are_drawn_as_often_as_they_have_maps(map_class):
    extent = Extent(map_class, 4)
    draw = random.Random(1)
    units = [unit for unit, _ in zip(drawn_units(extent, 4, 5, draw), range(300), strict=False)]
    sizes = [sum(1 for _ in unit.maps(extent)) for unit in units]
    assert max(sizes) <= 5
    assert all(unit.edges == 4 for unit in units)
    assert len({unit.prefix for unit in units}) > 3
    if not map_class.simple:
        assert min(sizes) > 0
    assert sum(sizes) > 0
