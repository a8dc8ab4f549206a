"""Write the table of claims into ``docs/claims.md``, and the short one into the README.

``python tests/evidence/write.py``; ``test_manifest.py`` compares.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from pathlib import Path

from allworlds import optimum, worst
from allworlds.evidence.claims.manifest import SECTIONS, Claim, manifest

ROOT = Path(__file__).parents[2]
NAMES = {"ours": "ours"} | {name: f"Section {name}" for name in SECTIONS if name != "ours"}
SUBJECTS = {
    "II": "world and robot",
    "III": "what is not enough",
    "IV": "Algorithm 1",
    "V": "correctness",
    "VI": "complexity",
    "VII": "measurements",
    "VIII": "other lighthouses",
    "ours": "not in the paper",
}


def short() -> Iterator[str]:
    """A row a section: the ids, those that must be refuted in bold."""
    yield "| section | claims; in bold: must be refuted |"
    yield "|---|---|"
    for section, claims in groupby(manifest(), lambda claim: claim.section):
        names = [
            f"`{claim.id}`" if claim.expected == "holds" else f"**`{claim.id}`**"
            for claim in claims
        ]
        title = section if section != "ours" else "ours"
        yield f"| {title}: {SUBJECTS[section]} | {', '.join(names)} |"


def whole() -> Iterator[str]:
    """A table a section: sentence, method, scope, verdict, and what must be found."""
    for section, claims in groupby(manifest(), lambda claim: claim.section):
        yield f"### {NAMES[section].capitalize() if section == 'ours' else NAMES[section]}"
        yield ""
        yield "| claim | says | must be | how, and on what | must be found |"
        yield "|---|---|---|---|---|"
        for claim in claims:
            yield _row(claim)
        yield ""


def _row(claim: Claim) -> str:
    quick, full = claim.scopes["quick"], claim.scopes["full"]
    scope = claim.scope_under("quick")
    if quick is not full:
        scope += f"; **full**: {claim.scope_under('full')}"
    cells = (
        f"`{claim.id}`",
        claim.statement,
        claim.expected if claim.expected == "holds" else f"**{claim.expected}**",
        f"{claim.method}: {scope}",
        _numbers({**full.witnesses, **full.figures}),
    )
    return f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |"


def _numbers(values: dict[str, object]) -> str:
    return "; ".join(
        f"{name} {value:,}" if isinstance(value, int) else f"{name} {value}"
        for name, value in values.items()
    )


OPTIMUM = 4
"""Up to so many edges the optimum takes seconds."""


def beside_the_bound(edges: int = 6) -> Iterator[str]:
    """A row a size: the exact worst cost beside the bound, the cheapest schedule, the optimum."""
    best = {row.edges: row.optimum for row in optimum(edges=min(edges, OPTIMUM)).rows}
    yield "| m | n | worst | (1)+(2) | worst / bound | best | lower bound | optimum, all n |"
    yield "|---|---|---|---|---|---|---|---|"
    for row in worst(edges=edges).rows:
        m, n = row.edges, row.vertices
        share = f"{row.worst / row.bound:.2f}"
        told = best.get(m, "")
        yield f"| {m} | {n} | {row.worst} | {row.bound} | {share} | {row.best} | {m} | {told} |"


def between(text: str, name: str) -> str:
    """What stands between the marks of a name."""
    return text.split(_begin(name))[1].split(_end(name), maxsplit=1)[0]


def placed(text: str, name: str, lines: Iterator[str]) -> str:
    """The text with these lines between the marks of a name."""
    before, rest = text.split(_begin(name))
    return "\n".join([f"{before}{_begin(name)}", *lines, _end(name) + rest.split(_end(name))[1]])


def _begin(name: str) -> str:
    return f"<!-- {name}: written by tests/evidence/write.py -->"


def _end(name: str) -> str:
    return f"<!-- end of {name} -->"


README, LEDGER = ROOT / "README.md", ROOT / "docs" / "claims.md"
PLACES = (
    (README, "claims", short),
    (LEDGER, "claims", whole),
    (LEDGER, "worst", beside_the_bound),
)

if __name__ == "__main__":
    for page, name, lines in PLACES:
        page.write_text(placed(page.read_text(encoding="utf-8"), name, lines()), encoding="utf-8")
