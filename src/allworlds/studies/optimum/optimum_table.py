"""The best worst case of any explorer, beside the worst cases of the built-in ones."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Annotated

from msgspec import Struct, field
from typing_extensions import override

from allworlds.document import (
    Document,
    Edges,
    Natural,
    Positive,
    Why,
    about,
    computed,
    replace,
)
from allworlds.engines import (
    COMPILER,
    STOPPED,
    LevelUnit,
    ReadyEngine,
    RowsReport,
    Silent,
    Sweep,
    SweptLevel,
    ThisThread,
    TimeIsUp,
    check_deadline,
    level_size,
    time_until,
)
from allworlds.explorers import BUILT_IN
from allworlds.inputs import answers, ensure_installed
from allworlds.maps import CombinatorialMap, Dart, Extent, MapClass
from allworlds.outcome import Ending
from allworlds.studies.check import check
from allworlds.studies.optimum.bouquets import (
    bound_of_information,
    bouquets,
    cautious_cost,
    number_of_bouquets,
    told_apart,
)
from allworlds.studies.optimum.in_every_world import most_expensive
from allworlds.studies.optimum.minimax_of_worlds import BeforeSearch, Solved, minimax
from allworlds.studies.optimum.optimum_request import OptimumRequest
from allworlds.studies.optimum.strategy import Strategy
from allworlds.world import Directional, World, worlds


class OptimumRow(Document):
    """Worlds of one number of edges, all or those of a family, which the explorer knows."""

    edges: Edges
    loops: Annotated[
        Positive | None, about("the number of loops; of bouquets; null: all worlds")
    ] = None
    runs: Annotated[Positive, about("worlds with every bearing")]
    optimum: Annotated[
        Natural | None,
        about("the fewest traversals that suffice in every world; null: the time was up"),
    ] = computed(lambda row: row.at_least if row.at_least == row.at_most else None)
    at_least: Annotated[Natural, about("no explorer needs less in its worst world")]
    at_most: Annotated[
        Natural | None, about("the strategy needs no more; null: there was no time to find one")
    ]
    information: Annotated[
        Natural | None,
        about("with less the worlds cannot be told apart, as counting says; null: not known"),
    ] = None
    cautious: Annotated[
        Natural | None,
        about("the worst cost of cautious explorers; null: not known"),
    ] = None
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
    strategy: Annotated[Strategy | None, about("a strategy that needs no more than `at_most`")]

    @property
    def agrees(self) -> bool:
        """Whether the strategy costs exactly as much as the search says."""
        return self.replayed == self.at_most

    @property
    def worlds(self) -> int:
        """The number of worlds, without their bearings."""
        if self.loops:
            return self.runs
        return level_size(Extent(MapClass.MAPS, self.edges), self.edges)


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
    """Find the best worst case of any explorer in worlds with this number of edges, or loops.

    The explorer has a directional lighthouse, and knows that number.  Of the row in which the
    time is up the bounds found are told.

    Raises:
        InputError: for a number of edges or loops, a family, or a limit, that is not legal; or if
            the compiler is not installed.
    """
    assert request.largest
    ensure_installed(*COMPILER, "optimum")
    return OptimumSweep(request).answer(request.run)


class OptimumSweep(Sweep["OptimumRows", OptimumReport]):
    """The sweep of the search. Each level is one unit."""

    verb, asked = "optimum", OptimumRequest

    def __init__(self, request: OptimumRequest) -> None:
        super().__init__(request)
        self._rows = OptimumRows()

    @override
    def levels(self) -> Iterator[SweptLevel]:
        for number in range(1, self.request.largest + 1):
            edges, size = number, 0
            if self.request.family:
                edges, size = number + 1, number_of_bouquets(number)
            else:
                size = level_size(Extent(MapClass.MAPS, edges), edges)
            yield SweptLevel(edges, size, [LevelUnit(edges, ())])

    @override
    def ready(self) -> ReadyEngine:
        engine = _MinimaxOfBouquets if self.request.family else _MinimaxOfAll
        return ReadyEngine(ThisThread(), engine(self.deadline))

    @override
    def finish(self, level: SweptLevel, total: OptimumRows) -> None:
        self._rows.add(total)

    leave = finish

    @override
    def report(self, ending: Ending) -> OptimumReport:
        return OptimumReport(ending=ending, rows=tuple(self._rows.rows))


class OptimumRows(Struct):
    """The rows of some levels."""

    rows: list[OptimumRow] = field(default_factory=list)

    @property
    def worlds(self) -> int:
        """The number of rooted maps."""
        return sum(row.worlds for row in self.rows)

    def add(self, other: OptimumRows) -> None:
        """Add the rows of another part."""
        self.rows += other.rows


OptimumSweep.result = OptimumRows


class _MinimaxOfAll(Struct, frozen=True):
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
        explorers = dict[str, int]()
        late = not solved.closed
        try:
            for name in _explorers():
                explorers[name] = _worst(name, edges, deadline)
        except TimeIsUp:
            late = True
        yield from _handed_over(_row(edges, every, solved, explorers), late=late)


class _MinimaxOfBouquets(Struct, frozen=True):
    """The engine for bouquets."""

    deadline: float | None

    def parts(self, unit: LevelUnit) -> Iterator[OptimumRows]:
        """The row of the level, as above."""
        loops = unit.edges - 1
        every = [*_in_time(bouquets(loops), self.deadline)]
        least = bound_of_information(len(every))
        before = BeforeSearch(least, cautious_cost(loops), told_apart)
        solved = minimax(map(_given, every), self.deadline, before)
        row = replace(
            _row(unit.edges, every, solved, {}),
            loops=loops,
            information=least,
            cautious=cautious_cost(loops),
        )
        yield from _handed_over(row, late=not solved.closed)


def _row(
    edges: int, every: Sequence[World], solved: Solved, explorers: dict[str, int]
) -> OptimumRow:
    """The row, with the strategy followed in every world."""
    strategy = solved.strategy
    return OptimumRow(
        edges=edges,
        runs=len(every),
        at_least=solved.at_least,
        at_most=solved.at_most,
        replayed=most_expensive(strategy, every) if strategy else None,
        states=solved.states,
        explorers=explorers,
        strategy=strategy,
    )


def _handed_over(row: OptimumRow, *, late: bool) -> Iterator[OptimumRows]:
    yield OptimumRows([row])
    if late:
        yield OptimumRows()  # so that the one before is handed over
        raise TimeIsUp


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
        left = time_until(deadline)
        # A notebook shows the bar of this verb alone.
        report = check(name, edges=edges, time_limit=left, listener=Silent()).uninterrupted()
        if not report.scope.complete:
            raise TimeIsUp
        rows = report.rows
        _KNOWN[name, edges] = max(row.max_cost for row in rows if row.edges == edges)
    return _KNOWN[name, edges]
