"""The ledger: every claim is checked, and the outcome is compared with the expected one."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Annotated, Literal, TypeAlias, cast

from typing_extensions import override

from allworlds.document import (
    EXIT_CODE,
    Aside,
    ExitCode,
    Natural,
    Positive,
    about,
    computed,
    one_of,
)
from allworlds.engines import COMPILER, AskedListener, AskedWorkers, Listener, RowsReport
from allworlds.evidence.claims.claim_types import (
    Budget,
    Check,
    Found,
    InternalError,
    Means,
    NotChecked,
    Outcome,
    ProgramFault,
    Shown,
    Truth,
    found_by,
)
from allworlds.evidence.claims.manifest import BUDGETS, Claim, Sentence, manifest
from allworlds.inputs import (
    EFFORT,
    SCOPE,
    InputError,
    Option,
    Taken,
    a_path,
    answers,
    ensure_installed,
    show,
)
from allworlds.outcome import Exit, until_interrupted
from allworlds.world import World

Seen: TypeAlias = Literal["holds", "refuted", "vacuous", "not-checked", "error"]
Standing: TypeAlias = Literal["as-expected", "unexpected", "vacuous", "not-checked"]


def _verdict(one: CheckedClaim) -> Seen:
    """The verdict in a word; ``vacuous`` if a witness is missing or zero."""
    if one.error:
        return "error"
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
    if one.error:
        return (f"an error of this program: {one.error}",)
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
    refutes a claim, whatever is expected of it; an ``error`` of this program leaves it open.
    """

    verdict: Annotated[
        Seen,
        about(
            "the verdict found; `vacuous`: a witness never occurred; `error`: this program failed"
        ),
    ] = computed(_verdict)
    standing: Annotated[
        Standing, about("whether verdict, witnesses and figures are as expected")
    ] = computed(_standing)
    witnesses: Annotated[
        dict[str, Natural], about("how often each case occurred that the sentence is about")
    ]
    expected_witnesses: Annotated[dict[str, Positive], about("how often it must occur")]
    figures: Annotated[dict[str, Shown], about("the numbers that the sentence names, as found")]
    expected_figures: Annotated[dict[str, Shown], about("the expected numbers")]
    differences: Annotated[
        tuple[str, ...], about("the differences from the expected outcome, in words")
    ] = computed(_differences)
    told: Annotated[
        str, about("the refutation, an explanation, why it was not checked, or a traceback")
    ]
    worlds: Annotated[tuple[World, ...], about("worlds that show it")]
    captions: Aside[tuple[str, ...]]
    truth: Aside[Truth | None]
    disagreement: Aside[str]
    error: Aside[str]
    seconds: Aside[float]


class ClaimsReport(RowsReport):
    """Report of 'claims'.

    The ledger, as far as it was made.
    """

    exit_code: Annotated[
        ExitCode,
        one_of(
            *(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERNAL),
            Exit.INTERRUPTED,
        ),
    ] = EXIT_CODE
    budget: Annotated[Budget, about("how much was done")]
    required: Annotated[tuple[str, ...], about("the claims that had to be checked")]
    claims: Annotated[
        tuple[CheckedClaim, ...], about("in the order of the sections; then those beyond the paper")
    ]

    @property
    def _standings(self) -> set[str]:
        return {one.standing for one in self.claims}

    @property
    @override
    def agrees(self) -> bool:
        return not any(one.error for one in self.claims)

    @property
    @override
    def refuted(self) -> bool:
        return "unexpected" in self._standings

    @property
    @override
    def undecided(self) -> bool:
        return bool(self.missed)

    @property
    @override
    def empty(self) -> bool:
        return "vacuous" in self._standings or self._standings <= {"not-checked"}

    @property
    @override
    def seconds_by_part(self) -> dict[str, list[float]]:
        return {"claim_seconds": [one.seconds for one in self.claims]}

    @property
    def missed(self) -> list[str]:
        """The required claims that were not checked."""
        return [
            one.id
            for one in self.claims
            if one.id in self.required and one.standing == "not-checked"
        ]


def _budget(given: object) -> Budget:
    if given not in BUDGETS:
        raise InputError(f"budget {show(given)} is not one of {', '.join(BUDGETS)}")
    return cast("Budget", given)


class ClaimsRequest(AskedListener, AskedWorkers):
    """Request of ``paper claims``: which of them, and how much of each."""

    only: Annotated[
        Taken[Iterable[str], tuple[str, ...]],
        Option(SCOPE, "ID", "Only this claim; may be repeated.", repeated=True),
    ] = Taken(lambda given: _named("only", given), ())
    require: Annotated[
        Taken[Iterable[str], tuple[str, ...]],
        Option(
            SCOPE,
            "ID",
            "A claim that must be checked, else the exit code is 3; may be repeated.",
            repeated=True,
        ),
    ] = Taken(lambda given: _named("require", given), ())
    proofs: Annotated[
        Taken[str | Path | None, Path | None],
        Option(
            SCOPE,
            "DIR",
            "The folder 'proofs' of the sources: certificates, and with --budget full and an "
            "installed Coq the proofs (default: that of the clone of the sources; without one "
            "their claims are not checked).",
        ),
    ] = Taken(lambda given: proofs_of_clone() if given is None else _folder(given), None)
    budget: Annotated[
        Taken[str, Budget],
        Option(
            EFFORT,
            "quick|full",
            "How much is checked: quick is less than a minute, full less than half an hour.",
        ),
    ] = Taken(_budget, "quick")


@answers(ClaimsRequest)
def claims(request: ClaimsRequest) -> ClaimsReport:
    """Check sentences of the paper, and further ones of this project, each on its scope.

    Raises:
        InputError: naming the offending value and what would be legal.
    """
    ensure_installed(*COMPILER, "paper claims")
    chosen, required = request.only, request.require
    wanted = [c for c in manifest() if not chosen or c.id in {*chosen, *required}]
    means = Means(request.workers, request.proofs, request.budget)
    request.listener.stage("claims", len(wanted), "claims")
    entries, ending = until_interrupted(_entries(wanted, means, request.listener))
    return ClaimsReport(ending=ending, budget=means.budget, required=required, claims=entries)


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
    match found:
        case Found():
            shown = found
        case InternalError():
            shown = Found("refuted", {}, told=found.traceback)
        case _:
            shown = Found("refuted", {}, told=found.reason)
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
        truth=None if isinstance(found, NotChecked | InternalError) else shown.verdict,
        disagreement=found.reason if isinstance(found, ProgramFault) else "",
        error=found.reason if isinstance(found, InternalError) else "",
        seconds=seconds,
    )


def _named(option: str, names: Iterable[str]) -> tuple[str, ...]:
    legal = [claim.id for claim in manifest()]
    given = (names,) if isinstance(names, str) else tuple(names)
    for name in given:
        if name not in legal:
            raise InputError(f"{option} {show(name)} is no claim{_hint(option, str(name), legal)}")
    return given


def _hint(option: str, name: str, legal: Sequence[str]) -> str:
    """Words about a name that is no claim: several in one text, or one that is nearly right."""
    several = [part.strip() for part in name.split(",")]
    if len(several) > 1 and set(several) <= {*legal}:
        return f"; claims are named one by one: {' '.join(f'--{option} {c}' for c in several)}"
    near = get_close_matches(name, legal, 3, 0.4)
    if near:
        return f"; near it are {', '.join(near)}"
    return f"; the {len(legal)} claims are in docs/claims.md, the first are {', '.join(legal[:3])}"


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
