"""The outcome of a check: a verdict that never comes without its scope."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, assert_never

from allworlds.engines import Sample, Scope, Shard, Tally, Whole
from allworlds.judging import Finding
from allworlds.outcome import SCHEMA, Exit, Verdict
from allworlds.studies.check.ending import Completed, Disagreed, Ending, Interrupted, Stopped
from allworlds.studies.check.gate import Cell
from allworlds.studies.check.known_findings import UserCorpus

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True)
class Report:
    """What a check has seen, and what follows from it.

    Attributes:
        explorer: the name of the subject.
        engine: ``python`` or ``kernel``.
        scope: what was to be checked.
        tally: the counts of the finished levels, and the smallest findings.
        levels: the numbers of edges of the finished levels.
        ending: how it came to its end.
        gate: the comparisons of the count gate.
        corpus: what became of the past findings, if there is a corpus of them.
        symmetry: where one run has been counted for several, why that is right; else empty.
    """

    explorer: str
    engine: str
    scope: Scope
    tally: Tally
    levels: tuple[int, ...]
    ending: Ending
    gate: tuple[Cell, ...] = ()
    corpus: UserCorpus | None = None
    symmetry: str = ""

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
    def complete(self) -> bool:
        """Every world of the scope was tried; a sample is never complete."""
        return isinstance(self.ending, Completed) and not isinstance(self.scope.coverage, Sample)

    @property
    def ended(self) -> bool:
        """The same check again would do no more."""
        match self.ending:
            case Completed() | Disagreed():
                return True
            case Stopped(enough=enough):
                return enough
            case Interrupted():
                return False
            case ending:
                assert_never(ending)

    @property
    def interrupted(self) -> bool:
        """By the user."""
        return isinstance(self.ending, Interrupted)

    @property
    def missing(self) -> tuple[str, ...]:
        """Witnesses that a complete check must have seen and has not."""
        return self.ending.missing if isinstance(self.ending, Completed) else ()

    @property
    def remarks(self) -> list[str]:
        """What happened and refutes nothing, and how often if more than once."""
        return [
            text if times == 1 else f"{text} ({times} times)"
            for text, times in sorted(self.tally.remarks.items())
        ]

    @property
    def verdict(self) -> Verdict:
        """The verdict, about the scope and nothing else."""
        if isinstance(self.ending, Disagreed) or not all(cell.agrees for cell in self.gate):
            return Verdict.ERROR
        if self.findings:
            return Verdict.REFUTED
        if not isinstance(self.ending, Completed):
            return Verdict.INCONCLUSIVE
        match self.scope.coverage:
            case Sample():
                return Verdict.NOT_REFUTED if self.runs else Verdict.INCONCLUSIVE
            case Shard():
                return Verdict.HOLDS
            case Whole():
                vacuous = self.missing or not self.runs
                return Verdict.VACUOUS if vacuous else Verdict.HOLDS
            case coverage:
                assert_never(coverage)

    @property
    def exit_code(self) -> Exit:
        """The exit code of the command."""
        if self.interrupted and self.verdict is not Verdict.ERROR:
            return Exit.INTERRUPTED
        return self.verdict.exit

    def uninterrupted(self) -> Report:
        """This report, for callers to whom half a check says nothing.

        Raises:
            KeyboardInterrupt: if it was interrupted; ``check`` has kept that to itself.
        """
        if self.interrupted:
            raise KeyboardInterrupt
        return self

    def to_json(self) -> documents.CheckDocument:
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
            "missing_witnesses": list(self.missing),
            "remarks": self.remarks,
            "corpus": self.corpus.to_json() if self.corpus else None,
            "findings": [finding.to_json() for finding in self.findings],
        }

    def rows(self) -> list[documents.CheckRow]:
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

    def _scope_json(self) -> documents.ScopeDocument:
        scope, rules, coverage = self.scope, self.scope.rules, self.scope.coverage
        sample: documents.SampleDocument | None = None
        if isinstance(coverage, Sample):
            sample = {
                "edges": scope.extent.levels[-1],
                "min_edges": coverage.min_edges,
                "runs": coverage.runs,
                "seed": coverage.seed,
            }
        return {
            "class": scope.extent.map_class.value,
            "edges": scope.extent.edges,
            "vertices": scope.extent.vertices,
            "lighthouse": rules.lighthouse,
            "policy": rules.policy,
            "schedules": scope.schedules,
            "laws": list(rules.applying),
            "bound": rules.the_bound.name,
            "step_budget": rules.step_budget,
            "shard": str(coverage) if isinstance(coverage, Shard) else "0/1",
            "sample": sample,
            "symmetry": self.symmetry or None,
            "gate": self._gate_json(),
            "complete": self.complete,
            "finished_levels": list(self.levels),
            "stopped": self.ending.reason or None,
        }

    def _gate_json(self) -> documents.Checked:
        match self.scope.coverage:
            case Sample():
                return "absent"
            case Shard():
                return "deferred to the merge of all shards"
            case Whole():
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
            case coverage:
                assert_never(coverage)
