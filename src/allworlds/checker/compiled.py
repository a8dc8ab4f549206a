"""The compiled engine of a check: rows of the kernel into tallies.

The kernel walks each rooted map once, at bearing 0, and the walk is counted once for every
bearing, because Algorithm 1 looks at the marker's direction only to tell the darts of v0
apart.  That premise, and the kernel itself, are compared with the Python engine before the
first level: world by world, on every bearing, up to AGREEMENT_EDGES edges.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache
from typing import Any, Self

from allworlds import kernel
from allworlds.checker.engines import EnginesDisagree, Job
from allworlds.episode import default_step_budget
from allworlds.findings import Rules
from allworlds.judge import paper_bound
from allworlds.kernel import Tables, tables
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.maps.counting import source_for
from allworlds.maps.enumeration import prefixes
from allworlds.runs import Examiner, Row, Scope, Tally, Unit, make_finding
from allworlds.subjects import Subject, load
from allworlds.world import Directional, World

AGREEMENT_EDGES = 4
"""The largest m for which a run begins with a comparison of both engines, world by world."""

BATCH = 8
"""Units that a thread does at a time, so that handing them over costs little."""

SYMMETRY = (
    "each rooted map is walked once, at bearing 0, and counted for every bearing: the walk does "
    f"not depend on it, as the python engine confirms on every bearing up to m = {AGREEMENT_EDGES}"
)


@dataclass(frozen=True, slots=True)
class CompiledExamination:
    """All runs of a unit, walked and judged by the kernel.

    Attributes:
        scope, subject, keep: as for the general engine.
        flag: its entry 0 tells the kernel to give up.
    """

    scope: Scope
    subject: Subject
    keep: int
    flag: Any = field(default_factory=kernel.flag)

    @classmethod
    def ready(cls, job: Job) -> Self:
        """The engine, after it has been compared with the general one.

        Raises:
            EnginesDisagree: naming the first world in which they do.
        """
        if not kernel.is_compiled(kernel.explore):
            job.notice(kernel.COMPILING)
        scope = job.scope
        compare_engines(scope.rules.policy, min(scope.extent.levels[-1], AGREEMENT_EDGES))
        return cls(scope, job.subject, job.keep)

    def halt(self) -> None:
        """Give up."""
        self.flag[0] = 1

    def parts(self, unit: Unit) -> Iterator[Tally]:
        """The same as the general engine's tally of the unit.

        Raises:
            EnginesDisagree: if the general engine does not confirm a broken law.
        """
        rows = kernel.examine(
            unit.edges,
            self.scope.extent.vertex_limit(unit.edges),
            self.scope.rules.policy,
            unit.prefix,
            level_tables(self.scope.rules, unit.edges),
            keep=self.keep,
            halt=self.flag,
        )
        yield self._tally(unit, rows)

    def _tally(self, unit: Unit, rows: kernel.Rows) -> Tally:
        tally = Tally(self.keep)
        places = -unit.prefix[0]
        for counts in rows.counts:
            runs = places * counts.worlds
            row = Row(
                counts.worlds,
                runs,
                runs,
                places * counts.traversals,
                counts.traversals,
                counts.largest,
                self.scope.rules.the_bound.value(counts.vertices, unit.edges, 0, 0),
            )
            tally.row(unit.edges, counts.vertices).add(row)
            tally.checkpoints += unit.edges * runs
            for event, count in counts.per_walk.items():
                tally.witnesses[event] += places * count
            tally.witnesses.update(counts.per_world)
        for _, sigma, alpha in rows.broken:
            try:
                map_ = CombinatorialMap(sigma, alpha)
            except InvalidMap as error:
                raise EnginesDisagree(f"the kernel met a world that is none: {error}") from None
            self._blame(map_, tally)
        tally.witnesses = +tally.witnesses
        return tally

    def _blame(self, map_: CombinatorialMap, tally: Tally) -> None:
        """The findings of the Python engine in a world where the kernel says a law is broken."""
        examiner = Examiner(self.subject, self.scope.rules)
        for place, lighthouse in enumerate(Directional.places(map_, 0)):
            world = World(map_, lighthouse, 0)
            outcome = examiner.examine(world, self.scope.rules.choices(""))
            if outcome.violation is None:
                raise EnginesDisagree(
                    f"the kernel says that a law is broken, the python engine that all hold, in "
                    f"the world sigma={list(map_.sigma)} alpha={list(map_.alpha)} bearing={place}"
                )
            tally.find(make_finding(examiner, world, place, outcome))


@cache
def _budget(edges: int) -> int:
    return max(default_step_budget(paper_bound(n, edges)) for n in range(1, edges + 2))


def level_tables(rules: Rules, edges: int) -> Tables:
    """The kernel's tables for a level under these rules."""
    bounds = [rules.the_bound.value(n, edges, 0, 0) for n in range(1, edges + 2)]
    return tables(edges, _budget(edges), bounds)


@cache
def compare_engines(policy: str, edges: int) -> None:
    """Nothing, where both engines agree on every world and bearing up to so many edges.

    Raises:
        EnginesDisagree: naming the first world in which they do not.
    """
    rules = Rules(policy=policy)
    examiner = Examiner(load("algorithm1"), rules)
    for level in range(1, edges + 1):
        listed = list(listed_costs(rules, level))
        worlds = sum(source_for("maps").cells(level).values())
        if len(listed) != worlds:
            raise EnginesDisagree(
                f"the kernel ends its walk in {len(listed)} of {worlds} worlds with {level} edges"
            )
        for map_, cost in listed:
            for bearing, lighthouse in enumerate(Directional.places(map_, 0)):
                outcome = examiner.examine(World(map_, lighthouse, 0), rules.choices(""))
                if outcome.violation or outcome.cost != cost:
                    law = outcome.violation.law if outcome.violation else "none"
                    raise EnginesDisagree(
                        f"the kernel walks {cost} traversals, the python engine {outcome.cost} "
                        f"(broken law: {law}), in the world sigma={list(map_.sigma)} "
                        f"alpha={list(map_.alpha)} bearing={bearing}"
                    )


def listed_costs(
    rules: Rules, edges: int, mode: kernel.Mode = "walk"
) -> Iterator[tuple[CombinatorialMap, int]]:
    """Every map of a level, rooted at dart 0, with the cost of the kernel's walk in it.

    Cost: the memory of all of them; meant for m <= 5.
    """
    room = sum(source_for("maps").cells(edges).values())
    for prefix in prefixes(edges, depth=1):
        for cost, degrees, partners in kernel.costs(
            edges, rules.policy, prefix, level_tables(rules, edges), room, mode=mode
        ):
            yield CombinatorialMap(rotation(degrees), partners), cost


def rotation(degrees: Iterable[int]) -> list[int]:
    """``sigma`` of vertices whose darts are consecutive and clockwise."""
    sigma: list[int] = []
    for degree in degrees:
        first = len(sigma)
        sigma += [*range(first + 1, first + degree), first]
    return sigma
