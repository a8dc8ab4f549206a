"""A run directory is believed where it is whole, and refused in one line where it is not."""

import random
import shutil

import pytest

from allworlds import check
from allworlds.engines import run_directory
from allworlds.engines.listeners import Listener
from allworlds.engines.run_directory import FILE, reading
from allworlds.inputs.checks import InputError


@pytest.mark.slowest
@pytest.mark.usefixtures("compiled")
def test_a_full_disk_loses_nothing_that_was_finished(tmp_path, monkeypatch):
    said = []
    whole = check(edges=4, engine="kernel").to_json()
    real = run_directory._write_ahead

    def small(connection):
        real(connection)
        connection.execute("PRAGMA max_page_count = 7")

    class Hears(Listener):
        notice = staticmethod(said.append)

    monkeypatch.setattr(run_directory, "_write_ahead", small)
    assert check(edges=4, engine="kernel", run=tmp_path, listener=Hears()).to_json() == whole
    (line,) = [text for text in said if "run directory" in text]
    assert "takes no more: database or disk is full; what it holds is kept" in line
    with reading(tmp_path) as read:
        kept = [key for key, *_ in read.units()]
    assert 0 < len(kept) < 20
    monkeypatch.setattr(run_directory, "_write_ahead", real)
    assert check(edges=4, engine="kernel", run=tmp_path).to_json() == whole
    with reading(tmp_path) as read:
        assert set(kept) < {key for key, *_ in read.units()}


@pytest.mark.slowest
@pytest.mark.usefixtures("without_workers")
def test_a_flipped_byte_is_detected_or_harms_nothing(tmp_path):
    job = lambda run: check(edges=3, engine="python", run=run).to_json()  # noqa: E731
    whole = job(tmp_path / "run")
    content = (tmp_path / "run" / FILE).read_bytes()
    results = [i for i in range(len(content)) if content.startswith(b'{"checkpoints"', i)]
    draw = random.Random(13)
    inside = [start + draw.randrange(100) for start in results]
    anywhere = [draw.randrange(len(content)) for _ in range(60)]
    refused = 0
    for number, place in enumerate([*inside, *anywhere]):
        copy = tmp_path / f"copy-{number}"
        shutil.copytree(tmp_path / "run", copy)
        flipped = bytearray(content)
        flipped[place] ^= 1 << draw.randrange(8)
        (copy / FILE).write_bytes(flipped)
        try:
            again = job(copy)
        except InputError as error:
            said = str(error)
            refused += "run directory" in said
        else:
            assert again == whole
            assert place not in inside
    assert len(inside) <= refused < len(inside) + len(anywhere)
