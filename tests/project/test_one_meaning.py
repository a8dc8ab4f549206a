"""A word of the table in ``docs/ARCHITECTURE.md`` has one meaning wherever it is a name.

What a parameter, a field or the value of a function so named may be follows from its annotation.
"""

import ast
from collections.abc import Iterator
from fnmatch import fnmatch

import pytest

from project.test_size import SOURCES
from project.test_tables import page, section

GENERAL = {"Any", "T"}
"""Names that say nothing of a meaning."""

PUBLIC = {
    "maps/build.py rows": "rows of a lattice: a keyword of lattice()",
    "maps/families.py rows": "rows of a lattice or a torus, as in maps/build.py",
    "maps/mixture.py rows": "rows of a lattice, as in maps/build.py",
    "studies/ledger.py told": "a sentence: a key of the ledger's document",
}
"""Names that users give or read, with their other meaning."""


def words() -> dict[str, set[str]]:
    """Each word with the patterns of the names of its types."""
    rows = [
        line.split("|")[1:4]
        for line in section(page("docs/ARCHITECTURE.md"), "Words").splitlines()
        if line.startswith("| `")
    ]
    return {
        word.strip(" `"): set(types.replace("`", "").replace(",", " ").split())
        for word, _, types in rows
    }


WORDS = words()


def second_meanings(source: str) -> Iterator[tuple[str, str]]:
    """Each word that is a name in this module for something of another type, with that type."""
    for name, annotation in annotated(ast.parse(source)):
        if name in WORDS:
            legal = WORDS[name] | GENERAL
            found = [*names_in(annotation)]
            if not any(fnmatch(one, pattern) for one in found for pattern in legal):
                yield name, ast.unparse(annotation)


def annotated(tree: ast.Module) -> Iterator[tuple[str, ast.expr]]:
    """The parameters, the fields and the functions with their annotations.

    A field ``Annotated[...]`` is a key of a document or an option of a verb, and left out.
    """
    for node in ast.walk(tree):
        match node:
            case ast.arg(name, ast.expr() as annotation):
                yield name, annotation
            case ast.AnnAssign(ast.Name(name), annotation) if "Annotated" not in ast.unparse(
                annotation
            ):
                yield name, annotation
            case ast.FunctionDef(name, returns=ast.expr() as annotation):
                yield name, annotation


def names_in(annotation: ast.AST) -> Iterator[str]:
    """The names of types in an annotation, without their modules."""
    match annotation:
        case ast.Attribute(attr=name) | ast.Name(name):
            yield name
        case ast.Constant(str(text)):
            yield from names_in(ast.parse(text, mode="eval"))
        case _:
            for part in ast.iter_child_nodes(annotation):
                yield from names_in(part)


def test_the_words_are_told():
    assert [*WORDS][:6] == ["engine", "judge", "place", "rows", "records", "told"]
    assert [*WORDS][6:] == ["acts", "dialogue", "timing", "transition"]  # of several robots


def test_no_word_has_a_second_meaning():
    found = {
        f"{module} {word}": annotation
        for module, source in SOURCES.items()
        for word, annotation in second_meanings(source)
    }
    assert {key: found[key] for key in found.keys() - PUBLIC.keys()} == {}
    assert found.keys() >= PUBLIC.keys()


@pytest.mark.parametrize(
    "source",
    [
        "def f(place: Lighthouse): pass",
        "class A:\n    rows: tuple[int, ...]",
        "def f(judge: 'Examiner | None'): pass",
        "def told() -> list[laws.Violation]: pass",
    ],
)
def test_a_second_meaning_is_found(source):
    assert [*second_meanings(source)]


@pytest.mark.parametrize(
    "source",
    [
        "def f(place: int | None): pass",
        "class A:\n    rows: tuple[parts.CheckRow, ...]",
        "class A:\n    told: Annotated[bool, about('a key')]",
        "def f(judge: 'PythonJudge', places: str): pass",
    ],
)
def test_its_own_meaning_and_other_words_are_not(source):
    assert not [*second_meanings(source)]
