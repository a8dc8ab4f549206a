"""A skeleton: what is written where, and what to do with it."""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from allworlds.inputs import InputError, a_path, show
from allworlds.outcome import SCHEMA, Exit

if TYPE_CHECKING:
    from allworlds import documents

SUFFIX = ".template"


@dataclass(frozen=True, slots=True)
class Language:
    """How an explorer in a language is tried, in its folder.

    Attributes:
        explorer: its file.
        check: the command that builds it, if it must be built, and checks it.
        test: what runs its test.
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
"""Every language that there is a skeleton for."""


@dataclass(frozen=True, slots=True)
class Skeleton:
    """A skeleton that has been written.

    Attributes:
        directory: as it was named.
        lang: the name of the language.
        files: relative to the directory, with ``/``, sorted.
    """

    directory: Path
    lang: str
    files: tuple[str, ...]

    @property
    def language(self) -> Language:
        """How its explorer is tried."""
        return LANGUAGES[self.lang]

    @property
    def check(self) -> str:
        """The command that checks the explorer, from where the skeleton was made."""
        return f"cd {shlex.quote(str(self.directory))} && {self.language.check}"

    @property
    def exit_code(self) -> Exit:
        """The exit code of the command: it was done."""
        return Exit.ANSWERED

    def to_json(self) -> documents.InitReport:
        """The document of ``init --json``."""
        return {
            "schema": SCHEMA,
            "directory": str(self.directory),
            "lang": self.lang,
            "files": list(self.files),
            "explorer": self.language.explorer,
            "check": self.check,
            "test": self.language.test,
        }


def init(directory: str | Path, *, lang: str = "python") -> Skeleton:
    """A skeleton of an explorer, its test and a workflow, written into a directory.

    The directory may be there already, with other files in it; no file is overwritten.

    Args:
        directory: need not exist yet.
        lang: one of :data:`LANGUAGES`.

    Raises:
        InputError: if there is no skeleton in that language, one of its files is there already
            (then nothing is written), or a file cannot be written.
    """
    if lang not in LANGUAGES:
        raise InputError(f"lang {show(lang)} is not one of {', '.join(LANGUAGES)}")
    folder = a_path("directory", directory)
    texts = dict(templates(lang))
    there = [name for name in texts if (folder / name).exists() or (folder / name).is_symlink()]
    if there:
        raise InputError(
            f"directory {show(str(directory))} has {', '.join(there)} already, and nothing is "
            "overwritten; name another one"
        )
    for name, text in texts.items():
        file = folder / name
        try:
            file.parent.mkdir(parents=True, exist_ok=True)
            with file.open("x", encoding="utf-8") as made:
                made.write(text)
        except OSError as error:
            raise InputError(
                f"file {show(str(file))} cannot be written: {error.strerror}"
            ) from None
    return Skeleton(folder, lang, tuple(texts))


def templates(lang: str) -> Iterator[tuple[str, str]]:
    """The files of a language with their texts, sorted by their names."""
    found = _below(files("allworlds") / "skeletons" / lang, PurePosixPath())
    for name, file in sorted(found):
        yield name, file.read_text(encoding="utf-8")


def _below(folder: Traversable, name: PurePosixPath) -> Iterator[tuple[str, Traversable]]:
    for entry in folder.iterdir():
        if entry.is_dir():
            yield from _below(entry, name / entry.name)
        elif entry.name.endswith(SUFFIX):
            yield str(name / entry.name.removesuffix(SUFFIX)), entry
