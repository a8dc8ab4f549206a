"""What is claimed and what is expected of it: ``claims.toml``, read and checked.

Expected verdicts and numbers stand in that file alone; the functions that find them do not read
it.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, Literal, TypeAlias, cast, get_args

from allworlds.evidence.claims.claim_types import Budget, Figure, Truth

Method: TypeAlias = Literal[
    "exhaustive",
    "dynamic program",
    "SMT",
    "certificate",
    "algebra",
    "machine-checked proof",
    "search",
    "measurement",
]
"""How a claim is decided: of every case in a scope; over all schedules; by a solver; from a
certificate; in formulas; by Coq; by minimax; on worlds that are drawn."""

BUDGETS: tuple[str, ...] = get_args(Budget)


class BadManifest(ValueError):
    """The file of the claims says something that it cannot say."""


@dataclass(frozen=True, slots=True)
class ClaimScope:
    """What a claim is checked on under a budget, and what must be found there.

    Attributes:
        text: in words.
        bounds: the keywords of the function.
        witnesses: expected, all of them more than zero.
        figures: expected.
    """

    text: str
    bounds: Mapping[str, Any]
    witnesses: Mapping[str, int]
    figures: Mapping[str, Figure]


@dataclass(frozen=True, slots=True)
class Claim:
    """A sentence, and what must come out.

    Attributes:
        name: its id.
        section: of the paper, by its number, or ``ours``.
        says: the sentence in short.
        method: how it is decided.
        expected: the verdict that it must get.
        source: where the sentence stands, and where the expected numbers come from.
        scopes: by budget.
    """

    name: str
    section: str
    says: str
    method: Method
    expected: Truth
    source: str
    scopes: Mapping[Budget, ClaimScope]


SECTIONS = ("II", "III", "IV", "V", "VI", "VII", "VIII", "ours")
_KEYS = {"section", "says", "method", "scope", "expected", "source", "quick", "full"}


@cache
def manifest() -> tuple[Claim, ...]:
    """Every claim, by section, and as they stand in the file.

    Raises:
        BadManifest: naming the claim and what is wrong with it.
    """
    return read((files("allworlds.evidence.claims") / "claims.toml").read_text(encoding="utf-8"))


def read(text: str) -> tuple[Claim, ...]:
    """The claims of a file; raises as :func:`manifest`."""
    claims = [_claim(name, row) for name, row in tomllib.loads(text).items()]
    return tuple(sorted(claims, key=lambda claim: SECTIONS.index(claim.section)))


def _claim(name: str, row: Mapping[str, Any]) -> Claim:
    wrong = sorted(set(row) - _KEYS) or sorted(_KEYS - {"full"} - set(row))
    if wrong:
        raise BadManifest(f"claim {name}: {', '.join(wrong)} missing, or not known")
    for key, legal in (
        ("section", SECTIONS),
        ("method", get_args(Method)),
        ("expected", get_args(Truth)),
    ):
        if row[key] not in legal:
            raise BadManifest(f"claim {name}: {key} {row[key]!r} is not one of {', '.join(legal)}")
    quick = _scope(name, row["scope"], row["quick"])
    full = _scope(name, row["scope"], row["full"]) if "full" in row else quick
    return Claim(
        name,
        row["section"],
        row["says"],
        row["method"],
        row["expected"],
        row["source"],
        {"quick": quick, "full": full},
    )


def _scope(name: str, text: str, row: Mapping[str, Any]) -> ClaimScope:
    bounds, witnesses = row.get("bounds", {}), row.get("witnesses", {})
    if not witnesses or not all(type(n) is int and n > 0 for n in witnesses.values()):
        raise BadManifest(f"claim {name}: witnesses must be there, and be more than zero")
    return ClaimScope(
        text.format(**bounds), bounds, witnesses, cast("dict[str, Figure]", row.get("figures", {}))
    )
