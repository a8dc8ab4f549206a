"""``init``: the skeleton of an explorer, with its test and a workflow, or of a paper's ledger."""

import shlex
from collections.abc import Mapping
from dataclasses import KW_ONLY
from pathlib import Path
from typing import Annotated

from allworlds.documents.document import Positive, Text, about, computed, one_of
from allworlds.documents.report import Report
from allworlds.explorers.languages import LANGUAGES, SKELETONS, Language, templates
from allworlds.explorers.shared_library import INTERFACE_VERSION, header_text
from allworlds.inputs.checks import InputError, a_path, not_one_of, one_of as one_of_these, show
from allworlds.inputs.requests import OUTPUT, Argument, Option, Request, answers


class Skeleton(Report):
    """Report of 'init'.

    The skeleton that has been written: an explorer for the user to complete, its test, and a
    workflow. In the names of files `/` separates folders.
    """

    directory: Annotated[Path, about("as it was named")]
    lang: Annotated[str, about("of the explorer"), one_of(*LANGUAGES)]
    files: Annotated[
        tuple[Text, ...], about("that were written, relative to the directory, sorted")
    ]

    @computed
    def explorer(self) -> Text:
        """The name of the file with the explorer, which the user completes."""
        return self.language.explorer

    @computed
    def check(self) -> Text:
        """A shell command that checks the explorer."""
        return f"cd {shlex.quote(str(self.directory))} && {self.language.check}"

    @computed
    def test(self) -> Text:
        """A shell command that runs the explorer's test; to be run in the folder ``directory``."""
        return self.language.test

    @property
    def language(self) -> Language:
        """The language of the explorer, with the commands that check and test the explorer."""
        return LANGUAGES[self.lang]


class LedgerSkeleton(Report):
    """Report of 'init --ledger'.

    The ledger that has been written: two claims as an example, which the user replaces.
    """

    directory: Annotated[Path, about("as it was named")]
    files: Annotated[tuple[Text, ...], about("that were written, sorted")]

    @computed
    def check(self) -> Text:
        """A shell command that checks the claims."""
        return f"allworlds ledger {shlex.quote(str(self.directory))}"


class Header(Report, kw_only=True):
    """Report of 'init --header'.

    The C header of native explorers, which are shared libraries.
    """

    version: Annotated[Positive, about("of the interface: `ALLWORLDS_VERSION`")] = INTERFACE_VERSION
    header: Annotated[Text, about("`allworlds.h`")]


class InitRequest(Request, kw_only=False):
    """Request of ``init``: a skeleton of an explorer or of a ledger, or the C header."""

    directory: Annotated[
        str | Path | None,
        Argument("", "[DIR]", "The directory of the skeleton; no file in it is overwritten."),
    ] = None
    _: KW_ONLY
    lang: Annotated[
        str | None, Option(OUTPUT, "LANG", f"{one_of_these(LANGUAGES)} [default: python].")
    ] = None
    ledger: Annotated[
        bool,
        Option(OUTPUT, "", "Write instead the ledger of a paper, with two claims that run."),
    ] = False
    header: Annotated[
        bool,
        Option(
            OUTPUT,
            "",
            "Print instead the C header of native explorers, which includes their manual.",
        ),
    ] = False


@answers(InitRequest)
def init(request: InitRequest) -> Skeleton | LedgerSkeleton | Header:
    """Write a skeleton of an explorer, its test and a workflow into a directory.

    With ``ledger`` write the ledger of a paper instead, with two claims that can be checked.  With
    ``header`` write no file, and return the C header of native explorers.

    The directory may exist and have other files; no file is overwritten.

    Raises:
        InputError: if both a skeleton and the header are requested, or neither; if ``lang`` has no
            skeleton; if a file of the skeleton exists already (then nothing is written); or if a
            file cannot be written.
    """
    directory, lang = request.directory, request.lang
    if request.header:
        others = {"directory": directory, "lang": lang, "ledger": request.ledger or None}
        if given := [name for name, value in others.items() if value is not None]:
            raise InputError(
                f"init writes a skeleton or tells the header, not both: {given[0]} given"
            )
        return Header(header=header_text())
    if directory is None:
        raise InputError("init needs the directory of a skeleton, or --header for the C header")
    if request.ledger:
        if lang is not None:
            raise InputError(f"lang {show(lang)} has no effect beside ledger")
        texts = templates(Path(__file__).with_name("ledger_skeleton"))
        return LedgerSkeleton(directory=_written(directory, texts), files=tuple(texts))
    if lang is None:
        lang = "python"
    if lang not in LANGUAGES:
        raise not_one_of("lang", lang, LANGUAGES, also={"js": "javascript", "node": "javascript"})
    texts = templates(SKELETONS / lang)
    return Skeleton(directory=_written(directory, texts), lang=lang, files=tuple(texts))


def _written(directory: str | Path, texts: Mapping[str, str]) -> Path:
    """Write the files of a skeleton into ``directory``, and return the path of this folder.

    ``texts`` holds the text of each file, by the file's name below ``directory``.

    Raises:
        InputError: if one of the files exists already (then nothing is written), or cannot be
            written.
    """
    folder = a_path("directory", directory)
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
    return folder
