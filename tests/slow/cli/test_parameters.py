"""The help: complete at any width, and no type where there is no value."""

import pytest

from allworlds.verbs import VERBS
from cli.test_parameters import help_of


@pytest.mark.slowest
def test_a_verb_that_takes_an_explorer_tells_of_the_shield(monkeypatch):
    for verb in VERBS:
        command, told = help_of(verb.name.split(), 200, monkeypatch)
        words = [p.metavar for p in command.params if p.param_type_name == "argument"]
        takes_one = verb.name != "worst" and any("EXPLORER" in str(word) for word in words)
        assert ("shield:EXPLORER" in told) == takes_one, verb.name
