"""Messages that a new user meets."""

import json
import sys

import pytest

from allworlds.explorers.program import missing_script
from allworlds.world import world_named

MINE = """
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    return (yield from algorithm1(first))
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
    assert "is no Python: SyntaxError: invalid syntax (typo.py, line 2)" in said


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("./notes.txt", "'./notes.txt' is a file, but no file.py with a function"),
        ("./folder/", "is a directory; an explorer in it is folder/FILE.py:FUNCTION"),
        ("folder", "is a directory; an explorer in it is folder/FILE.py:FUNCTION"),
        ("robot", "did you mean 'robot.py'?"),
        ("robbot.py", "there is no file 'robbot.py'; did you mean 'robot.py'?"),
        ("./robot.pyy", "there is no file './robot.pyy'; did you mean './robot.py'?"),
        ("./zzz", "there is no file './zzz'"),
        ("divides.py", "'divides.py' does not import: ZeroDivisionError"),
        ("empty.py", "'empty.py' has no generator function: an explorer is def explore(first)"),
    ],
)
def test_a_name_of_no_explorer_is_told_with_the_nearest_legal_one(
    name, said, refused, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    for file, text in (
        ("notes.txt", ""),
        ("robot.py", MINE),
        ("divides.py", "1 / 0"),
        ("empty.py", ""),
    ):
        (tmp_path / file).write_text(text, encoding="utf-8")
    assert said in refused("check", name, "--edges", 1)


def test_an_explorer_that_a_file_imports_is_found(cli, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "door.py").write_text(
        "from allworlds.explorers.builtin.algorithm1 import algorithm1 as explore\n",
        encoding="utf-8",
    )
    assert cli("check", "door.py", "--edges", 1, "-q")[0] == 0


@pytest.mark.parametrize(
    "command", ["python3 gone.py", "node gone.js", "python3 -u gone.py", "ruby -- gone.rb arg"]
)
def test_a_script_that_its_interpreter_cannot_open_is_bad_input(command, refused, monkeypatch):
    monkeypatch.setattr("shutil.which", lambda name: f"/usr/bin/{name}")
    said = refused("check", "--edges", 1, "--exec", command)
    gone = next(word for word in command.split() if word.startswith("gone"))
    assert f"cannot open '{gone}': there is no file '{gone}'" in said


@pytest.mark.parametrize(
    "command",
    [
        *(
            "python3 -m gone",
            "python3 -uc gone",
            "node -e gone",
            "node --eval=gone",
            "sh -c gone.sh",
        ),
        *("python3 -", "python3", "env", "node here.js gone.js", "node here", "mine gone.py"),
    ],
)
def test_a_command_without_a_script_or_with_one_that_is_there_is_not_refused(
    command, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "here.js").touch()
    assert missing_script(command.split()) == ""


def test_a_script_that_its_interpreter_cannot_read_is_a_crash_with_its_stderr(cli, tmp_path):
    script = tmp_path / "typo.py"
    script.write_text("a = 1\nb = = 1\n", encoding="utf-8")
    code, out, _ = cli("check", "--edges", 1, "--exec", f"{sys.executable} {script}")
    assert code == 1
    assert "crash" in out
    assert "SyntaxError: invalid syntax" in " ".join(out.split())


def test_two_explorers_of_one_name_are_told_apart(tmp_path, cli):
    files = [tmp_path / folder / "mine.py" for folder in ("one", "two")]
    for file in files:
        file.parent.mkdir()
        file.write_text(MINE, encoding="utf-8")
    code, out, _ = cli("compare", *files, "--edges", 1)
    assert code == 0
    assert "one/mine.py:explore" in "".join(out.split())
    assert "two/mine.py:explore" in "".join(out.split())


@pytest.mark.parametrize("name", ["cycle:5", "wheel:4", "wheel-4", "lattice:2x3"])
def test_a_world_has_one_name_in_run_play_and_compare(name, cli, tmp_path):
    _, ran, _ = cli("run", "dfs", name, "--lighthouse", "labels", "--json")
    _, played, _ = cli(
        "play", name, "--lighthouse", "labels", "--json", "-o", tmp_path / "page.html"
    )
    assert json.loads(ran)["world"] == json.loads(played)["world"]
    assert json.loads(ran)["world"]["lighthouse"]["kind"] == "labels"
    if ":" in name:
        code, out, _ = cli("compare", "folding-oldest", "algorithm1", "--family", name, "-q")
        assert code == 0
        code, out, _ = cli("run", "dfs", "--family", name, "--lighthouse", "labels", "--json")
        assert json.loads(out)["world"] == json.loads(ran)["world"]


def test_run_lists_the_names_of_worlds(cli, refused, tmp_path):
    code, out, _ = cli("run", "--list", "--json", "-o", (file := tmp_path / "names.csv"))
    assert "families,lattice:RxC" in file.read_text().splitlines()
    names = json.loads(out)
    assert code == 0
    assert "wheel:N" in names["maps"]
    assert "cycle:N" in names["families"]
    assert "fig2-step" in names["corpus"]
    for name in (*names["maps"], *names["corpus"]):
        assert world_named(name.replace(":N", ":3")).map.edge_count
    page = tmp_path / "page.html"
    assert cli("play", "wheel:3", "--lighthouse", "none", "-o", page)[0] == 0
    assert "lattice:RxC" in cli("run", "--list")[1]
    assert "'allworlds run --list'" in refused("run", "dfs", "whel")
