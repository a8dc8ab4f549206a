"""The ledger: every claim is checked, and the outcome is compared with the expected one."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Annotated, Literal, TypeAlias, cast

from allworlds.document import EXIT_CODE, AllRows, Aside, Positive, Report, about, computed, one_of
from allworlds.engines import COMPILER, Listener, Silent
from allworlds.evidence.claims.claim_types import (
    Budget,
    Check,
    Found,
    Means,
    NotChecked,
    Outcome,
    ProgramFault,
    Shown,
    Truth,
    found_by,
)
from allworlds.evidence.claims.manifest import BUDGETS, Claim, Sentence, manifest
from allworlds.inputs import InputError, a_path, an_integer, ensure_installed, show
from allworlds.outcome import Exit, Facts, until_interrupted
from allworlds.world import World

Seen: TypeAlias = Literal["holds", "refuted", "vacuous", "not-checked"]
Standing: TypeAlias = Literal["as-expected", "unexpected", "vacuous", "not-checked"]


def _verdict(one: CheckedClaim) -> Seen:
    """The verdict in a word; ``vacuous`` if a witness is missing or zero."""
    if one.truth is None:
        return "not-checked"
    if one.disagreement:
        return "refuted"
    seen = one.witnesses
    met = seen and all(seen.values()) and seen.keys() >= one.expected_witnesses.keys()
    return one.truth if met else "vacuous"


def _standing(one: CheckedClaim) -> Standing:
    """Whether the claim passes, as a word."""
    if one.verdict in ("not-checked", "vacuous"):
        return one.verdict
    return "unexpected" if _differences(one) else "as-expected"


def _differences(one: CheckedClaim) -> tuple[str, ...]:
    """Each difference from the expected outcome. An unchecked claim has none."""
    if one.truth is None:
        return ()
    if one.disagreement:
        return (f"a disagreement within this program: {one.disagreement}",)
    told = []
    if one.verdict != one.expected:
        told.append(f"verdict: {one.expected} expected, {one.verdict} found")
    for expected, seen in (
        (one.expected_witnesses, one.witnesses),
        (one.expected_figures, one.figures),
    ):
        told += [
            f"{name}: {expected.get(name)} expected, {seen.get(name)} found"
            for name in sorted({*expected, *seen})
            if expected.get(name) != seen.get(name)
        ]
    return tuple(told)


class CheckedClaim(Sentence):
    """A sentence that can be checked, with the expected outcome and the one found.

    ``truth`` is the verdict of its function, None if nothing was checked; checking took
    ``seconds``. Each of the ``worlds`` has its caption. A ``disagreement`` within this program
    refutes a claim, whatever is expected of it.
    """

    verdict: Annotated[Seen, about("the verdict found; `vacuous`: a witness never occurred")] = (
        computed(_verdict)
    )
    standing: Annotated[
        Standing, about("whether verdict, witnesses and figures are as expected")
    ] = computed(_standing)
    witnesses: Annotated[
        dict[str, int], about("how often each case occurred that the sentence is about")
    ]
    expected_witnesses: Annotated[dict[str, Positive], about("how often it must occur")]
    figures: Annotated[dict[str, Shown], about("the numbers that the sentence names, as found")]
    expected_figures: Annotated[dict[str, Shown], about("the expected numbers")]
    differences: Annotated[
        tuple[str, ...], about("the differences from the expected outcome, in words")
    ] = computed(_differences)
    told: Annotated[str, about("the refutation, an explanation, or why it was not checked")]
    worlds: Annotated[tuple[World, ...], about("worlds that show it")]
    captions: Aside[tuple[str, ...]]
    truth: Aside[Truth | None]
    disagreement: Aside[str]
    seconds: Aside[float]


class ClaimsReport(Report):
    """Report of 'claims'.

    The ledger, as far as it was made.
    """

    complete: AllRows
    exit_code: Annotated[
        Exit,
        one_of(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERRUPTED),
    ] = EXIT_CODE
    budget: Annotated[Budget, about("how much was done")]
    required: Annotated[tuple[str, ...], about("the claims that had to be checked")]
    claims: Annotated[
        tuple[CheckedClaim, ...], about("in the order of the sections; then those beyond the paper")
    ]

    @property
    def facts(self) -> Facts:
        """Whether each claim is as expected, the required ones were checked, and none is empty."""
        standings = {one.standing for one in self.claims}
        return Facts(
            interrupted=not self.complete,
            refuted="unexpected" in standings,
            undecided=bool(self.missed),
            vacuous="vacuous" in standings or standings <= {"not-checked"},
        )

    @property
    def missed(self) -> list[str]:
        """The required claims that were not checked."""
        return [
            one.id
            for one in self.claims
            if one.id in self.required and one.standing == "not-checked"
        ]


def claims(
    *,
    only: Iterable[str] = (),
    budget: str = "quick",
    require: Iterable[str] = (),
    proofs: str | Path | None = None,
    workers: int = 1,
    listener: Listener | None = None,
) -> ClaimsReport:
    """Check sentences of the paper, and further ones of this project, each on its scope.

    Args:
        only: ids of claims (default: all of them).
        budget: ``quick`` (below a minute) or ``full`` (below half an hour).
        require: ids of claims that must be checked: one that cannot be is exit code 3.
        proofs: the folder with the certificates and the proofs in Coq (default: that of the clone
            from which this runs, or in which one stands); without it the claims that rest on these
            alone are not checked.
        workers: processes, or threads.
        listener: is told of the progress.

    Raises:
        InputError: naming the offending value and what would be legal.
    """
    ensure_installed(*COMPILER, "paper claims")
    if budget not in BUDGETS:
        raise InputError(f"budget {show(budget)} is not one of {', '.join(BUDGETS)}")
    if an_integer("workers", workers) < 1:
        raise InputError(f"workers = {workers}; legal is 1 or more")
    chosen, required = _named("only", only), _named("require", require)
    wanted = [c for c in manifest() if not chosen or c.id in {*chosen, *required}]
    folder = proofs_of_clone() if proofs is None else _folder(proofs)
    means = Means(workers, folder, cast("Budget", budget))
    listener = listener or Silent()
    listener.stage("claims", len(wanted), "claims")
    entries, complete = until_interrupted(_entries(wanted, means, listener))
    return ClaimsReport(complete=complete, budget=means.budget, required=required, claims=entries)


def _entries(wanted: Sequence[Claim], means: Means, listener: Listener) -> Iterator[CheckedClaim]:
    from allworlds.evidence.claims.claim_table import CHECKS

    for claim in wanted:
        yield entry_of(claim, CHECKS[claim.id], means)
        listener.progress(1)


def entry_of(claim: Claim, check: Check, means: Means) -> CheckedClaim:
    """Check the claim and return its entry."""
    began = time.monotonic()
    found = found_by(check, means, claim.scopes[means.budget].bounds)
    return entry_with(claim, means.budget, found, time.monotonic() - began)


def entry_with(claim: Claim, budget: Budget, found: Outcome, seconds: float = 0) -> CheckedClaim:
    """The claim with the outcome found on its scope."""
    scope = claim.scopes[budget]
    shown = found if isinstance(found, Found) else Found("refuted", {}, told=found.reason)
    return CheckedClaim(
        id=claim.id,
        section=claim.section,
        statement=claim.statement,
        method=claim.method,
        scope=claim.scope_under(budget),
        source=claim.source,
        expected=claim.expected,
        witnesses=dict(shown.witnesses),
        expected_witnesses=scope.witnesses,
        figures=dict(shown.figures),
        expected_figures=scope.figures,
        told=shown.told,
        worlds=tuple(picture.world for picture in shown.pictures),
        captions=tuple(picture.caption for picture in shown.pictures),
        truth=None if isinstance(found, NotChecked) else shown.verdict,
        disagreement=found.reason if isinstance(found, ProgramFault) else "",
        seconds=seconds,
    )


def _named(option: str, names: Iterable[str]) -> tuple[str, ...]:
    legal = [claim.id for claim in manifest()]
    given = (names,) if isinstance(names, str) else tuple(names)
    for name in given:
        if name not in legal:
            near = get_close_matches(str(name), legal, 3, 0.4)
            hint = f"; near it are {', '.join(near)}" if near else ""
            raise InputError(f"{option} {show(name)} is no claim{hint}")
    return given


def proofs_of_clone() -> Path | None:
    """The folder of the proofs in the clone of the sources that is used here, if there is one.

    That is where this file stands in one, or where the current directory is one.
    """
    for clone in (Path(__file__).parents[4], Path.cwd()):
        sources = clone / "src" / "allworlds" / "evidence" / "claims" / Path(__file__).name
        if sources.is_file() and (clone / "proofs" / "check.py").is_file():
            return clone / "proofs"
    return None


def _folder(proofs: str | Path) -> Path:
    folder = a_path("proofs", proofs)
    if not (folder / "check.py").is_file():
        raise InputError(f"proofs {show(str(proofs))} is no folder that holds check.py")
    return folder
