"""The help: complete at any width, and no type where there is no value."""

import re

import pytest

from allworlds.cli.app import command_line
from allworlds.verbs import VERBS

NAMES = [verb.name for verb in VERBS]


def help_of(words, columns, monkeypatch):
    """The command, and the whole help that it prints."""
    monkeypatch.setenv("COLUMNS", str(columns))
    monkeypatch.setenv("TERMINAL_WIDTH", str(columns))
    command = command_line.__wrapped__()
    context = command.make_context("allworlds", [], resilient_parsing=True)
    for word in words:
        command = command.commands[word]
        context = command.make_context(word, [], parent=context, resilient_parsing=True)
    for param in command.params:
        param.hidden = False
    return command, command.get_help(context)


@pytest.mark.parametrize("columns", [50, 80])
@pytest.mark.parametrize("name", ["", "check"])
def test_no_help_cuts_a_word_or_gives_a_flag_a_value(name, columns, monkeypatch):
    command, told = help_of(name.split(), columns, monkeypatch)
    assert "\N{HORIZONTAL ELLIPSIS}" not in told
    assert "<bool>" not in told.lower()
    assert "BOOLEAN" not in told
    for param in command.params:
        assert not param.secondary_opts, "a flag has no opposite"
        for option in param.opts if param.param_type_name == "option" else ():
            assert re.search(rf"{re.escape(option)}\b", told), option


@pytest.mark.parametrize(
    ("name", "usage"),
    [
        ("check", "check [OPTIONS] [EXPLORER]"),
        ("run", "run [OPTIONS] [EXPLORER] WORLD"),
        ("replay", "replay [OPTIONS] FILE"),
        ("ambiguity twins", "ambiguity twins [OPTIONS] A B"),
    ],
)
def test_a_usage_line_shows_the_arguments_as_they_are_told_of(name, usage, monkeypatch):
    _, told = help_of(name.split(), 100, monkeypatch)
    line = next(line for line in told.splitlines() if "Usage" in line)
    assert line.split("allworlds ")[1].strip() == usage


@pytest.mark.parametrize("name", ["check", "count", "ambiguity search"])
def test_a_help_shows_at_most_sixteen_options_and_another_one_all(name, monkeypatch, cli):
    monkeypatch.setenv("COLUMNS", "100")
    command = command_line.__wrapped__()
    for word in name.split():
        command = command.commands[word]
    command_line.cache_clear()  # another test may have had a narrow terminal
    rare = {param.opts[0] for param in command.params if getattr(param, "hidden", False)}
    every = {param.opts[0] for param in command.params if param.param_type_name == "option"}
    for option, shown in (("--help", every - rare), ("--help-all", every)):
        code, told, _ = cli(*name.split(), option)
        if option in every | {"--help"}:
            listed = re.findall(r"(?m)^│ [*]? {,16}(-[a-z-]+)", told.partition("─ Options")[2])
            assert (code, {*listed}) == (0, shown | {"--help"})
        else:
            assert (code, rare) == (2, set())
        assert option == "--help-all" or len(listed) <= 16


def test_a_default_is_told_wherever_leaving_out_an_option_means_a_value(monkeypatch):
    for name, words in [
        ("check", "unless --vertices is given: 5"),
        ("check", "8 times the bound 'paper', plus 100"),
    ]:
        _, told = help_of([name], 79, monkeypatch)
        assert words in " ".join(told.replace("│", "").split())
