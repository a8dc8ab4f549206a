"""A comparison on a page: the rows, and the walks in the world that differs most."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree as ET

from allworlds.checker import SingleRun
from allworlds.comparing import Comparison
from allworlds.explaining import Walked
from allworlds.markup import tag
from allworlds.reports.compare_text import compare_table, compare_words
from allworlds.reports.html.findings import figure, finding_section, viewer
from allworlds.reports.html.frame import counts, framed
from allworlds.reports.html.walk import walk
from allworlds.reports.scenes import walk_in_world
from allworlds.words import plural


def comparison_page(report: Comparison) -> str:
    """The comparison as an HTML document that refers to nothing outside of it."""
    (word, text), *words = compare_words(report)
    summary = {key: told for key, told in report.to_json().items() if key != "findings"}
    entries = [
        part for name, said in words for part in (tag("dt", name), tag("dd", tag("bdi", said)))
    ]
    seen = tag(
        "section",
        tag("h2", "What was compared", id="seen"),
        tag("dl", *entries),
        *counts(*compare_table(report), "Compared worlds"),
        aria_labelledby="seen",
        class_="scope",
    )
    findings = [finding_section(found, i) for i, found in enumerate(report.findings, 1)]
    return framed(
        "allworlds compare",
        ", ".join(report.names),
        (word, text, report.verdict.value),
        [seen, *findings, *_walks(report)],
        summary,
    )


def _walks(report: Comparison) -> Iterator[ET.Element]:
    for number, told in enumerate(report.walks(), 1):
        yield _walk(told, f"walk-{number}")


def _walk(told: SingleRun, name: str) -> ET.Element:
    """One explorer's walk in the world that differs most."""
    transcript = told.outcome.episode.transcript
    scene = walk_in_world(told.world, transcript)
    picture = figure("The world", scene, f"{name}-world", "robot")
    walked = Walked(told.world, transcript)
    return tag(
        "section",
        tag(
            "h2",
            "In the world that differs most: ",
            tag("bdi", told.explorer),
            f", {plural(told.outcome.cost, 'traversal')}",
            id=f"{name}-title",
        ),
        viewer([picture], walk(walked, None, None, name), f"The walk of {told.explorer}."),
        class_="finding",
        id=name,
        aria_labelledby=f"{name}-title",
    )
