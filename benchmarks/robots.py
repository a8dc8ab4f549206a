"""Configurations a second of the search of several robots, beside a peer that does the same work.

    python benchmarks/robots.py [--edges M] [--scheduler S] [--repeats R] [--peer 'NAME=COMMAND']

The work: one robot waits, another one searches, in every map with up to M edges from every start.
A line for each way has configurations a second of processor time, the median of the repeats with
the least and the largest, and for the second way on its ratio to the first in the same repeat:

in this process   the programs stand in the process of the search
players           `allworlds team` with one worker, both players of each program included
two workers       the same with two, in seconds of the wall
peers             any commands; their processor time alone is told

Last, the bytes of a configuration in a search of one large world.
"""

import argparse
import os
import resource
import shlex
import statistics
import subprocess
import sys
import tempfile
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import allworlds
from allworlds import Automaton, Move
from allworlds.maps import MapClass, family, rooted_maps
from allworlds.robots.configurations import Search, in_lockstep
from allworlds.robots.minds import Minds
from allworlds.robots.model import ModelInMap
from allworlds.robots.models.meeting import Meeting
from allworlds.robots.schedulers import Timing
from allworlds.robots.single_search import search, turns_of

PROGRAMS = """
from allworlds import Move, Watch


def waits(first):
    while True:
        yield Watch()


def searches(first):
    def behind(seen, depth):
        for _ in range(seen.degree - 1 if depth else 0):
            yield from behind((yield Move(1)), depth - 1)
        yield Move(1 if depth else 0)

    depth, turn = 0, 0
    while True:
        for _ in range(first.degree):
            yield from behind((yield Move(turn)), depth)
            turn = 1
        depth += 1
"""

AT_ONCE = 2000


def here(edges: int, scheduler: str) -> int:
    """The number of configurations, with the programs in this process."""
    names: dict[str, Callable[..., object]] = {}
    exec(PROGRAMS, names)  # the text above
    minds = Minds([turns_of(names["waits"]), turns_of(names["searches"])])
    met, waiting = 0, list[Search]()
    maps = (map_ for m in range(1, edges + 1) for map_ in rooted_maps(m, MapClass.MAPS))
    for map_ in maps:
        world = ModelInMap(Meeting(apart=False), map_, "meeting")
        waiting += [
            Search(world, start, (0, 1), minds, Timing(scheduler)) for start in world.starts(2)
        ]
        if len(waiting) >= AT_ONCE:
            met += done(waiting, minds)
    return met + done(waiting, minds)


def done(waiting: list[Search], minds: Minds) -> int:
    """Do these searches; return their configurations."""
    in_lockstep(waiting, minds)
    met = sum(map(len, waiting))
    waiting.clear()
    return met


def seconds(work: Callable[[], object]) -> tuple[float, float]:
    """Processor time, children included, and time of the wall."""
    began, wall = used(), time.perf_counter()
    work()
    return used() - began, time.perf_counter() - wall


def used() -> float:
    """Processor time of this process and its children."""
    own = resource.getrusage(resource.RUSAGE_SELF)
    below = resource.getrusage(resource.RUSAGE_CHILDREN)
    return own.ru_utime + own.ru_stime + below.ru_utime + below.ru_stime


def told(name: str, values: list[float], first: list[float], unit: str) -> None:
    """Print a line."""
    middle, least, most = statistics.median(values), min(values), max(values)
    ratios = [a / b for a, b in zip(values, first, strict=True)]
    beside = "" if values is first else f"   x {statistics.median(ratios):.2f}"
    print(f"{name:18} {middle:10,.1f} ({least:,.1f} to {most:,.1f}) {unit}{beside}", flush=True)


def bytes_of_one() -> float:
    """The bytes of a configuration of three automata in the complete map of five vertices."""
    walkers = [Automaton(0, lambda t, _, k=k: ((t + 1) % 7, Move(1 + t * k))) for k in (1, 2, 3)]
    tracemalloc.start()
    found = search(family("dense:5"), (0, 5, 9), Meeting(), walkers, "central")
    held, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return held / found.configurations


def main() -> None:
    """Measure, and print."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--edges", type=int, default=4)
    parser.add_argument("--scheduler", default="async")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--peer", action="append", default=[], metavar="NAME=COMMAND")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "programs.py"
        file.write_text(PROGRAMS)
        names = [f"{file}:waits", f"{file}:searches"]
        options = {"model": "meeting:apart=false", "scheduler": asked.scheduler}

        def team(workers: int) -> None:
            allworlds.team(*names, edges=asked.edges, workers=workers, **options)

        rates, walls = dict[str, list[float]](), dict[str, list[float]]()
        for _ in range(asked.repeats):
            number = here(asked.edges, asked.scheduler)  # and all that is loaded once
            ways = {"in this process": lambda: here(asked.edges, asked.scheduler)}
            ways["players"] = lambda: team(1)
            for name, work in ways.items():
                cpu, wall = seconds(work)
                rates.setdefault(name, []).append(number / cpu)
                walls.setdefault(name, []).append(wall)
            _, wall = seconds(lambda: team(2))
            walls.setdefault("two workers", []).append(wall)
            for given in asked.peer:
                name, _, command = given.partition("=")
                run = [*shlex.split(command)]
                cpu, _ = seconds(
                    lambda run=run: subprocess.run(run, check=True, capture_output=True)
                )
                rates.setdefault(name, []).append(number / cpu)
    print(f"{number:,} configurations, {os.cpu_count()} processors, {sys.version.split()[0]}")
    first = rates["in this process"]
    for name, values in rates.items():
        told(name, values, first, "configurations a second of processor time")
    told("one worker", walls["players"], walls["players"], "s of the wall")
    told("two workers", walls["two workers"], walls["players"], "s of the wall")
    print(f"bytes of a configuration: {bytes_of_one():,.0f}")


if __name__ == "__main__":
    main()
