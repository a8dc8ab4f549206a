"""Content of reports of ``count`` and ``worst``: numbers for each size of maps, the count gate."""

from allworlds.reports import parts
from allworlds.reports.content.check import most_expensive
from allworlds.reports.content.scope import (
    finished,
    gate_facts,
    maps_in_words,
    miscount,
    of_the_class,
)
from allworlds.studies.count import Census
from allworlds.studies.worst.all_worlds import WorstReport
from allworlds.words import number, plural, size
from allworlds.world.named import code_of


def count_content(census: Census) -> parts.ReportContent:
    """The content for a count: a row for each number of edges, and the source of the counts."""
    rows = [
        [
            row.edges,
            row.rooted,
            row.unrooted,
            row.up_to_reflection,
            row.chiral,
            row.self_dual,
            " ".join(f"{n}:{count}" for n, count in row.by_vertices.items()),
        ]
        for row in census.rows
    ]
    header = ["edges", "rooted", "unrooted", "up to reflection", "chiral", "self-dual"]
    table = parts.Table([*header, "rooted by vertices"], rows, "Maps by size")
    facts = [("scope", maps_in_words(census))]
    if census.agrees:
        facts += gate_facts(census, "map", is_compared=bool(rows))
    columns = {"edges": int, "vertices": int, "genus": int, "rooted": int, "unrooted": int}
    return parts.ReportContent(
        "allworlds count",
        f"class {census.extent.map_class}",
        census,
        _counted(census),
        [parts.Section("seen", "", [table, parts.FactList(facts)])],
        rows=lambda: parts.CsvRows(
            columns, [[row.edges, *cell] for row in census.rows for cell in row.cells]
        ),
    )


def _counted(census: Census) -> parts.Headline | None:
    if not census.agrees:
        wrong = [
            miscount(row.edges, vertices, met, census.source, counted)
            for row in census.rows
            for vertices, met, counted in row.miscounts
        ]
        return parts.Headline("MISMATCH", "; ".join(wrong), "error")
    if census.complete and census.whole and census.empty:
        text = f"there is no map {of_the_class(census.extent)}"
        return parts.Headline("VACUOUS", text, "vacuous")
    done = None
    if census.rows:
        total = plural(sum(row.rooted for row in census.rows), "rooted map")
        done = parts.Headline("COUNTED", f"{total} {finished(census, census.rows[-1].edges)}")
    return parts.so_far(census, done)


def worst_content(report: WorstReport) -> parts.ReportContent:
    """The content for worst costs: the worst and the best cost of each size.

    A page also has the most expensive of the walks that attain worst costs.
    """
    header = ["edges", "vertices", "worlds", "best", "worst", "bound", "worst/bound"]
    table: list[list[parts.Cell]] = []
    rows: list[list[parts.CellValue]] = []
    for row in report.rows:
        numbers = [row.edges, row.vertices, row.worlds, row.best, row.worst, row.bound]
        table.append([*numbers, parts.RightText(f"{row.worst / (row.bound or 1):.3f}")])
        map_, start = row.world.map, row.world.start
        place = row.world.lighthouse.number(map_, start)
        rows.append([*numbers, code_of(map_, start), place, ",".join(map(str, row.choices))])
    kinds = dict.fromkeys(header[:-1], int) | {"code": str, "place": int, "choices": str}
    shown = parts.Table(header, table, "Worst and best cost of each size", keys=2)
    return parts.ReportContent(
        "allworlds worst",
        report.explorer,
        report,
        _worst(report),
        [parts.Section("seen", "What was searched", [shown, parts.FactList(_facts(report))])],
        more=lambda: most_expensive(report.walks()),
        rows=lambda: parts.CsvRows(kinds, rows),
    )


def _worst(report: WorstReport) -> parts.Headline | None:
    if not report.agrees:
        return parts.Headline("MISMATCH", _mismatch(report), "error")
    if report.complete and not report.rows:
        return parts.Headline("VACUOUS", "there is no run", "vacuous")
    done = None
    if report.rows:
        most = max(report.rows, key=lambda row: row.worst)
        where = size(most.edges, most.vertices)
        said = f"the largest cost is {plural(most.worst, 'traversal')}, in a world with {where}"
        done = parts.Headline("WORST", said)
    return parts.so_far(report, done)


def _facts(report: WorstReport) -> list[tuple[str, str]]:
    """Named texts: the scope of the numbers, and the sources with which they were compared."""
    ways = {"shortest": "a shortest path", "simple": "any simple path"}
    scope = (
        f"every schedule of algorithm1 in {maps_in_words(report)}; the robot goes to the "
        f"next unexplored edge on {ways[report.request.transit]}"
    )
    costs = (
        "worst: the largest cost of a schedule in any world; best: each world has a cheapest "
        "schedule, and this is the largest of their costs"
    )
    tests = sum(row.tests for row in report.rows)
    wrong = sum(row.wrong_tests for row in report.rows)
    tested = "every hypothesis that was tested was true" if report.rows else ""
    if tests:
        verdict = f"{number(wrong)} CONFIRMED a false one" if wrong else "all rejected"
        tested = f"{plural(tests, 'test')} of false hypotheses, by every path home: {verdict}"
    words = [("scope", scope), ("costs", costs), ("tests", tested)]
    if report.agrees:
        words += gate_facts(report, "world", is_compared=bool(report.rows))
        if report.rows:
            words.append(("replay", "the python engine reproduced every worst cost"))
    return words


def _mismatch(report: WorstReport) -> str:
    if report.disagreement:
        return report.disagreement
    row = next(row for row in report.rows if not row.agrees)
    if row.counted is not None and row.counted != row.worlds:
        return miscount(row.edges, row.vertices, row.worlds, report.source, row.counted)
    where = size(row.edges, row.vertices)
    played = "breaks a law" if row.replayed is None else f"costs {row.replayed}"
    return f"with {where} the worst cost is {row.worst}, but its replay in Python {played}"
