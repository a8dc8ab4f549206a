"""The sweep: **the** loop of the studies, through all units of a job, level by level.

A study is a :class:`Sweep`: its class defines the levels, the engine and the result of a unit, and
the use of a finished level.  This module does the rest: it keeps finished units, tells listeners of
the progress, ends the job at a time limit, and reports all finished parts.

An *ending* says how a job has ended: completed, stopped early, interrupted by the user, or given up
because two engines disagree.
"""

import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable
from pathlib import Path
from random import randrange
from typing import (
    Any,
    ClassVar,
    Generic,
    Literal,
    TypeAlias,
    TypeVar,
)

from allworlds import outcome, words
from allworlds.documents import document as doc
from allworlds.engines import limits, linux, players, tally, units
from allworlds.engines.engine_table import ReadyEngine, ThisThread
from allworlds.engines.kept_units import ENDED, NOTHING_KEPT, Identity, KeptUnits, from_kept
from allworlds.engines.listeners import NOBODY, Listener
from allworlds.engines.user_code_checks import DRAWN, SMALL, ensure_same_worlds
from allworlds.inputs import checks, requests
from allworlds.maps import classes

By: TypeAlias = Literal["size", "world", "run"]
"""The choice of the rows in a report's CSV or Parquet file.

For each explorer there is one row for each size, for each world, or for each run.
"""


Total = TypeVar("Total", bound=units.Sum)
Answer = TypeVar("Answer")


def gather(
    transport: units.Transport,
    engine: Any,
    undone: Iterable[units.Unit],
    total: units.Sum,
    listener: Listener,
    kept: KeptUnits = NOTHING_KEPT,
    extent: classes.Extent | None = None,
) -> None:
    """Do all units ``undone``, and add their results to ``total``.

    Args:
        transport: brings the units to the engine.
        engine: computes the results of the units; its type is one that the transport takes.
        undone: the units.
        total: the sum of the results.
        listener: hears of each part of a result.
        kept: the finished units of the job, to which each unit is added when it is finished.
        extent: the class of the maps; needed only to estimate, at the time limit, how long a unit
            takes.

    Raises:
        TimeIsUp: when the time limit has been reached; ``total`` holds the results so far.  A job
            that keeps its finished units in a directory can be continued by the same command.  If
            this command has finished no unit, the text of the exception warns that the same command
            would come no further.  If a part of a unit was done, the text may also estimate the
            time for the whole unit.
    """
    begun: dict[str, units.Sum] = {}
    started, unit = time.monotonic(), None
    try:
        for part in transport.map(engine, undone):
            unit, result = part.unit, part.result
            if part.anew and unit.key in begun:
                listener.progress(-begun.pop(unit.key).worlds)
            whole, worlds = begun.setdefault(unit.key, result), result.worlds
            if whole is not result:
                whole.add(result)
            listener.progress(worlds)  # this may end the job, so the part was counted before
            if part.walk:
                listener.walk(*part.walk)
            if part.last:
                total.add(begun.pop(unit.key))
                kept.keep(unit.key, whole)
    except limits.TimeIsUp:
        if kept is NOTHING_KEPT or kept.added:
            raise
        said = "; no unit was finished, so that the same again comes no further"
        if unit and extent and hasattr(unit, "weight") and (done := begun[unit.key].worlds):
            seconds = (time.monotonic() - started) * unit.weight(extent) / done
            said += f": a unit takes about {words.duration(1 + seconds)}"
        raise limits.TimeIsUp(said) from None
    finally:
        for unfinished in begun.values():
            total.add(unfinished)


