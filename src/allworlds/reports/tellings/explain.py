"""Telling of ``explain``: a finding in plain words."""

from __future__ import annotations

from allworlds.reports.telling import ToldResult
from allworlds.reports.tellings.finding import finding_section, headline_of
from allworlds.studies.explain import Explanation


def explain_telling(explanation: Explanation) -> ToldResult:
    """The broken law, the story in sentences, and the walk in the world and in the answer."""
    finding = explanation.finding
    title = headline_of(finding)
    if explanation.findings > 1:
        which = f"finding {explanation.number} of {explanation.findings}"
        title = f"{title} ({which}; --finding K tells another)"
    section = finding_section(finding, explanation.number, title=title)
    return ToldResult(
        "allworlds explain",
        explanation.explorer,
        explanation,
        None,
        [section],
    )
