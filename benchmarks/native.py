"""The cost of a run of a native explorer in the compiled engine, part by part.

    python benchmarks/native.py LIBRARY [--edges M] [--units N] [--explore PROGRAM]

Runs are laid out, played, judged, played again and compared as in a lane, but all in this process;
a check also needs processes, which send each other the messages.  In the same units of work, two
other costs are measured.  A loop in C plays the explorer twice and does nothing else, which no
judge can do without.  The Python engine plays the built-in explorer once; so the whole is also told
without the second play.  PROGRAM is a yardstick: it is called with ``0 M`` and prints the number of
worlds (``leaves``).  All times are processor times, in microseconds a run, or for the yardstick a
world.
"""

from __future__ import annotations

import argparse
import ctypes
import re
import resource
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import allworlds.explorers.shared_library
from allworlds.engines.batch import Work
from allworlds.engines.compiled_engine import load_native
from allworlds.engines.compiled_judge import CompiledBatch, CompiledJudge
from allworlds.engines.judge import PythonJudge
from allworlds.engines.kernel.arrays import LONGEST_STRETCH, RUN_TOLD
from allworlds.engines.kernel.library_player import LibraryPlayer
from allworlds.engines.players import Logs
from allworlds.engines.tally import RunCounter
from allworlds.engines.units import Scope, units_of_level
from allworlds.explorers.loading import load
from allworlds.explorers.shared_library import ROOM, Library, NativeExplorer
from allworlds.judging.referee import Examiner
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.protocol.choices import Choices
from allworlds.world import World

PARTS = ("laid out", "first play", "judged", "second play", "compared")
SECOND = PARTS.index("second play")
SAMPLED = 40
"""In so many units, evenly spaced, the Python engine plays the runs."""


class Bare:
    """A library that is played without anybody who looks on.

    Args:
        path: of the library.
        folder: where the loop is built.
    """

    def __init__(self, path: str, folder: str) -> None:
        source, loop = Path(__file__).with_name("bare.c"), Path(folder) / "bare.so"
        include = str(Path(allworlds.explorers.shared_library.__file__).parent)
        command = ["cc", "-O2", "-shared", "-fPIC", "-I", include, "-o", str(loop), str(source)]
        subprocess.run(command, check=True)
        self._play = ctypes.CDLL(str(loop)).play
        self._play.restype = ctypes.c_long
        library = Library(path)
        self._explorer = (ctypes.c_void_p * 5)(*library.addresses(), library.new())
        self._room = [(ctypes.c_int32 * ROOM)() for _ in range(2)]

    def play(self, batch: CompiledBatch) -> int:
        """The number of traversals of the runs of a batch."""
        heads, worlds = batch.heads, batch.tables
        sizes = ctypes.c_long(len(batch)), ctypes.c_long(worlds.shape[1])
        told = ctypes.c_void_p(heads[:, RUN_TOLD:].ctypes.data)
        apart = ctypes.c_long(heads.shape[1])
        tables = ctypes.c_void_p(worlds.ctypes.data)
        return int(self._play(self._explorer, *sizes, tables, told, apart, ROOM, *self._room))


