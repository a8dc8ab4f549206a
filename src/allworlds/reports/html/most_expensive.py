"""The most expensive runs: cost against bound, and each of them to be stepped through."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from xml.etree import ElementTree as ET

from allworlds.engines import SingleRun
from allworlds.reports.finding_words import headline
from allworlds.reports.html.findings import finding_section
from allworlds.reports.html.frame import Page, counts
from allworlds.reports.html.plot import PlotCell, plot
from allworlds.reports.html.runs import cost_words, run_parts
from allworlds.reports.markup import tag
from allworlds.reports.worst_text import worst_table, worst_words
from allworlds.studies.check import CheckReport
from allworlds.studies.worst import WorstReport
from allworlds.words import plural, size

ROOM = 700_000
"""So many characters of a page are for walks; of those that do not fit the smallest go."""


def worst_page(report: WorstReport) -> Page:
    """The rows, cost against bound, and the walk that attains each row's worst cost."""
    entries = [
        part
        for name, said in worst_words(report)
        for part in (tag("dt", name), tag("dd", tag("bdi", said)))
    ]
    seen = tag(
        "section",
        tag("h2", "What was searched", id="seen"),
        tag("dl", *entries),
        *counts(*worst_table(report), "Worst and best cost of each size"),
        aria_labelledby="seen",
        class_="scope",
    )
    return Page(
        "allworlds worst",
        report.explorer,
        _answer(report),
        [
            *(finding_section(found, i) for i, found in enumerate(report.findings, 1)),
            seen,
            *most_expensive_sections(_cells(report), report.walks()),
        ],
        report.to_json(),
    )


def _answer(report: WorstReport) -> tuple[str, str, str]:
    if report.findings:
        return "REFUTED", headline(report.findings[0]), "refuted"
    if not report.gate.agrees:
        return "MISMATCH", "two roads to one number lead to different ones", "error"
    if not report.rows:
        return "NOTHING", "there is no run", "vacuous"
    most = max(_cells(report), key=lambda cell: cell.cost)
    most_expensive = f"{plural(most.cost, 'traversal')}, with {size(most.edges, most.vertices)}"
    return ("WORST" if report.complete else "SO FAR"), most_expensive, "vacuous"


def _cells(report: WorstReport) -> list[PlotCell]:
    """The worst cost of each row, beside its bound."""
    return [PlotCell(row.edges, row.vertices, row.worst, row.bound) for row in report.rows]


def cells_of(report: CheckReport) -> list[PlotCell]:
    """The largest cost of each size that a check has met, beside its bound."""
    return [
        PlotCell(row.edges, row.vertices, row.max_cost, row.bound)
        for row in report.rows
        if row.episodes
    ]


def most_expensive_sections(
    cells: Sequence[PlotCell], runs: Iterable[SingleRun]
) -> Iterator[ET.Element]:
    """Cost against bound, then the runs, each to be opened; nothing where there are no cells.

    The last, which is the largest, is open.
    """
    if not cells:
        return
    chart = tag(
        "div",
        plot(cells, "costs"),
        class_="frame",
        tabindex="0",
        role="group",
        aria_label="Cost against bound",
    )
    key = tag(
        "p",
        tag("span", "the largest cost", class_="key cost-key"),
        tag("span", "the largest bound", class_="key bound-key"),
        class_="legend",
    )
    yield tag(
        "section",
        tag("h2", "Cost against bound", id="costs-heading"),
        chart,
        key,
        aria_labelledby="costs-heading",
    )
    walks, left_out = _that_fit(runs)
    if walks:
        walks[-1].set("open", "open")
        few = f"{plural(left_out, 'smaller size')} left out to keep the page small."
        yield tag(
            "section",
            tag("h2", "The most expensive run of each size", id="most-expensive"),
            *([tag("p", few)] if left_out else []),
            *walks,
            aria_labelledby="most-expensive",
        )


def _that_fit(runs: Iterable[SingleRun]) -> tuple[list[ET.Element], int]:
    """The last of the runs for which there is room, and how many others there are."""
    every, room, kept = [*runs], ROOM, list[ET.Element]()
    for number in range(len(every), 0, -1):
        walk = _walk(every[number - 1], f"most-expensive-{number}")
        room -= len(ET.tostring(walk, "unicode", method="html"))
        if room < 0:
            break
        kept.append(walk)
    return kept[::-1], len(every) - len(kept)


def _walk(told: SingleRun, name: str) -> ET.Element:
    map_ = told.world.map
    title = f"{size(map_.edge_count, map_.vertex_count)}: {cost_words(told)}"
    return tag(
        "details",
        tag("summary", tag("h3", title, id=f"{name}-title")),
        *run_parts(told, name),
        class_="run",
        id=name,
    )
