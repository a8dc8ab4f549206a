"""Every run of a foreign explorer played twice: in worlds, and against what was sensed there.

The second play is not in the order of the first, and, where the explorer can be played in other
processes, not in the process of the first nor in one that holds any world.  An explorer that
keeps something from one run to the next, or looks at anything but its percepts, does not play
the same way twice.  The orders are drawn anew for each check, and among the second plays are
some of worlds that came long before, so that nothing but its percepts tells an explorer which
world it is in.

What a player tells is believed of its runs alone.  Which they are, which choices each was asked
to make, and that none is left out, the referee knows by itself; the second play gets the choices
that were asked for, and not those that the first has told.

What the machine may have done is tried once more in fresh processes before it is believed: a
run that has cost its process its life, or that crashed, or was silent, in one of its plays alone.
"""

from __future__ import annotations

import secrets
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice
from random import Random
from typing import NamedTuple, Protocol

from allworlds.engines.python.examiner import (
    Outcome,
    Referee,
    difference_of,
    name_run,
    nondeterministic,
    overruled,
)
from allworlds.engines.python.play import Record
from allworlds.engines.python.python_engine import REPORT_EVERY, PythonEngine
from allworlds.engines.python.runs_of_unit import NumberedRun, UnitOfRuns
from allworlds.engines.python.tally import Tally
from allworlds.judging import Episode, Fault, Log, LostRun, retold
from allworlds.protocol import DEFAULT_POLICY, next_script
from allworlds.world import IllegalAction, World

FEW, MANY = 16, 1024
"""The least and the greatest number of runs among which the order is drawn."""

ENOUGH, BEGINNING = 32, 128
"""So many second plays leave an explorer that goes by their number no chance; and so many are the
beginning of a check, in which even a unit of one run is played often enough."""


OTHER_CHOICES = (
    "the choices of one schedule are not those of the next, as far as they are asked for"
)


FIRST, KEPT = 64, 256
"""So many plays are kept to be played again among later ones; of these the first, for good."""


class Players(Protocol):
    """Who plays; in this process, or in others that may be lost."""

    def first(
        self,
        examination: PythonEngine,
        unit: UnitOfRuns,
        numbers: Sequence[int],
        script: tuple[int, ...] | None = None,
    ) -> Iterator[list[tuple[int, Log]]]:
        """The logs of these runs of the unit, some at a time, each with its number.

        Of a run that cost its process its life, twice, there is one log, with that fault.
        """

    def send_records(self, records: Sequence[Record], policy: str) -> None:
        """Begin to play these once more, in another order, against what was sensed."""

    def receive_logs(self) -> list[Log]:
        """The logs of what was asked for, in the order of the records."""

    def renew(self) -> None:
        """Go on in fresh processes."""


@dataclass(frozen=True, slots=True)
class OneRun:
    """A run of a unit: its number there, the number of its place, and its world."""

    number: int
    place: int
    world: World


@dataclass(slots=True)
class ScriptTracker:
    """How far each run has been told: by one log, or by one for each schedule.

    Attributes:
        every: every schedule is asked for.
        scripts: for each run the first choices of its next log, all others being 0 where
            every schedule is asked for; None behind the last.
    """

    every: bool
    scripts: dict[int, tuple[int, ...] | None]

    def take(self, number: int, log: Log) -> tuple[tuple[int, ...], bool]:
        """The script of the next log of a run, and whether this is its log.

        Raises:
            RuntimeError: if the run has no more logs.
        """
        script = self.scripts.get(number)
        if script is None:
            raise RuntimeError(f"a player has told more of run {number} than it was asked for")
        if isinstance(log.ending, LostRun) or not self.every:
            self.scripts[number] = None
            return script, True
        length = max(len(script), len(log.choices))
        due = (script + (0,) * length)[:length]
        self.scripts[number] = next_script(log.choices, log.widths)
        return script, log.choices == due and len(log.widths) == len(log.choices)

    def finish(self) -> None:
        """Nothing is left.

        Raises:
            RuntimeError: if a run has not been told to its end.
        """
        left = [number for number, script in self.scripts.items() if script is not None]
        if left:
            raise RuntimeError(f"a player has told that run {left[0]} is done, and not how")


