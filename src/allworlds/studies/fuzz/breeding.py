"""Worlds that are bred from draws, which are random worlds.

A bred world is a *mutant*: a draw, or another bred world, after a few random changes.  The aim is
that the explorer runs those lines of its code that run in few worlds.
"""

from collections import Counter, deque
from collections.abc import Iterable, Iterator
from random import Random
from typing import Any

from msgspec import Struct, json

from allworlds.documents.document import replace
from allworlds.engines.batch import FIRST, Due
from allworlds.engines.judge import PythonJudge
from allworlds.engines.limits import Limits
from allworlds.engines.players import Lost, Setup, answered, started
from allworlds.engines.tally import RunCounter
from allworlds.engines.units import NumberedRun, Sample, Scope
from allworlds.explorers import loading
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.mixture import mutated
from allworlds.notations.given import MapWithPlaces
from allworlds.protocol.code_lines import ONCE, UserLine
from allworlds.studies.fuzz.sampling import Batch
from allworlds.world import world
from allworlds.world.lighthouses.base import Lighthouse

DRAWS_PER_BLOCK = 256
"""The number of draws in a block; worlds are bred from each whole block of a sample."""

DRAWS_TRACED = 64
"""The number of draws in a block, from the first on, that can be parents."""

BRED_PER_BLOCK = 192
"""The number of worlds that are bred from a block."""

BRED_PER_GENERATION = 16
"""The number of worlds in a generation; for the next generation, parents are chosen anew."""

RAREST_LINES = 4
"""The number of rarest lines.  A world in which one of them ran can be a parent."""

PARENTS_PER_LINE = 8
"""The number of worlds that are kept for a line: the last worlds in which the line ran."""

TRAVERSALS_TRACED = 20_000
"""The most traversals of a traced run."""

MUTANTS_TRIED = 20
"""The most mutants that are made of a world until one of them is in the class."""


class Bred(Struct, frozen=True):
    """The unit of the worlds that are bred from one block of draws.

    A block is :data:`DRAWS_PER_BLOCK` draws.  The batch ``drawn`` has the first
    :data:`DRAWS_TRACED` draws of the block: only in these draws the explorer's lines are traced, so
    only from them worlds are bred.
    """

    drawn: Batch

    @property
    def key(self) -> str:
        """The key of the bred worlds in a run directory: the key of their draws, and ``bred``."""
        return f"{self.drawn.key}/bred"

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[MapWithPlaces]:
        """Yield the draws of the unit, which are random worlds, and not the bred worlds.

        The bred worlds depend on the lines that the explorer runs in these draws; :func:`bred`
        makes them.
        """
        return self.drawn.placed(extent, kind)


def bred_of(sample: Sample, begins: Iterable[int]) -> Iterator[Bred]:
    """Yield a unit of bred worlds for each block of draws that belongs to the sample's shard.

    ``begins`` has the number of the first draw of each block, whatever shard the block belongs to.
    """
    for first in begins:
        if first // DRAWS_PER_BLOCK % sample.portion.count == sample.portion.index:
            yield Bred(
                Batch(sample.seed, first, first + DRAWS_TRACED, sample.mix, sample.min_edges)
            )


def is_bred_for(subject: loading.Subject) -> bool:
    """Whether worlds are bred for an explorer.

    This is so if the explorer is a user's, and is no program or shared library, so that its lines
    can be traced.
    """
    return subject.from_user and not (
        loading.is_program(subject.name) or loading.is_library(subject.name)
    )


