"""**The** table of the files that results can be written to, and which name means which."""

from __future__ import annotations

import re
from typing import Any

from allworlds.inputs.checks import InputError, ensure_installed, show
from allworlds.reports.file_format import Format
from allworlds.reports.formats import (
    annotations as commands,
    csv,
    html,
    json,
    junit,
    markdown,
    sarif,
)
from allworlds.reports.rendering import told
from allworlds.verbs import BY_NAME
from allworlds.words import escaped, harmless

FORMATS: dict[str, Format] = {
    "html": html.FORMAT,
    "markdown": markdown.FORMAT,
    "csv": csv.FORMAT,
    "json": json.FORMAT,
    "parquet": csv.PARQUET,
    "sarif": sarif.FORMAT,
    "junit": junit.FORMAT,
    "annotations": commands.FORMAT,
}
"""Every format by its name."""


def formats_of(verb: str) -> dict[str, Format]:
    """The formats in which a verb's results can be written."""
    has = {*BY_NAME[verb].has}
    return {name: form for name, form in FORMATS.items() if not form.shows or has & {*form.shows}}


def legal_files(verb: str) -> str:
    """The names of files that a verb can write, in words."""
    forms = formats_of(verb)
    names = " ".join(form.suffix for form in forms.values() if form.suffix)
    return f"{names}, or FORMAT:FILE ({', '.join(forms)})"


def form_and_path(verb: str, name: str) -> tuple[str, str]:
    """The format and the path that a FILE means.

    Raises:
        InputError: if this verb writes no such file, or a library is not installed.
    """
    forms = formats_of(verb)
    form, colon, path = name.partition(":")
    if not colon or not form.isalpha():
        named = (each for each, made in forms.items() if name.endswith(made.suffix or "\0"))
        form, path = next(named, ""), name
    if form not in forms:
        raise InputError(f"-o {show(name)} is no file that {verb} writes: {legal_files(verb)}")
    if library := forms[form].library:
        ensure_installed(*library)
    return form, path


def file_of(verb: str, form: str, result: Any) -> Any:
    """The content of a file of that format: a text, or bytes if it is none."""
    format_ = FORMATS[form]
    made = format_.of_telling(told(verb, result))
    return made if isinstance(made, bytes) else _fit_for_a_file(made, bool(format_.told_to))


def _fit_for_a_file(text: str, is_for_a_runner: bool) -> str:
    """The text as a text file can hold it.

    Lines that look like commands of a CI service are made harmless, unless the format is made of
    such commands.

    UTF-8 has no halves of pairs: the name of a file that is no UTF-8 holds some, and what an
    explorer says may hold any.
    """
    whole = re.sub("[\ud800-\udfff]", "\N{REPLACEMENT CHARACTER}", text)
    whole = whole.replace("\r", r"\x0d")
    return escaped(whole) if is_for_a_runner else harmless(whole)
