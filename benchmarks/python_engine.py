"""How fast the Python engine is on this machine, and beside others in the same session.

    python benchmarks/python_engine.py [--repeats N] [--peer 'NAME=COMMAND']...

Each repeat measures everything once, so that what slows the machine down slows all down.
Printed are median, least and largest value; nothing is asserted.
"""

from __future__ import annotations

import argparse
import shlex
import statistics
import subprocess
import time
from collections import deque
from collections.abc import Callable

import allworlds
from allworlds.explorers.loading import load
from allworlds.judging.referee import Examiner
from allworlds.judging.rules import Rules
from allworlds.maps import family, rooted_code, rooted_maps, unrooted_code
from allworlds.protocol.choices import Choices

LEVEL = 5
CODE_EDGES = 20


def seconds(work: Callable[[], object]) -> float:
    """The wall time of the work."""
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def judged_runs() -> float:
    """Runs a second: Algorithm 1 on every run of the level, judged, in this process alone."""
    worlds = [w for w in allworlds.worlds(edges=LEVEL, places="all") if w.map.edge_count == LEVEL]
    examiner = Examiner(load("algorithm1"), Rules("directional"))

    def work() -> None:
        for world in worlds:
            if examiner.examine(world, Choices()).violation:
                raise SystemExit(f"a law is broken in {world.to_json()}: this measures nothing")
            examiner.events.clear()

    return len(worlds) / seconds(work)


def enumerated() -> float:
    """Rooted maps a second, on the level above."""
    maps = 0

    def work() -> None:
        nonlocal maps
        maps = sum(1 for _ in rooted_maps(LEVEL + 1))

    taken = seconds(work)
    return maps / taken


def rooted_codes() -> float:
    """Microseconds for the code of a random rooted map."""
    maps = [family(f"random:{CODE_EDGES}", seed=seed) for seed in range(1000)]
    codes = (rooted_code(map_.sigma, map_.alpha, 0) for map_ in maps)
    return seconds(lambda: deque(codes, maxlen=0)) * 1e6 / len(maps)


def unrooted_codes() -> float:
    """Microseconds for the code of a random map: the least of all its rootings."""
    maps = [family(f"random:{CODE_EDGES}", seed=seed) for seed in range(1000)]
    codes = (unrooted_code(map_) for map_ in maps)
    return seconds(lambda: deque(codes, maxlen=0)) * 1e6 / len(maps)


def whole_check() -> float:
    """Seconds for the whole check, with one worker process; what peers are compared with."""
    return seconds(lambda: allworlds.check(edges=LEVEL, workers=1))


def peer(command: str) -> float:
    """Seconds for a command."""
    arguments = shlex.split(command)
    return seconds(lambda: subprocess.run(arguments, check=True, stdout=subprocess.DEVNULL))


MEASURES: dict[str, tuple[str, Callable[[], float]]] = {
    f"judged runs, m = {LEVEL}": ("runs/s and core", judged_runs),
    f"enumeration, m = {LEVEL + 1}": ("maps/s and core", enumerated),
    f"rooted code, m = {CODE_EDGES}": ("us", rooted_codes),
    f"unrooted code, m = {CODE_EDGES}": ("us", unrooted_codes),
    f"check --edges {LEVEL}, one worker": ("s", whole_check),
}


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeats", type=int, default=5, metavar="N")
    parser.add_argument("--peer", action="append", default=[], metavar="NAME=COMMAND")
    options = parser.parse_args()
    named = [text.partition("=")[::2] for text in options.peer]
    if options.repeats < 1 or not all(name and command for name, command in named):
        parser.error("--repeats is at least 1, and --peer has the form NAME=COMMAND")
    measures = MEASURES | {
        name: ("s", lambda command=command: peer(command)) for name, command in named
    }
    values: dict[str, list[float]] = {name: [] for name in measures}
    for _ in range(options.repeats):
        for name, (_, measure) in measures.items():
            values[name].append(measure())
    width = max(map(len, values))
    for name, measured in values.items():
        print_row(name.ljust(width), measured, measures[name][0])
    ours = values[f"check --edges {LEVEL}, one worker"]
    for name, _ in named:
        ratios = [theirs / our for theirs, our in zip(values[name], ours, strict=True)]
        print_row(f"{name} / check".ljust(width), ratios, "times as long")


def print_row(name: str, values: list[float], unit: str) -> None:
    """Median, least and largest value."""
    median, least, largest = statistics.median(values), min(values), max(values)
    print(f"{name}  {median:>12,.2f}  ({least:,.2f} .. {largest:,.2f})  {unit}")


if __name__ == "__main__":
    main()
