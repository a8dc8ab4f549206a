"""An estimate of a check's duration, from runs in a sample of the worlds of its last level."""

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
"""The seconds for which a sample continues after its first unit is done."""

MOST_SECONDS = 4.0
"""The most seconds of a sample, without compiling; an estimate has at most two samples.
If no further unit is done by then, the estimate has no rate."""

FEW, MANY = 200, 200_000
"""The most worlds in one unit of the sample: ``MANY`` if the runs are compiled, else ``FEW``."""

LONGEST = 1e300
"""The largest number of seconds that an estimate names; it also stands for longer times."""

PIECES = 2000

COUNTABLE = 16
"""The most edges of the larger check that is also estimated; counting more maps takes long."""


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
    """The base of estimates: the time for ``worlds`` rooted maps at ``rate`` maps a second."""

    worlds: int
    rate: float | None

    @doc.computed
    def seconds(self) -> doc.Seconds | None:
        """The time for all worlds, a guess, since smaller worlds take less; null without a rate."""
        if not self.rate:
            return None
        if self.worlds > LONGEST * self.rate:
            return LONGEST
        return round(self.worlds / self.rate, 1)


class Guess(doc.Document, _Lasting):
    """The estimated duration of a check of worlds with up to ``edges`` edges."""

    edges: Largest
    engine: Doer
    worlds: ToBeTried
    sampled: Sampled
    rate: Rate


class TimeEstimate(Report, _Lasting):
    """Report of 'check --estimate'.

    An estimate of the duration of a check.

    ``counted``: whether ``worlds`` is the exact number of worlds, and not an upper limit.
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
    """The number of worlds of a job; for one of N shards, the number of all worlds divided by N."""
    extent = job.scope.extent
    worlds = sum(units.level_size(extent, edges) for edges in extent.levels)
    return worlds // job.scope.portion.count


def estimated(job: Job, engine: EngineKind) -> Guess:
    """An estimate of a job's duration, from runs in random units of the job's last level.

    ``engine`` is the kind of engine that would do the job.  The estimate does not include compiling
    and the start of workers.  The runs take some seconds.
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
    """The job's class of maps, with a bound on the edges that is larger by one.

    The result is None in three cases.  First: the job has no bound on the edges.  Second: no map
    has as many edges as the new bound, for example because simple maps with few vertices have few
    edges.  Third: the new bound is larger than :data:`COUNTABLE`, since counting so many maps takes
    long.
    """
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
