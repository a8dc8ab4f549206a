"""The outcome of a check: a verdict that never comes without its scope."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from allworlds.checker.finding import Finding
from allworlds.checker.past import Past
from allworlds.checker.scope import Scope
from allworlds.checker.tally import Tally

SCHEMA = 1


class Verdict(StrEnum):
    """What was found out."""

    HOLDS = "holds"
    REFUTED = "refuted"
    INCONCLUSIVE = "inconclusive"
    VACUOUS = "vacuous"
    ERROR = "error"
    NOT_REFUTED = "not-refuted"


EXIT_CODES = {
    Verdict.HOLDS: 0,
    Verdict.NOT_REFUTED: 0,
    Verdict.REFUTED: 1,
    Verdict.INCONCLUSIVE: 3,
    Verdict.VACUOUS: 4,
    Verdict.ERROR: 70,
}
INTERRUPTED = 130


@dataclass(frozen=True, slots=True)
class Cell:
    """One comparison of the count gate.

    Attributes:
        edges, vertices: the size.
        enumerated: the rooted maps that were visited.
        counted: those that there are according to ``source``.
    """

    edges: int
    vertices: int
    enumerated: int
    counted: int
    source: str

    @property
    def agrees(self) -> bool:
        """Nothing speaks against the enumeration."""
        return self.counted == self.enumerated


@dataclass(slots=True)
class Report:
    """What a check has seen, and what follows from it.

    Attributes:
        explorer: the name of the subject.
        engine: ``python`` or ``kernel``.
        scope: what was to be checked.
        tally: the counts of the finished levels, and the smallest findings.
        levels: the numbers of edges of the finished levels.
        complete: every level of the scope is finished.
        gate: the comparisons of the count gate.
        missing: witnesses that a complete check must have seen and has not.
        stopped: why the check is not complete; empty if it is.
        interrupted: by the user.
        corpus: what became of the past findings, if there is a corpus of them.
        symmetry: where one run has been counted for several, why that is right; else empty.
        disagreement: what two engines say differently; empty if they agree.
    """

    explorer: str
    engine: str
    scope: Scope
    tally: Tally
    levels: list[int] = field(default_factory=list)
    complete: bool = False
    gate: list[Cell] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    stopped: str = ""
    interrupted: bool = False
    corpus: Past | None = None
    symmetry: str = ""
    disagreement: str = ""

    @property
    def findings(self) -> list[Finding]:
        """The smallest findings, ascending."""
        return self.tally.findings

    @property
    def worlds(self) -> int:
        """Rooted maps visited in finished levels."""
        return self.tally.worlds

    @property
    def runs(self) -> int:
        """Worlds x places in finished levels."""
        return self.tally.runs

    @property
    def verdict(self) -> Verdict:
        """The verdict, about the scope and nothing else."""
        if self.disagreement or not all(cell.agrees for cell in self.gate):
            return Verdict.ERROR
        if self.findings:
            return Verdict.REFUTED
        if self.scope.sample and self.runs and not self.stopped:
            return Verdict.NOT_REFUTED
        if not self.complete:
            return Verdict.INCONCLUSIVE
        if self.missing or (not self.runs and self.scope.shard == (0, 1)):
            return Verdict.VACUOUS
        return Verdict.HOLDS

    @property
    def exit_code(self) -> int:
        """The exit code of the command."""
        if self.interrupted and self.verdict is not Verdict.ERROR:
            return INTERRUPTED
        return EXIT_CODES[self.verdict]

    def uninterrupted(self) -> Report:
        """This report, for callers to whom half a check says nothing.

        Raises:
            KeyboardInterrupt: if it was interrupted; ``check`` has kept that to itself.
        """
        if self.interrupted:
            raise KeyboardInterrupt
        return self

    def to_json(self) -> dict[str, Any]:
        """The document of ``check --json``."""
        return {
            "schema": SCHEMA,
            "verdict": self.verdict.value,
            "exit_code": self.exit_code,
            "explorer": self.explorer,
            "engine": self.engine,
            "scope": self._scope_json(),
            "worlds": self.worlds,
            "runs": self.runs,
            "episodes": sum(row.episodes for row in self.tally.rows.values()),
            "left_out": self.tally.left_out,
            "traversals": self.tally.traversals,
            "checkpoints": self.tally.checkpoints,
            "rows": self.rows(),
            "witnesses": dict(sorted(self.tally.witnesses.items())),
            "missing_witnesses": self.missing,
            "corpus": self.corpus and self.corpus.to_json(),
            "findings": [finding.to_json() for finding in self.findings],
        }

    def rows(self) -> list[dict[str, Any]]:
        """One row for each (edges, vertices), ascending."""
        return [
            {
                "edges": edges,
                "vertices": vertices,
                "worlds": row.worlds,
                "runs": row.runs,
                "episodes": row.episodes,
                "traversals": row.traversals,
                "traversals_rooted": row.traversals_rooted,
                "max_cost": row.max_cost,
                "bound": row.bound,
            }
            for (edges, vertices), row in sorted(self.tally.rows.items())
        ]

    def _scope_json(self) -> dict[str, Any]:
        scope, rules = self.scope, self.scope.rules
        index, count = scope.shard
        return {
            "class": scope.bounds.map_class.value,
            "edges": scope.bounds.edges,
            "vertices": scope.bounds.vertices,
            "lighthouse": rules.lighthouse,
            "policy": rules.policy,
            "schedules": scope.schedules,
            "laws": list(rules.applying),
            "bound": rules.the_bound.name,
            "step_budget": rules.step_budget,
            "shard": f"{index}/{count}",
            "sample": self.scope.sample and dict(self.scope.sample),
            "symmetry": self.symmetry or None,
            "gate": self._gate_json(),
            "complete": self.complete,
            "finished_levels": self.levels,
            "stopped": self.stopped or None,
        }

    def _gate_json(self) -> list[dict[str, Any]] | str:
        if self.scope.sample:
            return "absent"
        if self.scope.shard != (0, 1):
            return "deferred to the merge of all shards"
        return [
            {
                "edges": cell.edges,
                "vertices": cell.vertices,
                "enumerated": cell.enumerated,
                "counted": cell.counted,
                "source": cell.source,
            }
            for cell in self.gate
        ]
