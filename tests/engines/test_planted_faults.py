"""Faults in the defence against explorers: each lets some of them through, and a check notices."""

import pytest

from allworlds.engines.isolation import process, process_tree
from allworlds.studies.check import check
from attacks.reading import ATTACKS

GOES_BY_ITS_SEED = """
import os
from allworlds.explorers import algorithm1

def explore(first):
    estimate = yield from algorithm1(first)
    return estimate if os.environ["PYTHONHASHSEED"] == "0" else 7
"""
GOES_BY_AN_ADDRESS = """
import ctypes
from allworlds.explorers import algorithm1

def explore(first):
    with open("addresses", "a") as addresses:
        print(ctypes.cast(ctypes.CDLL(None).getpid, ctypes.c_void_p).value, file=addresses)
    return (yield from algorithm1(first))
"""


@pytest.fixture
def plant(monkeypatch):
    """Plant a fault, or none, into the processes of later checks."""
    monkeypatch.setattr(process, "_guardians", {})

    def planted(fault):
        if fault:
            process.guardian().prepare("planted_faults", fault)

    yield planted
    for one in [*process._guardians.values()]:
        process.forget(one)


@pytest.fixture
def checked(tmp_path, monkeypatch):
    """The report of a small check of an explorer of that text, in a folder of its own."""
    monkeypatch.chdir(tmp_path)

    def of(text, **options):
        (tmp_path / "mine.py").write_text(text)
        return check("mine.py:explore", edges=2, workers=1, **options)

    return of


@pytest.mark.parametrize(("fault", "code"), [("", 1), ("one_seed", 0)])
def test_players_have_hash_seeds_of_their_own(plant, checked, fault, code):
    plant(fault)
    assert checked(GOES_BY_ITS_SEED).exit_code == code


@pytest.mark.parametrize(("fault", "number"), [("", 2), ("one_seed", 1)])
def test_players_have_addresses_of_their_own(plant, checked, tmp_path, fault, number):
    plant(fault)
    assert checked(GOES_BY_AN_ADDRESS).exit_code == 0
    assert len({*(tmp_path / "addresses").read_text().split()}) == number


@pytest.mark.parametrize(
    ("fault", "verdict"), [("", "holds"), ("who_is_stopped_stays_so", "inconclusive")]
)
def test_who_is_stopped_by_an_explorer_goes_on(plant, checked, monkeypatch, fault, verdict):
    plant(fault)
    if fault:  # nor does anybody else let it go on
        monkeypatch.setattr(process.Process, "wake", lambda _: None)
        monkeypatch.setattr(process_tree, "MOST_STOPS", 3)
    stops = ATTACKS / "reaching" / "stops_its_siblings.py"
    report = checked(stops.read_text().replace("def once(", "def explore("), answer_timeout=3)
    assert report.verdict.value == verdict
    assert ("stopped again and again" in str(report.to_json())) == bool(fault)


def test_a_guardian_that_waits_for_a_child_that_was_stopped_is_helped(plant):
    plant("wait_for_a_child_that_was_stopped")
    assert process.guardian().exit_code(1) is None
