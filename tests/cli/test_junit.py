"""The option --junit."""

from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from allworlds.checker import check
from allworlds.cli.app import _guarded
from allworlds.cli.junit import ensure_writable, write_junit
from allworlds.errors import InputError
from allworlds.reports.junit import junit

QUICK = ["check", "--edges", "1", "--workers", "1", "-q"]


def test_the_file_holds_the_report(tmp_path, capsys):
    file = tmp_path / "junit.xml"
    assert _guarded([*QUICK, "--junit", str(file)]) == 0
    assert file.read_text(encoding="utf-8") == junit(check(edges=1))
    assert ET.parse(file).getroot().tag == "testsuites"
    assert "HOLDS" in capsys.readouterr().out


def test_an_older_file_is_replaced_whole(tmp_path):
    file = tmp_path / "junit.xml"
    file.write_text("x" * 100_000)
    assert _guarded([*QUICK, "--junit", str(file)]) == 0
    assert file.read_text(encoding="utf-8") == junit(check(edges=1))


@pytest.mark.parametrize("name", ["no/such/directory.xml", "", ".", "\0", "a\ud800"])
def test_a_file_that_cannot_be_written_is_refused_before_the_run(
    name, tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("allworlds.checker.check", lambda *_args, **_options: 1 / 0)
    assert _guarded([*QUICK, "--junit", name]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert "cannot be written" in err
    assert list(tmp_path.iterdir()) == []


def test_asking_whether_a_file_can_be_written_leaves_it_as_it_is(tmp_path):
    there, not_there = tmp_path / "there", tmp_path / "not-there"
    there.write_text("kept")
    ensure_writable(str(there))
    ensure_writable(str(not_there))
    ensure_writable(None)
    assert there.read_text() == "kept"
    assert not not_there.exists()


def test_without_a_file_nothing_is_written(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_junit(None, check(edges=1))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
def test_a_full_disk_is_bad_input():
    with pytest.raises(InputError, match="/dev/full"):
        write_junit("/dev/full", check(edges=1))
