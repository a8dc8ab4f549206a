"""The text of ``worst``."""

from __future__ import annotations

from allworlds.engines import Shard
from allworlds.reports.check_words import counted
from allworlds.reports.finding_words import headline
from allworlds.reports.text_layout import entry, interruption, table
from allworlds.studies.worst import RunsReport, WorstReport
from allworlds.words import number, plural, size


def worst_text(report: WorstReport | RunsReport, width: int) -> str:
    """A line for each size, and what the numbers are about."""
    header, rows = worst_table(report)
    lines = [*table(header, rows, "r" * len(header), width, keys=2), ""]
    lines += interruption(complete=report.complete, width=width)
    for name, text in worst_words(report):
        lines += entry(name, text, width)
    return "\n".join(lines)


def worst_table(report: WorstReport | RunsReport) -> tuple[list[str], list[list[str]]]:
    """The header and the rows, one for each size."""
    header, rows = ["edges", "vertices", "worlds", "best", "worst", "bound"], []
    for row in report.rows:
        cells = [row.edges, row.vertices, row.worlds, row.best, row.worst]
        rows.append([*map(number, cells), "-" if row.bound is None else number(row.bound)])
    if isinstance(report, WorstReport):
        header.append("worst/bound")
        for row, texts in zip(report.rows, rows, strict=True):
            texts.append(f"{row.worst / row.bound:.3f}")
    return header, rows


def worst_words(report: WorstReport | RunsReport) -> list[tuple[str, str]]:
    """What the numbers are about, and what they were compared with, as names and texts."""
    return _of_runs(report) if isinstance(report, RunsReport) else _paper(report)


def _of_runs(report: RunsReport) -> list[tuple[str, str]]:
    """The same of an explorer whose runs were played."""
    schedules = "every schedule" if report.schedules == "all" else "the one schedule"
    scope = (
        f"{schedules} of {report.explorer} in {_maps(report)}, "
        f"at every place of the lighthouse {report.lighthouse}"
    )
    words = [
        ("scope", scope),
        (
            "costs",
            "worst: of all episodes; best: the largest cost of the cheapest schedule of a run",
        ),
    ]
    words += [("REFUTED", headline(finding)) for finding in report.findings]
    if report.agrees and not report.findings:
        words.append(("gate", f"no world was forgotten: {counted(report.source)}"))
        words.append(("replay", "every worst cost was attained again"))
    elif report.disagreement:
        words.append(("MISMATCH", report.disagreement))
    elif not report.agrees:
        row = next(row for row in report.rows if not row.agrees)
        text = (
            f"with {size(row.edges, row.vertices)}: {row.worlds} worlds, counted {row.counted}; "
            f"worst {row.worst}, once more {row.replayed}"
        )
        words.append(("MISMATCH", text))
    return words


def _maps(report: WorstReport | RunsReport) -> str:
    extent = report.extent
    return (
        f"every map of the class {extent.map_class.value} "
        f"with at most {plural(extent.edges or 0, 'edge')}"
    )


def _paper(report: WorstReport) -> list[tuple[str, str]]:
    """The same of Algorithm 1, by the compiled search."""
    tests = sum(row.tests for row in report.rows)
    wrong = sum(row.wrong for row in report.rows)
    verdict = "all rejected" if not wrong else f"{number(wrong)} CONFIRMED"
    scope = (
        f"every schedule of algorithm1 in {_maps(report)}, from every vertex; "
        f"transit on {_WAYS[report.transit]}"
    )
    costs = (
        "worst: the most expensive schedule of the most expensive world; best: the largest cost "
        "of the cheapest schedule of a world"
    )
    words = [
        ("scope", scope),
        ("costs", costs),
        ("tests", f"{plural(tests, 'test')} of false hypotheses on every path: {verdict}"),
    ]
    if not report.agrees:
        return [*words, ("MISMATCH", _mismatch(report))]
    text = f"no world was forgotten: {counted(report.source)}"
    if isinstance(report.portion, Shard):
        text = f"of the shard {report.portion} alone; the merge of all shards compares counts"
    return [
        *words,
        ("gate", text),
        ("replay", "every worst cost was attained by the python engine"),
    ]


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
