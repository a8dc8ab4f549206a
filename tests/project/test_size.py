"""The size of the house: no part of it grows without a reason, and none beyond what one can read.

Lines of code are all but blank lines, comments, docstrings and imports.
"""

import ast
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

from project.test_wings import HOME, WINGS

ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "src" / "allworlds"


class Size(NamedTuple):
    """Of some files."""

    code: int
    lines: int


MOST = 31_745
"""Lines of code of ``src/allworlds``."""

MOST_OF_WING = {
    "ground": 1_300,
    "maps": 2_200,
    "protocol": 1_100,
    "world": 2_500,
    "explorers": 2_000,
    "judging": 2_300,
    "engines": 6_300,
    "robots": 2_400,
    "studies": 6_672,
    "reports": 4_300,
    "doors": 300,
    "cli": 900,
}
"""Lines of code of each wing: what was reached, rounded up to the next hundred."""

MOST_OF_MODULE = 400
"""Lines of code of a module."""

MOST_OF_FUNCTION = 60
"""Lines of a function, from its name to its end."""

MOST_ATTRIBUTES = 20
"""Attributes that a class sets on itself; fields that are declared do not count."""

MOST_OF_PAPERS = 9_800
"""Lines of the papers' programs, without tests."""

MOST_OF_PROOFS = 25_300
"""Lines of ``.v``, ``.py``, ``.ml`` and ``.smt2`` in ``proofs``."""


def size(paths):
    """The size of these Python files."""
    sources = [path.read_text(encoding="utf-8") for path in paths]
    lines = sum(len(source.splitlines()) for source in sources)
    return Size(sum(map(code, sources)), lines)


@cache
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


def sources():
    """``{path below src/allworlds: source}`` of every module."""
    paths = sorted(SOURCE.rglob("*.py"))
    below = {path.relative_to(SOURCE).as_posix(): path for path in paths}
    return {name: path.read_text(encoding="utf-8") for name, path in below.items()}


SOURCES = sources()


def too_large_wings(files):
    """The wings that are larger than is allowed, and ``the whole``, with their lines of code."""
    found = code_of_wings(files)
    larger = {wing: lines for wing, lines in found.items() if lines > MOST_OF_WING[wing]}
    whole = sum(map(code, files.values()))
    return larger if whole <= MOST else larger | {"the whole": whole}


def code_of_wings(files):
    """The lines of code of each wing among these files."""
    found = dict.fromkeys(WINGS, 0)
    for name, source in files.items():
        entry = name.partition("/")[0].removesuffix(".py")
        if entry in HOME:
            found[HOME[entry]] += code(source)
    return found


def too_large(source):
    """What in a module is larger than is allowed, by its name, with its size."""
    found = {}
    if (lines := code(source)) > MOST_OF_MODULE:
        found["the module"] = lines
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            lines = node.end_lineno - node.lineno + 1
            if lines > MOST_OF_FUNCTION:
                found[node.name] = lines
        elif isinstance(node, ast.ClassDef):
            attributes = len(attributes_of(node))
            if attributes > MOST_ATTRIBUTES:
                found[node.name] = attributes
    return found


def attributes_of(class_):
    """The names that a class sets on itself."""
    return {
        node.attr
        for node in ast.walk(class_)
        if isinstance(node, ast.Attribute)
        and isinstance(node.ctx, ast.Store)
        and isinstance(node.value, ast.Name)
        and node.value.id == "self"
    }


def test_lines_of_code_are_counted_as_is_said():
    assert size([Path(__file__)]).code < size([Path(__file__)]).lines
    assert (
        code('"""A.\n\nB."""\n\nimport x\nfrom y import (\n    z,\n)\n\n# C\na = 1\n\nb = 2\n') == 2
    )


def test_neither_the_program_nor_a_wing_is_larger_than_is_allowed():
    assert MOST_OF_WING.keys() == WINGS.keys()
    assert too_large_wings(SOURCES) == {}


@pytest.mark.parametrize("wing", WINGS)
def test_one_line_more_in_a_wing_is_found(wing):
    most = MOST_OF_WING[wing]
    name = f"{WINGS[wing].holds[0]}/a.py"
    assert too_large_wings({name: "a = 1\n" * most}) == {}
    assert too_large_wings({name: "a = 1\n" * (most + 1)}) == {wing: most + 1}


def test_one_line_more_in_the_whole_is_found():
    assert too_large_wings({"of_no_wing.py": "a = 1\n" * MOST}) == {}
    assert too_large_wings({"of_no_wing.py": "a = 1\n" * (MOST + 1)}) == {"the whole": MOST + 1}


def test_every_line_of_code_is_of_a_wing():
    assert sum(code_of_wings(SOURCES).values()) == sum(map(code, SOURCES.values()))


def test_a_line_is_counted_in_its_wing():
    files = {"maps/a.py": "a = 1\n", "maps/b/c.py": "b = 2\nc = 3\n", "verbs.py": "d = 4\n"}
    found = code_of_wings(files)
    assert (found["maps"], found["ground"], found["cli"]) == (3, 1, 0)


def test_no_module_no_function_and_no_class_is_too_large():
    found = {name: too_large(source) for name, source in SOURCES.items()}
    assert not {name: large for name, large in found.items() if large}


def made_up(function, attributes, module=0):
    """A module with a function, a class and lines besides of these sizes."""
    body = ["    pass"] * (function - 1)
    named = ["        self.set = 0", *(f"        self.a{i} = {i}" for i in range(attributes - 1))]
    class_ = ["class Large:", "    declared: int", "    def set_all(self, other):", *named]
    class_ += ["        self.set += other.b", "        other.c = self.d"]
    lines = ["def long():", *body, *class_]
    return "\n".join([*lines, *["x = 0"] * (module - len(lines))])


@pytest.mark.parametrize(
    ("sizes", "name"),
    [
        ({"function": MOST_OF_FUNCTION}, "long"),
        ({"attributes": MOST_ATTRIBUTES}, "Large"),
        ({"module": MOST_OF_MODULE}, "the module"),
    ],
)
def test_one_more_than_is_allowed_is_found(sizes, name):
    smallest = {"function": 2, "attributes": 1}
    ((what, most),) = sizes.items()
    assert too_large(made_up(**smallest | sizes)) == {}
    assert too_large(made_up(**smallest | {what: most + 1})) == {name: most + 1}


def test_the_papers_are_no_larger_than_is_allowed():
    paths = (path for path in (ROOT / "papers").rglob("*.py") if "tests" not in path.parts)
    assert size(paths).lines <= MOST_OF_PAPERS


def test_the_proofs_are_no_larger_than_is_allowed():
    kinds = {".v", ".py", ".ml", ".smt2"}
    paths = [path for path in (ROOT / "proofs").rglob("*") if path.suffix in kinds]
    tracked = (p for p in paths if "build" not in p.parts and p.name != "certified.ml")
    assert sum(len(path.read_text().splitlines()) for path in tracked) <= MOST_OF_PROOFS
