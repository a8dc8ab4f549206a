"""**The** table of the pages by the verb, and a result as a page."""

from typing import Any

from allworlds.reports.html.frame import Own, Page, framed
from allworlds.reports.html.viewer import figure
from allworlds.verbs import loaded

PAGES = {
    "check": "reports.html.checks:check_page",
    "fuzz": "reports.html.checks:check_page",
    "run": "reports.html.runs:run_page",
    "replay": "reports.html.runs:replay_page",
    "explain": "reports.html.runs:explain_page",
    "ambiguity twins": "reports.html.lookalikes:twins_page",
    "ambiguity class": "reports.html.lookalikes:class_page",
    "ambiguity search": "reports.html.lookalikes:search_page",
    "worst": "reports.html.most_expensive:worst_page",
    "compare": "reports.html.comparison:comparison_page",
    "paper claims": "evidence.claims.claims_page:claims_page",
    "play": "reports.play.page:play_page",
}
"""The function that makes the page of each verb's result, as ``module:name``."""


def page(verb: str, result: Any) -> str:
    """A verb's result as an HTML document that refers to nothing outside of it."""
    return framed(loaded(PAGES[verb])(result))


def check_page(report: Any) -> str:
    """The page of a report of ``check`` or ``fuzz``."""
    return page("check", report)


__all__ = ["PAGES", "Own", "Page", "check_page", "figure", "page"]
