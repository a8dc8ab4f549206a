"""Telling of a result of which nobody has written one: its keys and its rows."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from allworlds.document.report import Report
from allworlds.inputs.checks import show
from allworlds.reports.rows import CsvRows, Value
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
    rows = CsvRows({}, [])
    for key, value in report.to_json().items():
        if key in ASIDE or value is None:
            continue
        if isinstance(value, list) and value and all(isinstance(row, dict) for row in value):
            header = [*value[0]]
            cells = [[_cell(row.get(name)) for name in header] for row in value]
            tables.append(ToldTable(header, cells, key))
            rows = rows if rows.columns else _rows(header, value)
        else:
            facts.append((key, str(_cell(value))))
    verdict = str(getattr(report, "verdict", ""))
    headline = Headline(verdict.upper(), "", verdict) if verdict else None
    section = Section("seen", "", [*tables, *([ToldFacts(facts)] if facts else [])])
    return ToldResult(type(report).__name__, "", report, headline, [section], rows=lambda: rows)


def _rows(names: Sequence[str], objects: Sequence[dict[str, Any]]) -> CsvRows:
    """A row for each object; columns that hold anything but numbers are texts."""
    columns = {}
    for name in names:
        kinds = {type(one.get(name)) for one in objects} - {type(None)}
        columns[name] = kinds.pop() if kinds in ({int}, {float}) else str
    rows = [[_value(one.get(name), kind) for name, kind in columns.items()] for one in objects]
    return CsvRows(columns, rows)


def _value(value: Any, kind: type) -> Value:
    fits = value is None or isinstance(value, kind)
    found: Value = value if fits else show(value)
    return found


def _cell(value: Any) -> Cell:
    return value if value is None or type(value) in (int, str) else show(value)
