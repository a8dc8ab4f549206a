"""What the compiled judge says to the second player of a batch."""

from array import array
from types import SimpleNamespace

import pytest

from allworlds.engines import compiled_judge
from allworlds.engines.compiled_judge import CompiledBatch, CompiledJudge


@pytest.fixture
def batch(monkeypatch):
    """Two runs of a library that have been judged: three percepts of the first, one more."""
    made = object.__new__(CompiledBatch)
    made.laid, made.plain = SimpleNamespace(runs=2), False
    made.percepts, made.starts, made.motioned = b"abcd", array("i", [0, 3, 4]), "heads of both"
    made.unit = SimpleNamespace(edges=5)
    python = SimpleNamespace(
        judged=None,
        counter=None,
        rules=SimpleNamespace(policy="fifo"),
        message=lambda kind, rows, order: {"kind": kind, "rows": [*rows], "order": order},
    )
    made.by = CompiledJudge(python, lambda: 7, native=True)
    paired = staticmethod(lambda batch, rows, places: zip(rows, places, strict=True))
    monkeypatch.setattr(compiled_judge, "_rows_of", paired)
    return made


def test_a_library_replays_all_runs_of_a_batch_in_compiled_code(batch):
    message = batch.by.records(batch, [0, 1])
    assert (message["kind"], message["runs"], message["again"]) == ("native", 2, True)
    assert (message["percepts"], message["heads"]) == (b"abcd", "heads of both")


@pytest.mark.parametrize(("row", "percepts"), [(0, b"abc"), (1, b"d")])
def test_of_a_part_of_the_runs_it_replays_their_own_percepts(batch, row, percepts):
    message = batch.by.records(batch, [row], [0])
    assert message == {"kind": "record", "rows": [(row, percepts)], "order": [0]}


def test_what_python_plays_is_replayed_by_python(batch):
    batch.plain = True
    message = batch.by.records(batch, [0, 1])
    assert message["rows"] == [(0, b"abc"), (1, b"d")]
