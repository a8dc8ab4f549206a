"""The size of the house: what was reached, rounded up; nothing is added without a reason.

Lines of code are all but blank lines, comments, docstrings and imports.
"""

import ast
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).parents[2]


class Size(NamedTuple):
    """Of some files."""

    code: int
    lines: int


MOST = {"": 27_250, "engines": 6_350, "engines/kernel": 2_350}
"""Lines of code of folders of ``src/allworlds``; the whole has the name of none."""

MOST_OF_PAPERS = 8_200
"""Lines of the papers' programs, without tests."""

MOST_OF_PROOFS = 24_400
"""Lines of ``.v``, ``.py``, ``.ml`` and ``.smt2`` in ``proofs``."""


def size(paths):
    """The size of these Python files."""
    sources = [path.read_text(encoding="utf-8") for path in paths]
    lines = sum(len(source.splitlines()) for source in sources)
    return Size(sum(map(code, sources)), lines)


def code(source):
    """The number of lines of code."""
    left_out = set()
    for node in ast.walk(ast.parse(source)):
        text = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        docstring = text and isinstance(node.value.value, str)
        if docstring or isinstance(node, ast.Import | ast.ImportFrom):
            left_out.update(range(node.lineno, node.end_lineno + 1))
    numbered = enumerate(map(str.strip, source.splitlines()), 1)
    return sum(
        bool(line) and not line.startswith("#") and number not in left_out
        for number, line in numbered
    )


def test_lines_of_code_are_counted_as_is_said():
    assert size([Path(__file__)]).code < size([Path(__file__)]).lines
    assert (
        code('"""A.\n\nB."""\n\nimport x\nfrom y import (\n    z,\n)\n\n# C\na = 1\n\nb = 2\n') == 2
    )


@pytest.mark.parametrize(("folder", "most"), MOST.items())
def test_the_program_is_no_larger_than_it_was(folder, most):
    found = size((ROOT / "src" / "allworlds" / folder).rglob("*.py"))
    assert found.code <= most


def test_the_papers_are_no_larger_than_is_allowed():
    paths = (path for path in (ROOT / "papers").rglob("*.py") if "tests" not in path.parts)
    assert size(paths).lines <= MOST_OF_PAPERS


def test_the_proofs_are_no_larger_than_is_allowed():
    kinds = {".v", ".py", ".ml", ".smt2"}
    paths = [path for path in (ROOT / "proofs").rglob("*") if path.suffix in kinds]
    tracked = (p for p in paths if "build" not in p.parts and p.name != "certified.ml")
    assert sum(len(path.read_text().splitlines()) for path in tracked) <= MOST_OF_PROOFS