class _Play(NamedTuple):
    """A first play, retold in its world, with what is needed to play it again.

    ``fits``: it made the choices that it was asked to make.
    """

    one: OneRun
    log: Log
    episode: Episode
    record: Record
    fits: bool


@dataclass(slots=True)
class Earlier:
    """Plays that were the same twice, to be played again among those of other units and levels.

    Otherwise one who counts the second plays would know which level they come from.

    Attributes:
        random: from which it is drawn which.
    """

    random: Random = field(default_factory=lambda: Random(secrets.randbits(64)))  # noqa: S311
    _plays: list[_Play] = field(default_factory=list)
    _taken: int = 0

    def some(self, plays: int) -> list[_Play]:
        """Some of them, to go with so many others; at the beginning of a check more."""
        least = FEW if self._taken < BEGINNING else FEW // 4
        wanted = min(max(least, plays // FEW), len(self._plays))
        self._taken += wanted
        return self.random.sample(self._plays, wanted)

    def keep(self, play: _Play) -> None:
        """Keep one; what is kept beyond the first gives way to it."""
        if len(self._plays) < KEPT:
            self._plays.append(play)
        else:
            self._plays[self.random.randrange(FIRST, KEPT)] = play


@dataclass(slots=True)
class PlayedTwice:
    """The engine for a foreign explorer."""

    examination: PythonEngine
    explorer: str
    players: Players
    earlier: Earlier = field(default_factory=Earlier)
    _belated: list[tuple[OneRun, Outcome]] = field(default_factory=list)
    _window: int = FEW
    _again: int = 0
    _referee: Referee = field(init=False)

    def __post_init__(self) -> None:
        self._referee = Referee(self.explorer, self.examination.scope.rules)

    def parts(self, unit: UnitOfRuns, start: int = 0) -> Iterator[tuple[int, Tally]]:
        """After some runs, and at the end, the number of the next run and the tally since."""
        runs = self.examination.runs(unit, start)
        after = start
        while window := list(islice(runs, self._window)):
            began = time.monotonic()
            yield (after := window[-1].number + 1), self.tally(unit, window)
            slow = time.monotonic() - began > REPORT_EVERY / 2
            self._window = max(FEW, self._window // 2) if slow else min(MANY, self._window * 2)
        if after == start:
            yield after, self.examination.tally()

    def tally(self, unit: UnitOfRuns, window: Sequence[NumberedRun]) -> Tally:
        """What comes of these runs of a unit."""
        tally = self.examination.tally()
        placed = {}
        for run in window:
            world = self.examination.count_run(run, tally)
            if world is not None:
                placed[run.number] = OneRun(run.number, run.place, world)

        def matters(one: OneRun) -> bool:
            return tally.wants(one.world.map.edge_count, one.world.map.vertex_count)

        for one, outcome in self.outcomes(unit, placed, matters, tally.remark):
            if isinstance(outcome, Outcome):
                self.examination.count_outcome(self._referee, one.world, one.place, outcome, tally)
            elif matters(one):
                tally.find(self._referee.lost(one.world, one.place, outcome))
        for one, outcome in self._belated:
            if matters(one):
                tally.find(self._referee.finding(one.world, one.place, outcome))
        self._belated.clear()
        return tally

    def outcomes(
        self,
        unit: UnitOfRuns,
        placed: Mapping[int, OneRun],
        matters: Callable[[OneRun], bool] = lambda _: True,
        remark: Callable[[str], None] = lambda _: None,
        given: tuple[int, ...] | None = None,
    ) -> Iterator[tuple[OneRun, Outcome | LostRun]]:
        """What comes of these runs of a unit, by their numbers, in any order.

        Args:
            unit: the unit.
            placed: the runs.
            matters: whether it is worth while to try a run once more in fresh processes.
            remark: takes what happened and refutes nothing.
            given: the choices to be made; None for every schedule that the scope asks for.
        """
        told = ScriptTracker(self._every and given is None, dict.fromkeys(placed, given or ()))
        for logs in self.players.first(self.examination, unit, [*placed], given):
            whole = []
            for number, log in logs:
                script, fits = told.take(number, log)
                if isinstance(log.ending, LostRun):
                    yield placed[number], log.ending
                else:
                    whole.append(self._play(placed[number], log, script, fits))
            records = [play.record for play in whole]
            earlier = self.earlier.some(len(records))
            # What ended in a fault is played again once: a silence need not be heard out for ever.
            lively = [i for i, play in enumerate(whole) if not isinstance(play.log.ending, Fault)]
            rounds = self._rounds(len(lively), len(earlier))
            order = [*range(len(records)), *lively * (rounds - 1)]
            asked = [*(records[i] for i in order), *(play.record for play in earlier)]
            self.players.send_records(asked, self._policy)
            outcomes = [
                self._referee.outcome(play.one.world, play.episode, play.log.choices)
                for play in whole
            ]
            again = self.players.receive_logs()
            self._look_back(earlier, again[len(order) :])
            seconds: dict[int, list[Log]] = {i: [] for i in range(len(whole))}
            for i, log in zip(order, again, strict=False):
                seconds[i].append(log)
            for i, (play, outcome) in enumerate(zip(whole, outcomes, strict=True)):
                second = _another(play.log, seconds[i])
                if not play.fits:
                    yield play.one, replace(outcome, violation=nondeterministic(OTHER_CHOICES))
                elif _may_be_the_machine(play.log, second) and matters(play.one):
                    yield play.one, self._once_more(unit, play, remark)
                else:
                    settled = overruled(outcome, play.log, second)
                    if settled.violation is None:
                        self.earlier.keep(play)
                    yield play.one, settled
        told.finish()

    @property
    def _every(self) -> bool:
        return self.examination.scope.schedules == "all"

    @property
    def _policy(self) -> str:
        """Who answers the choices that no script answers."""
        return DEFAULT_POLICY if self._every else self.examination.scope.rules.policy

    def _look_back(self, plays: list[_Play], again: list[Log]) -> None:
        """What earlier plays have become by now; if the machine can have done it, it is nothing."""
        for play, log in zip(plays, again, strict=True):
            if difference_of(play.log, log) and not _may_be_the_machine(play.log, log):
                outcome = self._referee.outcome(play.one.world, play.episode, play.log.choices)
                self._belated.append((play.one, overruled(outcome, play.log, log)))

    def _rounds(self, records: int, others: int) -> int:
        """How often these records are to be played: of few, one order may be as good as another."""
        if not records:
            return 1
        wanted = max(ENOUGH - self._again - others, FEW if self._again < BEGINNING else 1)
        rounds = -(-wanted // records)
        self._again += rounds * records
        return rounds

    def _play(self, one: OneRun, log: Log, script: tuple[int, ...], fits: bool = True) -> _Play:
        rules, world = self.examination.scope.rules, one.world
        try:
            episode = retold(log, world)
        except IllegalAction as error:
            raise RuntimeError(f"the log of a run is no walk in its world: {error}") from error
        record = Record(
            tuple(episode.transcript.percepts),
            world.told,
            script,
            rules.budget(world.map),
            name_run(rules, world),
        )
        return _Play(one, log, episode, record, fits)

    def _once_more(
        self, unit: UnitOfRuns, before: _Play, remark: Callable[[str], None]
    ) -> Outcome | LostRun:
        """The run played anew, both times in fresh processes."""
        one = before.one
        # A player that is given a script lets the rules' policy answer what it does not.
        script = before.log.choices if self._every else before.record.choices
        self.players.renew()
        (((_, log),),) = self.players.first(self.examination, unit, [one.number], script)
        if isinstance(log.ending, LostRun):
            return log.ending
        play = self._play(one, log, script)
        self.players.send_records([play.record], self._policy)
        (second,) = self.players.receive_logs()
        if not _may_be_the_machine(log, second) and log.ending != before.log.ending:
            remark(f"a run ended otherwise when it was tried again; at first: {_how(before.log)}")
        outcome = self._referee.outcome(one.world, play.episode, log.choices)
        return overruled(outcome, log, second)


def _another(first: Log, again: Sequence[Log]) -> Log:
    """The first of the later plays that differs, if one does."""
    return next((log for log in again if difference_of(first, log)), again[0])


def _may_be_the_machine(first: Log, second: Log) -> bool:
    """One play ended in a way that is not always the explorer's own, and the other did not."""
    endings = (first.ending, second.ending)
    suspicious = any(isinstance(end, Fault) and end.machine for end in endings)
    return suspicious and difference_of(first, second) is not None


def _how(log: Log) -> str:
    return log.ending.seen if isinstance(log.ending, Fault) else "it ended with an answer"
