"""The text of ``check``."""

from __future__ import annotations

from textwrap import wrap

from allworlds.checker import Report
from allworlds.reports.check_words import origin_words, scope_words, size_table, verdict_words
from allworlds.reports.layout import entry, table
from allworlds.reports.run_text import finding_text


def check_text(report: Report, width: int) -> str:
    """What was seen, its scope, the findings, and the verdict last, where it is seen first."""
    header, rows = size_table(report)
    scope = [line for name, text in scope_words(report) for line in entry(name, text, width)]
    blocks = [table(header, rows, "r" * len(header)), scope]
    blocks += [
        [finding_text(finding, width, origin_words(report, finding))] for finding in report.findings
    ]
    word, text = verdict_words(report)
    blocks.append(entry(word, text, width) if len(word) < 11 else wrap(f"{word}: {text}", width))
    return "\n\n".join("\n".join(block) for block in blocks if block)


def verdict_line(report: Report) -> str:
    """The verdict in one line."""
    word, text = verdict_words(report)
    return f"{word}: {text}"
