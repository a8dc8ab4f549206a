"""What larger and larger worlds have cost, and the exponents that are fitted to it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import log
from typing import TYPE_CHECKING

from allworlds.judging import Finding
from allworlds.outcome import SCHEMA, Exit, Verdict
from allworlds.studies.check import Completed, Ending, Interrupted, Stopped

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True, slots=True)
class GrowRow:
    """What an explorer walks in the members of one size.

    Attributes:
        family: as it was asked for.
        edges, vertices: of the members.
        explorer: its name.
        members: the names of these worlds.
        costs: of the runs in them.
        bound: the largest legal cost; None without a bound.
    """

    family: str
    edges: int
    vertices: int
    explorer: str
    members: tuple[str, ...]
    costs: tuple[int, ...]
    bound: int | None

    @property
    def mean(self) -> float:
        """Of the costs."""
        return sum(self.costs) / len(self.costs)

    def to_json(self) -> documents.GrowthRowDocument:
        """One row of the document."""
        return {
            "family": self.family,
            "edges": self.edges,
            "vertices": self.vertices,
            "explorer": self.explorer,
            "mean": round(self.mean, 6),
            "least": min(self.costs),
            "worst": max(self.costs),
            "bound": self.bound,
            "members": list(self.members),
            "costs": list(self.costs),
        }


@dataclass(frozen=True, slots=True)
class Exponent:
    """How an explorer's cost grows in a family: like m to this power, fitted to the means."""

    family: str
    explorer: str
    exponent: float
    last: float

    def to_json(self) -> documents.ExponentDocument:
        """One entry of the document."""
        return {
            "family": self.family,
            "explorer": self.explorer,
            "exponent": round(self.exponent, 3),
            "last": round(self.last, 3),
        }


@dataclass(frozen=True, slots=True)
class Growth:
    """The cost by size.

    Attributes:
        explorers: their names.
        families: as they were asked for.
        rows: by family, size and explorer, as they were named.
        findings: the smallest of each explorer in each family.
        ending: how it came to its end.
        left_out: members in which a lighthouse has no place.
    """

    explorers: tuple[str, ...]
    families: tuple[str, ...]
    rows: tuple[GrowRow, ...]
    findings: tuple[Finding, ...]
    ending: Ending
    left_out: int = 0

    @property
    def exponents(self) -> list[Exponent]:
        """Where there are two sizes or more."""
        fitted = []
        for family in self.families:
            for name in self.explorers:
                rows = [r for r in self.rows if (r.family, r.explorer) == (family, name)]
                if len(rows) > 1:
                    fitted.append(Exponent(family, name, _slope(rows), _slope(rows[-2:])))
        return fitted

    @property
    def complete(self) -> bool:
        """Nothing was left undone."""
        return isinstance(self.ending, Completed)

    @property
    def verdict(self) -> Verdict:
        """Whether a run broke a law."""
        if self.findings:
            return Verdict.REFUTED
        if not self.complete:
            return Verdict.INCONCLUSIVE
        return Verdict.NOT_REFUTED if self.rows else Verdict.VACUOUS

    @property
    def exit_code(self) -> Exit:
        """That of the verdict; 130 where it was interrupted, whatever was found till then."""
        if isinstance(self.ending, Interrupted):
            return Exit.INTERRUPTED
        return self.verdict.exit

    def to_json(self) -> documents.GrowthDocument:
        """The document of ``grow --json``."""
        return {
            "schema": SCHEMA,
            "verdict": self.verdict.value,
            "exit_code": self.exit_code,
            "complete": self.complete,
            "explorers": list(self.explorers),
            "families": list(self.families),
            "rows": [row.to_json() for row in self.rows],
            "exponents": [exponent.to_json() for exponent in self.exponents],
            "left_out": self.left_out,
            "stopped": self.ending.reason if isinstance(self.ending, Stopped) else None,
            "findings": [finding.to_json() for finding in self.findings],
        }


def _slope(rows: Sequence[GrowRow]) -> float:
    """Of the straight line through log mean over log edges, by least squares."""
    from numpy import polyfit

    points = [(log(row.edges), log(row.mean)) for row in rows]
    slope, _ = polyfit([x for x, _ in points], [y for _, y in points], 1)
    return float(slope)
