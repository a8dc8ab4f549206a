"""Telling of ``init``: the files written, or the header."""

from __future__ import annotations

from allworlds.reports.telling import Block, Quote, Section, ToldFacts, ToldResult, Words
from allworlds.studies.init import Header, LedgerSkeleton, Skeleton


def init_telling(begun: Skeleton | LedgerSkeleton | Header) -> ToldResult:
    """The header line by line; or the written files, and the next commands."""
    if isinstance(begun, Header):
        lines = Quote("header", "", begun.header.rstrip("\n"))
        return ToldResult("allworlds init", "header", begun, None, [Section("header", "", [lines])])
    facts = [("written", ", ".join(begun.files))]
    if isinstance(begun, LedgerSkeleton):
        steps: list[Block] = [ToldFacts(facts), Quote("next", "next", begun.check, command=True)]
        return ToldResult("allworlds init", "ledger", begun, None, [Section("next", "", steps)])
    facts += [("needs", ", ".join(begun.language.needs))] if begun.language.needs else []
    said = f"{begun.explorer} is wrong so far: the check draws the smallest world that refutes it."
    blocks: list[Block] = [
        ToldFacts(facts),
        Quote("next", "next", begun.check, command=True),
        Words(said),
    ]
    return ToldResult("allworlds init", begun.explorer, begun, None, [Section("next", "", blocks)])
