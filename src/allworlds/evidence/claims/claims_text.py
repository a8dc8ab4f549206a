"""The text of ``claims``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from textwrap import wrap

from allworlds.evidence.claims.ledger import CheckedClaim, ClaimsReport
from allworlds.reports import draw, entry, in_lines, interruption, scene_of
from allworlds.words import number, plural

NARROWEST_SENTENCE = 30
"""A sentence that has less room beside its verdict stands below it."""

LEGEND = ("= as expected", "≠ not as expected", "? nothing was met", "- not checked")

SIGNS = {"as-expected": "=", "unexpected": "≠", "vacuous": "?", "not-checked": "-"}
"""Before each claim: whether it is what is expected."""


def claims_text(report: ClaimsReport, width: int) -> str:
    """Section by section each claim with its verdict; of one alone all that was found."""
    lines: list[str] = []
    section = ""
    name_width = max((len(e.id) for e in report.claims), default=0)
    for one in report.claims:
        if one.section != section:
            section = one.section
            lines += ["", heading(section)] if lines else [heading(section)]
        lines += _told(one, name_width, width, at_length=len(report.claims) == 1)
    lines += ["", *interruption(complete=report.complete, width=width)]
    for one in report.claims:
        if one.standing in ("unexpected", "vacuous"):
            lines += entry("DIFFERS", f"{one.id}: {'; '.join(one.differences)}", width)
    for name in report.missed:
        lines += entry("REQUIRED", f"{name} was not checked", width)
    lines += [*in_lines(LEGEND, width), *wrap(claims_line(report, width), width)]
    return "\n".join(lines)


def heading(section: str) -> str:
    """``Section IV``, or that the sentences are ours."""
    return "Ours" if section == "ours" else f"Section {section}"


def claims_line(report: ClaimsReport, _width: int) -> str:
    """All in one line, which begins with the verdict."""
    standings = Counter(one.standing for one in report.claims)
    checked = [one for one in report.claims if one.standing == "as-expected"]
    held = sum(one.verdict == "holds" for one in checked)
    refuted = len(checked) - held
    parts = []
    if held:
        parts.append(f"{number(held)} {'holds' if held == 1 else 'hold'}")
    if refuted:
        parts.append(f"{number(refuted)} {'is' if refuted == 1 else 'are'} refuted, as must be")
    if standings["unexpected"]:
        parts.append(f"{number(standings['unexpected'])} not as expected")
    if standings["vacuous"]:
        parts.append(f"{number(standings['vacuous'])} vacuous")
    if standings["not-checked"]:
        parts.append(f"{number(standings['not-checked'])} not checked")
    return f"{_word(report)}: {plural(len(report.claims), 'claim')}: {', '.join(parts)}"


def _word(report: ClaimsReport) -> str:
    words = {0: "HOLDS", 1: "REFUTED", 3: "INCONCLUSIVE", 4: "VACUOUS", 130: "INTERRUPTED"}
    return words[int(report.exit_code)]


def _told(one: CheckedClaim, name_width: int, width: int, *, at_length: bool) -> Iterator[str]:
    before = f"{SIGNS[one.standing]} {one.id.ljust(name_width)}  {one.verdict.ljust(11)}  "
    if width - len(before) < NARROWEST_SENTENCE:
        yield before.rstrip()
        yield from (f"  {line}" for line in wrap(one.statement, width - 2, break_on_hyphens=False))
    else:
        sentence = wrap(one.statement, width - len(before), break_on_hyphens=False)
        for i, line in enumerate(sentence):
            yield (before if i == 0 else " " * len(before)) + line
    if at_length:
        yield ""
        yield from _drawn(one, width)
        for name, text in details(one):
            yield from entry(name, text, width)


def _drawn(one: CheckedClaim, width: int) -> Iterator[str]:
    """The worlds that show it, in characters."""
    for caption, world in zip(one.captions, one.worlds, strict=True):
        yield from (caption, "", *draw(scene_of(world), width).splitlines(), "")


def details(one: CheckedClaim) -> list[tuple[str, str]]:
    """Everything else that there is to say about a claim, each with its name."""
    told = [
        ("method", one.method),
        ("scope", one.scope),
        ("expected", one.expected),
        ("source", one.source),
    ]
    if one.standing == "not-checked":
        return [*told, ("reason", one.told)]
    told.append(("witnesses", _listed(one.witnesses)))
    if one.figures:
        told.append(("figures", _listed(one.figures)))
    if one.told:
        told.append(("seen", one.told))
    return told


def _listed(values: Mapping[str, object]) -> str:
    return ", ".join(f"{name} {_value(value)}" for name, value in values.items())


def _value(value: object) -> str:
    if isinstance(value, list):
        return "[" + ", ".join(map(str, value)) + "]"
    return number(value) if isinstance(value, int) else str(value)
