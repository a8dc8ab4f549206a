"""The ledger: every claim is checked, and what is found is held against what is expected."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeAlias, cast

from allworlds.evidence.claims.claim_types import Budget, Check, Found, Means, NotChecked
from allworlds.evidence.claims.manifest import BUDGETS, Claim, ClaimScope, manifest
from allworlds.inputs import InputError, a_path, an_integer, show
from allworlds.outcome import SCHEMA, Exit, until_interrupted
from allworlds.progress import Listener, Silent

if TYPE_CHECKING:
    from allworlds import documents

Seen: TypeAlias = Literal["holds", "refuted", "vacuous", "not-checked"]
Standing: TypeAlias = Literal["as-expected", "unexpected", "vacuous", "not-checked"]

_NOTHING = Found("refuted", {})
"""What is written of a claim that was not looked at; its verdict says so."""


@dataclass(frozen=True, slots=True)
class CheckedClaim:
    """One line of the ledger.

    Attributes:
        claim: the sentence, with what is expected.
        scope: what it was checked on.
        found: what was found.
        seconds: how long that took.
    """

    claim: Claim
    scope: ClaimScope
    found: Found | NotChecked
    seconds: float

    @property
    def verdict(self) -> Seen:
        """What was found in a word; ``vacuous`` where a witness is missing or zero."""
        if isinstance(self.found, NotChecked):
            return "not-checked"
        seen = self.found.witnesses
        met = seen and all(seen.values()) and seen.keys() >= self.scope.witnesses.keys()
        return self.found.verdict if met else "vacuous"

    @property
    def differences(self) -> list[str]:
        """Each thing that is not what is expected, in words; of what was not checked nothing."""
        if isinstance(self.found, NotChecked):
            return []
        told = []
        if self.verdict != self.claim.expected:
            told.append(f"verdict: {self.claim.expected} expected, {self.verdict} found")
        for expected, seen in (
            (self.scope.witnesses, self.found.witnesses),
            (self.scope.figures, self.found.figures),
        ):
            for name in sorted({*expected, *seen}):
                one, other = expected.get(name), seen.get(name)
                if one != other:
                    told.append(f"{name}: {one} expected, {other} found")
        return told

    @property
    def standing(self) -> Standing:
        """Whether it passes."""
        verdict = self.verdict
        if verdict in ("not-checked", "vacuous"):
            return verdict
        return "unexpected" if self.differences else "as-expected"

    def to_json(self) -> documents.ClaimEntry:
        """The entry as it stands in the document."""
        found = self.found
        told = found.reason if isinstance(found, NotChecked) else found.told
        if isinstance(found, NotChecked):
            found = _NOTHING
        return {
            "id": self.claim.name,
            "section": self.claim.section,
            "statement": self.claim.says,
            "method": self.claim.method,
            "scope": self.scope.text,
            "source": self.claim.source,
            "expected": self.claim.expected,
            "verdict": self.verdict,
            "standing": self.standing,
            "witnesses": dict(found.witnesses),
            "expected_witnesses": dict(self.scope.witnesses),
            "figures": dict(found.figures),
            "expected_figures": dict(self.scope.figures),
            "differences": self.differences,
            "told": told,
            "worlds": [picture.world.to_json() for picture in found.pictures],
        }


@dataclass(frozen=True, slots=True)
class ClaimsReport:
    """The ledger as far as it was made.

    Attributes:
        budget: under which it was made.
        entries: in the order of the manifest.
        required: claims that must have been checked.
        complete: False if the user has interrupted, and entries are missing.
    """

    budget: Budget
    entries: tuple[CheckedClaim, ...]
    required: tuple[str, ...] = ()
    complete: bool = True

    @property
    def missed(self) -> list[str]:
        """The required claims that were not checked."""
        return [
            entry.claim.name
            for entry in self.entries
            if entry.claim.name in self.required and entry.standing == "not-checked"
        ]

    @property
    def exit_code(self) -> Exit:
        """130 interrupted, 1 a claim is not as expected, 3 a required one unchecked, 4 vacuous."""
        standings = {entry.standing for entry in self.entries}
        if not self.complete:
            return Exit.INTERRUPTED
        if "unexpected" in standings:
            return Exit.REFUTED
        if self.missed:
            return Exit.INCONCLUSIVE
        return Exit.VACUOUS if "vacuous" in standings else Exit.HOLDS

    def to_json(self) -> documents.ClaimsDocument:
        """The document of ``claims --json``."""
        return {
            "schema": SCHEMA,
            "complete": self.complete,
            "exit_code": self.exit_code,
            "budget": self.budget,
            "required": list(self.required),
            "claims": [entry.to_json() for entry in self.entries],
        }


def claims(
    *,
    only: Iterable[str] = (),
    budget: str = "quick",
    require: Iterable[str] = (),
    proofs: str | Path | None = None,
    workers: int = 1,
    listener: Listener | None = None,
) -> ClaimsReport:
    """Check the sentences of the paper, and our own, each on its scope.

    Args:
        only: ids of claims (default: all of them).
        budget: ``quick`` (below a minute) or ``full`` (below half an hour).
        require: ids of claims that must be checked: one that cannot be is exit code 3.
        proofs: the folder with the certificates and the proofs in Coq; without it the claims
            that rest on these alone are not checked.
        workers: processes, or threads.
        listener: is told of the progress.

    Raises:
        InputError: naming the offending value and what would be legal.
    """
    if budget not in BUDGETS:
        raise InputError(f"budget {show(budget)} is not one of {', '.join(BUDGETS)}")
    if an_integer("workers", workers) < 1:
        raise InputError(f"workers = {workers}; legal is 1 or more")
    chosen, required = _named("only", only), _named("require", require)
    wanted = [c for c in manifest() if not chosen or c.name in {*chosen, *required}]
    folder = None if proofs is None else _folder(proofs)
    means = Means(workers, folder, cast("Budget", budget))
    listener = listener or Silent()
    listener.stage("claims", len(wanted), "claims")
    entries, complete = until_interrupted(_entries(wanted, means, listener))
    return ClaimsReport(means.budget, entries, required, complete)


def _entries(wanted: Sequence[Claim], means: Means, listener: Listener) -> Iterator[CheckedClaim]:
    from allworlds.evidence.claims.claim_table import CHECKS

    for claim in wanted:
        yield entry_of(claim, CHECKS[claim.name], means)
        listener.progress(1)


def entry_of(claim: Claim, check: Check, means: Means) -> CheckedClaim:
    """The claim, checked."""
    scope, began = claim.scopes[means.budget], time.monotonic()
    found = check(means, **scope.bounds)
    return CheckedClaim(claim, scope, found, time.monotonic() - began)


def _named(option: str, names: Iterable[str]) -> tuple[str, ...]:
    legal = [claim.name for claim in manifest()]
    given = (names,) if isinstance(names, str) else tuple(names)
    for name in given:
        if name not in legal:
            near = get_close_matches(str(name), legal, 3, 0.4)
            hint = f"; near it are {', '.join(near)}" if near else ""
            raise InputError(f"{option} {show(name)} is no claim{hint}")
    return given


def _folder(proofs: str | Path) -> Path:
    folder = a_path("proofs", proofs)
    if not (folder / "check.py").is_file():
        raise InputError(f"proofs {show(str(proofs))} is no folder that holds check.py")
    return folder
