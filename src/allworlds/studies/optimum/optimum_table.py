"""The best worst case of any explorer, beside the worst cases of the built-in ones."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import partial
from typing import Annotated

from typing_extensions import override

from allworlds.document import (
    Document,
    Edges,
    Natural,
    Positive,
    Why,
    about,
    computed,
)
from allworlds.engines import (
    STOPPED,
    LevelUnit,
    ReadyEngine,
    RowsReport,
    Sweep,
    SweptLevel,
    ThisThread,
    TimeIsUp,
    check_deadline,
    level_size,
    time_until,
)
from allworlds.explorers import BUILT_IN
from allworlds.inputs import InputError, an_integer, answers, show
from allworlds.maps import CombinatorialMap, Dart, Extent, MapClass
from allworlds.outcome import Ending
from allworlds.studies.check import check
from allworlds.studies.optimum.fewest_traversals import Search
from allworlds.studies.optimum.in_every_world import most_expensive
from allworlds.studies.optimum.knowledge import Places
from allworlds.studies.optimum.optimum_request import MOST_EDGES, OptimumRequest
from allworlds.studies.optimum.strategy import Strategy
from allworlds.world import Directional, World, worlds


@dataclass(frozen=True, slots=True)
class Solved:
    """Minimax over some worlds.

    Attributes:
        at_least: no explorer needs less at its worst.
        strategy: one that needs no more; None where the time was up before it was found.
        states: the number of states of knowledge that were examined.
    """

    at_least: int
    strategy: Strategy | None
    states: int


def minimax(
    given: Iterable[tuple[CombinatorialMap, Dart, Dart]], deadline: float | None = None
) -> Solved:
    """Find the fewest traversals that suffice in all these worlds, and a strategy for them.

    The explorer knows which worlds there are.

    Args:
        given: of each the map, the dart that the robot faces, and the dart of its vertex that
            the marker points at; at least one.
        deadline: of the search, on the monotonic clock; then what is known by then is told.

    Cost: seconds for all worlds with 4 edges; it grows faster than any power.
    """
    places = Places()
    starts = places.parted([places.number(*world) for world in given])
    search = Search(places, partial(check_deadline, deadline))
    try:
        value = max(search.value(part.known) for part in starts)
    except TimeIsUp:
        at_least = max(search.at_least(part.known) for part in starts)
        return Solved(at_least, None, search.states)
    return Solved(value, search.strategy(starts), search.states)


class OptimumRow(Document):
    """The worlds with one number of edges, which the explorer knows."""

    edges: Edges
    runs: Annotated[Positive, about("worlds with every bearing")]
    optimum: Annotated[
        Natural | None,
        about("the fewest traversals that suffice in every world; null: the time was up"),
    ] = computed(lambda row: row.at_least if row.strategy else None)
    at_least: Annotated[Natural, about("no explorer needs less in its worst world")]
    replayed: Annotated[
        Natural | None,
        about(
            "the strategy's worst cost, followed in every world; null: there is no strategy, "
            "or it is wrong"
        ),
    ]
    states: Annotated[Natural, about("the number of states of knowledge that were examined")]
    explorers: Annotated[
        dict[str, Natural],
        about("the worst cost of each built-in explorer; of none for which there was no time"),
    ]
    strategy: Annotated[Strategy | None, about("a strategy that attains the optimum")]

    @property
    def agrees(self) -> bool:
        """Whether the strategy costs exactly as much as the search says."""
        return self.replayed == self.optimum


class OptimumReport(RowsReport):
    """Report of 'optimum'.

    The optimum by the number of edges, beside the worst costs of the built-in explorers.
    """

    stopped: Why = STOPPED
    rows: Annotated[tuple[OptimumRow, ...], about("by the number of edges")]

    @property
    @override
    def agrees(self) -> bool:
        return all(row.agrees for row in self.rows)


@answers(OptimumRequest)
def optimum(request: OptimumRequest) -> OptimumReport:
    """Find the best worst case of any explorer in worlds with this number of edges.

    The explorer has a directional lighthouse, and knows the number of edges.  Of the row in which
    the time is up a lower bound is told.

    Raises:
        InputError: for a number of edges, or a limit, that is not legal.
    """
    edges = request.edges
    if not 1 <= an_integer("edges", edges) <= MOST_EDGES:
        raise InputError(f"edges = {show(edges)}; the optimum is searched for 1..{MOST_EDGES}")
    return OptimumSweep(request).answer(request.run)


class OptimumSweep(Sweep["OptimumRows", OptimumReport]):
    """The sweep of the search. Each level is one unit."""

    verb, asked = "optimum", OptimumRequest

    def __init__(self, request: OptimumRequest) -> None:
        super().__init__(request)
        self._rows = OptimumRows()

    @override
    def levels(self) -> Iterator[SweptLevel]:
        for edges in range(1, self.request.edges + 1):
            size = level_size(Extent(MapClass.MAPS, edges), edges)
            yield SweptLevel(edges, size, [LevelUnit(edges, ())])

    @override
    def ready(self) -> ReadyEngine:
        return ReadyEngine(ThisThread(), _Minimax(self.deadline))

    @override
    def finish(self, level: SweptLevel, total: OptimumRows) -> None:
        self._rows.add(total)

    leave = finish

    @override
    def report(self, ending: Ending) -> OptimumReport:
        return OptimumReport(ending=ending, rows=tuple(self._rows.rows))


@dataclass(slots=True)
class OptimumRows:
    """The rows of some levels."""

    rows: list[OptimumRow] = field(default_factory=list)

    @property
    def worlds(self) -> int:
        """The number of rooted maps."""
        extents = (Extent(MapClass.MAPS, row.edges) for row in self.rows)
        return sum(level_size(extent, extent.levels[-1]) for extent in extents)

    def add(self, other: OptimumRows) -> None:
        """Add the rows of another part."""
        self.rows += other.rows


OptimumSweep.result = OptimumRows


@dataclass(frozen=True, slots=True)
class _Minimax:
    """The engine, which solves a whole level, and runs other explorers in it."""

    deadline: float | None

    def parts(self, unit: LevelUnit) -> Iterator[OptimumRows]:
        """The row of the level.

        Raises:
            TimeIsUp: after a row without all that there was no time for, if there is a row.
        """
        edges, deadline = unit.edges, self.deadline
        every = [*_in_time(_worlds(edges), deadline)]
        solved = minimax(map(_given, _in_time(every, deadline)), deadline)
        strategy, explorers = solved.strategy, dict[str, int]()
        late: TimeIsUp | None = None if strategy else TimeIsUp()
        try:
            for name in _explorers():
                explorers[name] = _worst(name, edges, deadline)
        except TimeIsUp as error:
            late = error
        row = OptimumRow(
            edges=edges,
            runs=len(every),
            at_least=solved.at_least,
            replayed=most_expensive(strategy, every) if strategy else None,
            states=solved.states,
            explorers=explorers,
            strategy=strategy,
        )
        yield OptimumRows([row])
        if late:
            yield OptimumRows()  # so that the one before is handed over
            raise late


def _explorers() -> list[str]:
    return [name for name, own in BUILT_IN.items() if own.lighthouse == Directional.kind]


def _worlds(edges: int) -> Iterator[World]:
    """Every world of a level, with every bearing."""
    return (world for world in worlds(edges=edges, places="all") if world.map.edge_count == edges)


def _in_time(every: Iterable[World], deadline: float | None) -> Iterator[World]:
    """The worlds, one by one; TimeIsUp is raised after the deadline."""
    for world in every:
        check_deadline(deadline)
        yield world


def _given(world: World) -> tuple[CombinatorialMap, Dart, Dart]:
    assert isinstance(world.lighthouse, Directional)
    return world.map, world.start, world.lighthouse.dart


_KNOWN: dict[tuple[str, int], int] = {}
"""Worst costs that were found in this process, by explorer and number of edges."""


def _worst(name: str, edges: int, deadline: float | None) -> int:
    """The largest cost of an explorer, first in, first out, in a world with these edges.

    Raises:
        TimeIsUp: if there was no time for all these worlds.
    """
    if (name, edges) not in _KNOWN:
        report = check(name, edges=edges, time_limit=time_until(deadline)).uninterrupted()
        if not report.scope.complete:
            raise TimeIsUp
        rows = report.rows
        _KNOWN[name, edges] = max(row.max_cost for row in rows if row.edges == edges)
    return _KNOWN[name, edges]
