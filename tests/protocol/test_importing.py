"""What is said of an exception that a user's module raises."""

import sys

import pytest

from allworlds.protocol.importing import module_named, said
from interrupts import Unshown


class Odd(Exception):
    def __str__(self):
        raise ZeroDivisionError


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (ValueError("a\nb"), "ValueError: a"),
        (ValueError(), "ValueError"),
        (Odd(), "Odd, which cannot be shown"),
    ],
)
def test_it_is_one_line_whatever_it_says(error, words):
    assert said(error) == words


def test_a_module_of_the_current_directory_is_found_last(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.path", [each for each in sys.path if each])
    (tmp_path / "a_module_of_mine.py").write_text("here = True\n")
    (tmp_path / "json.py").write_text("here = True\n")
    assert module_named("a_module_of_mine").here
    assert sys.path[-1] == str(tmp_path)
    assert not hasattr(module_named("json"), "here")
    del sys.modules["a_module_of_mine"]


def test_an_interrupt_is_no_error_of_a_module(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "interrupted_module.py").write_text("raise KeyboardInterrupt\n")
    with pytest.raises(KeyboardInterrupt):
        module_named("interrupted_module")
    with pytest.raises(KeyboardInterrupt):
        said(Unshown())
