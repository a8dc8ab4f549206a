"""A telling as Markdown, for the page of a job in a CI service."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from allworlds.reports.file_format import Format
from allworlds.reports.plain_text import text_of
from allworlds.reports.telling import (
    Section,
    ToldFacts,
    ToldPicture,
    ToldResult,
    ToldTable,
    ToldWalk,
)
from allworlds.reports.text_layout import fenced
from allworlds.words import escaped

WIDTH = 100


def markdown(telling: ToldResult) -> str:
    """The headline, every section with a picture, and the others folded."""
    head = [f"## {_plain(telling.done)}: {_plain(telling.subject)}"]
    if said := telling.headline:
        named = telling.done.partition(" ")[0]
        head = [f"## {named}: {said.word} {_plain(telling.subject)}", _plain(said.text)]
    blocks = [block for section in telling.sections for block in _section(section)]
    return "\n\n".join([*head, *blocks]) + "\n"


def _section(section: Section) -> Iterator[str]:
    if any(isinstance(block, ToldWalk | ToldPicture) for block in section.blocks):
        yield from [f"### {_plain(section.title)}"] if section.title else []
        yield fenced(text_of([section], WIDTH))
        return
    tables = [block for block in section.blocks if isinstance(block, ToldTable)]
    for table in tables:
        if table.rows:
            yield from [f"**{_plain(table.caption)}**"] if table.caption else []
            yield _table(table.header, table.texts, table.right)
    others = [block for block in section.blocks if not isinstance(block, ToldTable)]
    if others:
        yield f"<details><summary>{_plain(section.title or 'More')}</summary>"
        for block in others:
            if isinstance(block, ToldFacts):
                yield _table(["", ""], block.entries, "ll")
            else:
                yield fenced(text_of([Section("", "", [block])], WIDTH))
        yield "</details>"


def _table(header: Sequence[str], rows: Sequence[Sequence[str]], right: str) -> str:
    rule = "| " + " | ".join("--:" if side == "r" else "---" for side in right) + " |"
    first, *lines = (f"| {' | '.join(_plain(cell) for cell in line)} |" for line in (header, *rows))
    return "\n".join([first, rule, *lines])


def _plain(text: str) -> str:
    """The text in one line, with markup escaped."""
    one = escaped(re.sub(r"[\t\n\r]+", " ", text))
    one = one.replace("&", "&amp;").replace("<", "&lt;")
    return re.sub(r"([\\`*_|\[\]#~])", r"\\\1", one)


FORMAT = Format(markdown, ".md", summary="GITHUB_STEP_SUMMARY")
