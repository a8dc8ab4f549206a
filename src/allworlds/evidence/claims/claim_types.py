"""What the functions of this room take and hand back."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, TypeAlias

from allworlds.outcome import Verdict
from allworlds.studies.check import CheckReport
from allworlds.world import World

Truth: TypeAlias = Literal["holds", "refuted"]
Budget: TypeAlias = Literal["quick", "full"]
Shown: TypeAlias = int | float | str | Sequence[int | float | str]
"""What a claim says besides that it holds: a number, a name, or a list of these."""


@dataclass(frozen=True, slots=True)
class Picture:
    """A world to be drawn beside a claim."""

    caption: str
    world: World


@dataclass(frozen=True, slots=True)
class Found:
    """What was found out about a sentence, without a word about what is expected.

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


@dataclass(frozen=True, slots=True)
class NotChecked:
    """The sentence could not be looked at here, and why."""

    reason: str


class Unfinished(RuntimeError):
    """What a claim asked another part of this program has no answer: a fault of this program."""


@dataclass(frozen=True, slots=True)
class Means:
    """With what claims are checked.

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


def truth(holds: object) -> Truth:
    """The verdict in its word."""
    return "holds" if holds else "refuted"


def of_check(report: CheckReport, *events: str, **figures: Shown) -> Found:
    """What an exhaustive check has found; its worlds, its runs and the named events are witnesses.

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
    """The size of the smallest world that refutes; nothing where none does."""
    if not report.findings:
        return {}
    first = report.findings[0].world.map
    return {"edges": first.edge_count, "vertices": first.vertex_count}
