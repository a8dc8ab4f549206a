"""The ledger on a page: a table of the claims, and each of them with its worlds drawn."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree as ET

from allworlds.evidence.claims.claims_text import claims_line, details, heading
from allworlds.evidence.claims.ledger import CheckedClaim, ClaimsReport
from allworlds.reports import Page, counts, figure, scene_of, tag

VERDICTS = {0: "holds", 1: "refuted", 3: "inconclusive", 4: "vacuous", 130: "inconclusive"}


def claims_page(report: ClaimsReport) -> Page:
    """The table of the claims, and each of them."""
    word, _, text = claims_line(report, 0).partition(": ")
    header = ["section", "claim", "sentence", "expected", "found", ""]
    rows = [
        [
            heading(one.section),
            one.id,
            one.statement,
            one.expected,
            one.verdict,
            one.standing.replace("-", " "),
        ]
        for one in report.claims
    ]
    table = tag(
        "section",
        tag("h2", "The ledger", id="ledger"),
        *counts(header, rows, "Every claim"),
        aria_labelledby="ledger",
        class_="scope",
    )
    return Page(
        "allworlds paper claims",
        f"budget {report.budget}",
        (word, text, VERDICTS[int(report.exit_code)]),
        [table, *(_section(one) for one in report.claims)],
        report.to_json(),
    )


def _section(one: CheckedClaim) -> ET.Element:
    told = [("verdict", f"{one.verdict}, {one.standing.replace('-', ' ')}"), *details(one)]
    if one.differences:
        told.append(("differs", "; ".join(one.differences)))
    terms = (part for key, text in told for part in (tag("dt", key), tag("dd", tag("bdi", text))))
    return tag(
        "section",
        tag("h2", f"{heading(one.section)}: ", tag("bdi", one.id), id=f"{one.id}-title"),
        tag("p", tag("bdi", one.statement), class_="story"),
        *_pictures(one),
        tag("dl", *terms),
        class_="finding",
        id=one.id,
        aria_labelledby=f"{one.id}-title",
    )


def _pictures(one: CheckedClaim) -> Iterator[ET.Element]:
    if one.worlds:
        drawn = [
            figure(caption.capitalize(), scene_of(world), f"{one.id}-{i}", "")
            for i, (caption, world) in enumerate(zip(one.captions, one.worlds, strict=True), 1)
        ]
        yield tag("div", *drawn, class_="pictures")
