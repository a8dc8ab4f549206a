"""The text of ``compare``, and its rows as CSV."""

from __future__ import annotations

import csv
import io

from allworlds.reports.finding_words import headline
from allworlds.reports.growth_text import growth_csv, growth_text
from allworlds.reports.text_layout import entry, table
from allworlds.studies.compare import ComparedRow, Comparison, Growth
from allworlds.words import number, plural, size


def compare_text(report: Comparison | Growth, width: int) -> str:
    """A line for each size, what differs most, and what was compared."""
    if isinstance(report, Growth):
        return growth_text(report, width)
    header, rows = compare_table(report)
    lines = [*table(header, rows, "r" * len(header), width, keys=2), ""]
    for name, text in compare_words(report):
        lines += entry(name, text, width)
    return "\n".join(lines)


def compare_table(report: Comparison) -> tuple[list[str], list[list[str]]]:
    """The rows with their header; the first explorer is compared with each other one."""
    names = [_short(name) for name in report.names]
    header = ["edges", "vertices", "worlds"]
    header += [f"{name} mean" for name in names] + [f"{name} worst" for name in names]
    header += [f"{name} / {names[0]}" for name in names[1:]]
    header += [f"{names[0]} < = > {name}" for name in names[1:]]
    return header, [_cells(report, row) for row in report.rows]


def _cells(report: Comparison, row: ComparedRow) -> list[str]:
    cells = [number(row.edges), number(row.vertices), number(row.worlds)]
    cells += [_mean(row.mean[name]) for name in report.names]
    cells += [number(row.worst[name]) for name in report.names]
    ratios = [row.ratio[name] for name in report.names[1:]]
    cells += ["-" if ratio is None else _mean(ratio) for ratio in ratios]
    cells += [
        " ".join(number(times[name]) for times in (row.less, row.equal, row.more))
        for name in report.names[1:]
    ]
    return cells


def compare_words(report: Comparison) -> list[tuple[str, str]]:
    """What is to be said beside the table, each with its name."""
    words = [(report.verdict.value.upper(), _verdict(report))]
    words += [
        ("explorer", f"{each.name} under {each.lighthouse}, bound {each.bound}")
        for each in report.explorers
    ]
    words.append(("scope", _scope(report)))
    meant = "traversals; mean: over rooted maps, in each over the places; worst: of a run"
    words.append(("costs", meant))
    if report.rows:
        words += [("in all", _in_all(report, name)) for name in report.names[1:]]
    most = report.differ_most
    if most is not None:
        costs = ", ".join(f"{name} {_mean(cost)}" for name, cost in most.costs.items())
        map_ = most.world.map
        where = size(map_.edge_count, map_.vertex_count)
        world = f"sigma={[*map_.sigma]} alpha={[*map_.alpha]}"
        if map_.edge_count > _SHOWN:
            world = "in the document"
        words.append(("differ most", f"in a world with {where}: {costs}; {world}"))
    words += [("finding", headline(finding)) for finding in report.findings]
    return words


_SHOWN = 12
"""The edges of the largest world that a text spells out."""


def _verdict(report: Comparison) -> str:
    runs = sum(row.runs for row in report.rows)
    if report.findings:
        return "a run has broken a law"
    if not report.all_counted:
        return "the enumeration and its count disagree"
    if not report.complete:
        why = report.stopped or "interrupted"
        return f"{why}; no law is broken in {plural(runs, 'run')} of finished levels"
    if not report.rows:
        return "there is no world in which every explorer has a place"
    return f"no law is broken in {plural(runs, 'run')}"


def _scope(report: Comparison) -> str:
    if report.family:
        return f"one world: {report.family}"
    limits = [
        f"at most {plural(limit, *words)}"
        for limit, words in (
            (report.edges, ("edge",)),
            (report.vertices, ("vertex", "vertices")),
        )
        if limit is not None
    ]
    return f"every rooted map of the class {report.map_class} with {' and '.join(limits)}"


def _in_all(report: Comparison, name: str) -> str:
    first = report.names[0]
    less, equal, more = (
        sum(getattr(row, which)[name] for row in report.rows) for which in ("less", "equal", "more")
    )
    return (
        f"{first} walks less than {name} in {plural(less, 'world')}, as much in {number(equal)}, "
        f"more in {number(more)}"
    )


def compare_csv(report: Comparison | Growth) -> str:
    """The rows as CSV, one line for each size and explorer; of worlds that grow for each run."""
    if isinstance(report, Growth):
        return growth_csv(report)
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(
        ["edges", "vertices", "worlds", "explorer", "mean", "worst", "less", "equal", "more"]
    )
    for row in report.rows:
        for name in report.names:
            compared = [which.get(name, "") for which in (row.less, row.equal, row.more)]
            mean = f"{row.mean[name]:.6f}"
            writer.writerow(
                [row.edges, row.vertices, row.worlds, name, mean, row.worst[name], *compared]
            )
    return out.getvalue()


def _mean(value: float) -> str:
    return f"{value:,.2f}"


def _short(name: str) -> str:
    """What tells an explorer in the head of a column."""
    return name.rpartition(":")[2] if not name.startswith("exec:") else name[:20]
