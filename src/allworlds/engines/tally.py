"""The tally of many judged runs: counts that can be added up in any order.

The tally also holds the smallest findings.
"""

from bisect import insort
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import islice
from typing import Annotated, Any, NamedTuple, Self

from msgspec import Struct

from allworlds.documents.document import replace
from allworlds.engines import kept_units, units
from allworlds.judging.findings.finding import Finding
from allworlds.judging.referee import Outcome, Referee
from allworlds.judging.rules import Rules
from allworlds.maps.combinatorial import rooted_code
from allworlds.maps.enumeration import FINGERPRINTS, fingerprint
from allworlds.world.world import World


def finding_to_record(finding: Finding) -> dict[str, Any]:
    """The JSON document in which a run directory keeps a finding, without the finding's rules.

    The added key ``machine`` says whether the machine, and not the explorer, may be the cause.
    """
    return {**finding.to_json(), "machine": finding.machine}


def finding_from_record(document: Mapping[str, Any]) -> Finding:
    """The finding, without its rules, that :func:`finding_to_record` has written."""
    return replace(Finding.from_json(document), machine=document["machine"])


class AtRun(NamedTuple):
    """A run, given by the code of its rooted map, its place, and the choices that were made in it.

    Attributes:
        sigma, alpha: the code: the map with its darts renumbered from the start, which is dart 0.
        place: the number of the lighthouse's place.
        choices: the index of the option that was taken at each choice; may be empty if the policy
            makes the choices.
    """

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    place: int
    choices: tuple[int, ...]


@dataclass(slots=True)
class Row:
    """The counts of the worlds with one number of edges and one number of vertices.

    A run is given by a rooted map and a place of the lighthouse in it.  An episode is one run under
    one schedule; a run has several episodes only if every schedule is tried.

    Attributes:
        worlds: the number of rooted maps.
        runs: the number of runs.
        episodes: the number of episodes.
        traversals: the traversals, summed over the episodes.
        traversals_rooted: the traversals, summed over the first place of each rooted map only.
        max_cost: the largest cost of an episode.
        bound: the largest bound of a run; None without a bound.
        best_cost: the cost of the cheapest schedule of a run; of all runs, the largest such cost.
            None unless every schedule is tried.
        fingerprint: the sum of the fingerprints of all rooted maps, modulo 2^62.  A fingerprint is
            a number computed from the map.  The sum shows whether each map was counted once.
        most_expensive: the run and the choices of an episode with the cost ``max_cost``; of several
            such episodes the first in the order of :class:`AtRun`.  None without an episode.  The
            comparison of rows ignores this field.
    """

    worlds: int = 0
    runs: int = 0
    episodes: int = 0
    traversals: int = 0
    traversals_rooted: int = 0
    max_cost: int = 0
    bound: int | None = None
    most_expensive: AtRun | None = field(default=None, compare=False)
    best_cost: int | None = None
    fingerprint: int = 0

    def add(self, other: "Row") -> None:
        """Add the counts of another part of the check, in worlds of the same size."""
        self.worlds += other.worlds
        self.fingerprint = (self.fingerprint + other.fingerprint) % FINGERPRINTS
        self.runs += other.runs
        self.episodes += other.episodes
        self.traversals += other.traversals
        self.traversals_rooted += other.traversals_rooted
        if other.most_expensive is not None:
            self.cost_of(other.max_cost, other.most_expensive)
        self.max_cost = max(self.max_cost, other.max_cost)
        self.bound_of(other.bound)
        self.best_of(other.best_cost)

    def cost_of(self, cost: int, where: AtRun) -> None:
        """Update the largest cost, and the run that has it, by the run ``where`` with this cost."""
        if cost > self.max_cost or self.most_expensive is None:
            self.max_cost, self.most_expensive = cost, where
        elif cost == self.max_cost:
            self.most_expensive = min(self.most_expensive, where)

    def bound_of(self, run: int | None) -> None:
        """Update the field ``bound``, the largest bound of a run, by the bound of one more run.

        ``run`` is this further bound, or None if the further run has no bound.  If it is None,
        nothing changes.  A user's formula can also give a negative bound, which counts like any
        other number.
        """
        if run is not None:
            self.bound = run if self.bound is None else max(self.bound, run)

    def best_of(self, run: int | None) -> None:
        """Update the field ``best_cost`` by the cost of the cheapest schedule of one more run.

        ``run`` is this cost.  If it is greater than the field, it becomes the value of the field.
        If it is None, nothing changes.
        """
        if run is not None:
            self.best_cost = max(run, self.best_cost or 0)


