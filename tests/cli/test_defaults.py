"""Defaults of options from ``allworlds.toml`` and from ``[tool.allworlds]``."""

import json

import pytest

from allworlds.cli.app import call
from allworlds.outcome import Exit


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def document(capsys, *words):
    call([*words, "--json"])
    return json.loads(capsys.readouterr().out)


def test_of_a_project(here, capsys):
    (here / "pyproject.toml").write_text(
        '[tool.allworlds]\nclass = "simple"\n[tool.allworlds.count]\nedges = 2\n'
        "[tool.allworlds.ambiguity.census]\nedges = 3\n"
    )
    found = document(capsys, "count")
    assert found["scope"]["edges"] == 2
    assert found["scope"]["class"] == "simple"
    assert found["made_by"]["defaults"] == {"pyproject.toml": {"class": "simple", "edges": "2"}}
    assert document(capsys, "ambiguity", "census")["scope"]["edges"] == 3


def test_the_command_line_comes_first(here, capsys):
    (here / "allworlds.toml").write_text("edges = 2\n")
    found = document(capsys, "count", "--edges", "1")
    assert found["scope"]["edges"] == 1
    assert "defaults" not in found["made_by"]


def test_a_verbs_own_come_before_those_of_all(here, capsys):
    (here / "allworlds.toml").write_text("edges = 2\n[count]\nedges = 1\n")
    assert document(capsys, "count")["scope"]["edges"] == 1


def test_a_verb_of_two_words_may_have_words_behind_it(here, capsys):
    (here / "allworlds.toml").write_text("[ambiguity.class]\nlimit = 1\n")
    assert document(capsys, "ambiguity", "class", "k4")["listed"] == 1


def test_of_the_nearest_directory(here, capsys, monkeypatch):
    (here / "allworlds.toml").write_text("edges = 2\n")
    (here / "pyproject.toml").write_text("[tool.allworlds]\nedges = 3\n")
    inner = here / "inner"
    inner.mkdir()
    (inner / "pyproject.toml").write_text("[tool.other]\n")  # says nothing of ours
    monkeypatch.chdir(inner)
    found = document(capsys, "count")
    assert found["scope"]["edges"] == 2
    assert [*found["made_by"]["defaults"]] == [str(here / "allworlds.toml")]


def test_the_report_says_which(here, capsys):
    (here / "allworlds.toml").write_text("edges = 1\nquiet = false\n")
    assert call(["count"]) == Exit.ANSWERED
    assert capsys.readouterr().out.startswith("defaults from allworlds.toml: edges = 1, quiet")
    assert call(["count", "-q"]) == Exit.ANSWERED
    assert len(capsys.readouterr().out.splitlines()) == 1


def test_several_values_and_a_flag(here, capsys):
    (here / "allworlds.toml").write_text('edges = 2\nquiet = true\no = ["a.csv", "b.json"]\n')
    assert call(["count"]) == Exit.ANSWERED
    assert (here / "a.csv").exists()
    assert (here / "b.json").exists()


def test_an_explorer_in_place_of_the_usual_one(here, capsys):
    (here / "allworlds.toml").write_text('[check]\nexplorer = "folding"\nedges = 1\n')
    assert document(capsys, "check")["explorer"] == "folding"
    assert document(capsys, "check", "dudek91")["explorer"] == "dudek91"
    call(["check", "--exec", "no-such-program"])
    assert "no-such-program" in capsys.readouterr().err


def test_a_printed_command_holds_where_the_file_is(here, capsys):
    (here / "allworlds.toml").write_text('policy = "lifo"\n')
    wrong = "allworlds.corpus.explorers:pose_lost"
    (finding, *_) = document(capsys, "check", wrong, "--policy", "fifo")["findings"]
    assert "--policy fifo" in finding["reproduce"]
    (here / "allworlds.toml").unlink()
    (finding, *_) = document(capsys, "check", wrong, "--policy", "fifo")["findings"]
    assert "--policy" not in finding["reproduce"]  # the file of an earlier command is forgotten


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("edge = 1", "edge is no option of a verb; did you mean 'edges'?"),
        ("count.edge = 1", "edge is no option of count; did you mean 'edges'?"),
        ("counts.edges = 1", "there is no verb 'counts'; did you mean 'count'?"),
        ("edges = true", "edges = True is neither a text nor a number"),
        ("edges = [1]", "edges = [1] is neither a text nor a number"),
        ("quiet = 1", "quiet = 1 is not true or false"),
        ("o = [true]", "o[0] = True is neither a text nor a number"),
        ("edges = ", "'allworlds.toml' is not TOML: "),
        ('edges = "x"', "'x' is not an integer (edges = 'x' stands in 'allworlds.toml')"),
    ],
)
def test_refusals(here, capsys, text, said):
    (here / "allworlds.toml").write_text(text)
    assert call(["count"]) == Exit.USAGE
    out, err = capsys.readouterr()
    assert out == ""
    assert said in err
    assert "allworlds.toml" in err
    assert call(["--version"]) == Exit.HOLDS
