"""How long a check will take is guessed from its last level."""

import random
import time
from types import SimpleNamespace

import pytest

from allworlds.documents.document import replace
from allworlds.engines import units
from allworlds.engines.tally import EnginesDisagree
from allworlds.engines.units import drawn_units
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.reports.formats import text as text_of
from allworlds.studies.check.time_estimate import Guess, TimeEstimate, estimate

pytestmark = pytest.mark.usefixtures("compiled")


def test_where_nothing_is_finished_there_is_no_guess(monkeypatch):
    def never(*_):
        raise EnginesDisagree("they do not agree")

    monkeypatch.setattr("allworlds.engines.units.drawn_units", never)
    said = estimate(edges=2, engine="kernel")
    assert (said.rate, said.seconds, said.sampled) == (None, None, 0)
    assert said.to_json()["seconds"] is None
    assert "takes very long" in text_of(said, 100)


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


@pytest.mark.parametrize(
    ("rate", "seconds"), [(None, None), (4.0, 250.0), (0.5, 2000.0), (1e-299, 1e300)]
)
def test_a_guess_is_the_worlds_by_the_rate_and_at_most_what_a_float_holds(rate, seconds):
    said = Guess(edges=2, engine="python", worlds=1000, sampled=1, rate=rate)
    assert said.to_json()["seconds"] == seconds


def test_pieces_are_tried_until_the_time_for_a_sample_is_over(monkeypatch):
    monkeypatch.setattr("allworlds.studies.check.time_estimate.SECONDS", 600.0)
    monkeypatch.setattr("allworlds.studies.check.time_estimate.FEW", 20)
    drawn, pieces_of = [], units.drawn_units
    monkeypatch.setattr(
        "allworlds.engines.units.drawn_units",
        lambda extent, edges, *more: drawn.append(edges) or pieces_of(extent, edges, *more),
    )
    sampled = []
    for pieces in (3, 5):
        monkeypatch.setattr("allworlds.studies.check.time_estimate.PIECES", pieces)
        sampled.append(estimate(edges=3, engine="python").sampled)
    assert 0 < sampled[0] < sampled[1]
    assert drawn == [3, 4, 3, 4]  # and what one edge more would take


def test_of_a_clock_that_stands_still_there_is_no_rate(monkeypatch):
    now = time.monotonic()
    clock = SimpleNamespace(monotonic=lambda: now)
    monkeypatch.setattr("allworlds.studies.check.time_estimate.time", clock)
    said = estimate(edges=3, engine="python")
    assert said.sampled > 0
    assert said.rate is None


def told(guess):
    """The text of a guess for algorithm1."""
    known = {name: getattr(guess, name) for name in Guess.__struct_fields__}
    return text_of(TimeEstimate(explorer="algorithm1", larger=(), **known), 100)


GUESS = Guess(edges=3, engine="kernel", worlds=6, sampled=4, rate=2.0)


def test_a_guess_is_told_with_its_sample():
    assert told(GUESS) == (
        "estimate   3 s for 6 worlds: a guess\n\nsample     4 worlds of the last level, 2 a second"
    )
    never = replace(GUESS, rate=None)
    assert told(never).startswith("estimate   no world of the last level was finished in a few s")


COUNTED = """
edges  worlds  engine  sampled  worlds/s  duration
    3       6  kernel        4         2       3 s
    4     100  kernel     none         3      33 s"""


@pytest.mark.parametrize(
    ("counted", "said"), [(True, COUNTED), (False, "\nedges  worlds <=  engine  sampled  wor")]
)
def test_larger_checks_are_told_in_a_table(counted, said):
    known = {name: getattr(GUESS, name) for name in Guess.__struct_fields__}
    larger = (
        replace(GUESS, edges=4, worlds=100, sampled=0, rate=3.0),
        replace(GUESS, edges=5, rate=None),
    )
    whole = TimeEstimate(explorer="algorithm1", larger=larger, counted=counted, **known)
    text = text_of(whole, 100)
    assert said in text
    assert ("at most" in text) is not counted
