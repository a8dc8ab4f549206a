"""The cost of a schedule of a native explorer in the compiled engine, beside the Python engine.

    python benchmarks/schedules.py LIBRARY [--edges M] [--rounds N]

Every schedule of every run of a level is played, judged, played again and compared, in this
process; a check also needs messages and processes.  The Python engine plays the first runs of each
unit, once.  All times are processor times, in microseconds a schedule; the median of the rounds,
with the least and the greatest.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from statistics import median
from typing import Any

from allworlds.engines import PythonEngine, Scope
from allworlds.engines.compiled.requests import level_of
from allworlds.engines.isolation.jobs import DueSchedules, PlayStretch
from allworlds.engines.isolation.library_player import LibraryPlayer
from allworlds.engines.isolation.shared_logs import StretchMemory
from allworlds.engines.kernel.schedule_judge import ScheduleJudge, load_every_schedule
from allworlds.engines.kernel.stretch import LONGEST_STRETCH
from allworlds.explorers import NativeExplorer, load
from allworlds.explorers.shared_library.library import Library
from allworlds.judging import Rules
from allworlds.maps import Extent, MapClass

PARTS = ("laid out", "first play", "judged", "second play", "compared")


class Round:
    """The processor time of each part, in a level.

    Args:
        library: of the explorer.
        scope: of the check.
        edges: of the level.
    """

    def __init__(self, library: str, scope: Scope, edges: int) -> None:
        self.scope, self.edges = scope, edges
        self.memory = [StretchMemory(edges) for _ in range(2)]
        explorers = [NativeExplorer(Library(library)) for _ in range(2)]
        self.players = [LibraryPlayer(explorer, bytearray(16)) for explorer in explorers]
        self.spent = dict.fromkeys(PARTS, 0.0)
        self.schedules = 0
        for unit in scope.units(edges):
            self.unit(unit.prefix)
        for memory in self.memory:
            memory.close()

    def timed(self, part: str, work: Callable[[], Any]) -> Any:
        """The result of the work, whose time is added to that part."""
        start = time.process_time()
        done = work()
        self.spent[part] += time.process_time() - start
        return done

    def unit(self, prefix: tuple[int, ...]) -> None:
        """Play every schedule of a unit, twice."""
        level = level_of("native:", self.scope.rules, self.scope.extent, self.edges)
        judge = ScheduleJudge(level, prefix, 1, *(each.stretch for each in self.memory))
        laid = None
        while laid is None or not laid.last:
            laid = self.timed("laid out", lambda: judge.lay_out(LONGEST_STRETCH))
            while not judge.is_done(laid):
                self.portion(judge, laid)

    def portion(self, judge: ScheduleJudge, laid: Any) -> None:
        """Play one portion of a stretch, twice."""
        (first, second), timed = self.memory, self.timed
        due = DueSchedules(*judge.next, LONGEST_STRETCH)
        job = PlayStretch(first.file, self.edges, laid.runs, 0, "fifo", again=False, schedules=due)
        size = timed("first play", lambda: self.players[0].play(job)).size
        rows, good = timed("judged", lambda: judge.judge(laid, size))
        again = PlayStretch(
            second.file, self.edges, judge.logs, 1, "fifo", again=True, schedules=due
        )
        size = timed("second play", lambda: self.players[1].play(again)).size
        if not good or rows.broken or timed("compared", lambda: judge.differing(size)):
            raise SystemExit("a law is broken: this measures nothing")
        self.schedules += judge.logs

    def cost(self, *parts: str) -> float:
        """Microseconds a schedule of these parts."""
        return sum(self.spent[part] for part in parts) / self.schedules * 1e6


def main() -> None:
    """Measure one level."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("library")
    parser.add_argument("--edges", type=int, default=4)
    parser.add_argument("--rounds", type=int, default=5)
    given = parser.parse_args()
    rules = Rules("directional", own_bound="paper")
    scope = Scope(Extent(MapClass.MAPS, given.edges, None), rules, schedules="all")
    load_every_schedule()
    Round(given.library, scope, min(given.edges, 2))  # what is loaded only once
    rounds, pythons = [], []
    for _ in range(given.rounds):
        rounds.append(Round(given.library, scope, given.edges))
        pythons.append(python_engine(given.library, scope, given.edges))
    for part in PARTS:
        told(part, [each.cost(part) for each in rounds])
    told("all", [each.cost(*PARTS) for each in rounds], f", {rounds[0].schedules:,} schedules")
    told("Python, one play", pythons)
    ratios = [slow / each.cost(*PARTS) for slow, each in zip(pythons, rounds, strict=True)]
    told("times as much", ratios)


def told(name: str, values: list[float], more: str = "") -> None:
    """Print the median of the values, with the least and the greatest."""
    spread = f"({min(values):.2f} to {max(values):.2f})"
    print(f"{name:18} {median(values):8.2f} {spread}{more}")


def python_engine(library: str, scope: Scope, edges: int) -> float:
    """Microseconds a schedule in the Python engine, in the first runs of each unit."""
    engine = PythonEngine(scope, 1).for_built_in(load(f"native:{library}"))
    start, schedules = time.process_time(), 0
    for unit in scope.units(edges):
        _, tally = next(iter(engine.parts(unit)))
        schedules += sum(row.episodes for row in tally.rows.values())
    return (time.process_time() - start) / schedules * 1e6


if __name__ == "__main__":
    main()
