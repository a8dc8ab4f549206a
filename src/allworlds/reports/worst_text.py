"""The text of ``worst``."""

from __future__ import annotations

from allworlds.reports.finding_words import headline
from allworlds.reports.layout import entry, interruption, table
from allworlds.words import number, plural, size
from allworlds.work import Shard
from allworlds.worst_case import RunsReport, WorstReport


def worst_text(report: WorstReport | RunsReport, width: int) -> str:
    """A line for each size, and what the numbers are about."""
    return _of_runs(report, width) if isinstance(report, RunsReport) else _paper(report, width)


def _of_runs(report: RunsReport, width: int) -> str:
    """The same of an explorer whose runs were played."""
    header = ["edges", "vertices", "worlds", "best", "worst", "bound"]
    rows = []
    for row in report.rows:
        cells = [row.edges, row.vertices, row.worlds, row.best, row.worst]
        rows.append([*map(number, cells), "-" if row.bound is None else number(row.bound)])
    lines = [*table(header, rows, "r" * len(header)), ""]
    lines += interruption(complete=report.complete, width=width)
    schedules = "every schedule" if report.schedules == "all" else "the one schedule"
    lines += entry(
        "scope",
        f"{schedules} of {report.explorer} in every map of the class "
        f"{report.extent.map_class.value} with at most {plural(report.extent.edges or 0, 'edge')}, "
        f"at every place of the lighthouse {report.lighthouse}",
        width,
    )
    lines += entry(
        "worst, best", "of all episodes; the largest cost of the cheapest schedule of a run", width
    )
    for finding in report.findings:
        lines += entry("REFUTED", headline(finding), width)
    if report.agrees and not report.findings:
        lines += entry("gate", f"the numbers of worlds are those of: {report.source}", width)
        lines += entry("replay", "every worst cost was attained again", width)
    elif not report.agrees:
        row = next(row for row in report.rows if not row.agrees)
        lines += entry(
            "MISMATCH",
            f"with {size(row.edges, row.vertices)}: {row.worlds} worlds, counted {row.counted}; "
            f"worst {row.worst}, once more {row.replayed}",
            width,
        )
    return "\n".join(lines)


def _paper(report: WorstReport, width: int) -> str:
    """The same of Algorithm 1, by the compiled search."""
    header = ["edges", "vertices", "worlds", "best", "worst", "bound", "worst/bound"]
    rows = []
    for row in report.rows:
        cells = [row.edges, row.vertices, row.worlds, row.best, row.worst, row.bound]
        rows.append([*map(number, cells), f"{row.worst / row.bound:.3f}"])
    lines = table(header, rows, "r" * len(header))
    tests = sum(row.tests for row in report.rows)
    wrong = sum(row.wrong for row in report.rows)
    lines += [""]
    lines += interruption(complete=report.complete, width=width)
    lines += entry(
        "scope",
        f"every schedule of algorithm1 in every map of the class {report.extent.map_class.value} "
        f"with at most {plural(report.extent.edges or 0, 'edge')}, from every vertex; "
        f"transit on {_WAYS[report.transit]}",
        width,
    )
    lines += entry(
        "worst, best",
        "the dearest schedule of the dearest world; the largest cost of the cheapest schedule "
        "of a world",
        width,
    )
    verdict = "all rejected" if not wrong else f"{number(wrong)} CONFIRMED"
    lines += entry(
        "tests", f"{plural(tests, 'test')} of false hypotheses on every path: {verdict}", width
    )
    if report.agrees:
        text = f"the numbers of worlds are those of: {report.source}"
        if isinstance(report.portion, Shard):
            text = f"of the shard {report.portion} alone; the merge of all shards compares counts"
        lines += entry("gate", text, width)
        lines += entry("replay", "every worst cost was attained by the python engine", width)
    else:
        lines += entry("MISMATCH", _mismatch(report), width)
    return "\n".join(lines)


_WAYS = {"shortest": "a shortest path", "simple": "any simple path"}


def _mismatch(report: WorstReport) -> str:
    if report.missing:
        edges, vertices = report.missing[0]
        return f"no map with {size(edges, vertices)} was met"
    whole = not isinstance(report.portion, Shard)
    row = next(row for row in report.rows if not (row.agrees if whole else row.repeats))
    if whole and row.worlds != row.counted:
        return (
            f"of maps with {size(row.edges, row.vertices)} {row.worlds} were enumerated, but "
            f"{report.source} counts {row.counted}"
        )
    return (
        f"with {size(row.edges, row.vertices)} the worst cost is {row.worst}, but "
        f"the python engine walks {row.replayed}"
    )
