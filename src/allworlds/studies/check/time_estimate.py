"""Estimated duration of a check, from a short sample of its last level."""

from __future__ import annotations

import time
from collections.abc import Iterator
from itertools import islice
from random import Random
from typing import Annotated, Any, TypeAlias

from allworlds.document.report import Report
from allworlds.document.struct import (
    Aside,
    Document,
    Figure,
    Natural,
    Positive,
    Seconds,
    Text,
    about,
    computed,
    replace,
)
from allworlds.engines.effort import ClusterLost, TimeIsUp
from allworlds.engines.engine_table import EngineKind, EngineName, Job
from allworlds.engines.players import Unsettled
from allworlds.engines.scope import Given
from allworlds.engines.tally import EnginesDisagree
from allworlds.engines.units import LevelUnit, drawn_units, level_size, shards_of
from allworlds.maps.classes import Extent
from allworlds.maps.count_source import source_of

SECONDS = 2.0
"""Seconds that a sample takes from its first piece on."""

MOST_SECONDS = 4.0
"""Seconds that it takes at most, besides compiling, once on a machine; samples are at most two.
Where no piece is done by then there is no guess."""

PIECE = {"python": 200, "compiled": 200_000}
"""The most worlds in a piece of the sample, by the player."""

MANY = {"python": 20_000, "compiled": 100_000_000}
"""Checks of more worlds begin with an estimate."""

LONG = 60.0
"""Seconds; of longer checks it is said how long they will take."""

LONGEST = 1e300
"""Seconds; what takes longer is said to take as long."""

PIECES = 2000

COUNTABLE = 16
"""Levels of more edges are not counted for this; that they are many is said without it."""


Largest: TypeAlias = Annotated[Positive, about("of the largest worlds")]
Doer: TypeAlias = Annotated[EngineName, about("the engine that would run it")]
ToBeTried: TypeAlias = Annotated[
    Natural,
    about("rooted maps that are to be tried; under a condition without a source at most so many"),
]
Sampled: TypeAlias = Annotated[
    Natural,
    about("rooted maps of the last level that were tried for this; 0: the rate is a guess"),
]
Rate: TypeAlias = Annotated[
    Figure | None, about("of these a second; null: none was finished in time")
]
Takes: TypeAlias = Annotated[Seconds | None, about("for all: a guess; null where there is no rate")]


def _seconds(guess: Guess | TimeEstimate) -> float | None:
    """Duration for all worlds at this rate. Smaller worlds take less."""
    if not guess.rate:
        return None
    if guess.worlds > LONGEST * guess.rate:
        return LONGEST
    return round(guess.worlds / guess.rate, 1)


class Guess(Document):
    """Estimated duration of a check with this number of edges."""

    edges: Largest
    engine: Doer
    worlds: ToBeTried
    sampled: Sampled
    rate: Rate
    seconds: Takes = computed(_seconds)


class TimeEstimate(Report):
    """Estimate.

    How long a check will take: what `check --estimate` writes.

    ``counted`` tells that the worlds were counted, and are not at most so many.
    """

    explorer: Annotated[Text, about("its name")]
    edges: Largest
    engine: Doer
    worlds: ToBeTried
    sampled: Sampled
    rate: Rate
    seconds: Takes = computed(_seconds)
    larger: Annotated[tuple[Guess, ...], about("the same check with more edges")]
    counted: Aside[bool] = True


def _plays(job: Job, engine: EngineKind) -> str:
    """``compiled`` if compiled code plays the runs; else ``python``, for programs too."""
    slow = job.subject.from_user and not job.subject.compiled
    return "python" if slow or engine.name == "python" else "compiled"


def worlds_of(job: Job) -> int:
    """The number of worlds to be tried; for a shard an estimate."""
    extent = job.scope.extent
    worlds = sum(level_size(extent, edges) for edges in extent.levels)
    return worlds // shards_of(job.scope.coverage)


def is_worth_a_guess(job: Job, engine: EngineKind) -> bool:
    """Whether a check may be long, and has no limit of time; its worlds are soon counted."""
    extent = job.scope.extent
    if source_of(extent) is None or isinstance(job.scope.coverage, Given):
        return False  # how many worlds there are is not known
    soon = job.limits.time_limit is None and job.scope.extent.levels[-1] <= COUNTABLE
    return soon and worlds_of(job) > MANY[_plays(job, engine)]


def estimated(job: Job, engine: EngineKind) -> Guess:
    """A guess from pieces of the last level, which are drawn like its maps.

    What starts workers and compiles is not counted; the sample takes some seconds.
    """
    engine.ready(job)  # compiles, where that is still to be done
    ready = engine.ready(replace(job, deadline=time.monotonic() + MOST_SECONDS))
    sampled, began, ended = 0, 0.0, 0.0
    try:
        with ready.transport as transport:
            for part in transport.map(ready.engine, _pieces(job, PIECE[_plays(job, engine)])):
                now = time.monotonic()
                if not began:
                    began = now
                    continue
                sampled, ended = sampled + part.result.worlds, now
                if sampled and now > began + SECONDS:
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
    """Extrapolate to one edge more, of which nothing was tried; None if there are no such worlds.

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
        yield LevelUnit(unit.edges, unit.prefix)
