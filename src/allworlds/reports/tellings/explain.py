"""Telling of ``explain``: a finding in plain words."""

from __future__ import annotations

from allworlds.judging.explanations.explanation import Explanation
from allworlds.reports.telling import ToldResult
from allworlds.reports.tellings.finding import finding_section, headline_of


def explain_telling(explanation: Explanation) -> ToldResult:
    """The broken law, the story in sentences, and the walk in the world and in the answer."""
    finding = explanation.finding
    title = headline_of(finding)
    if explanation.findings > 1:
        which = f"finding {explanation.number} of {explanation.findings}"
        title = f"{title} ({which}; --finding K tells another)"
    section = finding_section(finding, explanation.number, title=title, told=explanation)
    return ToldResult(
        "allworlds explain",
        explanation.explorer,
        explanation,
        None,
        [section],
    )
