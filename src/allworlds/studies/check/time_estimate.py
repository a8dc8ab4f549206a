"""An estimate of a check's duration, from a sample of its last level."""

import time
from contextlib import suppress
from functools import cache
from itertools import islice
from random import Random
from typing import Annotated, TypeAlias

from allworlds.documents import document as doc
from allworlds.documents.report import Report
from allworlds.engines import limits, players, tally, units
from allworlds.engines.engine_table import EngineKind, EngineName, Job
from allworlds.inputs.checks import InputError
from allworlds.inputs.requests import answers
from allworlds.maps import classes
from allworlds.studies.check.exhaustive import job_of
from allworlds.studies.check.report import CheckRequest

SECONDS = 2.0
"""The seconds of a sample after its first piece is done."""

MOST_SECONDS = 4.0
"""The most seconds of a sample, without compiling; an estimate has at most two samples.
If no piece is done by then, there is no estimate."""

FEW, MANY = 200, 200_000
"""The most worlds in a piece of the sample, played in Python, or by compiled code."""

LONGEST = 1e300
"""The largest number of seconds of an estimate."""

PIECES = 2000

COUNTABLE = 16
"""The most edges of a level whose maps are counted for an estimate."""


Largest: TypeAlias = Annotated[doc.Positive, doc.about("edges of the largest worlds")]
Doer: TypeAlias = Annotated[EngineName, doc.about("the engine that would run it")]
ToBeTried: TypeAlias = Annotated[
    doc.Natural,
    doc.about("rooted maps to try; an upper limit, if no formula counts the maps of the condition"),
]
Sampled: TypeAlias = Annotated[
    doc.Natural,
    doc.about("tried rooted maps of the last level, for the rate; 0: the rate is a guess"),
]
Rate: TypeAlias = Annotated[
    doc.Figure | None, doc.about("rooted maps a second; null: no map was finished in time")
]


class _Lasting:
    """The common part of estimates: the time for ``worlds`` rooted maps at ``rate`` a second."""

    worlds: int
    rate: float | None

    @doc.computed
    def seconds(self) -> doc.Seconds | None:
        """For all: a guess, since smaller worlds take less; null where there is no rate."""
        if not self.rate:
            return None
        if self.worlds > LONGEST * self.rate:
            return LONGEST
        return round(self.worlds / self.rate, 1)


class Guess(doc.Document, _Lasting):
    """Estimated duration of a check with this number of edges."""

    edges: Largest
    engine: Doer
    worlds: ToBeTried
    sampled: Sampled
    rate: Rate


class TimeEstimate(Report, _Lasting):
    """Estimate.

    How long a check will take: what `check --estimate` writes.

    ``counted`` tells that the worlds were counted, and are not at most so many.
    """

    explorer: Annotated[doc.Text, doc.about("its name")]
    edges: Largest
    engine: Doer
    worlds: ToBeTried
    sampled: Sampled
    rate: Rate
    larger: Annotated[tuple[Guess, ...], doc.about("the same check with more edges")]
    counted: doc.NotInDocument[bool] = True


def worlds_of(job: Job) -> int:
    """The number of worlds of a job; for a shard an equal part of all worlds, an estimate."""
    extent = job.scope.extent
    worlds = sum(units.level_size(extent, edges) for edges in extent.levels)
    return worlds // job.scope.portion.count


def estimated(job: Job, engine: EngineKind) -> Guess:
    """An estimate of a job's duration, from its runs in random pieces of its last level.

    The estimate does not include compiling and the start of workers.  The sample takes some
    seconds.
    """
    engine.ready(job)  # compiles, where that is still to be done
    ready = engine.ready(doc.replace(job, deadline=time.monotonic() + MOST_SECONDS))
    extent, draw = job.scope.extent, Random(0)  # noqa: S311  # the same pieces each time
    sampled, began, ended = 0, 0.0, 0.0
    slow = engine.name == "python" or (job.subject.from_user and not job.subject.compiled)
    try:
        drawn = units.drawn_units(extent, extent.levels[-1], FEW if slow else MANY, draw)
        with ready.transport as transport:
            for part in transport.map(ready.engine, islice(drawn, PIECES)):
                now = time.monotonic()
                if not began:
                    began = now
                    continue
                sampled, ended = sampled + part.result.worlds, now
                if sampled and now > began + SECONDS:
                    break
    except (limits.TimeIsUp, tally.EnginesDisagree, limits.ClusterLost, players.Unsettled):
        pass  # the check itself will say so
    rate = sampled / (ended - began) if ended > began and sampled else None
    return Guess(
        edges=extent.levels[-1],
        engine=engine.name,
        worlds=worlds_of(job),
        sampled=sampled,
        rate=None if rate is None else round(rate, 3),
    )


def one_larger(job: Job) -> classes.Extent | None:
    """The job's extent with one edge more; None if no further world is in it, or too many are."""
    extent = job.scope.extent
    if extent.edges is None or extent.edges >= COUNTABLE:
        return None
    edges = extent.edges + 1
    larger = doc.replace(extent, edges=edges)
    return larger if units.level_size(larger, edges) else None


@answers(CheckRequest)
def estimate(request: CheckRequest) -> TimeEstimate:
    """Estimate the duration of :func:`check` with these options, from a sample of some seconds.

    The duration with one edge more is estimated, too.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if request.given is not None:
        raise InputError(f"estimate is for a class, not for {request.given.words}")
    once = cache(request.listener.notice)
    job, chosen = job_of(request, once)
    guess, larger = estimated(job, chosen), tuple[Guess, ...]()
    if guess.rate and (extent := one_larger(job)):
        # What an engine cannot do ends the table.
        with suppress(InputError):
            larger = (estimated(*job_of(doc.replace(request, edges=extent.edges), once)),)
    counted = units.is_counted(job.scope.extent)
    first = {name: getattr(guess, name) for name in guess.__struct_fields__}
    return TimeEstimate(explorer=job.subject.name, larger=larger, counted=counted, **first)
