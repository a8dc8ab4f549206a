"""Reports as Markdown: what a job's page of a CI service shows."""

from __future__ import annotations

import re

from allworlds.judging import Finding
from allworlds.reports.check_words import origin_words, scope_words, size_table, verdict_words
from allworlds.reports.finding_words import headline
from allworlds.reports.law_words import ASKED
from allworlds.reports.run_text import finding_text
from allworlds.studies.check import CheckReport

WIDTH = 100


def markdown(report: CheckReport) -> str:
    """The verdict, every finding with its picture, what was counted, and the scope."""
    word, text = verdict_words(report)
    blocks = [f"## allworlds: {word} {_plain(report.explorer)}", _plain(text)]
    for finding in report.findings:
        blocks += _finding(finding, origin_words(report, finding))
    header, rows = size_table(report)
    if rows:
        blocks.append(_table(header, rows, "--:"))
    scope = [[name, text] for name, text in scope_words(report)]
    blocks += ["<details><summary>What was checked</summary>", _table(["", ""], scope, "---")]
    blocks.append("</details>")
    return "\n\n".join(blocks) + "\n"


def _finding(finding: Finding, origin: str) -> list[str]:
    text = finding_text(finding, WIDTH, origin)
    # A fence is longer than any that the text holds.
    longest = max((len(run) for run in re.findall("`+", text)), default=0)
    fence = "`" * max(3, longest + 1)
    asked = f"Law `{finding.law}`: {ASKED[finding.law]}"
    return [f"### {_plain(headline(finding))}", asked, f"{fence}text\n{text}\n{fence}"]


def _table(header: list[str], rows: list[list[str]], rule: str) -> str:
    lines = [header, [rule] * len(header), *rows]
    return "\n".join(f"| {' | '.join(_plain(cell) for cell in line)} |" for line in lines)


def _plain(text: str) -> str:
    """The text in one line, where none of it is taken for markup."""
    one = re.sub(r"[\x00-\x1f\x7f]+", " ", text)
    one = one.replace("&", "&amp;").replace("<", "&lt;")
    return re.sub(r"([\\`*_|\[\]#~])", r"\\\1", one)
