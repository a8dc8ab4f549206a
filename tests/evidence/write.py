"""Write the tables of the pages that are made from results.

``python tests/evidence/write.py`` writes ``docs/claims.md``, the table of worst cases in
``docs/paper.md`` and the tables of ``docs/explorers.md``; it takes five minutes.  With the name
of a table it writes that one: ``six edges`` takes a quarter of an hour, and is written only so.
``test_manifest.py`` and ``test_tables_of_pages.py`` compare, of six edges what is quick, and
``nox -s exhaustive`` the rest.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from importlib.util import module_from_spec, spec_from_file_location
from itertools import groupby
from math import fsum
from pathlib import Path
from typing import Any

from allworlds.evidence.claims.manifest import SECTIONS, Claim, manifest

from allworlds import check, compare, run
from allworlds.judging import paper_bound
from allworlds.maps import CorridorShape, usual_degree
from allworlds.outcome import Verdict
from allworlds.studies.compare.comparison import Comparison
from allworlds.studies.compare.intervals import geometric_mean, mean_interval, power_law
from allworlds.world import Adversary

ROOT = Path(__file__).parents[2]
CLAIMS, PAPER, EXPLORERS = (
    ROOT / "docs" / f"{name}.md" for name in ("claims", "paper", "explorers")
)
BOUNDS = ROOT / "docs" / "figures" / "figure-bounds.csv"
FIGURES = ROOT / "docs" / "figures"

# ---------------------------------------------------------------- claims

NAMES = {"ours": "Beside the paper"} | {
    name: f"Section {name}" for name in SECTIONS if name != "ours"
}
SUBJECTS = {
    "II": "world and robot",
    "III": "lighthouses that are not enough",
    "IV": "Algorithm 1",
    "V": "correctness",
    "VI": "complexity",
    "VII": "measurements",
    "VIII": "other lighthouses",
    "ours": "claims of this project",
}
HEAD = """\
# The list of claims

