"""Telling of a result of which nobody has written one: its keys and its rows."""

from __future__ import annotations

from typing import Any

from allworlds.document import Report
from allworlds.inputs import show
from allworlds.reports.telling import (
    Block,
    Cell,
    Headline,
    Section,
    ToldFacts,
    ToldResult,
    ToldTable,
)

ASIDE = ("schema", "made_by", "verdict", "exit_code")
"""Keys that stand in the headline, or are of no use to people."""


def plain_telling(report: Report) -> ToldResult:
    """A fact for each key of the document, and a table for each list of objects."""
    facts: list[tuple[str, str]] = []
    tables: list[Block] = []
    for key, value in report.to_json().items():
        if key in ASIDE or value is None:
            continue
        if isinstance(value, list) and value and all(isinstance(row, dict) for row in value):
            header = [*value[0]]
            rows = [[_cell(row.get(name)) for name in header] for row in value]
            tables.append(ToldTable(header, rows, key))
        else:
            facts.append((key, str(_cell(value))))
    verdict = str(getattr(report, "verdict", ""))
    headline = Headline(verdict.upper(), "", verdict) if verdict else None
    section = Section("seen", "", [*tables, *([ToldFacts(facts)] if facts else [])])
    return ToldResult(type(report).__name__, "", report, headline, [section])


def _cell(value: Any) -> Cell:
    return value if value is None or type(value) in (int, str) else show(value)
