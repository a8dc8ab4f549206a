"""The bar of a notebook moves by hundredths, and ends where the job does."""

import sys
from types import SimpleNamespace

from allworlds.engines.progress import InNotebook


def test_a_bar_is_moved_by_a_hundredth_and_to_its_end(monkeypatch):
    shown = []
    display = SimpleNamespace(display=lambda bar, display_id: SimpleNamespace(update=shown.append))
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(display=display))
    bar = InNotebook()
    bar.level(4, 1000)
    for _ in range(999):
        bar.progress(1)
    assert [each.done for each in shown] == [*range(10, 1000, 10)]
    bar.progress(1)
    assert repr(shown[-1]) == "edges 4: 1,000 of 1,000 worlds"
