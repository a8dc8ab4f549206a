"""The text of ``check``."""

from __future__ import annotations

import sys
from textwrap import wrap

from allworlds.reports.check_words import origin_words, scope_words, size_table, verdict_words
from allworlds.reports.run_text import finding_text
from allworlds.reports.text_layout import entry, table
from allworlds.studies.check import CheckReport, Guess, TimeEstimate
from allworlds.words import duration, number, plural


def check_text(report: CheckReport | TimeEstimate, width: int) -> str:
    """What was seen, its scope, the findings, and the verdict last; or how long it will take."""
    if isinstance(report, TimeEstimate):
        return "\n".join(_guess(report, width) + _larger(report, width))
    header, rows = size_table(report)
    scope = [line for name, text in scope_words(report) for line in entry(name, text, width)]
    blocks = [table(header, rows, "r" * len(header), width, keys=2), scope]
    blocks += [
        [finding_text(finding, width, origin_words(report, finding))] for finding in report.findings
    ]
    word, text = verdict_words(report)
    blocks.append(entry(word, text, width) if len(word) < 11 else wrap(f"{word}: {text}", width))
    return "\n\n".join("\n".join(block) for block in blocks if block)


def verdict_line(report: CheckReport | TimeEstimate, _width: int) -> str:
    """The verdict, or the estimate, in one line however wide it is."""
    if isinstance(report, TimeEstimate):
        return _guess(report, sys.maxsize)[0]
    word, text = verdict_words(report)
    return f"{word}: {text}"


def _guess(guess: TimeEstimate, width: int) -> list[str]:
    if guess.seconds is None or guess.rate is None:
        text = "no world of the last level was finished in time: this takes very long"
        return entry("estimate", text, width)
    text = f"{duration(guess.seconds)} for {plural(guess.worlds, 'world')}: a guess"
    of = f"{plural(guess.sampled, 'world')} of the last level, {number(round(guess.rate))} a second"
    return entry("estimate", text, width) + entry("sample", of, width)


def _larger(estimate: TimeEstimate, width: int) -> list[str]:
    """A table of what the check would take with more edges; nothing if that is not known."""
    if not estimate.larger:
        return []
    guesses: list[TimeEstimate | Guess] = [estimate, *estimate.larger]
    header = ("edges", "worlds", "engine", "sampled", "a second", "takes")
    rows = [
        (
            str(guess.edges),
            number(guess.worlds),
            guess.engine,
            number(guess.sampled) if guess.sampled else "none",
            number(round(guess.rate)),
            duration(guess.seconds),
        )
        for guess in guesses
        if guess.rate is not None and guess.seconds is not None
    ]
    return ["", *table(header, rows, "rrlrrr", width)]
