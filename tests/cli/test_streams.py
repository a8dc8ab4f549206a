"""Standard streams that are closed or full."""

import io
import os
import subprocess
import sys
from pathlib import Path

import pytest

from allworlds.cli import run
from allworlds.cli.output import prepare_streams
from processes import PATIENCE


def shell(words):
    """The exit code, stdout and stderr of a command whose streams the shell redirects."""
    done = subprocess.run(
        ["/bin/sh", "-c", f"{sys.executable} -m allworlds {words}"],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
    )
    return done.returncode, done.stdout, done.stderr


@pytest.mark.parametrize("stderr", ["2>/dev/full", "2>&-"])
def test_bad_input_is_exit_code_2_and_no_output_whatever_becomes_of_stderr(stderr):
    assert shell(f"check --edges x {stderr}") == (2, "", "")


VERBS = ["check --edges 2", "check --edges 2 --json", "count --edges 2", "run theta", "--help"]


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("verb", VERBS)
def test_a_stdout_that_is_full_is_one_line_and_exit_code_70(cli, monkeypatch, verb):
    with Path("/dev/full").open("w") as full:
        monkeypatch.setattr(sys, "stdout", full)
        code, _, err = cli(*verb.split())
    assert code == 70
    assert err.count("\n") == 1, err
    assert err.startswith("allworlds: ")


@pytest.mark.parametrize("stdout", [">/dev/full", ">&-"])
def test_bad_input_goes_before_a_bad_stdout(stdout):
    code, out, err = shell(f"count --edges x {stdout}")
    assert (code, out) == (2, "")
    assert "'x'" in err


@pytest.mark.parametrize("columns", ["100", "50"])
@pytest.mark.parametrize(
    "words",
    ["count --edges 2", "--version", "--help", "", "check --help", "ambiguity", "ambiguity -h"],
)
def test_a_reader_that_has_gone_is_no_error(cli, monkeypatch, words, columns):
    monkeypatch.setenv("COLUMNS", columns)
    reader, writer = os.pipe()
    os.close(reader)
    with os.fdopen(writer, "w") as gone:
        monkeypatch.setattr(sys, "stdout", gone)
        code, _, err = cli(*words.split())
    assert (code, err) == (0, "")


@pytest.mark.parametrize("words", ["--version", "--help"])
def test_a_text_without_a_verdict_needs_no_reader(words):
    """A pipe whose reader has gone before, and a stdout that is closed."""
    assert shell(f"{words} >&-") == (0, "", "")
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, "-m", "allworlds", words]
    done = subprocess.run(command, stdout=writer, stderr=subprocess.PIPE, check=False)
    os.close(writer)
    assert (done.returncode, done.stderr) == (0, b"")


def test_the_words_of_an_explorer_give_no_orders_to_a_terminal(cli, refused, tmp_path):
    file = tmp_path / "rude.py"
    file.write_text(
        "def explore(first):\n    raise ValueError('\\x1b[2J\\x00\\x9b7m\\x7f\\r')\n    yield\n"
    )
    for verb in (["check", "--edges", 1, "--workers", 1], ["run", "theta"]):
        code, out, err = cli(*verb[:1], f"{file}:explore", *verb[1:])
        assert code == 1, err
        assert r"\x1b[2J\x00\x9b7m\x7f" in out
        assert all(c.isprintable() or c in "\n\t" for c in out)
        assert not err
    file.write_text("raise ValueError('\\x1b[2J')\n")
    err = refused("check", f"{file}:explore", "--edges", 1)
    assert r"\x1b[2J" in err
    assert "\x1b" not in err


def test_a_question_without_a_newline_is_seen_before_its_answer(monkeypatch):
    """A stream like stderr, which writes whole lines by itself, and no others."""
    stream = io.TextIOWrapper(io.BytesIO(), line_buffering=True)
    monkeypatch.setattr(sys, "stderr", stream)
    run._say("> ")
    assert stream.buffer.getvalue() == b"> "


@pytest.fixture
def no_input(monkeypatch):
    """A process that had no stdin at its start, whose place is taken by a pipe now."""
    kept, (reading, writing) = os.dup(0), os.pipe()
    os.write(writing, b"not for us")
    os.dup2(reading, 0)
    os.close(reading)
    for name in ("stdin", "stdout", "stderr"):
        monkeypatch.setattr(sys, name, None if name == "stdin" else getattr(sys, name))
    yield
    os.dup2(kept, 0)
    os.close(kept)
    os.close(writing)


def test_a_stream_that_was_closed_is_one_that_is_empty(no_input):
    before = len([*Path("/proc/self/fd").iterdir()])
    prepare_streams()
    assert os.read(0, 1) == b""
    assert os.get_inheritable(0)
    assert len([*Path("/proc/self/fd").iterdir()]) == before
