"""Rows of a telling as CSV or Parquet: plain numbers, and empty cells for missing values."""

from __future__ import annotations

import csv
import io

from allworlds.reports.file_format import Format
from allworlds.reports.rows import CsvRows, rows_of_walk
from allworlds.reports.telling import ToldResult, ToldWalk


def csv_rows(telling: ToldResult) -> str:
    """The rows for programs; empty if there is none."""
    out, found = io.StringIO(), rows_of(telling)
    if found.columns:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(found.columns)
        writer.writerows(found.rows)
    return out.getvalue()


def parquet_rows(telling: ToldResult) -> bytes:
    """A file of Parquet with these rows, a column for each name and of its type."""
    from pyarrow import BufferOutputStream, Table, bool_, float64, int64, schema, string
    from pyarrow.parquet import write_table

    kinds = {int: int64(), float: float64(), str: string(), bool: bool_()}
    found, out = rows_of(telling), BufferOutputStream()
    columns = schema([(name, kinds[kind]) for name, kind in found.columns.items()])
    write_table(Table.from_pylist(found.records, schema=columns), out)
    written: bytes = out.getvalue().to_pybytes()
    return written


def rows_of(telling: ToldResult) -> CsvRows:
    """The rows for programs, by default those of the first walk; no columns if there is none."""
    if telling.rows:
        return telling.rows()
    blocks = (block for section in telling.sections for block in section.blocks)
    walk = next((block for block in blocks if isinstance(block, ToldWalk)), None)
    return rows_of_walk(walk) if walk else CsvRows({}, [])


FORMAT = Format(csv_rows, ".csv")
PARQUET = Format(parquet_rows, ".parquet", library=("pyarrow", "notebook", "a file .parquet"))
