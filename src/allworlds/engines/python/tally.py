"""Counts that can be added up in any order, and the smallest findings."""

from __future__ import annotations

from bisect import insort
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, Self

from allworlds.document import Document, plain_at_once, taken
from allworlds.judging import Finding, Rules


class AtRun(NamedTuple):
    """A run in canonical numbering, and the choices of one of its episodes.

    Where the policy makes them, there may be none.
    """

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    place: int
    choices: tuple[int, ...]


@dataclass(slots=True)
class Row:
    """What was seen in the worlds with one number of edges and of vertices.

    Attributes:
        worlds: rooted maps.
        runs: worlds x places.
        episodes: runs x schedules.
        traversals: summed over the episodes.
        traversals_rooted: the same at the first place of each rooted map only.
        max_cost: the largest cost of an episode.
        bound: the largest bound of a run; None without a bound.
        most_expensive: the least run that attains the largest cost; None without a run, and in a
            part of a whole that has more expensive ones.  Rows that count the same are equal
            whatever it is.
    """

    worlds: int = 0
    runs: int = 0
    episodes: int = 0
    traversals: int = 0
    traversals_rooted: int = 0
    max_cost: int = 0
    bound: int | None = None
    most_expensive: AtRun | None = field(default=None, compare=False)

    def add(self, other: Row) -> None:
        """Take in what was seen elsewhere."""
        self.worlds += other.worlds
        self.runs += other.runs
        self.episodes += other.episodes
        self.traversals += other.traversals
        self.traversals_rooted += other.traversals_rooted
        if other.most_expensive is not None:
            self.cost_of(other.max_cost, other.most_expensive)
        self.max_cost = max(self.max_cost, other.max_cost)
        self.bound_of(other.bound)

    def cost_of(self, cost: int, where: AtRun) -> None:
        """Take in the largest cost that there is at that place."""
        if cost > self.max_cost or self.most_expensive is None:
            self.max_cost, self.most_expensive = cost, where
        elif cost == self.max_cost:
            self.most_expensive = min(self.most_expensive, where)

    def bound_of(self, run: int | None) -> None:
        """Take in the bound of a run, which may be negative; None where it has none."""
        if run is not None:
            self.bound = run if self.bound is None else max(self.bound, run)


@dataclass(slots=True)
class Tally:
    """Everything that a part of a check has seen.

    Attributes:
        keep: how many findings are kept, each the smallest of its law and map.
        rows: by (edges, vertices).
        witnesses: how often each event occurred.
        left_out: worlds without a place for the lighthouse.
        checkpoints: how many were published.
        findings: the smallest, ascending.
        remarks: what happened that refutes nothing, each with how often.
    """

    keep: int
    rows: dict[tuple[int, int], Row] = field(default_factory=dict)
    witnesses: Counter[str] = field(default_factory=Counter)
    left_out: int = 0
    checkpoints: int = 0
    findings: list[Finding] = field(default_factory=list)
    remarks: Counter[str] = field(default_factory=Counter)

    def row(self, edges: int, vertices: int) -> Row:
        """The row of that size."""
        return self.rows.setdefault((edges, vertices), Row())

    def wants(self, edges: int, vertices: int) -> bool:
        """Whether a finding of that size could be among the smallest."""
        if len(self.findings) < self.keep:
            return True
        return (edges, vertices) <= self.findings[-1].key[:2]

    def find(self, finding: Finding) -> None:
        """Keep the finding if it is the smallest of its kind, and that is among the smallest."""
        if len(self.findings) >= self.keep and finding.key >= self.findings[-1].key:
            return
        for place, kept in enumerate(self.findings):
            if kept.kind == finding.kind:
                if kept.key <= finding.key:
                    return
                del self.findings[place]
                break
        insort(self.findings, finding, key=lambda kept: kept.key)
        del self.findings[self.keep :]

    def remark(self, text: str) -> None:
        """Note what happened, and refutes nothing."""
        self.remarks[text] += 1

    def add(self, other: Tally) -> None:
        """Take in another part's tally."""
        for (edges, vertices), row in other.rows.items():
            self.row(edges, vertices).add(row)
        self.witnesses.update(other.witnesses)
        self.left_out += other.left_out
        self.checkpoints += other.checkpoints
        self.remarks.update(other.remarks)
        for finding in other.findings:
            self.find(finding)

    def to_json(self) -> dict[str, Any]:
        """The document :class:`KeptTally`, as it is kept in a run directory."""
        kept = KeptTally(
            rows=tuple((*size, row) for size, row in sorted(self.rows.items())),
            witnesses=dict(sorted(self.witnesses.items())),
            left_out=self.left_out,
            checkpoints=self.checkpoints,
            findings=tuple(map(finding_to_record, self.findings)),
            remarks=dict(sorted(self.remarks.items())),
        )
        return plain_at_once(kept)

    @classmethod
    def from_json(cls, document: object, keep: int, rules: Rules) -> Self:
        """The tally of :meth:`to_json`'s document, made under these rules."""
        kept = taken(document, KeptTally, "tally")
        return cls(
            keep,
            {(edges, vertices): row for edges, vertices, row in kept.rows},
            Counter(kept.witnesses),
            kept.left_out,
            kept.checkpoints,
            [finding_from_record(found, rules) for found in kept.findings],
            Counter(kept.remarks),
        )

    @property
    def worlds(self) -> int:
        """Rooted maps visited."""
        return sum(row.worlds for row in self.rows.values())

    @property
    def runs(self) -> int:
        """Worlds x places."""
        return sum(row.runs for row in self.rows.values())

    @property
    def traversals(self) -> int:
        """Summed over all episodes."""
        return sum(row.traversals for row in self.rows.values())


class KeptTally(Document):
    """A tally in a run directory, without what the job knows."""

    rows: tuple[tuple[int, int, Row], ...]
    witnesses: dict[str, int]
    left_out: int
    checkpoints: int
    findings: tuple[dict[str, Any], ...]
    remarks: dict[str, int]


def finding_to_record(finding: Finding) -> dict[str, Any]:
    """A finding with what its own document leaves out, but without the rules."""
    return {
        **finding.to_json(),
        "place": finding.place,
        "machine": finding.machine,
        "traced": finding.traced,
    }


def finding_from_record(document: Mapping[str, Any], rules: Rules) -> Finding:
    """The finding of :func:`finding_to_record`'s document, made under these rules."""
    return replace(
        Finding.from_json(document),
        rules=rules,
        place=document["place"],
        machine=document["machine"],
        traced=document["traced"],
    )
