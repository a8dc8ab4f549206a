"""Results as people and other programs read them; each report is loaded when it is asked for.

A verb's text is a function from a result and a width, which the table of the verbs names.

``FORMATS``
    **the** table of the files that a report of ``check`` or ``fuzz`` can be written to, by the
    option of the same name: a function from a report to a text.

A new report is a module here, and an entry of one of the two tables.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from allworlds.inputs import ensure_installed
from allworlds.verbs import VERBS


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
"""What the option for a page says, with whatever verb."""


FORMATS = {
    "junit": Format("junit:junit", "Write the report as JUnit XML too."),
    "html": Format("html:check_page", PAGE),
    "sarif": Format(
        "sarif:sarif", "Write the report as SARIF 2.1.0 too, for code scanning and editors."
    ),
    "markdown": Format(
        "markdown:markdown",
        "Write the report as Markdown too.",
        summary="GITHUB_STEP_SUMMARY",
    ),
    "annotations": Format(
        "annotations:runner_commands",
        "Write the findings as commands of GitHub's runners too; there stderr has them anyway.",
        told_to="GITHUB_ACTIONS",
    ),
}
"""Every kind of file by the name of its option."""


FILES = {
    ("claims", "junit"): "claims_junit:claims_junit",
    ("compare", "csv"): "compare_text:compare_csv",
    ("grow", "csv"): "grow_text:grow_csv",
    ("grow", "plot"): "grow_plot:grow_plot",
}
"""What else a verb's result can be written to, by the verb and the option; pages have a table of
their own, :data:`allworlds.reports.html.PAGES`."""

_TEXTS = {verb.name: verb.text for verb in VERBS}
_BRIEFS = {verb.name: verb.brief for verb in VERBS}


def text(verb: str, result: Any, width: int) -> str:
    """The text of a verb's result for a terminal with so many columns."""
    made: str = _load(_TEXTS[verb])(result, width)
    return made


def brief(verb: str, result: Any, width: int) -> str:
    """What ``--quiet`` leaves of it: one line where the verb has one, else all."""
    if not _BRIEFS[verb]:
        return text(verb, result, width)
    made: str = _load(_BRIEFS[verb])(result, width)
    return made


def finding_in_words(finding: Any, width: int) -> str:
    """A finding with its picture, as the text of ``check`` has it."""
    made: str = _load("run_text:finding_text")(finding, width)
    return made


def written(form: str, report: Any) -> str:
    """The content of a file of that format."""
    return _fit_for_a_file(_load(FORMATS[form].home)(report))


def file_of(verb: str, option: str, result: Any) -> str:
    """The content of the file of a verb's option: a page, or one of :data:`FILES`."""
    if option == "html":
        return page_of(verb, result)
    return _fit_for_a_file(_load(FILES[verb, option])(result))


def page_of(verb: str, result: Any) -> str:
    """A verb's result as a web page."""
    from allworlds.reports.html import page

    return page(verb, result)


def ensure_drawable() -> None:
    """Nothing, if curves can be drawn.

    Raises:
        InputError: if what draws them is not installed.
    """
    ensure_installed("matplotlib", "figures", "plot")


def _load(home: str) -> Any:
    module, _, function = home.partition(":")
    return getattr(import_module(f"allworlds.reports.{module}"), function)


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
