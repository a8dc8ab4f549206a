"""Messages that a new user meets."""

import json

import pytest

from allworlds.world import world_named

GREEDY = """
from allworlds.explorers import greedy

def explore(first):
    return (yield from greedy(first))
"""


def test_a_file_that_is_not_there_is_told_as_that(refused, tmp_path):
    gone = tmp_path / "gone.py"
    said = refused("check", gone, "--edges", 1)
    assert "there is no file" in said
    assert "gone.py" in said


def test_a_file_that_is_no_python_is_told_with_its_line(refused, tmp_path):
    file = tmp_path / "typo.py"
    file.write_text("def explore(first):\n    x = = 1\n", encoding="utf-8")
    said = refused("check", file, "--edges", 1)
    assert "line 2 is no Python: SyntaxError: invalid syntax" in said


@pytest.mark.parametrize("command", ["python3 gone.py", "node gone.js"])
def test_a_script_that_its_interpreter_cannot_open_is_bad_input(command, refused, monkeypatch):
    monkeypatch.setattr("shutil.which", lambda name: f"/usr/bin/{name}")
    said = refused("check", "--edges", 1, "--exec", command)
    assert f"cannot open '{command.split()[1]}': there is no such file" in said


def test_two_explorers_of_one_name_are_told_apart(tmp_path, cli):
    files = [tmp_path / folder / "mine.py" for folder in ("one", "two")]
    for file in files:
        file.parent.mkdir()
        file.write_text(GREEDY, encoding="utf-8")
    code, out, _ = cli("compare", *files, "--edges", 1)
    assert code == 0
    assert "one/mine.py:explore mean" in " ".join(out.split())
    assert "two/mine.py:explore mean" in " ".join(out.split())


@pytest.mark.parametrize("name", ["cycle:5", "wheel:4", "wheel-4", "lattice:2x3"])
def test_a_world_has_one_name_in_run_play_and_compare(name, cli, tmp_path):
    _, ran, _ = cli("run", "dfs", name, "--lighthouse", "labels", "--json")
    _, played, _ = cli(
        "play", name, "--lighthouse", "labels", "--json", "--html", tmp_path / "page.html"
    )
    assert json.loads(ran)["world"] == json.loads(played)["world"]
    assert json.loads(ran)["world"]["lighthouse"]["kind"] == "labels"
    if ":" in name:
        code, out, _ = cli("compare", "greedy", "algorithm1", "--family", name, "-q")
        assert code == 0
        code, out, _ = cli("run", "dfs", "--family", name, "--lighthouse", "labels", "--json")
        assert json.loads(out)["world"] == json.loads(ran)["world"]


def test_run_lists_the_names_of_worlds(cli, refused, tmp_path):
    code, out, _ = cli("run", "--list", "--json")
    names = json.loads(out)
    assert code == 0
    assert "wheel:N" in names["maps"]
    assert "cycle:N" in names["families"]
    assert "fig2-step" in names["corpus"]
    for name in (*names["maps"], *names["corpus"]):
        assert world_named(name.replace(":N", ":3")).map.edge_count
    page = tmp_path / "page.html"
    assert cli("play", "wheel:3", "--lighthouse", "none", "--html", page)[0] == 0
    assert "lattice:RxC" in cli("run", "--list")[1]
    assert "'allworlds run --list'" in refused("run", "dfs", "whel")
