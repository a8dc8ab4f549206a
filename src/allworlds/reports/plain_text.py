"""Reports as plain text."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sequence
from textwrap import wrap

from allworlds.reports.drawing.text import draw
from allworlds.reports.telling import (
    Block,
    Costs,
    Headline,
    Quote,
    Section,
    ToldFacts,
    ToldPicture,
    ToldRecord,
    ToldResult,
    ToldTable,
    ToldWalk,
    Words,
)
from allworlds.reports.text_layout import GAP, INDENT, entry, table

MOST, FEW = 30, 3
"""Lines on a terminal of a telling that has short facts, and of its findings after the first."""

LONGEST_WALK = 60
"""The steps of a longer walk are told from both ends."""


def text(telling: ToldResult, width: int) -> str:
    """The headline and every section."""
    head = [*_headline(telling.headline, width)] if telling.headline else []
    return _joined([head, *(_section(section, width) for section in telling.sections)])


def on_terminal(telling: ToldResult, width: int, *, whole: bool) -> str:
    """The text; of a telling with short facts at most :data:`MOST` lines, or the verdict last."""
    if not telling.short or telling.headline is None:
        return text(telling, width)
    last = " ".join([*_headline(telling.headline, sys.maxsize)])
    if whole:
        return _joined([*(_section(section, width) for section in telling.sections), [last]])
    facts = [_cut(entry(name, said, width - 4)) for name, said in telling.short[: MOST // 2]]
    *findings, _ = telling.sections
    others = [_cut(wrap(each.title, width - 4)) for each in findings[1:]]
    if len(others) > FEW:
        others = [*others[: FEW - 1], f"... and {len(others) - FEW + 1} more findings: -v"]
    room = MOST - len(facts) - 4 - len(others)
    lines = [*_found(findings[0], width, room), *others] if findings else []
    return _joined([lines, facts, [last]])


def _cut(lines: Sequence[str]) -> str:
    """The first line, and a sign that there are more."""
    return f"{lines[0]} ..." if len(lines) > 1 else lines[0]


def _found(section: Section, width: int, room: int) -> list[str]:
    """A finding without its walk, with the picture of its world if there is room."""
    lines = wrap(section.title, width, break_long_words=False)
    picture, command = list[str](), list[str]()
    for block in section.blocks:
        if isinstance(block, ToldFacts) and not picture:
            lines += _block(block, width)
        elif isinstance(block, ToldWalk):
            lines += [line for said in block.sentences for line in wrap(said, width)]
            picture = ["", *draw(block.views[0].scene, width).splitlines(), ""]
        elif isinstance(block, Quote) and block.command:
            command = [*_block(block, width)]
    if len(lines) + len(picture) + len(command) <= room:
        lines += picture
    return [*lines[: room - len(command)], *command, "(-v: the walk, the answer, and the output)"]


def brief(telling: ToldResult, width: int) -> str:
    """The answer in one line, however wide it is; without one the first line of the text."""
    head = telling.headline
    return head.line if head else text(telling, width).partition("\n")[0]


def text_of(sections: Iterable[Section], width: int) -> str:
    """The text of some sections."""
    return _joined(_section(section, width) for section in sections)


def _joined(parts: Iterable[Sequence[str]]) -> str:
    return "\n\n".join("\n".join(part) for part in parts if part)


def _headline(headline: Headline, width: int) -> Iterator[str]:
    if len(headline.word) < INDENT:
        yield from entry(headline.word, headline.text, width)
    else:
        yield from wrap(headline.line, width)


def _section(section: Section, width: int) -> list[str]:
    title = wrap(section.title, width, break_long_words=False) if section.title else []
    lines = [line for line in ["\n".join(title)] if line]
    before: Block | None = None
    for block in section.blocks:
        told = [*_block(block, width)]
        # Facts, and the quotation of a command, follow facts without an empty line.
        near = isinstance(before, ToldFacts) and isinstance(block, ToldFacts | Quote)
        if told:
            lines += [*([""] if lines and not near else []), *told]
            before = block
    return lines


def _block(block: Block, width: int) -> Iterator[str]:
    match block:
        case Words():
            yield from wrap(block.text, width, break_on_hyphens=False)
        case ToldFacts():
            for name, said in block.entries:
                yield from entry(name, said, width)
        case ToldTable():
            yield from _table(block, width)
        case ToldPicture():
            yield from [*wrap(block.title, width), "", draw(block.scene, width)]
        case ToldWalk():
            yield from _walk(block, width)
        case Quote():
            indent = block.prefix or ("  " if block.title else "")
            yield from [block.title] if block.title else []
            yield from (f"{indent}{line}".rstrip() for line in block.text.splitlines())
        case Costs() | ToldRecord():
            return  # pictures and data of pages; tables and documents hold the same


def _table(told: ToldTable, width: int) -> list[str]:
    if not told.rows:
        return []
    title = wrap(told.caption, width)
    return [*title, *table(told.header, told.texts, told.right, width, told.keys)]


def _walk(walk: ToldWalk, width: int) -> Iterator[str]:
    sentences = () if walk.tour else walk.sentences
    for sentence in sentences:
        yield from wrap(sentence, width, break_on_hyphens=False)
    between = [""] if sentences else []
    for view in walk.views:
        if view.known is None:
            title = f"{view.title} ({view.note})" if view.note else view.title
            yield from [*between, *wrap(title, width), "", draw(view.scene, width)]
            between = [""]
    if walk.tour:
        return
    yield from ["", "The walk", ""]
    if walk.walked.world.told is not None:
        yield from [f"told before the start: {walk.walked.world.told}", ""]
    steps = walk.table
    rows = steps.texts
    if len(rows) > LONGEST_WALK:
        half = LONGEST_WALK // 2
        between = ["...", f"({len(rows) - 2 * half} more)", *[""] * (len(steps.header) - 2)]
        rows = [*rows[:half], between, *rows[-half:]]
    yield from _steps(steps.header, rows, width)


def _steps(header: Sequence[str], rows: Sequence[Sequence[str]], width: int) -> list[str]:
    """The steps as a table. Where it is too wide, percepts stand below each motion.

    What is sensed elsewhere is then told only where it is not what is sensed.
    """
    lines = table(header, rows, "r")
    if max(map(len, lines)) <= width:
        return lines
    below = " " * (len(header[0]) + GAP)
    lines = [(" " * GAP).join(header[:3]), f"{below}{header[3]}"]
    if len(header) > 4:
        lines.append(f"{below}≠ {header[5]}")
    for step, motion, place, sensed, *other in rows:
        lines.append(f"{step:>{len(header[0])}}  {motion:6}  {place}".rstrip())
        told = [sensed, f"≠ {other[1]}" if other and other[0] == "≠" else ""]
        lines += [below + line for said in told for line in wrap(said, width - len(below))]
    return lines