@dataclass(slots=True)
class Tally:
    """The results of a part of a check, added up.

    Attributes:
        keep: the largest number of findings that are kept.  Of findings with equal laws and maps
            only the smallest is kept.
        rows: the numbers of worlds, runs and traversals, by (edges, vertices).
        witnesses: the number of occurrences of each event, such as ``loop-edge``.
        left_out: the number of worlds without a place for the lighthouse.
        checkpoints: the number of checkpoints that the explorer has shown.
        findings: the smallest findings, ascending.
        remarks: texts about events that refute nothing, each with its number of occurrences.
        covered: for random worlds, by pairs of a feature of maps, such as ``genus``, and a value:
            the number of worlds in which the feature has this value.  Else empty.
    """

    keep: int
    rows: dict[tuple[int, int], Row] = field(default_factory=dict)
    witnesses: Counter[str] = field(default_factory=Counter)
    left_out: int = 0
    checkpoints: int = 0
    findings: list[Annotated[Finding, kept_units.Form(finding_to_record, finding_from_record)]] = (
        field(default_factory=list)
    )
    remarks: Counter[str] = field(default_factory=Counter)
    covered: Counter[tuple[str, int]] = field(default_factory=Counter)

    def row(self, edges: int, vertices: int) -> Row:
        """The row of the worlds of this size; an empty row is added if there is none."""
        return self.rows.setdefault((edges, vertices), Row())

    def wants(self, edges: int, vertices: int) -> bool:
        """Whether a finding in a world of this size could be among those that are kept."""
        if len(self.findings) < self.keep:
            return True
        return (edges, vertices) <= self.findings[-1].key[:2]

    def find(self, finding: Finding) -> None:
        """Keep the finding if it is one of the ``keep`` smallest.

        Of several findings with the same law and map only the smallest is kept.
        """
        if len(self.findings) >= self.keep and finding.rank >= self.findings[-1].rank:
            return
        for at, kept in enumerate(self.findings):
            if kept.kind == finding.kind:
                if kept.rank <= finding.rank:
                    return
                del self.findings[at]
                break
        insort(self.findings, finding, key=lambda kept: kept.rank)
        del self.findings[self.keep :]

    def remark(self, text: str) -> None:
        """Count an event that refutes nothing, by the text about it."""
        self.remarks[text] += 1

    def add(self, other: "Tally") -> None:
        """Add the tally of another part of the check."""
        for (edges, vertices), row in other.rows.items():
            self.row(edges, vertices).add(row)
        self.witnesses.update(other.witnesses)
        self.left_out += other.left_out
        self.checkpoints += other.checkpoints
        self.remarks.update(other.remarks)
        self.covered.update(other.covered)
        for finding in other.findings:
            self.find(finding)

    def under(self, rules: Rules) -> Self:
        """Put ``rules``, those of the job, into all findings, and return this tally.

        Findings that were read from a run directory have no rules.
        """
        self.findings = [replace(found, under=rules) for found in self.findings]
        return self

    @property
    def costs_by_size(self) -> Iterator[tuple[int, int, int]]:
        """Yield a triple for each size of worlds: edges, vertices, the largest cost of a run."""
        for (edges, vertices), row in self.rows.items():
            yield edges, vertices, row.max_cost

    @property
    def worlds(self) -> int:
        """The number of rooted maps visited."""
        return sum(row.worlds for row in self.rows.values())

    @property
    def runs(self) -> int:
        """The number of runs, which are pairs of a world and a place."""
        return sum(row.runs for row in self.rows.values())

    @property
    def traversals(self) -> int:
        """The number of traversals, summed over all episodes."""
        return sum(row.traversals for row in self.rows.values())


