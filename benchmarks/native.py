"""What a run of a native explorer costs in the compiled engine, part by part.

    python benchmarks/native.py LIBRARY [--edges M]

Everything is done in this process: laid out, played, judged, played again, compared.  Printed is
the processor time a run, in microseconds, of each part; messages and processes come on top.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from typing import Any

from allworlds import kernel
from allworlds.checker.questions import level_of
from allworlds.findings import make_rules
from allworlds.isolation.jobs import PlayStretch
from allworlds.isolation.stretches import Actor, Shared
from allworlds.libraries import Library, NativeExplorer
from allworlds.maps.classes import Extent, MapClass
from allworlds.work import units_of_level

PARTS = ("laid out", "first play", "judged", "second play", "compared")


def main() -> None:
    """Measure one level."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("library")
    parser.add_argument("--edges", type=int, default=6)
    given = parser.parse_args()
    rules = make_rules({}, "directional", "paper")
    extent = Extent(MapClass.MAPS, given.edges, None)
    level = level_of("native:", rules, extent, given.edges)
    memory = [Shared(given.edges) for _ in range(2)]
    actors = [Actor(NativeExplorer(Library(given.library)), bytearray(16)) for _ in range(2)]
    kernel.load_native()
    spent, runs = dict.fromkeys(PARTS, 0.0), 0

    def timed(part: str, work: Callable[[], Any]) -> Any:
        start = time.process_time()
        done = work()
        spent[part] += time.process_time() - start
        return done

    for unit in units_of_level(extent, given.edges):
        judge = kernel.UnitJudge(level, unit.prefix, 1, *(each.stretch for each in memory))
        laid = None
        while laid is None or not laid.last:
            laid = timed("laid out", lambda judge=judge: judge.lay_out(kernel.LONGEST_STRETCH))
            jobs = [
                PlayStretch(each.file, given.edges, laid.runs, again, "fifo", again=bool(again))
                for again, each in enumerate(memory)
            ]
            size = timed("first play", lambda job=jobs[0]: actors[0].play(job)).size
            rows, good = timed("judged", lambda j=judge, a=laid, s=size: j.judge(a, s))
            size = timed("second play", lambda job=jobs[1]: actors[1].play(job)).size
            if not good or rows.broken or judge.differing(laid, size):
                raise SystemExit("a law is broken: this measures nothing")
            timed("compared", lambda j=judge, a=laid, s=size: j.differing(a, s))
            runs += laid.runs
    for part, seconds in spent.items():
        print(f"{part:12} {seconds / runs * 1e6:6.2f}")
    print(f"{'all':12} {sum(spent.values()) / runs * 1e6:6.2f} microseconds a run, {runs:,} runs")


if __name__ == "__main__":
    main()
