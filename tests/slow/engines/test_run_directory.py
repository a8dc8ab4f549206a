"""A run directory is believed where it is whole, and refused in one line where it is not."""

import pytest

from allworlds import check
from allworlds.engines import run_directory
from allworlds.engines.progress import Silent
from allworlds.engines.run_directory import reading


@pytest.mark.usefixtures("compiled")
def test_a_full_disk_loses_nothing_that_was_finished(tmp_path, monkeypatch):
    said = []
    whole = check(edges=4, engine="kernel").to_json()
    real = run_directory._write_ahead

    def small(connection):
        real(connection)
        connection.execute("PRAGMA max_page_count = 7")

    class Hears(Silent):
        notice = staticmethod(said.append)

    monkeypatch.setattr(run_directory, "_write_ahead", small)
    assert check(edges=4, engine="kernel", run=tmp_path, listener=Hears()).to_json() == whole
    (line,) = [text for text in said if "run directory" in text]
    assert "takes no more: database or disk is full; what it holds is kept" in line
    with reading(tmp_path) as read:
        kept = read.keys()
    assert 0 < len(kept) < 20
    monkeypatch.setattr(run_directory, "_write_ahead", real)
    assert check(edges=4, engine="kernel", run=tmp_path).to_json() == whole
    with reading(tmp_path) as read:
        assert set(kept) < set(read.keys())
