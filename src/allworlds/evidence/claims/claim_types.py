"""Arguments and results of the functions that decide claims."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, TypeAlias

from msgspec import Struct, field

from allworlds.engines import EnginesDisagree
from allworlds.maps import Disagreement
from allworlds.outcome import Verdict
from allworlds.studies.ambiguity import SolversDisagree
from allworlds.studies.check import CheckReport
from allworlds.studies.worst import WrongTest
from allworlds.world import World

Truth: TypeAlias = Literal["holds", "refuted"]
Budget: TypeAlias = Literal["quick", "full"]
Shown: TypeAlias = int | float | str | Sequence[int | float | str]
"""A figure of a claim: a number, a name, or a list of these."""


class Picture(Struct, frozen=True):
    """A world to be drawn beside a claim."""

    caption: str
    world: World


class Found(Struct, frozen=True):
    """The result of checking a sentence, independent of any expectation.

    Attributes:
        verdict: whether it holds in the scope that was asked for.
        witnesses: how often each thing was met that the sentence is about; where one of them was
            never met nothing was checked.
        figures: the numbers that the sentence names.
        pictures: worlds that show it.
        told: in words, what refutes it or what is to be seen; may be empty.
    """

    verdict: Truth
    witnesses: Mapping[str, int]
    figures: Mapping[str, Shown] = field(default_factory=dict)
    pictures: tuple[Picture, ...] = ()
    told: str = ""


class NotChecked(Struct, frozen=True):
    """The reason why the sentence could not be checked here."""

    reason: str


class ProgramFault(Struct, frozen=True):
    """The reason why no answer counts: two parts of this program disagree, or one has no answer."""

    reason: str


class InternalError(Struct, frozen=True):
    """An error of this program, by which nothing is known of the sentence.

    Attributes:
        reason: the error in a line.
        traceback: where it was raised.
    """

    reason: str
    traceback: str


class Unfinished(RuntimeError):
    """Raised where another part of this program gives no answer, which is this program's fault."""


FAULTS = (Unfinished, Disagreement, EnginesDisagree, SolversDisagree, WrongTest)
"""The faults of this program that refute the claim that meets them."""


class Means(Struct, frozen=True):
    """Resources for checking claims.

    Attributes:
        workers: processes, or threads.
        proofs: the folder with the certificates and the proofs in Coq; None: it was not named.
        budget: how much may be done.
    """

    workers: int = 1
    proofs: Path | None = None
    budget: Budget = "quick"


Check: TypeAlias = Callable[..., Found | NotChecked]
"""Takes the means, and the bounds of its scope as keywords."""

Checks: TypeAlias = Mapping[str, Check]

Outcome: TypeAlias = Found | NotChecked | ProgramFault | InternalError
"""The outcome of a claim, as the ledger keeps it."""


def truth(holds: object) -> Truth:
    """The verdict for a truth value."""
    return "holds" if holds else "refuted"


def found_by(check: Check, means: Means, bounds: Mapping[str, Any]) -> Outcome:
    """The outcome of a claim's function, or the fault or error of this program that it met."""
    try:
        return check(means, **bounds)
    except FAULTS as fault:
        return ProgramFault(str(fault))
    except Exception as error:  # noqa: BLE001  # of one claim: the others are checked all the same
        reason = "".join(traceback.format_exception_only(error)).strip()
        return InternalError(reason, traceback.format_exc())


def of_check(report: CheckReport, *events: str, **figures: Shown) -> Found:
    """The outcome of an exhaustive check. Its worlds, runs and named events are witnesses.

    Raises:
        Unfinished: where it neither holds nor is refuted.
    """
    whole = report.uninterrupted()
    if whole.verdict not in (Verdict.HOLDS, Verdict.REFUTED):
        raise Unfinished(f"the check of {whole.explorer} ended as {whole.verdict.value}")
    seen: dict[str, Any] = {"worlds": whole.worlds, "runs": whole.runs}
    seen |= {event: whole.tally.witnesses.get(event, 0) for event in events}
    pictures = tuple(
        Picture(f"the smallest world in which {whole.explorer} fails", finding.world)
        for finding in whole.findings[:1]
    )
    told = "".join(
        f"the law {finding.law} is broken in a world with {finding.world.map.edge_count} edges and "
        f"{finding.world.map.vertex_count} vertices"
        for finding in whole.findings[:1]
    )
    return Found(truth(whole.verdict is Verdict.HOLDS), seen, figures, pictures, told)


def smallest(report: CheckReport) -> dict[str, Shown]:
    """The size of the smallest refuting world; empty if there is none."""
    if not report.findings:
        return {}
    first = report.findings[0].world.map
    return {"edges": first.edge_count, "vertices": first.vertex_count}