REPORT_EVERY = 0.25
"""Seconds after which a lane returns the counts of units that are not finished."""


class EnginesDisagree(Exception):
    """Raised if two engines have different results in a world, or different counts of a unit."""


class RunCounter(Struct, frozen=True):
    """The counter of runs, which adds runs and their outcomes to tallies.

    Attributes:
        scope: the worlds and the rules of the check.
        keep: the largest number of findings that are kept.
        compiled_from: if a level has at least this number of worlds, compiled code judges the runs
            of a user's explorer in that level; in smaller levels Python judges.  None if Python
            judges always.
    """

    scope: units.Scope
    keep: int
    compiled_from: int | None = None

    def runs(self, unit: units.UnitOfRuns, start: int = 0) -> Iterator[units.NumberedRun]:
        """The runs of a unit, from the run with the number ``start`` on."""
        every = units.numbered_runs(unit, self.scope.extent, self.scope.rules.kind)
        return islice(every, start, None)

    def tally(self) -> Tally:
        """An empty tally."""
        return Tally(self.keep)

    def count_run(self, run: units.NumberedRun, tally: Tally) -> World | None:
        """Count a run in the tally; return its world, or None if the lighthouse has no place in it.

        The first run of a world also counts the world.
        """
        edges, vertices = run.map.edge_count, run.map.vertex_count
        if run.first:
            tally.row(edges, vertices).add(Row(1, fingerprint=fingerprint(run.map)))
            if run.map.loop_count:
                tally.witnesses["loop-edge"] += 1
            if run.map.parallel_count:
                tally.witnesses["parallel-edge"] += 1
        if run.lighthouse is None:
            tally.left_out += 1
            return None
        tally.row(edges, vertices).runs += 1
        return World(run.map, run.lighthouse, 0)

    def count_outcome(self, world: World, place: int, outcome: Outcome, tally: Tally) -> None:
        """Add the outcome of a run under one schedule to the tally.

        ``place`` is the number of the lighthouse's place in the map of ``world``.
        """
        edges, vertices = world.map.edge_count, world.map.vertex_count
        row, cost = tally.row(edges, vertices), outcome.cost
        row.episodes += 1
        row.traversals += cost
        if place == 0:
            row.traversals_rooted += cost
        if cost >= row.max_cost:
            code = rooted_code(world.map.sigma, world.map.alpha, 0)
            row.cost_of(cost, AtRun(*code, place, outcome.choices))
        row.bound_of(outcome.bound)
        tally.checkpoints += len(outcome.episode.checkpoints)

    def settle(
        self, referee: Referee, world: World, place: int, outcome: Outcome, tally: Tally
    ) -> None:
        """Keep a finding in the tally if the outcome of a run breaks a law.

        This is called after the two plays of the run were compared.

        Args:
            referee: makes the finding from the outcome; it belongs to the judge, and decides which
                law an episode breaks.
            world: the world of the run.
            place: the number of the lighthouse's place in the map of the world.
            outcome: the outcome of the run, with the broken law, if any.
            tally: the tally, which keeps only the smallest findings.
        """
        if outcome.violation and tally.wants(world.map.edge_count, world.map.vertex_count):
            tally.find(referee.finding(world, place, outcome))

    def count_best(self, world: World, cost: int, tally: Tally) -> None:
        """Add to the tally the cost of a run's cheapest schedule, if every schedule is tried."""
        if self.scope.schedules == "all":
            tally.row(world.map.edge_count, world.map.vertex_count).best_of(cost)
