import pytest

from allworlds.studies.check.exhaustive import check

STAR = """\
from allworlds import CombinatorialMap, Estimate, Move


def helper():
    return 0


def explore(first):
    k = first.degree
    for turn in [0] + [1] * (k - 1):
        yield Move(turn)
        yield Move(0)
    sigma = [*range(1, k), 0, *range(k, 2 * k)]
    alpha = [*range(k, 2 * k), *range(k)]
    return Estimate(CombinatorialMap(sigma, alpha), k - 1)
"""


@pytest.fixture
def line():
    """Where the explorer of ``refuted`` begins."""
    return STAR.splitlines().index("def explore(first):") + 1


@pytest.fixture
def refuted(tmp_path, monkeypatch):
    """The report of a refuted explorer in a file ``mine.py`` of the current folder."""
    (tmp_path / "mine.py").write_text(STAR)
    monkeypatch.chdir(tmp_path)
    return check("mine.py:explore", edges=2, max_findings=2)
