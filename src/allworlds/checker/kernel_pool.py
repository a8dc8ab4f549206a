"""The compiled engine in the place of worker processes: units in threads, rows into tallies.

The kernel walks each rooted map once, at bearing 0, and the walk is counted once for every
bearing, because Algorithm 1 looks at the marker's direction only to tell the darts of v0
apart.  That premise, and the kernel itself, are compared with the Python engine before the
first level: world by world, on every bearing, up to AGREEMENT_EDGES edges.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from functools import cache
from itertools import islice
from typing import Self

from allworlds.checker.examine import Examiner, make_finding
from allworlds.checker.pool import POLL, Poisoned, check_deadline
from allworlds.checker.scope import Limits, Rules, Scope, Unit, Work
from allworlds.checker.tally import Row, Tally
from allworlds.episode import default_step_budget
from allworlds.judge import paper_bound
from allworlds.kernel import engine as kernel
from allworlds.kernel import walk
from allworlds.kernel.tables import Tables, tables
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.maps.counting import source_for
from allworlds.maps.enumeration import prefixes
from allworlds.subjects import Subject, load
from allworlds.world import Directional, World

AGREEMENT_EDGES = 4
"""The largest m for which a run begins with a comparison of both engines, world by world."""

_BATCH = 8
"""Units that a thread does at a time, so that handing them over costs little."""

SYMMETRY = (
    "each rooted map is walked once, at bearing 0, and counted for every bearing: the walk does "
    f"not depend on it, as the python engine confirms on every bearing up to m = {AGREEMENT_EDGES}"
)


class EnginesDisagree(Exception):
    """The compiled engine and the general one say different things about one world."""


class KernelPool:
    """Examines units in threads; see :class:`allworlds.checker.pool.Pool`."""

    def __init__(
        self, subject: Subject, limits: Limits, notice: Callable[[str], None] | None = None
    ) -> None:
        self._subject, self._limits = subject, limits
        self._deadline = limits.deadline()
        self._threads = ThreadPoolExecutor(limits.workers)
        self._halt = kernel.flag()
        if notice and not kernel.is_compiled(walk.explore):
            notice(kernel.COMPILING)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._halt[0] = 1
        self._threads.shutdown(cancel_futures=True)

    def examine(self, scope: Scope, works: Iterable[Work], keep: int) -> Iterator[Tally | Poisoned]:
        """The units, as many at a time as there are threads.

        Raises:
            EnginesDisagree: if the Python engine does not confirm what the kernel says.
            TimeIsUp: when the time limit has been reached.
        """
        compare_engines(scope.rules.policy, min(scope.bounds.levels[-1], AGREEMENT_EDGES))
        waiting = (unit for unit in works if isinstance(unit, Unit))
        at_work: set[Future[list[tuple[Unit, kernel.Rows]]]] = set()
        while True:
            while len(at_work) < 2 * self._limits.workers and (job := [*islice(waiting, _BATCH)]):
                at_work.add(self._threads.submit(self._rows, scope, job, keep))
            if not at_work:
                return
            done, at_work = wait(at_work, POLL, FIRST_COMPLETED)
            for future in done:
                yield self._tally(scope, future.result(), keep)
            check_deadline(self._deadline)

    def _rows(self, scope: Scope, units: list[Unit], keep: int) -> list[tuple[Unit, kernel.Rows]]:
        edges = units[0].edges
        limit, policy = scope.bounds.vertex_limit(edges), scope.rules.policy
        looked_up = level_tables(scope.rules, edges)
        return [
            (
                unit,
                kernel.examine(
                    edges, limit, policy, unit.prefix, looked_up, keep=keep, halt=self._halt
                ),
            )
            for unit in units
        ]

    def _tally(self, scope: Scope, done: list[tuple[Unit, kernel.Rows]], keep: int) -> Tally:
        """The same as the Python engine's tally of these units."""
        tally = Tally(keep)
        for unit, rows in done:
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
                    scope.rules.the_bound.value(counts.vertices, unit.edges, 0, 0),
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
                self._blame(scope, map_, tally)
        tally.witnesses = +tally.witnesses
        return tally

    def _blame(self, scope: Scope, map_: CombinatorialMap, tally: Tally) -> None:
        """The findings of the Python engine in a world where the kernel says a law is broken."""
        examiner = Examiner(self._subject, scope.rules)
        for place, lighthouse in enumerate(Directional.places(map_, 0)):
            world = World(map_, lighthouse, 0)
            outcome = examiner.examine(world, scope.rules.choices(""))
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
