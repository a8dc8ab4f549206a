"""The cost of a run of a native explorer in the compiled engine, part by part.

    python benchmarks/native.py LIBRARY [--edges M] [--units N] [--explore PROGRAM]

Runs are laid out, played, judged, played again and compared, all in this process; a check also
needs messages and processes.  In the same units of work, two other costs are measured.  A loop in C
plays the explorer twice and does nothing else, which no judge can do without.  The Python engine
plays the built-in explorer once; so the whole is also told without the second play.  PROGRAM is a
yardstick: it is called with ``0 M`` and prints the number of worlds (``leaves``).  All times are
processor times, in microseconds a run, or for the yardstick a world.
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

from allworlds.engines.isolation.jobs import PlayStretch
from allworlds.engines.isolation.library_player import LibraryPlayer
from allworlds.engines.isolation.shared_logs import StretchMemory

import allworlds.explorers.shared_library
from allworlds.engines import PythonEngine, Scope
from allworlds.engines.compiled.requests import level_of
from allworlds.engines.kernel.batches import UnitJudge, load_native
from allworlds.engines.kernel.stretch import LONGEST_STRETCH, RUN_TOLD, Stretch
from allworlds.explorers import NativeExplorer, load
from allworlds.explorers.shared_library.library import ROOM, Library
from allworlds.judging import Rules
from allworlds.maps import Extent, MapClass

PARTS = ("laid out", "first play", "judged", "second play", "compared")
SECOND = PARTS.index("second play")
SAMPLED = 40
"""In so many units, evenly spaced, the Python engine plays the first runs."""


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
        addresses = library.addresses()
        names = ("start", "step", "answer", "choose")
        self._explorer = (ctypes.c_void_p * 5)(*(addresses[name] for name in names), library.new())
        self._room = [(ctypes.c_int32 * ROOM)() for _ in range(2)]

    def play(self, stretch: Stretch, runs: int) -> int:
        """The number of traversals of so many runs that have been laid out."""
        heads, worlds = stretch.heads, stretch.worlds
        sizes = ctypes.c_long(runs), ctypes.c_long(worlds.shape[1])
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
        self.edges = edges
        rules = Rules("directional", own_bound="paper")
        extent = Extent(MapClass.MAPS, edges, None)
        self.scope = Scope(extent, rules)
        self.level = level_of("native:", rules, extent, edges)
        self.memory = [StretchMemory(edges) for _ in range(2)]
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

    def one_by_one(self, prefix: tuple[int, ...]) -> None:
        """Play every run of a unit by itself, twice, and once more by a loop in C."""
        memory, players, timed = self.memory, self.players, self.timed
        judge = UnitJudge(self.level, prefix, 1, *(each.stretch for each in memory))
        laid = None
        while laid is None or not laid.last:
            laid = timed("laid out", lambda: judge.lay_out(LONGEST_STRETCH))
            jobs = [
                PlayStretch(each.file, self.edges, laid.runs, again, "fifo", again=bool(again))
                for again, each in enumerate(memory)
            ]
            size = timed("first play", lambda job=jobs[0]: players[0].play(job)).size
            rows, good = timed("judged", lambda a=laid, s=size: judge.judge(a, s))
            size = timed("second play", lambda job=jobs[1]: players[1].play(job)).size
            if not good or rows.broken or judge.differing(size):
                raise SystemExit("a law is broken: this measures nothing")
            timed("compared", lambda s=size: judge.differing(s))
            walked = timed("bare", lambda n=laid.runs: self.bare.play(memory[0].stretch, n))
            assert walked == sum(row.traversals for row in rows.counts)
            self.runs += laid.runs

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
    units = list(measured.scope.units(given.edges))[: given.units]
    for unit in units:
        measured.one_by_one(unit.prefix)
    whole, once = measured.cost(*PARTS), measured.cost(*PARTS[:SECOND])
    bare = 2 * measured.cost("bare")
    for part in PARTS:
        print(f"{part:18} {measured.cost(part):6.2f}")
    runs = measured.runs
    print(f"{'all':18} {whole:6.2f} microseconds a run, {runs:,} runs; played once {once:.2f}")
    print(f"{'bare':18} {bare:6.2f} two plays in C and nothing else")
    python = python_engine(measured.scope, units)
    print(f"{'Python':18} {python:6.0f} the Python engine: {python / whole:.0f} times as much,")
    print(f"{'':25} {python / once:.0f} times one play, {python / bare:.0f} times the bare ones")
    if given.explore:
        world = yardstick(given.explore, given.edges)
        ratios = f"{world / whole:.3f} runs for each of its worlds, {world / once:.3f} played once"
        print(f"{'yardstick':18} {world:6.3f} {ratios}")


def python_engine(scope: Scope, units: list[Any]) -> float:
    """Microseconds a run of the built-in explorer, in a sample of the units."""
    engine = PythonEngine(scope, 1).for_built_in(load("algorithm1"))
    start, runs = time.process_time(), 0
    for unit in units[:: -(-len(units) // SAMPLED)]:
        _, tally = next(iter(engine.parts(unit)))
        runs += tally.runs
    return (time.process_time() - start) / runs * 1e6


def yardstick(program: str, edges: int) -> float:
    """Microseconds for each of its worlds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    said = subprocess.run([program, "0", str(edges)], check=True, capture_output=True, text=True)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    (worlds,) = re.findall(r"leaves (\d+)", said.stdout)
    return seconds / int(worlds) * 1e6


if __name__ == "__main__":
    main()
