"""A telling as one web page."""

from __future__ import annotations

from allworlds.reports.file_format import Format
from allworlds.reports.telling import ToldResult
from allworlds.verbs import PAGE, ROWS


def html(telling: ToldResult) -> str:
    """An HTML document that refers to no other file."""
    if telling.page:
        return telling.page()
    from allworlds.reports.web.frame import Page, framed
    from allworlds.reports.web.sections import element

    said = telling.headline
    document = telling.result.to_json()
    return framed(
        Page(
            telling.done,
            telling.subject,
            (said.word, said.text, said.verdict or "open") if said else None,
            [element(section) for section in (*telling.sections, *telling.more())],
            {key: value for key, value in document.items() if key not in telling.apart},
        )
    )


FORMAT = Format(html, ".html", (ROWS, PAGE))
