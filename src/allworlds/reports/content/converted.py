"""Content of reports of ``convert``: each world of a file, with the vertex behind each door."""

from allworlds.reports import parts
from allworlds.studies.convert import Convert, ConvertRow
from allworlds.words import plural

FEW = 3
"""The largest number of worlds whose rooms a terminal shows without an option."""

COLUMNS = {"number": int, "name": str, "vertices": int, "edges": int, "genus": int, "faces": int}
COLUMNS |= {"automorphisms": int}


def convert_content(report: Convert) -> parts.ReportContent:
    """The content for a conversion: a row for each world, its rooms, the first worlds' pictures."""
    rows = parts.CsvRows.of(report.rows, **COLUMNS)
    table = parts.Table([*COLUMNS], rows.rows, plural(len(report.rows), "world"))
    facts = [("written", ", ".join(report.written or ()))]
    facts.append(("left out", ", ".join(report.left_out or ())))
    rooms = [_rooms(row) for row in report.rows]
    pictures = [
        (
            _title(row),
            parts.Scene(
                entry.map,
                entry.start,
                vertices=entry.labels.vertices,
                positions=entry.labels.positions,
            ),
        )
        for row, entry in zip(report.rows, report.drawn, strict=False)
    ]
    few = rooms if len(rooms) <= FEW else []
    return parts.ReportContent(
        "allworlds convert",
        "",
        report,
        None,
        [parts.Section("seen", "", [table, parts.FactList(facts)]), *few],
        [*([] if few else rooms), parts.Section("drawn", "", [parts.MapPictures(pictures)])],
        rows=lambda: rows,
    )


def _title(row: ConvertRow) -> str:
    return row.name or f"World {row.number}"


def _rooms(row: ConvertRow) -> parts.Section:
    """A section with a row for each room: the rooms behind its doors, clockwise."""
    names = row.names or [f"v{vertex}" for vertex in range(row.vertices)]
    doors = [[name, ", ".join(ends)] for name, ends in zip(names, row.doors, strict=True)]
    table = parts.Table(["room", "its doors lead, clockwise, to"], doors, _title(row))
    return parts.Section(f"rooms-{row.number}", "", [table])
