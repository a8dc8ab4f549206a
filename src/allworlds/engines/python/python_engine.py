"""All runs of a unit: the loop of the exhaustive check."""

from __future__ import annotations

import time
from collections.abc import Iterator, MutableSequence

from msgspec import Struct

from allworlds.engines.python.examiner import Examiner, name_run
from allworlds.engines.python.players import Players
from allworlds.engines.python.run_counter import REPORT_EVERY, PartwiseEngine, RunCounter
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.python.second_play import PlayedTwice
from allworlds.engines.python.tally import Tally
from allworlds.explorers import Subject


class PythonEngine(RunCounter, frozen=True):
    """The engine in which every run of a unit is played, judged and tallied in Python."""

    def for_built_in(
        self, subject: Subject, beat: MutableSequence[int] | None = None
    ) -> PartwiseEngine:
        """The engine with a built-in explorer, which is played in this process, and once.

        Args:
            subject: the explorer.
            beat: see :func:`allworlds.judging.episode.play`.
        """
        return BoundPythonEngine(self, subject, beat)

    def for_users(self, explorer: str, players: Players) -> PartwiseEngine:
        """The engine with the user's explorer of that name, which plays every run twice."""
        return PlayedTwice(self, explorer, players)


class BoundPythonEngine(Struct, frozen=True):
    """The Python engine with a built-in explorer, which is played in this process, and once."""

    engine: PythonEngine
    subject: Subject
    beat: MutableSequence[int] | None = None

    def parts(self, unit: UnitOfRuns, start: int = 0) -> Iterator[tuple[int, Tally]]:
        """Yield the number of the next run and the tally since, after some time and at the end."""
        engine, scope = self.engine, self.engine.scope
        examiner = Examiner(self.subject, scope.rules, self.beat)
        tally, after = engine.tally(), start
        due = time.monotonic() + REPORT_EVERY
        for run in engine.runs(unit, start):
            after = run.number + 1
            world = engine.count_run(run, tally)
            if world is not None:
                costs = []
                for choices in scope.schedule(name_run(scope.rules, world)):
                    outcome = examiner.examine(world, choices)
                    engine.count_outcome(examiner, world, run.place, outcome, tally)
                    costs.append(outcome.cost)
                engine.count_best(world, min(costs), tally)
                tally.witnesses.update(examiner.events)
                examiner.events.clear()
            if time.monotonic() > due:
                yield after, tally
                tally = engine.tally()
                due = time.monotonic() + REPORT_EVERY
        yield after, tally
