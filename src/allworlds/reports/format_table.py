"""**The** table of the files that results can be written to, found in the folder ``formats``."""

from __future__ import annotations

import re
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from allworlds.inputs.checks import ensure_installed
from allworlds.reports import formats
from allworlds.reports.file_format import Format
from allworlds.reports.rendering import told
from allworlds.verbs import BY_NAME, CASES, FINDINGS, GROWTH, ROWS
from allworlds.words import escaped, harmless

_SHOWN = (ROWS, CASES, FINDINGS, GROWTH)
"""The order of the options: first those for what most verbs have."""


def all_formats() -> dict[str, Format]:
    """Return the format of every module of the folder, in the order of the options."""
    names = sorted(module.name for module in iter_modules(formats.__path__))
    found = {name: import_module(f"{formats.__name__}.{name}").FORMAT for name in names}
    return dict(sorted(found.items(), key=lambda told: _SHOWN.index(told[1].shows)))


FORMATS: dict[str, Format] = all_formats()
"""Every format by the name of its option."""


def formats_of(verb: str) -> dict[str, Format]:
    """The formats in which a verb's results can be written."""
    has = BY_NAME[verb].has
    return {name: form for name, form in FORMATS.items() if form.shows in has}


def file_of(verb: str, form: str, result: Any) -> str:
    """The text of a file of that format."""
    format_ = FORMATS[form]
    text = format_.of_telling(told(verb, result))
    return _fit_for_a_file(text, is_for_a_runner=bool(format_.told_to))


def content_of(verb: str, form: str, result: Any, name: str) -> bytes:
    """The content of a file of that format and name."""
    if binary := FORMATS[form].binary_for(name):
        return binary.of_telling(told(verb, result))
    return file_of(verb, form, result).encode()


def ensure_possible(form: str, name: str) -> None:
    """Refuse to go on unless a file of that format and name can be made.

    Raises:
        InputError: if a library is not installed.
    """
    format_ = FORMATS[form]
    binary = format_.binary_for(name)
    library = binary.library if binary else format_.library
    if library:
        ensure_installed(*library)


def _fit_for_a_file(text: str, *, is_for_a_runner: bool) -> str:
    """The text as a text file can hold it.

    Lines that look like commands of a CI service are made harmless, unless the format is made of
    such commands.

    UTF-8 has no halves of pairs: the name of a file that is no UTF-8 holds some, and what an
    explorer says may hold any.
    """
    whole = re.sub("[\ud800-\udfff]", "\N{REPLACEMENT CHARACTER}", text)
    whole = whole.replace("\r", r"\x0d")
    return escaped(whole) if is_for_a_runner else harmless(whole)
