"""The kill matrix: which check kills which mutant, at which smallest world.

    python tests/support/mutants/matrix.py --edges 3

Wrong explorers, weakened judges and broken enumerators must all be caught.  Exit code 1: one
survives that must not, or the other way round.
"""

from __future__ import annotations

import argparse
import sys
import textwrap
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

from allworlds.corpus.explorers import (
    EQUIVALENT_EXPLORERS,
    WRONG_EXPLORERS,
    WRONG_LEARNERS,
    WrongExplorer,
    WrongLearner,
)
from allworlds.explorers.loading import in_process_subject
from allworlds.judging.episode import Answered, play
from allworlds.judging.findings.finding import canonical_world
from allworlds.judging.laws.bounds import default_step_budget, paper_bound
from allworlds.judging.laws.law_table import LAWS, Case, first_broken
from allworlds.judging.rules import Rules
from allworlds.judging.tasks import task_named
from allworlds.maps import CombinatorialMap, rooted_code, rooted_maps
from allworlds.maps.counting import SOURCES
from allworlds.protocol.choices import Choices
from allworlds.studies.check.exhaustive import check
from allworlds.words import plural
from allworlds.world import Directional, World
from allworlds.world.lighthouses.kinds import lighthouse_kind
from bruteforce import rooted_maps_by_permutations
from enumerators import BROKEN_ENUMERATORS, BrokenEnumerator
from errands import WEAK_TASK_JUDGES, WRONG_ERRANDS, WeakTaskJudge, WrongErrand
from judges import WEAK_JUDGES, WeakJudge

LARGEST_LEVEL = 4
"""The dumb enumerator, which some mutants need, goes no further in reasonable time."""


@dataclass(frozen=True)
class Kill:
    """The fate of one mutant.

    Attributes:
        mutant: its name.
        kind: ``explorer``, ``judge`` or ``enumerator``.
        breaks: its mistake.
        killed_by: the law or the check that killed it; None: it survived.
        world: the smallest world that kills it; None also where its plays differ, for then the
            world at which it is seen depends on the order in which it meets the worlds.
        equivalent: why it may survive; None: it may not.
    """

    mutant: str
    kind: str
    breaks: str
    killed_by: str | None = None
    world: World | None = None
    equivalent: str | None = None

    @property
    def as_it_should(self) -> bool:
        """Whether it is killed, or alive and equivalent."""
        return bool(self.killed_by) != bool(self.equivalent)


def survivors(matrix: Sequence[Kill]) -> list[str]:
    """The mutants that survive but must not, or should survive but do not."""
    return [kill.mutant for kill in matrix if not kill.as_it_should]


def _wrong() -> tuple[WrongExplorer | WrongLearner, ...]:
    """Explorers of maps that must be killed."""
    return (*WRONG_EXPLORERS, *WRONG_LEARNERS)


def mutants(edges: int) -> Iterator[Kill]:
    """Try every mutant on every world with at most so many edges.

    Cost: seconds for 3 edges; every equivalent mutant is run to the bound.
    """
    refuted = []
    for mutant in (*_wrong(), *WRONG_ERRANDS, *EQUIVALENT_EXPLORERS):
        kill = _explorer(mutant, edges)
        refuted += [kill.mutant] if kill.killed_by in (*LAWS, "ambiguity") else []
        yield kill
    yield from _judges(WEAK_JUDGES, lambda level: _refused(level, refuted), edges)
    yield from _judges(WEAK_TASK_JUDGES, _refused_errands, edges)
    for broken in BROKEN_ENUMERATORS:
        yield _enumerator(broken, edges)


def _explorer(mutant: WrongExplorer | WrongLearner | WrongErrand, edges: int) -> Kill:
    """Kill an explorer by the law that an ordinary check finds broken first."""
    explore = mutant.explorer()
    report = check(explore, edges=edges, lighthouse=mutant.lighthouse, task=mutant.task)
    report = report.uninterrupted()
    row = Kill(
        mutant=mutant.name,
        kind="explorer",
        breaks=mutant.breaks,
        equivalent=mutant.equivalent or None,
    )
    if not report.findings:
        return row
    finding = report.findings[0]
    world = None if finding.law == "nondeterministic" else finding.world
    return replace(row, killed_by=finding.law, world=world)


def _judges(
    judges: Sequence[WeakJudge] | Sequence[WeakTaskJudge],
    refused: Callable[[int], Iterator[_Refused]],
    edges: int,
) -> Iterator[Kill]:
    """Kill each weak judge by the smallest case that only the sound judge refuses.

    Cases come from the explorers that are known to answer wrongly.
    """
    alive: dict[str, Any] = {weak.name: weak for weak in judges}
    killed: dict[str, tuple[str, World]] = {}
    for level in range(1, edges + 1):
        smallest: dict[str, tuple[Any, str, World]] = {}
        for run, world, name in refused(level) if alive else ():
            for weak in alive.values():
                if weak.accepts(*run):
                    canonical = canonical_world(world)
                    key = (world.map.vertex_count, *_code(canonical.map), name)
                    if weak.name not in smallest or key < smallest[weak.name][0]:
                        smallest[weak.name] = (key, name, canonical)
        for weak_name, (_, explorer, world) in smallest.items():
            killed[weak_name] = (f"sound judge on {explorer}", world)
            del alive[weak_name]
    for weak in judges:
        by, smallest_world = killed.get(weak.name, (None, None))
        yield Kill(
            mutant=weak.name, kind="judge", breaks=weak.breaks, killed_by=by, world=smallest_world
        )


_Refused: TypeAlias = tuple[tuple[Any, ...], World, str]
"""A run that the sound judge refuses, as weak judges get it; its world, and who was run."""


