"""Telling of ``ambiguity search``: twins, or a certificate that there are none."""

from __future__ import annotations

from allworlds.reports.rows import CsvRows
from allworlds.reports.telling import Headline, Section, Shown, ToldFacts, ToldResult, ToldTable
from allworlds.reports.tellings.lookalikes import alike, letters
from allworlds.studies.ambiguity.twin_search import SearchResult


def search_telling(result: SearchResult) -> ToldResult:
    """The answer with the twins found, the sizes that it rests on, and its certificate."""
    pair = []
    if result.pair and result.bisimulation:
        walk = alike("AB", result.pair, result.bisimulation)
        pair.append(Section("walk-1", "Darts of one letter look alike", [walk]))
    headline, facts = _told(result)
    facts.append(("files", str(result.directory)))
    seen = Section("seen", "What was searched", [ToldFacts(facts), _table(result)])
    return ToldResult(
        "allworlds ambiguity search",
        f"{result.lighthouse} lighthouse, class {result.map_class.value}",
        result,
        headline,
        [*pair, seen],
        rows=lambda: _rows(result),
    )


def _rows(result: SearchResult) -> CsvRows:
    """A row for each size that was decided."""
    columns = {"sizes": str, "status": str, "seconds": float, "formula": str, "proof": str}
    rows = [
        [
            *(one.sizes.name, one.status, round(one.seconds, 6), one.formula.name),
            None if one.proof is None else one.proof.name,
        ]
        for one in result.levels
    ]
    return CsvRows(columns, rows)


def _table(result: SearchResult) -> ToldTable:
    """The sizes that were decided, in a table."""
    rows = [
        [
            searched.sizes.name,
            searched.status,
            Shown(round(searched.seconds, 6), f"{searched.seconds:.2f}"),
            searched.formula.name,
            None if searched.proof is None else searched.proof.name,
        ]
        for searched in result.levels
    ]
    header = ["sizes", "status", "seconds", "formula", "proof"]
    return ToldTable(header, rows, "The sizes that were decided")


def _told(result: SearchResult) -> tuple[Headline, list[tuple[str, str]]]:
    """The answer and its basis, as named texts."""
    asked = result.question.describes
    if result.status == "unknown":
        return Headline("UNKNOWN", f"{asked}: undecided.", "inconclusive"), []
    if result.vacuous:
        return Headline("VACUOUS", f"{asked}: there is no world at all.", "vacuous"), []
    if result.status == "sat":
        pair = [] if result.certificate is None else [("pair", str(result.certificate))]
        return Headline("FOUND", f"{asked}.", "vacuous"), [("why", _why(result)), *pair]
    proof = "no certificate for all sizes; the notices say why"
    if result.certificate is not None:
        proof = (
            f"{result.certificate}: a formula and an LRAT proof for all sizes, each proof checked "
            "by a program that is no solver"
        )
    return Headline("NONE", f"{asked}: there are none.", "holds"), [("proof", proof)]


def _why(result: SearchResult) -> str:
    assert result.pair is not None
    assert result.bisimulation is not None
    home = result.bisimulation[0][result.pair[0].start]
    return (
        f"the two starts are in class {letters(home)}, sigma and alpha take every class to one "
        "class, and the darts of a class sense the same: so whatever the motions, both robots "
        "stand at darts of one class. No start makes the two worlds the same."
    )
