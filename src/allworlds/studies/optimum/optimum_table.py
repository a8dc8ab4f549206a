"""The best that any explorer can do, beside what the built-in ones do at their worst."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated

from allworlds.document import AllRows, Document, Natural, Positive, Report, about, computed
from allworlds.engines import Listener
from allworlds.explorers import BUILT_IN
from allworlds.inputs import (
    InputError,
    an_integer,
    answers,
    show,
)
from allworlds.maps import CombinatorialMap, Dart
from allworlds.outcome import Exit, until_interrupted
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
        states: how many states of knowledge were looked into.
    """

    at_least: int
    strategy: Strategy | None
    states: int


def minimax(
    given: Iterable[tuple[CombinatorialMap, Dart, Dart]], deadline: float | None = None
) -> Solved:
    """The fewest traversals that are enough in all these worlds, and how.

    The explorer knows which worlds there are.

    Args:
        given: of each the map, the dart that the robot faces, and the dart of its vertex that
            the marker points at; at least one.
        deadline: on the monotonic clock; then what is known by then is told.

    Cost: seconds for all worlds with 4 edges; it grows faster than any power.
    """

    def tick() -> None:
        if deadline is not None and time.monotonic() > deadline:
            raise _Late

    places = Places()
    starts = places.parted([places.number(*world) for world in given])
    search = Search(places, tick)
    try:
        value = max(search.value(part.known) for part in starts)
    except _Late:
        at_least = max(search.at_least(part.known) for part in starts)
        return Solved(at_least, None, search.states)
    return Solved(value, search.strategy(starts), search.states)


class _Late(Exception):
    """The time is up."""


class OptimumRow(Document):
    """The worlds with one number of edges, which the explorer knows."""

    edges: Positive
    runs: Annotated[Positive, about("worlds with every bearing")]
    optimum: Annotated[
        Natural | None,
        about("the fewest traversals that are enough in every world; null: the time was up"),
    ] = computed(lambda row: row.at_least if row.strategy else None)
    at_least: Annotated[Natural, about("no explorer needs less in its worst world")]
    replayed: Annotated[
        Natural | None,
        about(
            "what the strategy costs at its worst, followed in every world; null: there is none, "
            "or it is wrong"
        ),
    ]
    states: Annotated[Natural, about("how many states of knowledge were looked into")]
    explorers: Annotated[dict[str, Natural], about("the worst cost of each built-in explorer")]
    strategy: Annotated[Strategy | None, about("one that attains the optimum")]

    @property
    def agrees(self) -> bool:
        """The strategy does what the search says that it does."""
        return self.replayed == self.optimum


class OptimumReport(Report):
    """Report of 'optimum'."""

    complete: AllRows
    rows: Annotated[tuple[OptimumRow, ...], about("by the number of edges")]

    @property
    def exit_code(self) -> Exit:
        """70 where a replay disagrees, 130 interrupted, 3 where an optimum was not found."""
        if not all(row.agrees for row in self.rows):
            return Exit.DISAGREES
        if not self.complete:
            return Exit.INTERRUPTED
        found = all(row.optimum is not None for row in self.rows)
        return Exit.ANSWERED if found else Exit.INCONCLUSIVE


@answers(OptimumRequest)
def optimum(request: OptimumRequest) -> OptimumReport:
    """The best that any explorer can do in the worst world with so many edges.

    The explorer has a directional lighthouse, and knows the number of edges.  A row that is not
    found in time tells a lower bound.

    Raises:
        InputError: for a number of edges, or a limit, that is not legal.
    """
    edges, time_limit = request.edges, request.time_limit
    if not 1 <= an_integer("edges", edges) <= MOST_EDGES:
        raise InputError(f"edges = {show(edges)}; the optimum is searched for 1..{MOST_EDGES}")
    if time_limit is not None and not (
        isinstance(time_limit, int | float) and 0 < time_limit < float("inf")
    ):
        raise InputError(f"time limit {show(time_limit)} is not a positive number of seconds")
    rows, complete = until_interrupted(_rows(edges, time_limit, request.listener))
    return OptimumReport(complete=complete, rows=rows)


def _rows(most: int, time_limit: float | None, listener: Listener) -> Iterator[OptimumRow]:
    explorers = [name for name, own in BUILT_IN.items() if own.lighthouse == Directional.kind]
    costs = {name: _worst(name, most) for name in explorers}
    for edges in range(1, most + 1):
        every = [world for world in worlds(edges=edges, places="all") if _size(world) == edges]
        deadline = None if time_limit is None else time.monotonic() + time_limit
        listener.level(edges, len(every))
        solved = minimax(map(_given, every), deadline)
        replayed = most_expensive(solved.strategy, every) if solved.strategy else None
        listener.progress(len(every))
        yield OptimumRow(
            edges=edges,
            runs=len(every),
            at_least=solved.at_least,
            replayed=replayed,
            states=solved.states,
            explorers={name: of[edges] for name, of in costs.items()},
            strategy=solved.strategy,
        )


def _size(world: World) -> int:
    return world.map.edge_count


def _given(world: World) -> tuple[CombinatorialMap, Dart, Dart]:
    assert isinstance(world.lighthouse, Directional)
    return world.map, world.start, world.lighthouse.dart


def _worst(name: str, most: int) -> Mapping[int, int]:
    """By the number of edges the largest cost of an explorer in any world; first in, first out."""
    worst: dict[int, int] = {}
    for row in check(name, edges=most).uninterrupted().to_json()["rows"]:
        worst[row["edges"]] = max(worst.get(row["edges"], 0), row["max_cost"])
    return worst
