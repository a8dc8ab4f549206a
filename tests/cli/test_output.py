"""How much is printed, and in which colours."""

from pathlib import Path

import pytest

from allworlds.cli.output import COLOURS, coloured, printable
from allworlds.outcome import Verdict

VERDICT = "12 worlds, 30 runs, 67 traversals: no law is broken"


WRONG = f"{Path(__file__).parents[1] / 'recorded' / 'explorers.py'}"


@pytest.mark.parametrize("more", [(), ("-v",)])
def test_the_verdict_stands_last(cli, more):
    _, out, _ = cli("check", "--edges", 2, "--workers", 1, *more)
    assert out.splitlines()[-1] == f"HOLDS      {VERDICT}"
    assert ("independent count agrees for all 5 sizes" in out) == (not more)
    assert ("Finished levels" in out) == bool(more)


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("columns", [60, 100])
@pytest.mark.parametrize(
    "words",
    [
        "check",
        "check WRONG:first_edge --max-findings 40",
        "check WRONG:crashes",
        "check WRONG:walks_for_ever",
        "check --time-limit 1e-9",
        "fuzz WRONG:first_edge --runs 9",
    ],
)
def test_a_report_is_short_and_says_what_is_wrong(words, columns, cli, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(columns))
    code, out, _ = cli(*words.replace("WRONG", WRONG).split(), "--edges", 3, "--workers", 1)
    lines = out.splitlines()
    assert len(lines) <= 30
    assert lines[-1].split()[0].rstrip(":") in COLOURS
    if code == 1:
        assert lines[0].startswith("Finding 1:")
        assert any(line.startswith("  allworlds run ") for line in lines)
    assert code in (0, 1, 3)


def test_quiet_leaves_the_verdict_alone_in_one_line(cli):
    assert cli("check", "--edges", 2, "--workers", 1, "-q") == (0, f"HOLDS: {VERDICT}\n", "")
    code, out, _ = cli("check", "--edges", 2, "--bound", "1", "--workers", 1, "-q")
    assert (code, out.count("\n")) == (1, 1)
    assert out.startswith("REFUTED: law bound is broken; ")


@pytest.mark.parametrize("words", ["count --edges 2", "run --list", "ambiguity class theta"])
def test_quiet_is_one_line_whatever_is_answered(cli, words):
    _, out, _ = cli(*words.split(), "-q")
    assert (out.count("\n"), len(out) > 9) == (1, True)


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
