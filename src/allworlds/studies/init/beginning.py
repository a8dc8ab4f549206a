"""A skeleton that was written, or the C header: what an explorer begins with."""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal, overload

from allworlds.explorers import INTERFACE_VERSION, LANGUAGES, Language, header_text, templates
from allworlds.inputs import InputError, a_path, show
from allworlds.outcome import SCHEMA, Exit

if TYPE_CHECKING:
    from allworlds import documents


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

    def to_json(self) -> documents.InitDocument:
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


@dataclass(frozen=True, slots=True)
class Header:
    """The C header.

    Attributes:
        text: of the file.
    """

    text: str

    @property
    def exit_code(self) -> Exit:
        """The exit code of the command: a question was answered."""
        return Exit.ANSWERED

    def to_json(self) -> documents.HeaderDocument:
        """The document of ``init --header --json``."""
        return {"schema": SCHEMA, "version": INTERFACE_VERSION, "header": self.text}


@overload
def init(directory: str | Path, *, lang: str = "python") -> Skeleton: ...
@overload
def init(*, header: Literal[True]) -> Header: ...
@overload
def init(
    directory: str | Path | None = ..., *, lang: str | None = ..., header: bool = ...
) -> Skeleton | Header: ...
def init(
    directory: str | Path | None = None, *, lang: str | None = None, header: bool = False
) -> Skeleton | Header:
    """Write a skeleton of an explorer, its test and a workflow into a directory.

    The directory may be there already, with other files in it; no file is overwritten.

    Args:
        directory: need not exist yet.
        lang: one of :data:`~allworlds.explorers.LANGUAGES`; None (default) for ``python``.
        header: hand back the C header of native explorers instead; nothing is written.

    Raises:
        InputError: if both or neither are asked for, there is no skeleton in that language, one of
            its files is there already (then nothing is written), or a file cannot be written.
    """
    if header:
        if directory is not None or lang is not None:
            given = "directory" if directory is not None else "lang"
            raise InputError(f"init writes a skeleton or tells the header, not both: {given} given")
        return Header(header_text())
    if directory is None:
        raise InputError("init needs the directory of a skeleton, or --header for the C header")
    if lang is None:
        lang = "python"
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
