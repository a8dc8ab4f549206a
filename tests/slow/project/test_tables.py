"""Each table is one: what is said of its entries elsewhere is said of every one of them."""

import pytest

import allworlds
from allworlds.maps import MapClass
from allworlds.outcome import Verdict

pytestmark = pytest.mark.usefixtures("without_workers")


@pytest.mark.parametrize("map_class", MapClass)
def test_algorithm_1_holds_in_every_class(map_class):
    report = allworlds.check("algorithm1", edges=3, map_class=map_class.value)
    assert (report.verdict, report.missing_witnesses) == (Verdict.HOLDS, ())
