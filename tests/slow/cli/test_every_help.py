"""The help of every verb at every width."""

import pytest

from cli import test_parameters as quick


@pytest.mark.slowest
@pytest.mark.parametrize("columns", [50, 79, 80, 120])
@pytest.mark.parametrize("name", ["", "ambiguity", *quick.NAMES])
def test_no_help_cuts_a_word_or_gives_a_flag_a_value(name, columns, monkeypatch):
    quick.test_no_help_cuts_a_word_or_gives_a_flag_a_value(name, columns, monkeypatch)


@pytest.mark.parametrize("name", quick.NAMES)
def test_a_help_shows_at_most_sixteen_options_and_another_one_all(name, monkeypatch, cli):
    quick.test_a_help_shows_at_most_sixteen_options_and_another_one_all(name, monkeypatch, cli)
