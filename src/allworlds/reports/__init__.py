"""Results as people and other programs read them; each report is loaded when it is asked for.

``TEXTS``
    **the** table of the texts, by verb: a function from a result and a width to a text;
``FORMATS``
    **the** table of the files that a report of ``check`` or ``fuzz`` can be written to, by the
    option of the same name: a function from a report to a text.

A new report is a module here, and an entry of one of the tables.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import Any

TEXTS = {
    "ambiguity census": "ambiguity_text:census_text",
    "ambiguity class": "ambiguity_text:class_text",
    "bench": "bench_text:bench_text",
    "check": "check_text:check_text",
    "count": "count_text:count_text",
    "explain": "explain_text:explain_text",
    "fuzz": "check_text:check_text",
    "mutants": "mutants_text:mutants_text",
    "replay": "run_text:replay_text",
    "run": "run_text:run_text",
    "search": "search_text:search_text",
    "twins": "ambiguity_text:twins_text",
    "worst": "worst_text:worst_text",
}
"""Where the text of each verb is made: module and function."""


@dataclass(frozen=True, slots=True)
class Format:
    """A kind of file.

    Attributes:
        home: where it is made: module and function.
        help: what the option says.
    """

    home: str
    help: str


FORMATS = {
    "junit": Format("junit:junit", "Write the report as JUnit XML too."),
    "html": Format(
        "html:page", "Write the report as a web page too: one file, which needs no network."
    ),
}
"""Every kind of file by the name of its option."""


def text(verb: str, result: Any, width: int) -> str:
    """The text of a verb's result for a terminal with so many columns."""
    made: str = _load(TEXTS[verb])(result, width)
    return made


def written(form: str, report: Any) -> str:
    """The content of a file of that format."""
    made: str = _load(FORMATS[form].home)(report)
    return made


def _load(home: str) -> Any:
    module, _, function = home.partition(":")
    return getattr(import_module(f"allworlds.reports.{module}"), function)


__all__ = ["FORMATS", "TEXTS", "Format", "text", "written"]
