"""How long a check will take is guessed from its last level."""

import random

import pytest

from allworlds import check
from allworlds.engines.limits import Silent
from allworlds.engines.tally import EnginesDisagree
from allworlds.engines.units import drawn_units
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.reports.formats import text as text_of
from allworlds.studies.check.exhaustive import estimate

pytestmark = pytest.mark.usefixtures("compiled")


def test_where_nothing_is_finished_there_is_no_guess(monkeypatch):
    def never(*_):
        raise EnginesDisagree("they do not agree")

    monkeypatch.setattr("allworlds.engines.units.drawn_units", never)
    said = estimate(edges=2, engine="kernel")
    assert (said.rate, said.seconds, said.sampled) == (None, None, 0)
    assert said.to_json()["seconds"] is None
    assert "takes very long" in text_of(said, 100)


class Hears:
    """A listener that is there."""

    def __init__(self):
        self.notices, silent = [], Silent()
        self.level, self.stage, self.progress = silent.level, silent.stage, silent.progress
        self.notice = self.notices.append


@pytest.mark.usefixtures("without_workers")
def test_a_long_check_begins_with_an_estimate(monkeypatch):
    room = "allworlds.studies.check.exhaustive"
    monkeypatch.setattr(f"{room}.SECONDS", 0.01)
    monkeypatch.setattr(f"{room}.MANY", {"python": 10})
    monkeypatch.setattr("allworlds.studies.check.exhaustive.LONG", -1.0)
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
