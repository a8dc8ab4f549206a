"""How long a check will take, from a short sample of its last level."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from random import Random
from typing import Annotated, Any, ClassVar, TypeAlias

from allworlds.document import (
    Document,
    Figure,
    Natural,
    Positive,
    Report,
    Seconds,
    Text,
    about,
    computed,
    one_of,
)
from allworlds.engines import (
    ENGINES,
    ClusterLost,
    EngineKind,
    EnginesDisagree,
    Job,
    LevelRuns,
    TimeIsUp,
    Unsettled,
    drawn_units,
    level_size,
    shards_of,
)
from allworlds.maps import Extent
from allworlds.outcome import Exit

SECONDS = 3.0
"""So long a sample takes from its first piece on."""

MOST_SECONDS = 120.0
"""So long it takes at most, compiling and all; where no piece is done by then there is no guess."""

PIECE = {"python": 200, "compiled": 200_000}
"""So many worlds at most stand in a piece of the sample, by what plays in them."""

MANY = {"python": 20_000, "compiled": 100_000_000}
"""Checks of more worlds begin with an estimate."""

LONG = 60.0
"""Seconds; of longer checks it is said how long they will take."""

PIECES = 2000

COUNTABLE = 16
"""Levels of more edges are not counted for this; that they are many is said without it."""


Largest: TypeAlias = Annotated[Positive, about("of the largest worlds")]
Engine: TypeAlias = Annotated[str, about("which would do it"), one_of(*ENGINES)]
ToBeTried: TypeAlias = Annotated[Natural, about("rooted maps that are to be tried")]
Sampled: TypeAlias = Annotated[
    Natural,
    about("rooted maps of the last level that were tried for this; 0: the rate is a guess"),
]
Rate: TypeAlias = Annotated[
    Figure | None, about("of these a second; null: none was finished in time")
]
Takes: TypeAlias = Annotated[Seconds | None, about("for all: a guess; null where there is no rate")]


def _seconds(guess: Guess | TimeEstimate) -> float | None:
    """For all worlds at this rate; smaller ones take less."""
    return round(guess.worlds / guess.rate, 1) if guess.rate else None


class Guess(Document):
    """How long a check with so many edges will take."""

    edges: Largest
    engine: Engine
    worlds: ToBeTried
    sampled: Sampled
    rate: Rate
    seconds: Takes = computed(_seconds)


class TimeEstimate(Report):
    """Estimate.

    How long a check will take: what `check --estimate` writes.
    """

    exit_code: ClassVar[Exit] = Exit.ANSWERED

    explorer: Annotated[Text, about("its name")]
    edges: Largest
    engine: Engine
    worlds: ToBeTried
    sampled: Sampled
    rate: Rate
    seconds: Takes = computed(_seconds)
    larger: Annotated[tuple[Guess, ...], about("the same check with more edges")]


def _plays(job: Job, engine: EngineKind) -> str:
    """What plays: compiled code, or, whoever judges it, an explorer in Python or behind a pipe."""
    slow = job.subject.from_user and not job.subject.compiled
    return "python" if slow or engine.name == "python" else "compiled"


def worlds_of(job: Job) -> int:
    """How many worlds are to be tried; of a shard about so many."""
    extent = job.scope.extent
    worlds = sum(level_size(extent, edges) for edges in extent.levels)
    return worlds // shards_of(job.scope.coverage)


def is_worth_a_guess(job: Job, engine: EngineKind) -> bool:
    """Whether a check may be long, and has no limit of time; its worlds are soon counted."""
    soon = job.limits.time_limit is None and job.scope.extent.levels[-1] <= COUNTABLE
    return soon and worlds_of(job) > MANY[_plays(job, engine)]


def estimated(job: Job, engine: EngineKind) -> Guess:
    """A guess from pieces of the last level, which are drawn like its maps.

    What starts workers and compiles is not counted; the sample takes some seconds.
    """
    hurried = replace(job, deadline=time.monotonic() + MOST_SECONDS)
    ready = engine.ready(hurried)
    sampled, began, ended = 0, 0.0, 0.0
    try:
        with ready.transport as transport:
            for part in transport.map(ready.engine, _pieces(job, PIECE[_plays(job, engine)])):
                now = time.monotonic()
                if not began:
                    began = now
                    continue
                sampled, ended = sampled + part.result.worlds, now
                if now > began + SECONDS:
                    break
    except (TimeIsUp, EnginesDisagree, ClusterLost, Unsettled):
        pass  # the check itself will say so
    rate = sampled / (ended - began) if ended > began and sampled else None
    return Guess(
        edges=job.scope.extent.levels[-1],
        engine=engine.name,
        worlds=worlds_of(job),
        sampled=sampled,
        rate=None if rate is None else round(rate, 3),
    )


def one_larger(job: Job) -> Extent | None:
    """The extent with one edge more; None where that holds no more worlds, or too many to count."""
    extent = job.scope.extent
    if extent.edges is None or extent.edges >= COUNTABLE:
        return None
    edges = extent.edges + 1
    larger = replace(extent, edges=edges)
    return larger if level_size(larger, edges) else None


def extrapolated(job: Job, guesses: tuple[Guess, Guess]) -> tuple[Guess, ...]:
    """A guess of the job with one edge more, of which nothing was tried; none if there is none.

    A world is thought to take longer by as much as from the first guess to the second.

    Args:
        job: that of the second guess.
        guesses: with one edge more each.
    """
    extent, (first, second) = one_larger(job), guesses
    if extent is None or not (first.rate and second.rate):
        return ()
    slower = min(1.0, second.rate / first.rate) if first.engine == second.engine else 1.0
    worlds = worlds_of(replace(job, scope=replace(job.scope, extent=extent)))
    rate = round(slower * second.rate, 3)
    return (
        Guess(edges=extent.levels[-1], engine=second.engine, worlds=worlds, sampled=0, rate=rate),
    )


def _pieces(job: Job, worlds: int) -> Iterator[Any]:
    extent = job.scope.extent
    draw = Random(0)  # noqa: S311  # the same pieces each time
    units = drawn_units(extent, extent.levels[-1], worlds, draw)
    for unit in islice(units, PIECES):
        yield LevelRuns(unit.edges, unit.prefix)