Every sentence of the paper that can be checked, and the claims that this project adds.
[The paper, examined](paper.md#the-ledger-of-claims) tells how to check them, and what the columns
mean; `allworlds paper claims --only ID` checks one. Numbers in the last column are those of
`--budget full`. This page is written by `tests/evidence/write.py`.
"""


def claims_page() -> str:
    """The page of all claims."""
    return f"{HEAD}\n" + "\n".join(claims()).rstrip() + "\n"


def claims() -> Iterator[str]:
    """A table a section: sentence, method, scope, verdict, and what must be found."""
    for section, group in groupby(manifest(), lambda claim: claim.section):
        yield f"## {NAMES[section]}: {SUBJECTS[section]}"
        yield ""
        yield "| claim | says | must be | how, and on what | must be found |"
        yield "|---|---|---|---|---|"
        for claim in group:
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


# ---------------------------------------------------------------- the bound


def beside_the_bound() -> Iterator[str]:
    """A row a size: the exact worst cost beside the bound, the best schedule and the optimum."""
    yield "| m | n | (1)+(2) | worst | worst / bound | best schedule | optimum |"
    yield "|---|---|---:|---:|---:|---:|---:|"
    with BOUNDS.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            if row["far_hubs"]:
                continue  # a corridor; its worlds are not all tried
            worst, bound = int(row["worst"]), int(row["bound_1_plus_2"])
            cells = (row["edges"], row["vertices"], bound, worst, f"{worst / bound:.2f}")
            told = (*cells, row["best_schedule"], row["optimum"] or "?")
            yield f"| {' | '.join(map(str, told))} |"


# ---------------------------------------------------------------- explorers side by side

FOUR = ("algorithm1", "remembering", "greedy", "prudent")
COLUMNS = " | ".join(f"`{name}`" for name in FOUR)


@cache
def compared(edges: int) -> Comparison:
    """The four explorers in every world with at most that many edges."""
    return compare(*FOUR, edges=edges)


def small_worlds(edges: int = 5) -> Iterator[str]:
    """A row a size: the largest cost of each explorer, and its mean."""
    yield f"| m | n | (1)+(2) | {COLUMNS} |"
    yield f"|---|---|---:|{'---:|' * len(FOUR)}"
    for row in compared(edges).rows:
        if row.edges > 1:
            told = [f"{row.worst[name]} / {row.mean[name]:.2f}" for name in FOUR]
            bound = paper_bound(row.vertices, row.edges)
            yield f"| {row.edges} | {row.vertices} | {bound} | {' | '.join(told)} |"


def beside_algorithm_1(edges: int = 5) -> Iterator[str]:
    """A row an explorer: in how many worlds Algorithm 1 costs less, as much, and more."""
    rows = compared(edges).rows
    yield "| beside | less | equal | more |"
    yield "|---|---:|---:|---:|"
    for name in FOUR[1:]:
        told = [sum(getattr(row, kind)[name] for row in rows) for kind in ("less", "equal", "more")]
        yield f"| `{name}` | {' | '.join(f'{number:,}' for number in told)} |"


def six_edges(names: Sequence[str] = FOUR) -> Iterator[str]:
    """A row an explorer: its traversals with up to 6 edges, and its largest costs with 6."""
    yield "| explorer | traversals | n = 1 | 2 | 3 | 4 | 5 | 6 | 7 |"
    yield "|---|---:|---:|---:|---:|---:|---:|---:|---:|"
    for name in names:
        report = check(name, edges=6)
        assert (report.verdict, report.runs) == (Verdict.HOLDS, 794_514)
        largest = [row.max_cost for row in report.rows if row.edges == 6]
        yield f"| `{name}` | {report.traversals:,} | {' | '.join(map(str, largest))} |"
    bounds = [paper_bound(vertices, 6) for vertices in range(1, 8)]
    yield f"| (1)+(2) | | {' | '.join(map(str, bounds))} |"


def growth() -> Any:
    """The module that reads ``docs/figures/growth.csv``."""
    spec = spec_from_file_location("growth", FIGURES / "growth.py")
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def large_worlds() -> Iterator[str]:
    """A row a family: the mean costs in its largest worlds with their intervals."""
    yield f"| family | n | m | worlds | runs | {COLUMNS} | (1)+(2) |"
    yield f"|---|---:|---:|---:|---:|{'---:|' * len(FOUR)}---:|"
    for family, rows in _families():
        last = [row for row in rows if int(row["edges"]) == _largest(rows)]
        costs = [growth().costs(last, name)[_largest(rows)] for name in FOUR]
        means = [fsum(some) / len(some) for some in costs]
        told = [
            _with_interval(
                f"**{mean:,.0f}**" if mean == min(means) else f"{mean:,.0f}",
                "exact" if growth().exact_sizes(last, name) else mean_interval(some),
                ",.0f",
            )
            for name, mean, some in zip(FOUR, means, costs, strict=True)
        ]
        own = [row for row in last if row["explorer"] == FOUR[0]]
        runs, places = (sum(int(row[name]) for row in own) for name in ("runs", "places"))
        sizes = f"{own[0]['vertices']} | {_largest(rows)} | {len(own)} | {runs} of {places}"
        bound = max(int(row["bound"]) for row in own)
        yield f"| {family} | {sizes} | {' | '.join(told)} | {bound:,} |"


def ratios() -> Iterator[str]:
    """A row a family: the costs divided by those of Algorithm 1, in the same largest worlds."""
    yield f"| family | m | {COLUMNS.partition(' | ')[2]} |"
    yield f"|---|---:|{'---:|' * (len(FOUR) - 1)}"
    for family, rows in _families():
        m = _largest(rows)
        first, *others = (growth().costs(rows, name)[m] for name in FOUR)
        exact = all(m in growth().exact_sizes(rows, name) for name in FOUR)
        told = []
        for costs in others:
            found = geometric_mean([b / a for a, b in zip(first, costs, strict=True)])
            assert found is not None
            told.append(_with_interval(f"{found[0]:.3f}", "exact" if exact else found[1], ".3f"))
        yield f"| {family} | {m} | {' | '.join(told)} |"


def exponents() -> Iterator[str]:
    """A row a family: exponents with their intervals and residuals, and a word where none fits."""
    yield f"| family | m | {COLUMNS} |"
    yield f"|---|---|{'---:|' * len(FOUR)}"
    for family, rows in _families():
        told = []
        for name in FOUR:
            costs, exact = growth().costs(rows, name), growth().exact_sizes(rows, name)
            law = power_law(costs, exact)
            assert law is not None
            sign = "" if law.fits else f" *{law.shape}*"
            ends = "exact" if exact == set(costs) else law.interval
            found = _with_interval(f"{law.exponent:.2f}", ends, ".2f")
            told.append(f"{found} ±{law.residual:.2f}{sign}")
        least = min(int(row["edges"]) for row in rows)
        yield f"| {family} | {least}..{_largest(rows)} | {' | '.join(told)} |"


def corridors() -> Iterator[str]:
    """A row a size: the mean costs in corridors with a drawn far matching, divided by m^2 n."""
    yield f"| n | m | worlds | {COLUMNS} | (1)+(2) |"
    yield f"|---:|---:|---:|{'---:|' * len(FOUR)}---:|"
    rows = dict(_families())["corridor"] + growth().read(FIGURES / "corridors.csv")
    for edges, same in growth().costs(rows, FOUR[0]).items():
        (vertices,) = {int(row["vertices"]) for row in rows if int(row["edges"]) == edges}
        means = [growth().costs(rows, name)[edges] for name in FOUR]
        scale = edges**2 * vertices
        told = " | ".join(f"{fsum(some) / len(some) / scale:.3f}" for some in means)
        bound = paper_bound(vertices, edges) / scale
        yield f"| {vertices} | {edges} | {len(same)} | {told} | {bound:.2f} |"


def against_the_adversary(least: int = 1, most: int = 3) -> Iterator[str]:
    """A row a size: what the explorers walk against the adversary of corridors, with the seed 1."""
    yield f"| F | n | m | {COLUMNS} | at least | pairs excluded |"
    yield f"|---|---:|---:|{'---:|' * len(FOUR)}---:|---:|"
    for far in range(least, most + 1):
        shape = CorridorShape(far, usual_degree(far))
        made = [run(name, Adversary(shape, 1)).adversary for name in FOUR]
        (excluded,) = {decided.excluded for decided in made if decided}
        costs = " | ".join(f"{decided.cost:,}" for decided in made if decided)
        sizes = f"{far} | {shape.hubs + 1} | {shape.edges}"
        yield f"| {sizes} | {costs} | {shape.bound_of_testers:,} | {excluded:,} |"


def _families() -> Iterator[tuple[str, list[dict[str, str]]]]:
    yield from growth().by_family(growth().read()).items()


def _largest(rows: list[dict[str, str]]) -> int:
    return max(int(row["edges"]) for row in rows)


def _with_interval(text: str, interval: tuple[float, float] | str | None, form: str) -> str:
    """The text with its interval, or with the word that stands for it, if it has one."""
    if interval is None:
        return text
    if isinstance(interval, str):
        return f"{text} ({interval})"
    low, high = (format(end, form) for end in interval)
    return f"{text} ({low}..{high})"


# ---------------------------------------------------------------- the shield

STRANGERS = "examples/python/strangers.py"
INSIDE = (
    *(f"{STRANGERS}:{name}" for name in ("lazy", "ahead", "zigzag")),
    *("algorithm1", "greedy"),
)


def shields(edges: int = 4) -> Iterator[str]:
    """A row an explorer: the traversals of its shield in all runs, and the largest share."""
    yield "| INSIDE | traversals | largest share of (1)+(2) |"
    yield "|---|---:|---:|"
    for inside in INSIDE:
        file = str(ROOT / inside) if inside.startswith(STRANGERS) else inside
        report = check(f"shield:{file}", edges=edges)
        assert report.verdict is Verdict.HOLDS
        share = max(row.max_cost / paper_bound(row.vertices, row.edges) for row in report.rows)
        yield f"| `{inside}` | {report.traversals:,} | {share:.1f} |"


# ---------------------------------------------------------------- pages


def between(text: str, name: str) -> str:
    """The text between the marks of a name."""
    return text.split(_begin(name))[1].split(_end(name), maxsplit=1)[0]


def placed(text: str, name: str, lines: Iterator[str]) -> str:
    """The text with these lines between the marks of a name."""
    before, rest = text.split(_begin(name))
    return "\n".join([f"{before}{_begin(name)}", *lines, _end(name) + rest.split(_end(name))[1]])


def _begin(name: str) -> str:
    return f"<!-- {name}: written by tests/evidence/write.py -->"


def _end(name: str) -> str:
    return f"<!-- end of {name} -->"


PLACES: tuple[tuple[Path, str, Callable[[], Iterator[str]]], ...] = (
    (PAPER, "worst", beside_the_bound),
    (EXPLORERS, "small worlds", small_worlds),
    (EXPLORERS, "beside algorithm 1", beside_algorithm_1),
    (EXPLORERS, "six edges", six_edges),
    (EXPLORERS, "large worlds", large_worlds),
    (EXPLORERS, "ratios", ratios),
    (EXPLORERS, "exponents", exponents),
    (EXPLORERS, "corridors", corridors),
    (EXPLORERS, "adversary", against_the_adversary),
    (EXPLORERS, "shields", shields),
)

LONG = {"six edges"}

if __name__ == "__main__":
    CLAIMS.write_text(claims_page(), encoding="utf-8")
    wanted = {*sys.argv[1:]} or {name for _, name, _ in PLACES} - LONG
    for page, name, lines in PLACES:
        if name in wanted:
            text = page.read_text(encoding="utf-8")
            page.write_text(placed(text, name, lines()), encoding="utf-8")
