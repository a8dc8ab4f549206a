"""The text of ``worst``."""

from __future__ import annotations

from allworlds.engines import WHOLE
from allworlds.reports.check_words import counted
from allworlds.reports.finding_words import headline
from allworlds.reports.text_layout import entry, interruption, table
from allworlds.studies.worst import WorstReport
from allworlds.words import number, plural, size


def worst_text(report: WorstReport, width: int) -> str:
    """A line for each size, and what the numbers are about."""
    header, rows = worst_table(report)
    lines = [*table(header, rows, "r" * len(header), width, keys=2), ""]
    lines += interruption(complete=report.complete, width=width)
    for name, text in worst_words(report):
        lines += entry(name, text, width)
    return "\n".join(lines)


def worst_table(report: WorstReport) -> tuple[list[str], list[list[str]]]:
    """The header and the rows, one for each size."""
    header, rows = ["edges", "vertices", "worlds", "best", "worst", "bound"], []
    for row in report.rows:
        cells = [row.edges, row.vertices, row.worlds, row.best, row.worst]
        rows.append([*map(number, cells), "-" if row.bound is None else number(row.bound)])
    if report.transit:
        header.append("worst/bound")
        for row, texts in zip(report.rows, rows, strict=True):
            texts.append(f"{row.worst / (row.bound or 1):.3f}")
    return header, rows


def worst_words(report: WorstReport) -> list[tuple[str, str]]:
    """What the numbers are about, and what they were compared with, as names and texts."""
    words = _paper(report, _WAYS[report.transit]) if report.transit else _of_runs(report)
    words += [("REFUTED", headline(finding)) for finding in report.findings]
    if not report.gate.agrees:
        return [*words, ("MISMATCH", _mismatch(report))]
    if report.findings:
        return words
    text = f"no world was forgotten: {counted(report.gate.source)}"
    if report.shard != str(WHOLE):
        text = f"of the shard {report.shard} alone; the merge of all shards compares counts"
    again = "by the python engine" if report.transit else "again"
    return [*words, ("gate", text), ("replay", f"every worst cost was attained {again}")]


def _of_runs(report: WorstReport) -> list[tuple[str, str]]:
    """What was done with an explorer whose runs were played."""
    schedules = "every schedule" if report.schedules == "all" else "the one schedule"
    scope = (
        f"{schedules} of {report.explorer} in {_maps(report)}, "
        f"at every place of the lighthouse {report.lighthouse}"
    )
    costs = "worst: of all episodes; best: the largest cost of the cheapest schedule of a run"
    return [("scope", scope), ("costs", costs)]


def _paper(report: WorstReport, way: str) -> list[tuple[str, str]]:
    """What was done with Algorithm 1, by the compiled search."""
    tests = sum(row.tests or 0 for row in report.rows)
    wrong = sum(row.wrong_tests or 0 for row in report.rows)
    verdict = "all rejected" if not wrong else f"{number(wrong)} CONFIRMED"
    scope = f"every schedule of algorithm1 in {_maps(report)}, from every vertex; transit on {way}"
    costs = (
        "worst: the most expensive schedule of the most expensive world; best: the largest cost "
        "of the cheapest schedule of a world"
    )
    return [
        ("scope", scope),
        ("costs", costs),
        ("tests", f"{plural(tests, 'test')} of false hypotheses on every path: {verdict}"),
    ]


_WAYS = {"shortest": "a shortest path", "simple": "any simple path"}


def _maps(report: WorstReport) -> str:
    return f"every map of the class {report.map_class} with at most {plural(report.edges, 'edge')}"


def _mismatch(report: WorstReport) -> str:
    if report.disagreement:
        return report.disagreement
    row = next(row for row in report.rows if not row.agrees)
    if row.counted not in (None, row.worlds):
        return (
            f"of maps with {size(row.edges, row.vertices)} {row.worlds} were enumerated, but "
            f"{report.gate.source} counts {row.counted}"
        )
    return (
        f"with {size(row.edges, row.vertices)} the worst cost is {row.worst}, but "
        f"the python engine walks {row.replayed}"
    )
