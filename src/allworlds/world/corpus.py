"""The corpus that ships with the package: known worlds, and every finding so far.

A manifest, and a file for each of its entries: named worlds, findings, pairs of worlds that
no motion tells apart, counts, and checks, with their provenance and what is expected of them.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias

from msgspec import Meta, Struct

from allworlds.document.reading import parse
from allworlds.document.struct import Document, Text, about
from allworlds.inputs.checks import parse_json

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
    """A directory with its manifest."""

    directory: Path
    entries: tuple[CorpusEntry, ...]

    def of_kind(self, kind: Kind) -> list[CorpusEntry]:
        """The entries of that kind, in the order of the manifest."""
        return [entry for entry in self.entries if entry.kind == kind]

    def document(self, entry: CorpusEntry) -> Any:
        """The JSON document of an entry."""
        return parse_json((self.directory / entry.file).read_text(encoding="utf-8"))


@cache
def own_corpus() -> Corpus:
    """The corpus that ships with the package."""
    package = Path(__file__).parents[1]
    installed = package / "corpus"
    directory = installed if installed.is_dir() else package.parents[1] / "corpus"
    document = parse_json((directory / MANIFEST).read_text(encoding="utf-8"))
    return Corpus(directory, parse(document, Manifest, MANIFEST).entries)
