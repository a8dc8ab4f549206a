"""The comparison with the certified shield can fail: others take its place."""

import pytest

from allworlds.explorers.builtin.folding import Shield
from allworlds.explorers.loading import Subject


@pytest.fixture
def certified(checkers):
    return checkers("certified_shield")


def compared(certified, monkeypatch, shield, edges=2):
    def taking_its_place(name):
        return Subject(name, frozenset(), shield(certified.INSIDE[name.rpartition(":")[2]]))

    monkeypatch.setattr(certified, "load", taking_its_place)
    return certified.shields_agree(edges)


def test_a_shield_that_walks_all_agrees(certified, monkeypatch, capsys):
    assert compared(certified, monkeypatch, certified.walks_all)
    assert capsys.readouterr().out.count(" 30 runs, 0 of them walked or answered otherwise") == 4


def test_one_that_walks_less_or_answers_otherwise_does_not(certified, monkeypatch):
    def one_dart_on(inside):
        def explore(first):
            answer = yield from certified.walks_all(inside)(first)
            return type(answer)(answer.map, answer.map.sigma[answer.here])

        return explore

    assert not compared(certified, monkeypatch, Shield)
    assert not compared(certified, monkeypatch, one_dart_on)