class Measured:
    """The time that each part takes, over all units.

    Args:
        library: the path of the explorer.
        edges: of the level.
        folder: where a loop in C is built.
    """

    def __init__(self, library: str, edges: int, folder: str) -> None:
        self.scope = Scope(
            Extent(MapClass.MAPS, edges, None), Rules("directional", own_bound="paper")
        )
        self.counter = RunCounter(self.scope, keep=1)
        python = PythonJudge(self.counter, "native:")
        self.judge = CompiledJudge(python, lambda: 0, native=True)
        explorers = [NativeExplorer(Library(library)) for _ in range(2)]
        self.players = [LibraryPlayer(explorer, bytearray(16)) for explorer in explorers]
        self.bare = Bare(library, folder)
        load_native()
        self.spent = dict.fromkeys((*PARTS, "bare"), 0.0)
        self.runs = 0

    def timed(self, part: str, work: Callable[[], Any]) -> Any:
        """The result of the work, whose time is added to that part."""
        start = time.process_time()
        done = work()
        self.spent[part] += time.process_time() - start
        return done

    def one_by_one(self, unit: Any) -> None:
        """Play every run of a unit by itself, twice, and once more by a loop in C."""
        timed, work, walked = self.timed, Work(unit, self.counter.tally()), 0
        batches = self.judge.batches(work, lambda: LONGEST_STRETCH)
        while batch := timed("laid out", lambda: next(batches, None)):
            rows = range(len(batch))
            first = timed("first play", lambda b=batch, r=rows: self.played(0, b.by.worlds(b, r)))
            batch.logs[0] = first
            good = timed("judged", lambda b=batch: self.judge.judge(b))
            second = timed(
                "second play", lambda b=batch, r=rows: self.played(1, b.by.percepts(b, r, r))
            )
            if not good or batch.broken or first.message != second.message:
                raise SystemExit("a law is broken: this measures nothing")
            timed("compared", lambda a=first, b=second: a.message == b.message)
            work.tally.add(batch.tally)
            walked += timed("bare", lambda b=batch: self.bare.play(b))
            self.runs += len(batch)
        assert walked == sum(row.traversals for row in work.tally.rows.values())

    def played(self, which: int, message: dict[str, Any]) -> Logs:
        """The logs that answer a message."""
        content = self.players[which].play(message)
        if content is None:
            raise SystemExit("logs do not fit: this measures nothing")
        return Logs(b"".join(map(bytes, content)), message["runs"])

    def cost(self, *parts: str) -> float:
        """Microseconds a run of these parts."""
        return sum(self.spent[part] for part in parts) / self.runs * 1e6


def main() -> None:
    """Measure one level."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("library")
    parser.add_argument("--edges", type=int, default=6)
    parser.add_argument("--units", type=int, default=1 << 30, help="the first so many alone")
    parser.add_argument("--explore", metavar="PROGRAM")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        measured = Measured(given.library, given.edges, folder)
    units = list(units_of_level(measured.scope.extent, given.edges))[: given.units]
    measured.one_by_one(units[0])  # both judges are compared on the first runs
    measured.spent, measured.runs = dict.fromkeys(measured.spent, 0.0), 0
    for unit in units:
        measured.one_by_one(unit)
    whole, once = measured.cost(*PARTS), measured.cost(*PARTS[:SECOND])
    bare = 2 * measured.cost("bare")
    for part in PARTS:
        print(f"{part:18} {measured.cost(part):6.2f}")
    runs = measured.runs
    print(f"{'all':18} {whole:6.2f} microseconds a run, {runs:,} runs; played once {once:.2f}")
    print(f"{'bare':18} {bare:6.2f} two plays in C and nothing else")
    python = python_engine(measured.counter, units)
    print(f"{'Python':18} {python:6.0f} the Python engine: {python / whole:.0f} times as much,")
    print(f"{'':25} {python / once:.0f} times one play, {python / bare:.0f} times the bare ones")
    if given.explore:
        world = yardstick(given.explore, given.edges)
        ratios = f"{world / whole:.3f} runs for each of its worlds, {world / once:.3f} played once"
        print(f"{'yardstick':18} {world:6.3f} {ratios}")


def python_engine(counter: RunCounter, units: list[Any]) -> float:
    """Microseconds a run of the built-in explorer, in a sample of the units."""
    examiner = Examiner(load("algorithm1"), counter.scope.rules)
    sampled = units[:: -(-len(units) // SAMPLED)]
    worlds = [
        World(run.map, run.lighthouse, 0)
        for unit in sampled
        for run in counter.runs(unit)
        if run.lighthouse is not None
    ]
    start = time.process_time()
    for world in worlds:
        examiner.examine(world, Choices())
    return (time.process_time() - start) / len(worlds) * 1e6


def yardstick(program: str, edges: int) -> float:
    """Microseconds for each of its worlds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    said = subprocess.run([program, "0", str(edges)], check=True, capture_output=True, text=True)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    (worlds,) = re.findall(r"leaves (\d+)", said.stdout)
    return seconds / int(worlds) * 1e6


if __name__ == "__main__":
    main()
