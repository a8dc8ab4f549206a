"""The telling of a result, found by its verb, and its texts for a terminal."""

from __future__ import annotations

import re
from functools import cache
from inspect import getdoc
from typing import TYPE_CHECKING, Any

from allworlds.lazy import loaded
from allworlds.verbs import BY_NAME, VERBS
from allworlds.words import harmless

if TYPE_CHECKING:
    from allworlds.document import Report
    from allworlds.reports.telling import ToldResult


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


__all__ = [
    "brief",
    "finding_in_words",
    "text",
    "told",
    "verb_of",
]
