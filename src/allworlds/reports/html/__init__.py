"""A result as one page that needs nothing else: no network, no other file, no script to be read.

``PAGES``
    **the** table of the kinds of pages, by the verb;
``checks``, ``runs``, ``alike``, ``dearest``, ``comparison``, ``claims``
    what each kind says;
``frame``
    what every page has round it;
``findings``, ``viewer``, ``walk``, ``plot``
    parts of pages: a finding, pictures to step through, a walk as a list of steps, and cost
    against bound;
``beside``, ``known``
    pictures of two maps side by side, and of what an explorer knows beside its world;
``style.css``, ``script.js``
    what a page looks like, and the keys that step along a walk.
"""

from importlib import import_module
from typing import Any

from allworlds.reports.html.frame import Own, Page, framed
from allworlds.reports.html.viewer import figure

PAGES = {
    "check": "html.checks:check_page",
    "fuzz": "html.checks:check_page",
    "run": "html.runs:run_page",
    "replay": "html.runs:replay_page",
    "explain": "html.runs:explain_page",
    "twins": "html.alike:twins_page",
    "ambiguity class": "html.alike:class_page",
    "search": "html.alike:search_page",
    "worst": "html.dearest:worst_page",
    "compare": "html.comparison:comparison_page",
    "claims": "html.claims:claims_page",
    "play": "play:play_page",
}
"""What makes the page of each verb's result: module and function."""


def page(verb: str, result: Any) -> str:
    """A verb's result as an HTML document that refers to nothing outside of it."""
    module, _, function = PAGES[verb].partition(":")
    return framed(getattr(import_module(f"allworlds.reports.{module}"), function)(result))


def check_page(report: Any) -> str:
    """The page of a report of ``check`` or ``fuzz``."""
    return page("check", report)


__all__ = ["PAGES", "Own", "Page", "check_page", "figure", "page"]
