"""The corpus that ships with the package: known worlds, and every finding so far.

A manifest, and a file for each of its entries: named worlds, findings, pairs of worlds that
no motion tells apart, counts, and checks, with their provenance and what is expected of them.
"""

from __future__ import annotations

import errno
import hashlib
import os
from collections import Counter
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias

from msgspec import Meta, Struct

from allworlds.document.reading import taken
from allworlds.document.struct import Document, Text, about
from allworlds.inputs.checks import InputError, parse_json, show

Kind: TypeAlias = Literal["world", "finding", "pair", "counts", "check"]

MANIFEST = "manifest.json"


class CorpusEntry(Document):
    """An entry of a corpus.

    Its file holds a WORLD, a FINDING, a pair of worlds, counts, or the options of a check.
    """

    name: Annotated[Text, about("unique in the corpus")]
    kind: Annotated[Kind, about("what the file holds")]
    file: Annotated[Text, about("where it stands, below the corpus")]
    sha256: Annotated[str, Meta(pattern="^[0-9a-f]{64}$"), about("of the file")]
    provenance: Annotated[Text, about("where it comes from")]
    expected: Annotated[dict[str, Any], about("what must come out when it is tried")]


class Manifest(Document):
    """Manifest of a corpus."""

    schema: Annotated[Literal[1], about("the version of the document")]
    entries: Annotated[
        tuple[CorpusEntry, ...], about("what is kept, in the order in which it is told")
    ]


class Corpus(Struct, frozen=True):
    """A directory with its manifest, which has been checked for shape.

    Files are checked against their digests when they are read.
    """

    directory: Path
    entries: tuple[CorpusEntry, ...]

    def of_kind(self, kind: Kind) -> list[CorpusEntry]:
        """The entries of that kind, in the order of the manifest."""
        return [entry for entry in self.entries if entry.kind == kind]

    def named(self, name: str) -> CorpusEntry:
        """The entry of that name.

        Raises:
            InputError: naming those that there are.
        """
        for entry in self.entries:
            if entry.name == name:
                return entry
        raise InputError(
            f"corpus entry {show(name)} is not one of "
            f"{', '.join(entry.name for entry in self.entries)}"
        )

    def document(self, entry: CorpusEntry) -> Any:
        """The JSON document of an entry.

        Raises:
            InputError: naming the entry, if its file is missing or is not what it was.
        """
        owner = f"corpus entry {show(entry.name)}"
        text = _text(self.directory / entry.file, owner, f"{owner}: {show(entry.file)}")
        digest = hashlib.sha256(text.encode()).hexdigest()
        if digest != entry.sha256:
            raise InputError(
                f"{owner}: {show(entry.file)} has the digest "
                f"{digest[:12]}..., but its manifest says {show(entry.sha256[:12])}..."
            )
        return parse_json(text)


def load_corpus(directory: Path) -> Corpus:
    """The corpus of a directory.

    Raises:
        InputError: if there is no manifest, or naming what in it is none.
    """
    what = f"corpus {directory}: {MANIFEST}"
    text = _text(directory / MANIFEST, what, what)
    try:
        entries = taken(parse_json(text), Manifest, MANIFEST).entries
    except InputError as error:
        raise InputError(f"corpus {directory}: {error}") from None
    names = Counter(entry.name for entry in entries)
    for name, times in names.items():
        if times > 1:
            raise InputError(f"corpus entry {show(name)} occurs twice")
    return Corpus(directory, entries)


def _text(file: Path, owner: str, name: str) -> str:
    """The text of a file; raise InputError, with these words before the reason, if it has none."""
    try:
        return file.read_bytes().decode()
    except UnicodeDecodeError:
        raise InputError(f"{name} is no text") from None
    except OSError as error:
        raise InputError(f"{owner}: {error.strerror}") from None
    except ValueError:  # no file can be named so
        raise InputError(f"{owner}: {os.strerror(errno.ENOENT)}") from None


@cache
def own_corpus() -> Corpus:
    """The corpus that ships with the package."""
    package = Path(__file__).parents[1]
    installed = package / "corpus"
    return load_corpus(installed if installed.is_dir() else package.parents[1] / "corpus")