class Sweep(ABC, Generic[Total, Answer]):
    """A study that goes through all units of its levels.

    Args:
        request: the request of the study; the fields ``listener``, ``time_limit`` and ``shard``
            have the same meaning in every study.
        extent: the class and the bounds of the worlds; None if the study does not go through all
            maps of an extent, but through random or chosen worlds.

    Attributes:
        verb: the study's name on the command line.
        request_type: the class of the study's requests.
        result: the class of the results of units, called without arguments for an empty result.  A
            study whose class needs arguments overrides :meth:`empty` and :meth:`read` instead.
        finer: a larger number makes smaller units.  The enumeration makes a map by decisions, and a
            unit holds the maps with the same first decisions; ``finer`` is added to the usual
            number of these first decisions.
        narrowed: the extent whose condition is tested: several fresh processes apply the condition
            to the same maps, and must select the same of them.  A condition that is not a user's
            code is not tested.  The default of this attribute is ``extent``.  A study of random
            worlds, which has no ``extent``, sets the extent from which its worlds are drawn.  None
            if no condition is tested.
        portion: the shard: the part of all units that the job does.
        seconds: the seconds that each finished level took.
        deadline: the end of the time limit, on the monotonic clock; or None.
        kept: the finished units of the job, while it goes on.
    """

    verb: ClassVar[str]
    request_type: ClassVar[Any]
    result: ClassVar[Any]
    finer: ClassVar[int] = 0
    kept: KeptUnits

    def __init__(self, request: Any, extent: classes.Extent | None = None) -> None:
        self.request, self.extent = request, extent
        self.narrowed = extent
        self.listener: Listener = request.listener
        self.portion: units.Shard = request.shard
        self.deadline = limits.deadline_after(request.time_limit)
        self.seconds: list[float] = []

    @classmethod
    def known(
        cls, identity: Identity, portion: units.Shard, listener: Listener
    ) -> "Sweep[Any, Any]":
        """Return the sweep of the job with the identity ``identity``; load no explorer.

        Args:
            identity: all on which the report of the job depends.
            portion: the shard that the sweep is about; :data:`units.WHOLE` if shards are merged.
            listener: the listener to the progress.
        """
        return cls(cls.request_of(identity, portion, listener))

    @classmethod
    def request_of(cls, identity: Identity, portion: units.Shard, listener: Listener) -> Any:
        """Return the request of a job that is kept in a run directory, but for another shard.

        ``identity`` is what the run directory says of the job, ``portion`` the shard to do, and
        ``listener`` is told of the progress.
        """
        options = requests.remembered(cls.request_type, identity.parameters)
        return cls.request_type(**options, shard=portion, listener=listener)

    def list_by(self, by: By) -> None:
        """Choose the rows of the report's CSV or Parquet file: one for each size, world, or run.

        Raises:
            InputError: if the study offers no choice.
        """
        raise checks.InputError(f"by {by} has no effect on a job of {self.verb}")

    # ------------------------------------------------------------ what a study says

    def identity(self) -> Identity:
        """Return the identity of the job: everything on which its report depends."""
        return Identity(
            verb=self.verb,
            parameters=self.parameters(),
            explorer=self.explorer(),
            shard=str(self.portion),
        )

    def parameters(self) -> dict[str, Any]:
        """Return all on which the report depends, except the explorer; by default all options."""
        return requests.meant(self.request)

    def explorer(self) -> dict[str, Any]:
        """Return the data that identify the explorer; by default there is no explorer."""
        return {"name": ""}

    def levels(self) -> Iterable[units.SweptLevel]:
        """Return the levels of the study, in their order."""
        assert self.extent is not None
        for edges in self.extent.levels:
            mine = units.units_of_level(self.extent, edges, self.portion, self.finer)
            yield units.SweptLevel(edges, units.level_size(self.extent, edges), mine)

    @abstractmethod
    def ready(self) -> ReadyEngine:
        """Return the engine that does units, and the transport that brings units to it."""

    def empty(self) -> Total:
        """Return an empty result, to which the results of units are added."""
        made: Total = self.result()
        return made

    def read(self, kept: Any) -> Total:
        """Return the result of a unit from its kept JSON value."""
        made: Total = from_kept(kept, self.result)
        return made

    @abstractmethod
    def finish(self, level: units.SweptLevel, total: Total) -> outcome.Ending | None:
        """Use ``total``, the sum of the results of a finished level.

        Return None if the job shall go on; else the ending with which it ends after this level.
        """

    @abstractmethod
    def report(self, ending: outcome.Ending) -> Answer:
        """Return the report of all finished levels; ``ending`` says how the job has ended."""

    def ended(self, ending: outcome.Ending, extent: classes.Extent | None = None) -> dict[str, Any]:
        """Return the arguments that every report gets: the ending, the request and the extent.

        ``extent`` is the extent that the report names; by default it is the sweep's own.
        """
        asked = doc.replace(requests.without_effort(self.request), listener=NOBODY)
        return {"ending": ending, "request": asked, "extent": extent or self.extent}

    def begin(self) -> outcome.Ending | None:
        """Prepare the first level; return None, or the ending if the job ends before this level."""
        return None

    def leave(self, level: units.SweptLevel, total: Total) -> None:
        """Take note of an unfinished level.

        ``total`` are the results of the units of it that are done.  By default they are dropped.
        """

    def conclude(self, ending: outcome.Ending) -> outcome.Ending | None:
        """Do the work after the last level; return a new ending, or None to keep ``ending``."""

    def costs(self, total: Total) -> Iterable[tuple[int, int, int]]:  # noqa: ARG002  # none
        """Return triples from ``total``: edges, vertices, and the largest cost in such worlds.

        By default there are no triples.
        """
        return ()

    # ------------------------------------------------------------ what a sweep does

    def answer(self, run: str | Path | None) -> Answer:
        """Do the job, and return its report.

        ``run`` is the directory in which finished units are kept, and from which those of an
        earlier command are read; None if no units are kept.

        Raises:
            InputError: if the directory is of another job, in use, damaged, or not writable.
        """
        if run is None and self.portion != units.WHOLE:
            self.listener.notice(
                "without --run DIR the report of this shard cannot be merged with others"
            )
        if run is None:
            return self._answered(NOTHING_KEPT, self._from_the_beginning)
        from allworlds.engines.run_directory import kept_in

        with kept_in(run, self.identity, self.listener.notice) as kept:
            return self._answered(kept, self._from_the_beginning)

    def merged(self, kept: KeptUnits) -> Answer:
        """Return the report of a job whose units are all in ``kept``; no unit is done again.

        Raises:
            Gap: if ``kept`` lacks a unit.
        """
        no_engine = ReadyEngine(ThisThread(), None)
        return self._answered(kept, lambda: self._swept(lambda: no_engine))

    def _answered(self, kept: KeptUnits, swept: Callable[[], outcome.Ending]) -> Answer:
        self.kept = kept
        ending = outcome.ended(swept)
        kept.note("ended", ENDED if ending.final else ending.reason)
        return self.report(ending)

    def _from_the_beginning(self) -> outcome.Ending:
        return self._guarded(self.begin) or self._swept(self.ready)

    def _swept(self, ready: Callable[[], ReadyEngine]) -> outcome.Ending:
        ending = self._guarded(lambda: self._through(ready)) or outcome.Completed()
        return self._guarded(lambda: self.conclude(ending)) or ending

    def _guarded(self, job: Callable[[], outcome.Ending | None]) -> outcome.Ending | None:
        """Call ``job``, a function that does a part of the work; return what it returns.

        The returned value is an ending, or None if the work goes on.  If ``job`` raises an
        exception that ends the work early, such as TimeIsUp, return the ending for this exception.
        """
        try:
            with limits.models_bounded(self.deadline):
                return job()
        except limits.TimeIsUp as up:
            limit = self.request.time_limit
            return outcome.Stopped(f"the time limit of {limit:g} s was reached{up}")
        except tally.EnginesDisagree as error:
            return outcome.Disagreed(str(error))
        except limits.ClusterLost as error:
            self.listener.notice(f"{error}; the report tells what was finished")
            return outcome.Stopped(str(error))
        except players.Unsettled as error:
            return outcome.Stopped(str(error))

    def _through(self, ready: Callable[[], ReadyEngine]) -> outcome.Ending | None:
        made, shards = ready(), self.portion.count
        drawn = list[units.Unit]()
        narrowed = None if made.engine is None else self.narrowed
        ending: outcome.Ending | None = None
        with made.transport as there, linux.compilers_ended():
            if self.extent is not None:
                units.tell_of_size(self.extent, self.listener, shards)
            for level in self.levels():
                self.listener.level(level.edges, level.worlds // shards)
                total, began = self.empty(), time.monotonic()
                try:
                    undone = self._undone(level, total, drawn)
                    gather(there, made.engine, undone, total, self.listener, self.kept, self.extent)
                    if level.edges >= SMALL:
                        ensure_same_worlds(narrowed, drawn, self.deadline)
                        drawn.clear()
                except BaseException:
                    self.leave(level, total)
                    raise
                self.seconds.append(time.monotonic() - began)
                ending = self.finish(level, total)
                if ending is not None:
                    break
            ensure_same_worlds(narrowed, drawn, self.deadline)
        return ending

    def _undone(
        self, level: units.SweptLevel, total: Total, drawn: list[units.Unit]
    ) -> Iterable[units.Unit]:
        """Yield the units of a level that were not finished before.

        The results of the units that an earlier command has finished are added to ``total``.  All
        units of a small level, and a random sample of the units of a larger level, are put into
        ``drawn``; on these the condition of the user is tested.
        """
        for number, unit in enumerate(level.units):
            if level.edges <= SMALL or number < DRAWN:
                drawn.append(unit)
            elif (spot := randrange(number + 1)) < DRAWN:  # noqa: S311  # any of them
                drawn[spot] = unit
            if not self._is_kept(unit, total):
                yield unit

    def _is_kept(self, unit: units.Unit, total: Total) -> bool:
        """Whether an earlier command has finished a unit; if so, add its result to ``total``."""
        result = self.kept.result(unit.key)
        if result is None:
            return False
        result = self.read(result)
        total.add(result)
        self.listener.progress(result.worlds)
        return True