def bred(
    unit: Bred, scope: Scope, subject: loading.Subject, limits: Limits
) -> Iterator[NumberedRun]:
    """Breed worlds in which the explorer runs its rarest lines; yield those where it breaks a law.

    The explorer is run in the draws of ``unit``, and its lines are traced.  Then it is run,
    generation by generation, in mutants of worlds in which it ran one of its rarest lines.  The
    bred worlds depend on the explorer and on these draws alone; but if the player dies, or is
    silent for too long, breeding ends early.

    These runs have a step budget of their own, :data:`TRAVERSALS_TRACED`, in place of that of the
    rules.  So an explorer that breaks a law here may break none under the rules.  The caller must
    run the explorer again in each yielded world; only this second run can refute the explorer.

    Breeding helps to find mistakes of an explorer that show only if several nested conditions are
    true.  It was compared with plain draws, which are random worlds.  For mistakes behind four
    nested conditions, 48 searches of each kind were made in worlds with up to 60 edges: a mistake
    was found by 4 of the 48 searches with 256 plain draws, and by 14 of the 48 searches with 64
    draws and 192 bred worlds.  In worlds with up to 12 edges, one such mistake was searched for
    with 8 seeds: breeding found it with 7 of the seeds, and 448 plain draws found it with 1 seed.

    Breeding prefers worlds in which rare lines ran.  Two other preferences were tried.  The first
    one was for worlds in which the explorer had a high cost.  The second one was for worlds in
    which a wrong hypothesis of the explorer agreed with the world for many steps.  Both found less
    than plain draws, in up to four times the time.  An explorer that trusts a hypothesis after 24
    steps was refuted with 4 of 6 seeds by plain draws, with 2 seeds by the preference for high
    costs, and with 1 seed by the preference for wrong hypotheses.  A run with a cost above 8,000
    was found with 5 of the 6 seeds by plain draws, with 4 by the preference for high costs, and
    with 3 by the preference for wrong hypotheses.

    Cost: 256 traced runs, each some three times as expensive as a plain run.
    """
    rules, extent = replace(scope.rules, step_budget=TRAVERSALS_TRACED), scope.extent
    number, pool = 0, _Pool(unit, extent, rules.kind)
    judge = PythonJudge(RunCounter(Scope(extent, rules), keep=1), subject.name)
    player = started(Setup(subject, limits), FIRST)
    try:
        for generation in range(1 + BRED_PER_BLOCK // BRED_PER_GENERATION):
            placed = pool.bred() if generation else unit.placed(extent, rules.kind)
            due = [
                Due(0, place, world.World(map_, lighthouse, 0))
                for map_, places in placed
                for place, lighthouse in places
            ]
            message = judge.worlds_message(due) | {"lines": ONCE, "runs": len(due) + 1}
            *logs, traced = answered(player, message)
            traces = json.decode(traced, type=list[tuple[Any, list[UserLine], Any]]) if due else []
            for run, log, (_, lines, _) in zip(due, logs, traces, strict=True):
                pool.add(run.world.map, lines)
                if generation and judge.judged(run, log).outcome.violation:
                    yield NumberedRun(
                        number, run.world.map, run.place, run.world.lighthouse, first=True
                    )
                    number += 1
            if not pool.lately:
                return
    except Lost:
        return
    finally:
        player.close()


class _Pool:
    """The worlds whose mutants may be in the next generation: the parents.

    Attributes:
        lately: for each line of the explorer's code the last worlds in which this line ran.
    """

    def __init__(self, unit: Bred, extent: Extent, kind: type[Lighthouse]) -> None:
        self.lately: dict[UserLine, deque[CombinatorialMap]] = {}
        self._often = Counter[UserLine]()
        self._least, self._extent, self._kind = unit.drawn.min_edges, extent, kind
        self._random = Random(f"bred/{unit.key}")  # noqa: S311  # reproducible

    def add(self, map_: CombinatorialMap, lines: Iterable[UserLine]) -> None:
        """Add a world in which the explorer ran these lines."""
        for line in lines:
            self._often[line] += 1
            self.lately.setdefault(line, deque(maxlen=PARENTS_PER_LINE)).append(map_)

    def bred(self) -> Iterator[MapWithPlaces]:
        """Yield the maps of a generation, each with a random place of the lighthouse."""
        rarest = sorted(self.lately, key=lambda line: (self._often[line], line))[:RAREST_LINES]
        for _ in range(BRED_PER_GENERATION):
            parent = self._random.choice(self.lately[self._random.choice(rarest)])
            child = self._child(parent)
            places = list(enumerate(self._kind.places(child, 0)))
            yield child, [self._random.choice(places)] if places else []

    def _child(self, parent: CombinatorialMap) -> CombinatorialMap:
        """A mutant of the parent that is in the class of maps and within the bounds.

        If none of :data:`MUTANTS_TRIED` mutants is such a map, the parent itself is returned.
        """
        for _ in range(MUTANTS_TRIED):
            child = mutated(parent, self._extent.levels[-1], self._random)
            if child.edge_count >= self._least and self._extent.include(child):
                return child
        return parent
