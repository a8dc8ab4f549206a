from pathlib import Path

import pytest

from allworlds.explorers.loading import Subject, in_process_subject, shield, source_of
from allworlds.explorers.sources import (
    content_digest,
    files_of_explorer,
    no_explorer,
    place_of_explorer,
    with_content,
)
from allworlds.inputs.checks import InputError

TEXT = '''\
"""An explorer."""

from elsewhere import another as other


class Inner:
    x = 0

    def explore(self):
        yield


def explore(first):
    yield


@decorated
def late(first):
    yield


named = explore
'''


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "placed.py").write_text(TEXT)
    return tmp_path


@pytest.mark.parametrize(
    ("attribute", "line"),
    [("explore", 13), ("Inner.explore", 9), ("other", 1), ("late", 18), ("named", 1), ("no", 1)],
)
@pytest.mark.parametrize("module", ["placed.py", "placed"])
def test_the_line_of_a_python_explorer_is_that_of_its_definition(folder, module, attribute, line):
    place = place_of_explorer(f"{module}:{attribute}")
    assert (place.file, place.line) == ((folder / "placed.py").resolve(), line)
    assert place.named_from(folder.resolve()) == "placed.py"
    assert place.is_in(folder.resolve())
    assert not place.is_in(folder.resolve() / "deeper")


def test_of_a_file_without_an_attribute_the_place_is_the_file(folder):
    place = place_of_explorer("placed.py")
    assert (place.file, place.line) == ((folder / "placed.py").resolve(), 1)


def test_the_files_with_which_an_explorer_changes_are_those_it_is_made_of(folder):
    for name in ("run.sh", "explorer.js", "fast.so", "fast.rs"):
        (folder / name).touch()
    assert files_of_explorer("exec:sh run.sh explorer.js x") == [
        Path("run.sh"),
        Path("explorer.js"),
    ]
    assert files_of_explorer("native:fast.so") == [Path("fast.so")]
    assert files_of_explorer("placed:explore") == [(folder / "placed.py").resolve()]
    for name in ("algorithm1", "exec:true", "exec:'", "native:missing.so", "missing.py:explore"):
        assert files_of_explorer(name) == []


@pytest.mark.parametrize(
    ("name", "file"),
    [
        ("exec:node explorer.js", "explorer.js"),
        ("exec:sh run.sh explorer.js --fast", "explorer.js"),
        ("native:./fast.so", "fast.so"),
    ],
)
def test_of_another_language_the_file_is_found(folder, name, file):
    for there in ("explorer.js", "run.sh", "fast.so"):
        (folder / there).touch()
    place = place_of_explorer(name)
    assert (place.file, place.line) == ((folder / file).resolve(), 1)


@pytest.mark.parametrize(
    ("name", "source"),
    [
        ("native:./fast.so", "fast.rs"),
        ("native:build/libfast.so", "build/fast.c"),
        ("exec:./fast --all", "fast.rs"),
        ("exec:build/fast", "build/fast.c"),
    ],
)
def test_of_compiled_code_the_place_is_the_source_beside_it(folder, name, source):
    (folder / "build").mkdir()
    for binary in ("fast.so", "fast", "build/libfast.so", "build/fast"):
        (folder / binary).write_bytes(b"\x7fELF\0")
    for text in ("fast.rs", "fast.md", "fast.h", "faster.c", "build/fast.c", "build/fast.o"):
        (folder / text).touch()
    assert place_of_explorer(name).file == (folder / source).resolve()
    (folder / source).unlink()
    assert place_of_explorer(name) is None


def test_of_a_python_module_as_a_program_the_place_is_its_file(folder):
    assert place_of_explorer("exec:python3 -m placed").file == (folder / "placed.py").resolve()
    assert files_of_explorer("exec:python3 -m this") == []


@pytest.mark.parametrize(
    "name",
    [
        "algorithm1",
        "missing.py:explore",
        "missing_module:explore",
        "exec:true",
        "exec:'",
        "native:missing.so",
        "broken.py:explore",
        "binary.py:explore",
    ],
)
def test_where_nobody_can_say_there_is_no_place(folder, name):
    (folder / "broken.py").write_text("def (")
    (folder / "binary.py").write_bytes(b"\xff\xfe")
    assert place_of_explorer(name) is None


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("placd.py", "; did you mean 'placed.py'?"),
        ("./placd.py", "; did you mean './placed.py'?"),
        ("far", ""),
    ],
)
def test_a_file_of_a_similar_name_is_told(folder, name, said):
    told = no_explorer(name, name, ["folding"])
    assert told.endswith(said or "path/to/file.py:attribute")


def test_a_folder_whose_name_is_too_long_has_no_files(folder):
    name = f"{'x' * 5000}/placed.py"
    assert no_explorer(name, name, ["folding"]).endswith("xxx...")


def test_an_explorer_of_this_process_alone_has_no_digest():
    subject = in_process_subject(lambda first: (yield))
    with pytest.raises(InputError, match=r"lives in this process alone.*; put it into a file of"):
        content_digest(subject)


def test_a_module_of_one_file_travels_as_its_text_and_others_do_not(folder, monkeypatch):
    monkeypatch.syspath_prepend(str(folder))
    for name in ("package", "compiled"):
        (folder / name).mkdir()
    (folder / "package" / "__init__.py").touch()
    assert with_content(Subject("placed:explore", frozenset())).source.text == TEXT
    for name in ("package:explore", "_ctypes:explore", "package.inner:explore", "algorithm1"):
        subject = Subject(name, frozenset())
        assert with_content(subject) is subject


def test_a_built_in_explorer_has_no_file_and_takes_no_arguments():
    assert source_of("algorithm1") is None
    with pytest.raises(
        InputError, match=r"^the built-in explorer algorithm1 takes no arguments, n"
    ):
        source_of("algorithm1?budget=3")


def test_the_shield_of_a_name_is_a_name():
    assert shield("folding") == "shield:folding"
