"""The speed of two workers of a Dask cluster, compared with two threads or processes.

    python benchmarks/cluster.py [--rounds N] [--engine kernel|python]

The same check is done without a cluster and on a cluster of this machine, in turns, so that other
work of the machine slows both.  The first turn of each is not counted: there the compiler and a
guardian start, and the workers import their modules.  The cluster is started before.  A ratio above
1 means that the cluster is faster, or takes less processor time; this is the time of all processes
together, the scheduler included.  The program requires only that the reports are equal.
"""

from __future__ import annotations

import argparse
import statistics
import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import psutil

from allworlds import check
from allworlds.engines.dask import local_cluster

WORKERS = 2

JOBS: dict[str, tuple[dict[str, Any], ...]] = {
    "kernel": ({"edges": 8}, {"edges": 9, "vertices": 2}),
    "python": ({"edges": 5},),
}
"""Checks that take a second, where what each level costs once counts most, and longer ones."""


@dataclass(frozen=True, slots=True)
class Taken:
    """Seconds of the clock, and of all processors."""

    wall: float
    cpu: float


def cpu_of_all() -> float:
    """Processor time of this process and of all that it has started, ended ones too."""
    return sum(_cpu_of_each())


def _cpu_of_each() -> Iterator[float]:
    here = psutil.Process()
    for process in (here, *here.children(recursive=True)):
        try:
            times = process.cpu_times()
        except psutil.NoSuchProcess:
            continue
        yield times.user + times.system + times.children_user + times.children_system


def taken(**options: Any) -> tuple[Taken, Any]:
    """The time that a check takes, and its document."""
    wall, cpu = time.perf_counter(), cpu_of_all()
    document = check(workers=WORKERS, **options).uninterrupted().to_json()
    return Taken(time.perf_counter() - wall, cpu_of_all() - cpu), document


def told(name: str, ratios: list[float]) -> str:
    """The median, and in parentheses the least and the largest."""
    return f"{name} {statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})"


def measure(engine: str, asked: dict[str, Any], rounds: int, address: str) -> None:
    """Print the ratios of one check."""
    turns: list[tuple[Taken, Taken]] = []
    job = {"engine": engine, **asked}
    for _ in range(rounds + 1):
        here, whole = taken(**job)
        there, same = taken(**job, dask=address)
        if same != whole:
            raise SystemExit(f"the reports of {engine} differ: this measures nothing")
        turns.append((here, there))
    walls = [here.wall / there.wall for here, there in turns[1:]]
    cpus = [here.cpu / there.cpu for here, there in turns[1:]]
    wall = statistics.median(here.wall for here, _ in turns[1:])
    cpu = statistics.median(here.cpu for here, _ in turns[1:])
    print(
        f"{engine}, {asked}: {told('clock', walls)}, {told('processors', cpus)}; "
        f"here {wall:.2f} s, {cpu:.2f} s of processors",
        flush=True,
    )


def main() -> None:
    """Measure, and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--engine", choices=JOBS, action="append")
    options = parser.parse_args()
    with local_cluster(WORKERS) as address:
        for engine in options.engine or JOBS:
            for asked in JOBS[engine]:
                measure(engine, asked, options.rounds, address)


if __name__ == "__main__":
    main()
