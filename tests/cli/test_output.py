"""How much is printed, and in which colours."""

import pytest

from allworlds.cli.output import COLOURS, coloured, printable
from allworlds.outcome import Verdict

VERDICT = "12 worlds, 30 runs, 67 traversals: no law is broken"


def test_the_verdict_stands_first(cli):
    _, out, _ = cli("check", "--edges", 2, "--workers", 1)
    assert out.splitlines()[0] == f"HOLDS      {VERDICT}"


def test_quiet_leaves_the_verdict_alone_in_one_line(cli):
    assert cli("check", "--edges", 2, "--workers", 1, "-q") == (0, f"HOLDS: {VERDICT}\n", "")
    code, out, _ = cli("check", "--edges", 2, "--bound", "1", "--workers", 1, "-q")
    assert (code, out.count("\n")) == (1, 1)
    assert out.startswith("REFUTED: law bound is broken; ")


def test_a_verb_without_a_verdict_says_all_of_it(cli):
    assert cli("count", "--edges", 2, "-q")[1] == cli("count", "--edges", 2)[1]


def test_every_verdict_has_a_colour():
    assert {verdict.value.upper() for verdict in Verdict} <= set(COLOURS)


GREEN, RED, YELLOW = 32, 31, 33
SHOWN = {
    **dict.fromkeys(("HOLDS", "FIXED"), GREEN),
    **dict.fromkeys(("REFUTED", "REPRODUCED", "ERROR"), RED),
    **dict.fromkeys(("NOT REPRODUCED", "NOT-REFUTED"), YELLOW),
    **dict.fromkeys(("INCONCLUSIVE", "VACUOUS", "EMPTY"), YELLOW),
}


def test_no_word_has_a_colour_that_is_not_expected_here():
    assert COLOURS.keys() == SHOWN.keys()


@pytest.mark.parametrize(("word", "colour"), SHOWN.items())
def test_a_terminal_shows_verdicts_in_colour_and_nothing_else(word, colour, monkeypatch):
    text = f"worlds\n{word}: {word} once more\n  {word} within"
    assert coloured(text) == text
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    monkeypatch.delenv("NO_COLOR", raising=False)
    shown = f"worlds\n\x1b[1;{colour}m{word}\x1b[0m: {word} once more\n  {word} within"
    assert coloured(text) == shown
    monkeypatch.setenv("NO_COLOR", "1")
    assert coloured(text) == text


def test_texts_of_ours_show_what_explorers_have_put_there():
    assert printable("\x1b[0m\n::error::\u202e\n ::x") == "\\x1b[0m\n:\\x3aerror::\\u202e\n :\\x3ax"
    assert printable("over\rwritten ##[error]") == "over\\x0dwritten ##\\x5berror]"


COMMANDS = """
def explore(first):
    print("::error::printed")
    yield ("\\n::error::said\\n##[error]\\x1b[31m\\u200b\\U000e0041 told", first)
"""
"""An explorer that says what a runner would take for commands."""


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("more", [(), ("--json",), ("-q",)])
def test_no_line_is_a_command_because_of_an_explorer(cli, more, tmp_path):
    file = tmp_path / "commands.py"
    file.write_text(COMMANDS)
    _, out, err = cli("check", f"{file}:explore", "--edges", 1, "--workers", 1, *more)
    assert "told" in out or more == ("-q",)
    for line in (out + err).splitlines():
        assert not line.lstrip().startswith("::")
        assert "##[" not in line
    assert not {"\x1b", "\u200b", "\U000e0041"} & {*out, *err}
