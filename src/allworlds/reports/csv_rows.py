"""Rows of a telling as CSV or Parquet: plain numbers, and empty cells for missing values."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from typing import Any

from allworlds.reports.telling import Cell, Shown, ToldResult, ToldTable, ToldWalk


def csv_rows(telling: ToldResult) -> str:
    """The rows for programs, else those of the first table or walk; empty if there is none."""
    table = _rows(telling)
    out = io.StringIO()
    if table is not None:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(table.header)
        writer.writerows([_plain(cell) for cell in row] for row in table.rows)
    return out.getvalue()


def records(telling: ToldResult) -> list[dict[str, Any]]:
    """The rows for programs, each by the names of its columns, with None for missing values."""
    table = _rows(telling)
    rows = table.rows if table else ()
    plain = ([cell.value if isinstance(cell, Shown) else cell for cell in row] for row in rows)
    return [dict(zip(table.header, row, strict=True)) for row in plain] if table else []


def parquet_rows(telling: ToldResult) -> bytes:
    """A file of Parquet with these rows, a column for each name; pyarrow makes it."""
    from pyarrow import BufferOutputStream, Table
    from pyarrow.parquet import write_table

    out = BufferOutputStream()
    write_table(Table.from_pylist(records(telling)), out)
    written: bytes = out.getvalue().to_pybytes()
    return written


def _rows(telling: ToldResult) -> ToldTable | None:
    return telling.rows() if telling.rows else next(_tables(telling), None)


def _tables(telling: ToldResult) -> Iterator[ToldTable]:
    """Tables come first; the rows of a walk are used if there is no table."""
    blocks = [block for section in telling.sections for block in section.blocks]
    yield from (block for block in blocks if isinstance(block, ToldTable))
    yield from (block.table for block in blocks if isinstance(block, ToldWalk))


def _plain(cell: Cell) -> str | float:
    match cell:
        case None:
            return ""
        case Shown():
            return cell.value
        case _:
            return cell
