"""Docstrings in plain words: an imperative or the returned noun first."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import allworlds

ROOT = Path(__file__).parents[2]
FOLDERS = {
    Path(allworlds.__file__).parent: 100,
    ROOT / "benchmarks": 5,
    ROOT / "proofs": 20,
    ROOT / "docsite": 5,
}
"""The folders whose docstrings are read, each with a number that its modules exceed."""

RIDDLES = ("Nothing", "None", "It", "The same", "What", "So many", "Whoever")
BEGINS_AS_RIDDLE = re.compile(rf"\W*(?:{'|'.join(RIDDLES)})\b", re.IGNORECASE)


def riddles(source: str) -> Iterator[str]:
    """Line and first words of each docstring that begins as no docstring should."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            told = ast.get_docstring(node)
            if told and BEGINS_AS_RIDDLE.match(told):
                yield f"{getattr(node, 'lineno', 1)}: {told.splitlines()[0]}"


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_no_docstring_begins_with_a_riddle(folder):
    inside = {path.relative_to(folder): path for path in sorted(folder.rglob("*.py"))}
    files = {name: path for name, path in inside.items() if "build" not in name.parts}
    assert len(files) > FOLDERS[folder]
    found = {
        str(name): told
        for name, path in files.items()
        if (told := [*riddles(path.read_text(encoding="utf-8"))])
    }
    assert not found


@pytest.mark.parametrize("word", RIDDLES)
@pytest.mark.parametrize(
    "source",
    [
        '"""{} is here."""',
        'class A:\n    """{}, as it travels."""',
        'def f():\n    """{}: nobody knows."""',
        'class A:\n    async def f(self):\n        r"""\n        ``{}`` is here.\n        """',
    ],
    ids=["module", "class", "function", "method"],
)
def test_a_docstring_that_begins_with_a_riddle_is_found(source, word):
    assert len([*riddles(source.format(word))]) == 1


@pytest.mark.parametrize(
    "told", ["Items of a list.", "Whether it holds.", "Items: what is told.", "Return None."]
)
def test_a_docstring_that_begins_plainly_is_not_found(told):
    assert not [*riddles(f'"""{told}"""')]
