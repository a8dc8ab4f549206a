"""Every skeleton is built, run and refuted, until it is filled in.  Nothing is overwritten."""

import json

import pytest

from allworlds.explorers.languages import LANGUAGES, SKELETONS, templates
from allworlds.inputs.checks import InputError
from allworlds.studies.init import init
from shells import shell_in


@pytest.fixture
def shell(tmp_path):
    """A shell in an empty folder."""
    return shell_in(tmp_path, tmp_path / "bin")


def test_the_code_that_makes_a_skeleton_right_fits_into_it(shell, tmp_path):
    """The next step of a reader: the skeleton has the signature of a right explorer."""
    init(tmp_path / "mine")
    file = tmp_path / "mine" / "explorer.py"
    right = "\n\nfrom allworlds.explorers.builtin.algorithm1 import algorithm1 as explore\n"
    file.write_text(file.read_text() + right)
    done = shell("allworlds check explorer.py:explore --edges 2 -q", tmp_path / "mine")
    assert done.stdout.startswith("HOLDS"), done.stderr


@pytest.mark.parametrize("lang", LANGUAGES)
def test_what_is_said_to_be_written_is_all_that_is_written(lang, tmp_path, cli):
    code, out, err = cli("init", tmp_path / "a b", "--lang", lang, "--json")
    assert (code, err) == (0, "")
    document = json.loads(out)
    folder = tmp_path / "a b"
    there = sorted(
        file.relative_to(folder).as_posix() for file in folder.rglob("*") if file.is_file()
    )
    assert document["files"] == there
    assert document["explorer"] in there
    assert ".github/workflows/allworlds.yml" in there
    assert document["check"].startswith(f"cd '{folder}' && ")
    assert {name: (folder / name).read_text(encoding="utf-8") for name in there} == templates(
        SKELETONS / lang
    )


def test_what_a_language_needs_and_what_comes_next_is_told(tmp_path, cli):
    out = cli("init", tmp_path / "c", "--lang", "c")[1]
    assert "needs      cc, make\n" in out
    assert f"next\n  cd {tmp_path}/c && make && allworlds check --native ./explorer.so" in out
    assert "\nneeds " not in cli("init", tmp_path / "python")[1]


def test_no_file_is_overwritten_and_then_none_is_written(tmp_path, refused):
    (tmp_path / "explorer.c").write_text("mine")
    (tmp_path / "README.md").symlink_to("nowhere")
    line = refused("init", tmp_path, "--lang", "c")
    assert "has README.md, explorer.c already, and nothing is overwritten" in line
    assert sorted(file.name for file in tmp_path.iterdir()) == ["README.md", "explorer.c"]
    assert (tmp_path / "explorer.c").read_text() == "mine"


def test_a_directory_with_other_files_is_no_obstacle(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    made = init(tmp_path, lang="python")
    assert "explorer.py" in made.files
    assert (tmp_path / "notes.txt").read_text() == "mine"


def test_a_language_without_a_skeleton_is_refused_with_those_that_have_one(tmp_path, refused):
    line = refused("init", tmp_path / "new", "--lang", "cobol")
    assert "'cobol' is not one of python, javascript, c, rust" in line
    assert not (tmp_path / "new").exists()


def test_a_place_that_cannot_be_written_is_refused(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(InputError, match="cannot be written: Not a directory"):
        init(tmp_path / "file" / "new")


def test_every_language_has_its_folder_and_every_folder_its_language():
    there = {entry.name for entry in SKELETONS.iterdir() if entry.is_dir()} - {"__pycache__"}
    assert there == set(LANGUAGES)
    assert all(templates(SKELETONS / lang) for lang in LANGUAGES)


@pytest.mark.parametrize(("lang", "name"), [("c", "blocking.h"), ("rust", "fiber.rs")])
def test_a_blocking_interface_is_short(lang, name):
    assert len(templates(SKELETONS / lang)[name].splitlines()) <= 150


@pytest.mark.parametrize("lang", ["c", "rust"])
def test_a_library_has_a_target_for_each_tool_that_looks_at_memory(lang):
    makefile = templates(SKELETONS / lang)["Makefile"]
    for target in ("all", "test", "asan", "valgrind"):
        assert f"\n{target}:" in makefile
