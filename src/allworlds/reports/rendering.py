"""**The** table of the files that results can be written to; texts and files of a result.

A new file of a report is a module of this package, and an entry of the table.
"""

from __future__ import annotations

import re
from functools import cache
from inspect import getdoc
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from allworlds.inputs import ensure_installed
from allworlds.lazy import loaded
from allworlds.verbs import BY_NAME, CASES, FINDINGS, GROWTH, ROWS, VERBS
from allworlds.words import escaped, harmless

if TYPE_CHECKING:
    from allworlds.document import Report
    from allworlds.reports.telling import ToldResult


class Format(Struct, frozen=True):
    """A file format of reports.

    Attributes:
        home: the module and the function that makes it of a telling.
        help: the help of the option.
        shows: what it shows; it is an option of every verb that has such.
        summary: the variable of a CI service that names a file to which the report is added
            without being asked for; empty where there is none.
        told_to: the variable by which a CI service says that it reads stderr for it, likewise.
    """

    home: str
    help: str
    shows: str = ROWS
    summary: str = ""
    told_to: str = ""


FORMATS = {
    "html": Format(
        "reports.html.html_page:html", "Also write a web page: one file, which needs no network."
    ),
    "markdown": Format(
        "reports.markdown:markdown",
        "Also write the report as Markdown.",
        summary="GITHUB_STEP_SUMMARY",
    ),
    "csv": Format(
        "reports.csv_rows:csv_rows",
        "Also write the rows as CSV; as Parquet, if FILE ends in .parquet (extra: notebook).",
    ),
    "junit": Format("reports.junit:junit", "Also write the report as JUnit XML.", CASES),
    "sarif": Format(
        "reports.sarif:sarif",
        "Also write the report as SARIF 2.1.0, for code scanning and editors.",
        FINDINGS,
    ),
    "annotations": Format(
        "reports.annotations:runner_commands",
        "Also write the findings as commands of GitHub's runners; there, stderr gets them anyway.",
        FINDINGS,
        told_to="GITHUB_ACTIONS",
    ),
    "plot": Format(
        "reports.growth_plot:growth_plot",
        "With --to: also draw the costs, as SVG; needs the extra 'figures'.",
        GROWTH,
    ),
}
"""Every kind of file by the name of its option."""


def formats_of(verb: str) -> dict[str, Format]:
    """The formats in which a verb's results can be written."""
    has = BY_NAME[verb].has
    return {name: form for name, form in FORMATS.items() if form.shows in has}


def told(verb: str, result: Any) -> ToldResult:
    """The telling of a verb's result."""
    telling: ToldResult = loaded(BY_NAME[verb].telling)(result)
    return telling


@cache
def verb_of(kind: type[Report]) -> str:
    """The verb whose report this is: its docstring begins with the name, or its folder has it."""
    named = re.match(r"Report of '([a-z ]+)", getdoc(kind) or "")
    words = named[1].strip() if named else kind.__module__.split(".")[2]
    return next(verb.name for verb in VERBS if f" {verb.name}".endswith(f" {words}"))


def text(verb: str, result: Any, width: int) -> str:
    """The text of a verb's result for a terminal with so many columns."""
    from allworlds.reports.plain_text import text

    return harmless(text(told(verb, result), width))


def brief(verb: str, result: Any, width: int) -> str:
    """Return the text that ``--quiet`` leaves: one line where there is a verdict, else all."""
    from allworlds.reports.plain_text import brief

    return harmless(brief(told(verb, result), width))


def finding_in_words(finding: Any, width: int, number: int = 1) -> str:
    """A finding with its picture, as in the text of ``check``."""
    from allworlds.reports.plain_text import text_of
    from allworlds.reports.tellings.finding import finding_section

    return harmless(text_of([finding_section(finding, number)], width))


def file_of(verb: str, form: str, result: Any) -> str:
    """The content of a file of that format."""
    text = loaded(FORMATS[form].home)(told(verb, result))
    return _fit_for_a_file(text, is_for_a_runner=bool(FORMATS[form].told_to))


PARQUET = ".parquet"
"""The end of the name of a file of rows that is no text."""


def parquet_of(verb: str, result: Any) -> bytes:
    """The content of a file of Parquet with the rows of a result."""
    from allworlds.reports.csv_rows import parquet_rows

    return parquet_rows(told(verb, result))


def ensure_parquet() -> None:
    """Refuse to go on unless files of Parquet can be written.

    Raises:
        InputError: if what writes them is not installed.
    """
    ensure_installed("pyarrow", "notebook", f"a file of rows that ends in {PARQUET}")


def ensure_drawable() -> None:
    """Refuse to go on unless curves can be drawn.

    Raises:
        InputError: if what draws them is not installed.
    """
    ensure_installed("matplotlib", "figures", "plot")


def _fit_for_a_file(text: str, *, is_for_a_runner: bool) -> str:
    """The text as a text file can hold it; its lines are commands only if they are to be.

    UTF-8 has no halves of pairs: the name of a file that is no UTF-8 holds some, and what an
    explorer says may hold any.
    """
    whole = re.sub("[\ud800-\udfff]", "\N{REPLACEMENT CHARACTER}", text)
    whole = whole.replace("\r", r"\x0d")
    return escaped(whole) if is_for_a_runner else harmless(whole)


__all__ = [
    "FORMATS",
    "PARQUET",
    "Format",
    "brief",
    "ensure_drawable",
    "ensure_parquet",
    "file_of",
    "finding_in_words",
    "formats_of",
    "parquet_of",
    "text",
    "told",
    "verb_of",
]
