"""**The** tables of the files that results can be written to; texts and files of a result.

A new file of a report is a module of this package, and an entry of one of the two tables.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from allworlds.inputs import ensure_installed
from allworlds.verbs import VERBS, loaded


@dataclass(frozen=True, slots=True)
class Format:
    """A kind of file.

    Attributes:
        home: where it is made: module and function.
        help: what the option says.
        summary: the variable of a CI service that names a file to which the report is added
            without being asked for; empty where there is none.
        told_to: the variable by which a CI service says that it reads stderr for it, likewise.
    """

    home: str
    help: str
    summary: str = ""
    told_to: str = ""


PAGE = "Write a web page too: one file, which needs no network."
"""The help of the option for a page, of every verb."""


FORMATS = {
    "junit": Format("reports.junit:junit", "Write the report as JUnit XML too."),
    "html": Format("reports.html.pages:check_page", PAGE),
    "sarif": Format(
        "reports.sarif:sarif", "Write the report as SARIF 2.1.0 too, for code scanning and editors."
    ),
    "markdown": Format(
        "reports.markdown:markdown",
        "Write the report as Markdown too.",
        summary="GITHUB_STEP_SUMMARY",
    ),
    "annotations": Format(
        "reports.annotations:runner_commands",
        "Write the findings as commands of GitHub's runners too; there stderr has them anyway.",
        told_to="GITHUB_ACTIONS",
    ),
}
"""Every kind of file by the name of its option."""


FILES = {
    ("paper claims", "junit"): "evidence.claims.claims_junit:claims_junit",
    ("compare", "csv"): "reports.compare_text:compare_csv",
    ("compare", "plot"): "reports.growth_plot:growth_plot",
}
"""Other files of a verb's result, by the verb and the option; pages have a table of
their own, :data:`allworlds.reports.html.pages.PAGES`."""

_TEXTS = {verb.name: verb.text for verb in VERBS}
_BRIEFS = {verb.name: verb.brief for verb in VERBS}


def text(verb: str, result: Any, width: int) -> str:
    """The text of a verb's result for a terminal with so many columns."""
    made: str = loaded(_TEXTS[verb])(result, width)
    return made


def brief(verb: str, result: Any, width: int) -> str:
    """Return the text that ``--quiet`` leaves: one line where the verb has one, else all."""
    if not _BRIEFS[verb]:
        return text(verb, result, width)
    made: str = loaded(_BRIEFS[verb])(result, width)
    return made


def finding_in_words(finding: Any, width: int) -> str:
    """A finding with its picture, as the text of ``check`` has it."""
    made: str = loaded("reports.run_text:finding_text")(finding, width)
    return made


def written(form: str, report: Any) -> str:
    """The content of a file of that format."""
    return _fit_for_a_file(loaded(FORMATS[form].home)(report))


def file_of(verb: str, option: str, result: Any) -> str:
    """The content of the file of a verb's option: a page, or one of :data:`FILES`."""
    if option == "html":
        return page_of(verb, result)
    return _fit_for_a_file(loaded(FILES[verb, option])(result))


def page_of(verb: str, result: Any) -> str:
    """A verb's result as a web page."""
    from allworlds.reports.html.pages import page

    return page(verb, result)


def ensure_drawable() -> None:
    """Refuse to go on unless curves can be drawn.

    Raises:
        InputError: if what draws them is not installed.
    """
    ensure_installed("matplotlib", "figures", "plot")


def _fit_for_a_file(text: str) -> str:
    """The text with a sign in place of what no text file should hold, or can.

    That is control characters, and halves of pairs, which UTF-8 has not: the name of a file that
    is no UTF-8 holds some, and what an explorer says may hold any.
    """
    return re.sub("[\x00-\x08\x0b-\x1f\x7f\ud800-\udfff]", "\N{REPLACEMENT CHARACTER}", text)


__all__ = [
    "FILES",
    "FORMATS",
    "PAGE",
    "Format",
    "brief",
    "ensure_drawable",
    "file_of",
    "finding_in_words",
    "page_of",
    "text",
    "written",
]
