"""Reports as plain text."""

import sys
from collections.abc import Iterable, Iterator, Sequence
from itertools import zip_longest
from textwrap import wrap
from typing import Any

from allworlds.reports import parts
from allworlds.reports.drawing.text import draw
from allworlds.words import harmless

MOST, FEW = 30, 3
"""The largest numbers of lines on a terminal if a content has short facts.

The first number is for all lines, the second for those about the findings after the first one.
"""

LONGEST_WALK, LONGEST_REFUTING = 60, 16
"""The numbers of steps that are shown of a walk with more than ``LONGEST_WALK`` steps.

The first number is for a walk that breaks no law, the second for a walk that breaks a law.  Half of
the shown steps are at the start of the walk, half at its end.  But if a walk that breaks a law has
a step ``parting`` (:class:`allworlds.reports.parts.ShownWalk`), the last shown step is this one,
and the others are those before it, ``LONGEST_WALK`` steps in all.
"""

GAP = 2
"""The number of spaces between the columns of a table."""

UNBROKEN = 24
"""The largest number of characters of a word in a table that is never broken."""

INDENT = 11
"""The number of characters before the text of a named paragraph."""


def finding_in_words(finding: Any, width: int, number: int = 1) -> str:
    """The text about a finding, with its picture, as ``check -v`` shows it.

    The title has the number ``number``; sentences are wrapped to ``width`` characters.
    """
    from allworlds.reports.content.single_run import finding_section

    return harmless(text_of([finding_section(finding, number)], width))


def content_text(content: parts.ReportContent, width: int) -> str:
    """The text of a content: the headline and every section.

    Sentences are wrapped to ``width`` characters.
    """
    said = content.headline
    head = entry(said.word, said.text, width) if said else []
    return _joined([head, *(_section(section, width) for section in content.sections)])