def _refused_errands(level: int) -> Iterator[_Refused]:
    """Runs of the explorers with other tasks, one a rooted map, that do not do them."""
    for mutant in WRONG_ERRANDS:
        kind, task = lighthouse_kind(mutant.lighthouse).as_class, task_named(mutant.task)
        player = in_process_subject(mutant.explorer()).player()
        for map_ in rooted_maps(level):
            world = World(map_, next(iter(kind.places(map_, 0))), 0)
            budget = default_step_budget(paper_bound(map_.vertex_count, level))
            episode = play(world, player, Choices(), budget, maps=False, over=task.over)
            if task.flaw(episode.walk, episode.ending):
                yield (task, episode.walk), world, mutant.name


def _refused(level: int, explorers: Collection[str]) -> Iterator[_Refused]:
    """Runs of those explorers, one a rooted map, whose answer breaks a law that applies."""
    players = [
        (
            mutant.name,
            lighthouse_kind(mutant.lighthouse).as_class,
            in_process_subject(mutant.explorer()).player(),
        )
        for mutant in _wrong()
        if mutant.name in explorers
    ]
    for map_ in rooted_maps(level):
        bound = paper_bound(map_.vertex_count, level)
        for name, kind, player in players:
            laws = {law: LAWS[law].check for law in Rules(kind.kind).applying}
            world = World(map_, next(iter(kind.places(map_, 0))), 0)
            episode = play(world, player, Choices(), default_step_budget(bound))
            match episode.ending:
                case Answered(answer):
                    least = bound if "bound" in laws else None
                    case = Case(episode.walk, episode.checkpoints, answer, least)
                    if first_broken(case, laws.values()):
                        yield (case, laws), world, name


def _enumerator(mutant: BrokenEnumerator, edges: int) -> Kill:
    """Kill an enumerator by the count gate, or else by comparison with the brute-force one."""
    row = Kill(mutant=mutant.name, kind="enumerator", breaks=mutant.breaks)
    for level in range(1, edges + 1):
        level_maps = list(mutant.enumerate(level))
        counted = SOURCES["maps"].cells(level)
        by_vertices = Counter(map_.vertex_count for map_ in level_maps)
        gate_agrees = all(by_vertices[n] == known for n, known in counted.items())
        wrong = _first_difference(level_maps, level)
        if wrong is not None:
            by = "brute-force enumerator" if gate_agrees else "count gate"
            return replace(row, killed_by=by, world=World(wrong, Directional(0)))
        if not gate_agrees:
            raise AssertionError(f"the count gate alone complains about {mutant.name}")
    return row


def _first_difference(maps: Iterable[CombinatorialMap], level: int) -> CombinatorialMap | None:
    """The smallest rooted map of the level that does not come exactly once."""
    found = Counter(_code(map_) for map_ in maps)
    expected = Counter(_code(map_) for map_ in rooted_maps_by_permutations(level))
    wrong = [code for code in found | expected if found[code] != expected[code]]
    return CombinatorialMap(*min(wrong)) if wrong else None


def _code(map_: CombinatorialMap) -> tuple[tuple[int, ...], tuple[int, ...]]:
    return rooted_code(map_.sigma, map_.alpha, 0)


# ---------------------------------------------------------------- in words


def told(matrix: Sequence[Kill], edges: int) -> Iterator[str]:
    """The lines of the matrix: survivors, kills, and equivalent mutants with their reasons."""
    alive, killed = survivors(matrix), sum(bool(kill.killed_by) for kill in matrix)
    equivalent = [kill for kill in matrix if kill.equivalent]
    yield (
        f"{'SURVIVORS' if alive else 'ALL KILLED'}  {plural(len(matrix), 'mutant')}, {killed} "
        f"killed, {len(equivalent)} equivalent, worlds with at most {plural(edges, 'edge')}"
    )
    yield from ["", *(f"survivor   {name}" for name in alive)][: len(alive) + bool(alive)]
    for kind in ("explorer", "judge", "enumerator"):
        rows = [(f"{kind}s", "killed by", "m", "n", "world")]
        rows += [_row(kill) for kill in matrix if kill.kind == kind and not kill.equivalent]
        wide = [max(len(row[column]) for row in rows) for column in range(4)]
        yield from ["", f"Wrong {kind}s"]
        for name, by, m, n, world in rows:
            row = [name.ljust(wide[0]), by.ljust(wide[1]), m.rjust(wide[2]), n.rjust(wide[3])]
            yield "  ".join([*row, world]).rstrip()
    for kill in equivalent:
        text = f"EQUIVALENT {kill.mutant}: {kill.breaks} {kill.equivalent}"
        yield from ["", *textwrap.wrap(text, 99, subsequent_indent=" " * 11)]


def _row(kill: Kill) -> tuple[str, ...]:
    by = kill.killed_by or "-"
    if kill.world is None:
        return (kill.mutant, by, "-", "-", "")
    map_ = kill.world.map
    rotation = "".join(f"({' '.join(map(str, vertex))})" for vertex in map_.vertices)
    edges = " ".join(f"{a}-{b}" for a, b in map_.edges)
    sizes = (str(map_.edge_count), str(map_.vertex_count))
    return (kill.mutant, by, *sizes, f"{rotation} {edges}")


if __name__ == "__main__":
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    levels = range(1, LARGEST_LEVEL + 1)
    options.add_argument("--edges", type=int, choices=levels, default=LARGEST_LEVEL)
    bound = options.parse_args().edges
    fates = list(mutants(bound))
    print("\n".join(told(fates, bound)))
    sys.exit(bool(survivors(fates)))
