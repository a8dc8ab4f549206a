"""Skeletons of explorers, and the C header."""

from __future__ import annotations

import shlex
from dataclasses import KW_ONLY
from pathlib import Path
from typing import Annotated, Literal, overload

from allworlds.document import Positive, Report, Text, about, computed, one_of
from allworlds.explorers import INTERFACE_VERSION, LANGUAGES, Language, header_text, templates
from allworlds.inputs import (
    OUTPUT,
    Argument,
    InputError,
    Option,
    Request,
    a_path,
    one_of as one_of_these,
    show,
    takes_fields,
)


class Skeleton(Report):
    """Report of 'init'.

    A skeleton that has been written; `/` stands in the names of its files.
    """

    directory: Annotated[Path, about("as it was named")]
    lang: Annotated[str, about("of the explorer"), one_of(*LANGUAGES)]
    files: Annotated[
        tuple[Text, ...], about("that were written, relative to the directory, sorted")
    ]
    explorer: Annotated[Text, about("the file of the explorer, to be completed")] = computed(
        lambda skeleton: skeleton.language.explorer
    )
    check: Annotated[Text, about("a shell command that checks it")] = computed(
        lambda made: f"cd {shlex.quote(str(made.directory))} && {made.language.check}"
    )
    test: Annotated[Text, about("a shell command that runs its test, in the directory")] = computed(
        lambda skeleton: skeleton.language.test
    )

    @property
    def language(self) -> Language:
        """The language of the explorer, with the commands that try it."""
        return LANGUAGES[self.lang]


class Header(Report):
    """Report of 'init --header'.

    The C header.
    """

    version: Annotated[Positive, about("of the interface: `ALLWORLDS_VERSION`")] = INTERFACE_VERSION
    header: Annotated[Text, about("`allworlds.h`")]


class InitRequest(Request, kw_only=False):
    """Request of ``init``: a skeleton, or the header."""

    directory: Annotated[
        str | Path | None,
        Argument("", "[DIR]", "The directory of the skeleton; no file in it is overwritten."),
    ] = None
    _: KW_ONLY
    lang: Annotated[
        str | None, Option(OUTPUT, "LANG", f"{one_of_these(LANGUAGES)} [default: python].")
    ] = None
    header: Annotated[
        bool,
        Option(
            OUTPUT,
            "",
            "Print instead the C header of native explorers, which includes their manual.",
        ),
    ] = False


def begun(request: InitRequest) -> Skeleton | Header:
    """Answer a request of ``init``."""
    directory, lang = request.directory, request.lang
    if request.header:
        if directory is not None or lang is not None:
            given = "directory" if directory is not None else "lang"
            raise InputError(f"init writes a skeleton or tells the header, not both: {given} given")
        return Header(header=header_text())
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
    return Skeleton(directory=folder, lang=lang, files=tuple(texts))


@overload
def init(directory: str | Path, *, lang: str = "python") -> Skeleton: ...
@overload
def init(*, header: Literal[True]) -> Header: ...
@overload
def init(
    directory: str | Path | None = ..., *, lang: str | None = ..., header: bool = ...
) -> Skeleton | Header: ...
@takes_fields(InitRequest, answered=begun)
def init(
    directory: str | Path | None = None, *, lang: str | None = None, header: bool = False
) -> Skeleton | Header:
    """Write a skeleton of an explorer, its test and a workflow into a directory.

    The directory may be there already, with other files in it; no file is overwritten.

    Raises:
        InputError: if both or neither are asked for, there is no skeleton in that language, one of
            its files is there already (then nothing is written), or a file cannot be written.
    """
    return begun(InitRequest(directory, lang=lang, header=header))
