"""Run directories: ``merge`` joins them, ``status`` shows their progress."""

import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias

from allworlds.documents import document as doc
from allworlds.documents.report import Report
from allworlds.engines import kept_units, run_directory, sweep
from allworlds.engines.listeners import NOBODY, Listener
from allworlds.engines.units import WHOLE, is_counted
from allworlds.inputs.checks import InputError, a_path, show
from allworlds.inputs.requests import Argument, Request, answers, given_again, takes_fields
from allworlds.protocol.user_code import as_recorded
from allworlds.studies.options import ListenerOptions
from allworlds.studies.swept import RowOptions
from allworlds.version import __version__


class MergeRequest(RowOptions, ListenerOptions):
    """Request of ``merge``: the run directories, and what a row of the CSV file is about."""

    runs: Annotated[
        Sequence[str | Path],
        Argument("", "DIR...", "The run directories, one for each shard.", repeated=True),
    ]


def sweep_of(verb: str) -> type[sweep.Sweep[Any, Any]]:
    """The class of the sweeps of a verb, such as ``check``; a sweep does all units of a job."""
    from allworlds.studies.ambiguity.census_sweep import CensusSweep
    from allworlds.studies.check.exhaustive import CheckSweep
    from allworlds.studies.compare.comparison import SameWorlds
    from allworlds.studies.count import CountSweep
    from allworlds.studies.fuzz.sample_sweep import FuzzSweep
    from allworlds.studies.team.search_sweep import TeamSweep
    from allworlds.studies.worst.all_worlds import SchedulesSweep

    kinds: tuple[type[sweep.Sweep[Any, Any]], ...] = (
        *(CheckSweep, FuzzSweep, SameWorlds, SchedulesSweep, CountSweep, CensusSweep),
        TeamSweep,
    )
    return next(kind for kind in kinds if kind.verb == verb)


@contextmanager
def shards_of(
    runs: Sequence[str | Path],
) -> Iterator[tuple[kept_units.Identity, run_directory.Merged]]:
    """Open the run directories of a job, one for each shard, as long as a ``with`` block runs.

    The ``with`` statement gets one pair: the identity of the job, which is the verb and all that
    the job's report depends on; and the finished units of all directories together.

    Raises:
        InputError: if there is no directory, if the directories are not of one job, or if two of
            them are of the same shard.
        Gap: if a shard is missing.
    """
    if not runs:
        raise InputError("merge needs at least one run directory")
    with ExitStack() as stack:
        paths = [a_path("run", run) for run in runs]
        directories = [stack.enter_context(run_directory.reading(path)) for path in paths]
        first = directories[0]
        seen: dict[str, run_directory.Database] = {}
        for one in directories:
            if said := first.identity.difference(one.identity):
                raise InputError(
                    f"{run_directory.named(one.path)} {said} as {show(str(first.path))}"
                )
            shard = one.identity.shard
            if (other := seen.setdefault(shard, one)) is not one:
                raise InputError(
                    f"run directories overlap: {show(str(other.path))} and {show(str(one.path))} "
                    f"are both shard {shard}"
                )
        shards = first.identity.shards
        missing = [f"{k}/{shards}" for k in range(shards) if f"{k}/{shards}" not in seen]
        if missing:
            more = f" and {len(missing) - 9} more" if len(missing) > 9 else ""
            said = f"what is missing is shard {', '.join(missing[:9])}{more}"
            raise run_directory.Gap(f"{said}: give the run directory of each shard")
        yield first.identity, run_directory.Merged(directories)


def _merged(request: MergeRequest) -> Any:
    runs = request.runs
    with shards_of(runs) as (identity, kept):
        if identity.version != __version__:
            raise InputError(
                f"run directory {show(str(runs[0]))} is of version {show(identity.version)}, not "
                f"{show(__version__)}"
            )
        kind = sweep_of(identity.verb)
        with as_recorded(identity.code):
            sweep = kind.known(identity, WHOLE, request.listener)
            if request.by is not None:
                sweep.list_by(request.by)
            return sweep.merged(kept)


@takes_fields(MergeRequest, several="runs", answered=_merged)
def merge(*runs: str | Path, by: str | None = None, listener: Listener | None = None) -> Any:
    """Merge the shards of a job, each in a run directory, into one report.

    As in a job without shards, counts are compared with an independent source, and witnesses are
    required.
    No explorer is needed or run: each shard has confirmed its own findings.
    ``by`` is for jobs of ``compare`` alone: one row of the report's CSV file is about one ``size``,
    one ``world`` or one ``run``; None keeps the default, ``size``.

    Returns:
        The report that the job's verb, such as ``check``, would have given without shards.

    Raises:
        InputError: if the directories are not of one job, are of another version of this program,
            or are damaged; if two of them have the same shard or unit; or if ``by`` has no effect.
        Gap: if a shard or a unit is missing.
    """
    return _merged(MergeRequest(runs=runs, by=by, listener=listener))


