"""What a run of a native explorer costs in the compiled engine, part by part.

    python benchmarks/native.py LIBRARY [--edges M] [--units N] [--explore PROGRAM]

Laid out, played, judged, played again and compared: all in this process; messages and processes
come on top.  Beside it stand, in the same units of work: the explorer played twice by a loop in C
and nothing else, which is what no judge can do without, and the Python engine with the built-in
explorer, which plays once; so the whole is also told without the second play.  PROGRAM is a
yardstick that is called with ``0 M`` and prints how many worlds there are (``leaves``).  Printed
is processor time, in microseconds a run.
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
from allworlds.engines import PythonEngine, Scope
from allworlds.engines.compiled.requests import level_of
from allworlds.engines.isolation.jobs import PlayStretch
from allworlds.engines.isolation.shared_logs import LibraryPlayer, StretchMemory
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


def main() -> None:
    """Measure one level."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("library")
    parser.add_argument("--edges", type=int, default=6)
    parser.add_argument("--units", type=int, default=1 << 30, help="the first so many alone")
    parser.add_argument("--explore", metavar="PROGRAM")
    given = parser.parse_args()
    rules = Rules("directional", own_bound="paper")
    extent = Extent(MapClass.MAPS, given.edges, None)
    scope = Scope(extent, rules)
    units = list(scope.units(given.edges))[: given.units]
    level = level_of("native:", rules, extent, given.edges)
    memory = [StretchMemory(given.edges) for _ in range(2)]
    explorers = [NativeExplorer(Library(given.library)) for _ in range(2)]
    players = [LibraryPlayer(explorer, bytearray(16)) for explorer in explorers]
    load_native()
    spent, runs = dict.fromkeys((*PARTS, "bare"), 0.0), 0

    def timed(part: str, work: Callable[[], Any]) -> Any:
        start = time.process_time()
        done = work()
        spent[part] += time.process_time() - start
        return done

    with tempfile.TemporaryDirectory() as folder:
        bare = Bare(given.library, folder)
    for unit in units:
        judge = UnitJudge(level, unit.prefix, 1, *(each.stretch for each in memory))
        laid = None
        while laid is None or not laid.last:
            laid = timed("laid out", lambda judge=judge: judge.lay_out(LONGEST_STRETCH))
            jobs = [
                PlayStretch(each.file, given.edges, laid.runs, again, "fifo", again=bool(again))
                for again, each in enumerate(memory)
            ]
            size = timed("first play", lambda job=jobs[0]: players[0].play(job)).size
            rows, good = timed("judged", lambda j=judge, a=laid, s=size: j.judge(a, s))
            size = timed("second play", lambda job=jobs[1]: players[1].play(job)).size
            if not good or rows.broken or judge.differing(laid, size):
                raise SystemExit("a law is broken: this measures nothing")
            timed("compared", lambda j=judge, a=laid, s=size: j.differing(a, s))
            walked = timed("bare", lambda n=laid.runs: bare.play(memory[0].stretch, n))
            assert walked == sum(row.traversals for row in rows.counts)
            runs += laid.runs
    cost = {part: seconds / runs * 1e6 for part, seconds in spent.items()}
    for part in PARTS:
        print(f"{part:12} {cost[part]:6.2f}")
    whole, once = (sum(cost[part] for part in parts) for parts in (PARTS, PARTS[:SECOND]))
    print(f"{'all':12} {whole:6.2f} microseconds a run, {runs:,} runs; played once {once:.2f}")
    print(f"{'bare':12} {2 * cost['bare']:6.2f} two plays in C and nothing else")
    python = python_engine(scope, units)
    bares = python / 2 / cost["bare"]
    print(f"{'Python':12} {python:6.0f} the Python engine: {python / whole:.0f} times as much,")
    print(f"{'':12}        {python / once:.0f} times one play, {bares:.0f} times the two bare ones")
    if given.explore:
        world = yardstick(given.explore, given.edges)
        ratios = f"{world / whole:.3f} runs for each of its worlds, {world / once:.3f} played once"
        print(f"{'yardstick':12} {world:6.3f} {ratios}")


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