def on_terminal(content: parts.ReportContent, width: int, *, whole: bool) -> str:
    """The text of a content for a terminal.

    There are two cases.  If the content has a headline and short facts, the headline is the last
    line, and the text is shortened to at most :data:`MOST` lines, unless ``whole`` is set.  If not,
    the text begins with its headline, if there is one, and is never shortened.

    Args:
        content: the content.
        width: the number of characters of a line.
        whole: whether the text is that of the option ``-v``: nothing is shortened, and the sections
            ``content.whole``, if there are any, are at the end.
    """
    if not content.short or content.headline is None:
        text, more = content_text(content, width), text_of(content.whole, width)
        return f"{text}\n\n{more}" if whole and more else text
    (last,) = entry(content.headline.word, content.headline.text, sys.maxsize)
    if whole:
        return _joined([*(_section(section, width) for section in content.sections), [last]])
    facts = [_cut(entry(name, said, width - 4)) for name, said in content.short[: MOST // 2]]
    *findings, _ = content.sections
    others = [_cut(wrap(each.title, width - 4)) for each in findings[1:]]
    if len(others) > FEW:
        others = [*others[: FEW - 1], f"... and {len(others) - FEW + 1} more findings: see -v"]
    room = MOST - len(facts) - 4 - len(others)
    lines = [*_found(findings[0], width, room), *others] if findings else []
    return _joined([lines, facts, [last]])


def _cut(lines: Sequence[str]) -> str:
    """The first line, with ``...`` if there are more lines."""
    return f"{lines[0]} ..." if len(lines) > 1 else lines[0]


def _found(section: parts.Section, width: int, room: int) -> list[str]:
    """The lines about a finding, without the steps of its walk.

    The result has at most ``room`` lines and one more, which names the option ``-v``.  The picture
    of the finding's world is among the lines if there is room for it.  ``width`` is the number of
    characters of a line.
    """
    lines = wrap(section.title, width, break_long_words=False)
    picture, command = "", list[str]()
    for block in section.blocks:
        if isinstance(block, parts.FactList) and not picture:
            lines += _block(block, width)
        elif isinstance(block, parts.ShownWalk):
            for said in block.sentences:
                lines += wrap(said, width, break_on_hyphens=False)
            picture = draw(block.views[0].scene, width)
        elif isinstance(block, parts.ShownRun):
            picture = _shortened(block.diagram, room - len(lines) - 4)
        elif isinstance(block, parts.Quote) and block.command:
            command = [*_block(block, width)]
    for drawn in (picture, picture.rpartition("\n\n")[0]):  # at least without its legend
        shown = ["", *drawn.splitlines(), ""]
        if drawn and len(lines) + len(shown) + len(command) <= room:
            lines += shown
            break
    return [*lines[: room - len(command)], *command, "(-v: all of it)"]


def _shortened(lines: Sequence[str], most: int) -> str:
    """The lines as one text; of more than ``most`` lines it has only the first and the last ones.

    In place of the lines that are left out stands the line ``...``.
    """
    if len(lines) > most:
        after = most // 3
        lines = [*lines[: most - 1 - after], "...", *lines[-after:]]
    return "\n".join(lines)


def content_line(content: parts.ReportContent, width: int) -> str:
    """The headline in one line of any length; without a headline, the first line of the text.

    The lines of the text have at most ``width`` characters where possible; a headline may be
    longer.
    """
    head = content.headline
    return head.line if head else content_text(content, width).partition("\n")[0]


def text_of(sections: Iterable[parts.Section], width: int) -> str:
    """The text of some sections, whose sentences are wrapped to ``width`` characters."""
    return _joined(_section(section, width) for section in sections)


def _joined(parts: Iterable[Sequence[str]]) -> str:
    return "\n\n".join("\n".join(part) for part in parts if part)


def _section(section: parts.Section, width: int) -> list[str]:
    lines = wrap(section.title, width, break_long_words=False)
    before: parts.Block | None = None
    for block in section.blocks:
        shown = [*_block(block, width)]
        # Facts, and the quotation of a command, follow facts without an empty line.
        near = isinstance(before, parts.FactList) and isinstance(
            block, parts.FactList | parts.Quote
        )
        if shown:
            lines += [*([""] if lines and not near else []), *shown]
            before = block
    return lines


def _block(block: parts.Block, width: int) -> Iterator[str]:
    match block:
        case parts.Paragraph():
            yield from wrap(block.text, width, break_on_hyphens=False)
        case parts.FactList():
            for name, said in block.entries:
                yield from entry(name, said, width)
        case parts.Table():
            if block.rows:
                yield from wrap(block.caption, width)
                yield from table(block.header, block.texts, block.right, width, block.keys)
        case parts.MapPictures():
            for i, (title, scene) in enumerate(block.entries):
                yield from [*([""] if i else []), *wrap(title, width), "", draw(scene, width)]
        case parts.ShownWalk():
            yield from _walk(block, width)
        case parts.Quote():
            indent = block.prefix or ("  " if block.title else "")
            yield from [block.title] if block.title else []
            yield from (f"{indent}{line}".rstrip() for line in block.text.splitlines())
        case parts.ShownRun():
            yield from block.diagram
        case parts.DataRecord() | parts.Curve():
            return  # for pages; documents and tables hold the same


def _walk(walk: parts.ShownWalk, width: int) -> Iterator[str]:
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
        half = (LONGEST_REFUTING if walk.sentences else LONGEST_WALK) // 2
        first, last = rows[:half], rows[-half:]
        if walk.sentences and walk.parting is not None:  # up to there
            first, last = rows[: walk.parting + 1][-LONGEST_WALK:], []
        more = len(rows) - len(first) - len(last)
        left_out = ["...", f"({more} more)", *[""] * (len(steps.header) - 2)]
        rows = [*first, left_out, *last]
    yield from table(steps.header, rows, "r", width)


def table(
    header: Sequence[str],
    rows: Sequence[Sequence[str]],
    right: str = "",
    width: int = sys.maxsize,
    keys: int = 1,
) -> list[str]:
    """The lines of a table; column i is flushed right where ``right[i]`` is ``r``.

    If the table is wider than ``width`` characters, the widest columns of texts are wrapped.  If
    that is not enough, the columns that do not fit are in a further table below the first one; this
    further table repeats the first ``keys`` columns.
    """
    columns = [*zip(header, *rows, strict=True)]
    widths = [max(map(len, column)) for column in columns]
    right = right.ljust(len(header), "l")
    least = [
        wide if side == "r" else min(wide, UNBROKEN, max(map(len, " ".join(column).split(" "))))
        for wide, side, column in zip(widths, right, columns, strict=True)
    ]
    room = width - GAP * (len(header) - 1)
    while sum(widths) > room and widths != least:
        widest = max(range(len(header)), key=lambda i: (widths[i] > least[i], widths[i]))
        widths[widest] -= 1
    fit = keys + 1
    while fit < len(header) and sum(widths[: fit + 1]) + GAP * fit <= width:
        fit += 1
    if fit < len(header):
        kept = [*range(keys), *range(fit, len(header))]
        below = [[line[i] for i in kept] for line in (header, *rows)]
        sides = "".join(right[i] for i in kept)
        above = table(header[:fit], [row[:fit] for row in rows], right[:fit], width, keys)
        return [*above, "", *table(below[0], below[1:], sides, width, keys)]
    lines = []
    for line in (header, *rows):
        cells = [
            wrap(cell, wide, break_on_hyphens=False) if len(cell) > wide else [cell]
            for cell, wide in zip(line, widths, strict=True)
        ]
        for row in zip_longest(*cells, fillvalue=""):
            flushed = [
                part.rjust(wide) if side == "r" else part.ljust(wide)
                for part, wide, side in zip(row, widths, right, strict=True)
            ]
            lines.append((" " * GAP).join(flushed).rstrip())
    return lines


def entry(name: str, text: str, width: int) -> list[str]:
    """The lines of a named paragraph, with a hanging indent, wrapped to ``width`` characters."""
    first, indent = f"{name} ".ljust(INDENT), " " * INDENT
    return wrap(
        text, width, initial_indent=first, subsequent_indent=indent, break_on_hyphens=False
    ) or [name]