JobState: TypeAlias = Literal["running", "finished", "unfinished"]


class DoneOf(doc.Document):
    """The number of finished units or worlds, and the number of all units or worlds."""

    done: Annotated[doc.Natural, doc.about("are finished")]
    all: Annotated[doc.Natural, doc.about("are to be done")]


class LargestCost(doc.Document):
    """The largest cost so far, and the smallest size of a world with that cost."""

    edges: doc.Edges
    vertices: doc.Vertices
    cost: Annotated[doc.Natural, doc.about("traversals")]


class Standing(Report):
    """Report of 'status'.

    The progress of the job in a run directory. Larger worlds take longer, so the time left is a
    guess.

    ``counted``: whether the number of all worlds is exact, and not an upper limit. ``options`` are
    options of the job as words of a command line: those that differ from their defaults, without
    the options in :data:`NAMED`, which the printed report tells in sentences.
    """

    verb: Annotated[doc.Text, doc.about("the verb whose units these are")]
    version: Annotated[doc.Text, doc.about("of the program that does them")]
    explorer: Annotated[str, doc.about("its name; empty where there is none")]
    shard: doc.WhichShard
    parameters: Annotated[dict[str, Any], doc.about("further options that the result depends on")]
    state: Annotated[
        JobState,
        doc.about(
            "whether somebody adds to it now; if nobody does, whether anything is left to add"
        ),
    ]
    units: Annotated[DoneOf, doc.about("pieces of work")]
    worlds: Annotated[
        DoneOf,
        doc.about(
            "rooted maps (`compare`: once for each explorer; a family: runs); in a shard `all` is "
            "its part, and an upper limit if no formula counts the maps of a condition"
        ),
    ]
    rate: Annotated[
        doc.Figure | None,
        doc.about("worlds a second since somebody last began; null: none yet, or all are"),
    ]
    left_s: Annotated[
        doc.Seconds | None,
        doc.about("seconds until the end at this rate, a guess; null if there is no rate"),
    ]
    worst: Annotated[LargestCost | None, doc.about("the largest cost so far; null: there is none")]
    findings: Annotated[doc.Natural, doc.about("in the finished units")]
    counted: doc.NotInDocument[bool] = True
    options: doc.NotInDocument[tuple[str, ...]] = ()


class StatusRequest(Request, kw_only=False):
    """Request of ``status``: the run directory."""

    run: Annotated[str | Path, Argument("", "DIR", "A run directory.")]


@answers(StatusRequest)
def status(request: StatusRequest) -> Standing:
    """Report the progress of the job in a run directory, from all units that are kept there.

    Raises:
        InputError: if the directory is no run directory, or is damaged.
    """
    path = a_path("run", request.run)
    running = run_directory.in_use(path)
    with run_directory.reading(path) as database, as_recorded(database.identity.code):
        identity = database.identity
        sweep = sweep_of(identity.verb).known(identity, identity.portion, NOBODY)
        ended = database.recall("ended") == kept_units.ENDED
        began = database.last_session()
        units = worlds = recent = findings = 0
        last = began
        costs: list[LargestCost] = []
        for _, met, finished, kept in database.units():
            units, worlds = units + 1, worlds + met
            if finished >= began:
                recent, last = recent + met, max(last, finished)
            total = sweep.read(kept)
            costs += (
                LargestCost(edges=edges, vertices=vertices, cost=cost)
                for edges, vertices, cost in sweep.costs(total)
            )
            findings += len(getattr(total, "findings", ()))
    until = time.time() if running and not ended else last
    worst = min(costs, key=lambda d: (-d.cost, d.edges, d.vertices), default=None)
    state: JobState = "running" if running and not ended else "finished" if ended else "unfinished"
    levels = [(level.worlds, sum(1 for _ in level.units)) for level in sweep.levels()]
    all_worlds = sum(size for size, _ in levels) // identity.portion.count
    rate = recent / (until - began) if recent and until > began and not ended else None
    left = 0.0 if ended else max(0, all_worlds - worlds) / rate if rate else None
    return Standing(
        verb=identity.verb,
        version=identity.version,
        explorer=identity.explorer["name"],
        shard=str(identity.portion),
        parameters=dict(identity.parameters),
        state=state,
        units=DoneOf(done=units, all=sum(number for _, number in levels)),
        worlds=DoneOf(done=worlds, all=all_worlds),
        rate=None if rate is None else round(rate, 1),
        left_s=None if left is None else round(left, 1),
        worst=worst,
        findings=findings,
        counted=is_counted(sweep.extent),
        options=tuple(given_again(type(sweep.request), sweep.request, but=NAMED)),
    )


NAMED = ("edges", "vertices", "map_class", "family", "to", "where", "lighthouse", "task")
"""The options of jobs that the printed report of ``status`` tells in sentences."""
