"""Claims and expected outcomes: ``claims.toml``, read and checked.

Expected verdicts and numbers stand in that file alone; the functions that find them do not read
it.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Annotated, Any, Literal, TypeAlias, get_args

from allworlds.document import Document, Meta, Positive, Text, about, key, taken
from allworlds.evidence.claims.claim_types import Budget, Shown, Truth
from allworlds.inputs import InputError

Section: TypeAlias = Literal["II", "III", "IV", "V", "VI", "VII", "VIII", "ours"]
SECTIONS: tuple[Section, ...] = get_args(Section)

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
    """Raised for an invalid entry in the file of the claims."""


class ClaimScope(Document):
    """The scope of a claim under a budget, and the numbers that must be found there.

    The bounds are the keywords of its function.
    """

    bounds: dict[str, Any] = key(default_factory=dict)
    witnesses: Annotated[dict[str, Positive], Meta(min_length=1)]
    figures: dict[str, Shown] = key(default_factory=dict)


class Sentence(Document):
    """A sentence that can be checked, and the expected verdict."""

    id: Annotated[Text, about("its name, for `--only` and `--require`")]
    section: Annotated[Section, about("of the paper; `ours`: the sentence is not the paper's")]
    statement: Annotated[Text, about("the sentence in short")]
    method: Annotated[Method, about("how it is decided")]
    scope: Annotated[Text, about("on what it was decided under this budget")]
    source: Annotated[
        Text, about("where the sentence stands, and where the expected numbers come from")
    ]
    expected: Annotated[Truth, about("the verdict that it must get; `refuted`: an erratum")]


class Claim(Sentence):
    """A sentence and its expected outcome: a table of ``claims.toml``.

    ``{names}`` in the scope are those of the bounds.
    """

    quick: ClaimScope
    full: ClaimScope | None = None

    @property
    def scopes(self) -> Mapping[Budget, ClaimScope]:
        """The scopes of the claim, by budget."""
        return {"quick": self.quick, "full": self.full or self.quick}

    def scope_under(self, budget: Budget) -> str:
        """The scope under a budget, in words."""
        return self.scope.format(**self.scopes[budget].bounds)


@cache
def manifest() -> tuple[Claim, ...]:
    """Every claim, by section, and as they stand in the file.

    Raises:
        BadManifest: naming the claim and what is wrong with it.
    """
    return read((files("allworlds.evidence.claims") / "claims.toml").read_text(encoding="utf-8"))


def read(text: str) -> tuple[Claim, ...]:
    """Read the claims of a file; raises as :func:`manifest`."""
    claims = [_claim(name, table) for name, table in tomllib.loads(text).items()]
    return tuple(sorted(claims, key=lambda claim: SECTIONS.index(claim.section)))


def _claim(name: str, table: Mapping[str, Any]) -> Claim:
    try:
        return taken({"id": name, **table}, Claim, "it")
    except InputError as error:
        raise BadManifest(f"claim {name}: {error}") from None
