"""The languages of skeletons: the files of each, and the commands that try an explorer.

A skeleton is files that build and run, and are still wrong.  Those of a language lie in the folder
of its name in ``skeletons``, each with ``.template`` after its own name.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import PurePosixPath

from msgspec import Struct

SUFFIX = ".template"


class Language(Struct, frozen=True):
    """A language, with the commands that try an explorer in its folder.

    Attributes:
        explorer: its file.
        check: the command that builds it, if it must be built, and checks it.
        test: the command that runs its test.
        needs: the programs, besides this one, that these commands call.
    """

    explorer: str
    check: str
    test: str
    needs: tuple[str, ...] = ()


LANGUAGES = {
    "python": Language(
        "explorer.py", "allworlds check explorer.py:explore --edges 4", "python -m pytest"
    ),
    "javascript": Language(
        "explorer.js", "allworlds check --exec 'node explorer.js' --edges 4", "npm test", ("node",)
    ),
    "c": Language(
        "explorer.c",
        "make && allworlds check --native ./explorer.so --edges 4",
        "make test",
        ("cc", "make"),
    ),
    "rust": Language(
        "explorer.rs",
        "make && allworlds check --native ./explorer.so --edges 4",
        "make test",
        ("rustc", "make"),
    ),
}
"""Every language with a skeleton."""


def templates(lang: str) -> Iterator[tuple[str, str]]:
    """The files of a language with their texts, sorted by their names."""
    return templates_in(files("allworlds.explorers") / "skeletons" / lang)


def templates_in(folder: Traversable) -> Iterator[tuple[str, str]]:
    """The files of a skeleton with their texts, sorted by their names."""
    for name, file in sorted(_below(folder, PurePosixPath())):
        yield name, file.read_text(encoding="utf-8")


def _below(folder: Traversable, name: PurePosixPath) -> Iterator[tuple[str, Traversable]]:
    for entry in folder.iterdir():
        if entry.is_dir():
            yield from _below(entry, name / entry.name)
        elif entry.name.endswith(SUFFIX):
            yield str(name / entry.name.removesuffix(SUFFIX)), entry
