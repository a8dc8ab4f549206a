"""Telling of ``check --estimate``."""

from __future__ import annotations

from allworlds.reports.telling import (
    Block,
    Headline,
    Section,
    Shown,
    ToldResult,
    ToldTable,
    fact,
)
from allworlds.studies.check import Guess, TimeEstimate
from allworlds.words import about, duration, number, plural


def estimate_telling(guess: TimeEstimate) -> ToldResult:
    """Estimated duration of the check, and of those with more edges if it is known."""
    if guess.seconds is None or guess.rate is None:
        head = Headline("estimate", _TOO_LONG, "inconclusive")
        return ToldResult("allworlds check", guess.explorer, guess, head, [])
    most = "" if guess.counted else "at most "
    worlds = f"{most}{about(guess.worlds)} world{'' if guess.worlds == 1 else 's'}"
    text = f"{most}{duration(guess.seconds)} for {worlds}: a guess"
    of = f"{plural(guess.sampled, 'world')} of the last level, {number(round(guess.rate))} a second"
    blocks: list[Block] = [fact("sample", of), *([_larger(guess)] if guess.larger else [])]
    head = Headline("estimate", text, "inconclusive")
    return ToldResult(
        "allworlds check", guess.explorer, guess, head, [Section("sample", "", blocks)]
    )


_TOO_LONG = "no world of the last level was finished in time: this takes very long"


def _larger(estimate: TimeEstimate) -> ToldTable:
    """Estimated duration with more edges."""
    guesses: list[TimeEstimate | Guess] = [estimate, *estimate.larger]
    worlds, takes = ("worlds", "takes") if estimate.counted else ("worlds <=", "takes <=")
    header = ("edges", worlds, "engine", "sampled", "a second", takes)
    rows = [
        (
            guess.edges,
            Shown(guess.worlds, about(guess.worlds)),
            guess.engine,
            guess.sampled or Shown(0, "none"),
            round(guess.rate),
            Shown(guess.seconds, duration(guess.seconds)),
        )
        for guess in guesses
        if guess.rate is not None and guess.seconds is not None
    ]
    return ToldTable(header, rows)
