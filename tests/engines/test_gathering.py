"""The results of units are added up, whatever is done anew."""

from types import SimpleNamespace

from allworlds.engines.sweep import gather
from allworlds.engines.units import PartialResult


class Counted:
    """A result: a number of worlds."""

    def __init__(self, worlds):
        self.worlds = worlds

    def add(self, other):
        self.worlds += other.worlds


def test_what_is_done_anew_is_counted_once():
    one, other = SimpleNamespace(key="1"), SimpleNamespace(key="2")
    parts = [
        PartialResult(one, Counted(3), last=False),
        PartialResult(other, Counted(5), last=True),
        PartialResult(one, Counted(2), last=False, anew=True),
        PartialResult(one, Counted(2), last=True),
        PartialResult(SimpleNamespace(key="3"), Counted(7), last=True, anew=True),
    ]
    heard, total = [], Counted(0)
    gather(
        SimpleNamespace(map=lambda engine, undone: iter(parts)),
        None,
        [],
        total,
        SimpleNamespace(progress=heard.append),
    )
    assert heard == [3, 5, -3, 2, 2, 7]
    assert total.worlds == sum(heard) == 16
