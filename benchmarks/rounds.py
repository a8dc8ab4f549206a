"""Engines and other programs measured side by side, in worlds per second.

    python benchmarks/rounds.py --edges 7 --peer 'lazy=./lazy 1 7'

Contenders take turns, round after round, and a ratio is taken within each round: what else
the machine does then befalls both sides.  Printed is a document: all contenders, the reference
first, and the ratios of its rate to that of each other one.
"""

from __future__ import annotations

import argparse
import json
import re
import resource
import shlex
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

from allworlds.engines.engine_table import ENGINES, WALKED_FROM, Job
from allworlds.engines.kernel.worlds import by_vertices_and_faces
from allworlds.engines.limits import Limits
from allworlds.engines.listeners import Listener
from allworlds.engines.sweep import gather
from allworlds.engines.tally import Tally
from allworlds.engines.units import Scope, units_of_level
from allworlds.explorers.loading import load
from allworlds.judging.laws.bounds import default_step_budget, paper_bound
from allworlds.judging.referee import Examiner
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass, rooted_maps
from allworlds.maps.classes import Extent
from allworlds.maps.counting import SOURCES
from allworlds.maps.enumeration import prefixes
from allworlds.version import __version__, host
from allworlds.world import Directional, World

PYTHON_EDGES = 4
JUDGED_EDGES = 6


def commit() -> str:
    """The commit of the sources; ``unknown`` in a copy without its history, or without git."""
    line = ["git", "-C", str(Path(__file__).parent), "describe", "--always", "--dirty"]
    try:
        return subprocess.run(line, check=True, capture_output=True, text=True).stdout.strip()
    except (FileNotFoundError, subprocess.CalledProcessError):
        return "unknown"


@dataclass(frozen=True)
class Contender:
    """Anything that walks every world with ``edges`` edges when it is called.

    Attributes:
        name: how it is called in the document.
        edges: m.
        does: its work in words, or its command.
        work: does it once.
    """

    name: str
    edges: int
    does: str
    work: Callable[[], object]

    def measured(self, seconds: Sequence[float]) -> dict[str, Any]:
        """The contender with the seconds that each of its rounds took."""
        rates = self.rates(seconds)
        told = {"name": self.name, "does": self.does, "edges": self.edges, "worlds": self.worlds}
        rounded = [round(each, 4) for each in seconds]
        return {**told, "seconds": rounded, "worlds_per_second": spread(rates, 1)}

    @property
    def worlds(self) -> int:
        """The rooted maps of its level."""
        return sum(SOURCES["maps"].cells(self.edges).values())

    def rates(self, seconds: Sequence[float]) -> list[float]:
        """Worlds a second in each round."""
        return [self.worlds / each for each in seconds]


def spread(values: Sequence[float], digits: int) -> dict[str, float]:
    """Median, smallest and largest value of a figure over the rounds."""
    three = {"median": median(values), "lowest": min(values), "highest": max(values)}
    return {name: round(value, digits) for name, value in three.items()}


def bench(edges: int, rounds: int, peers: Sequence[str]) -> dict[str, Any]:
    """Measure the engines of this package and other programs, side by side."""
    others = [peer(text, edges) for text in peers]
    contenders = [*own_contenders(edges), *others]
    # Compiling and loading is not what is measured.
    for work in (lambda: _walk(WALKED_FROM), lambda: _count(4), lambda: _judge(4)):
        work()
    turns = [[_seconds(each.work) for each in contenders] for _ in range(rounds)]
    taken = list(zip(contenders, zip(*turns, strict=True), strict=True))
    (reference, first), *rest = taken
    ratios = [
        {
            "of": reference.name,
            "to": other.name,
            "ratio": spread(
                [a / b for a, b in zip(reference.rates(first), other.rates(seconds), strict=True)],
                4,
            ),
        }
        for other, seconds in rest
    ]
    machine = {key: value for key, value in host().to_json().items() if key != "name"}
    return {
        "schema": 1,
        "version": __version__,
        "commit": commit(),
        "machine": machine,
        "edges": edges,
        "rounds": rounds,
        "peak_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024,
        "contenders": [each.measured(seconds) for each, seconds in taken],
        "ratios": ratios,
    }


def _seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def own_contenders(edges: int) -> list[Contender]:
    """The engines of this package, the reference first."""
    less = min(edges, JUDGED_EDGES)
    least = min(edges, PYTHON_EDGES)
    return [
        Contender("kernel", edges, "check --engine kernel, 1 thread", lambda: _walk(edges, 1)),
        Contender("kernel-2", edges, "check --engine kernel, 2 threads", lambda: _walk(edges, 2)),
        Contender("count", edges, "count, compiled", lambda: _count(edges)),
        Contender("judge", less, "every bearing played and judged", lambda: _judge(less)),
        Contender("python", least, "the python engine, one bearing", lambda: _python(least)),
    ]


def peer(text: str, edges: int) -> Contender:
    """The contender of ``NAME=COMMAND`` or ``NAME@M=COMMAND``."""
    match = re.fullmatch(r"([^=@]+)(?:@([0-9]+))?=(.+)", text)
    if match is None:
        sys.exit(f"peer {text!r} is not of the form NAME=COMMAND or NAME@M=COMMAND")
    name, level, command = match.groups()
    return Contender(name, int(level or edges), command, lambda: _run(name, command))


def _run(name: str, command: str) -> None:
    done = subprocess.run(shlex.split(command), stdout=subprocess.DEVNULL, check=False)
    if done.returncode:
        sys.exit(f"peer {name!r} ended with {done.returncode}")


def _walk(edges: int, threads: int = 1) -> None:
    _check(Scope(Extent(MapClass.MAPS, edges), Rules()), threads)


def _check(scope: Scope, threads: int) -> None:
    """The last level of the scope."""
    job = Job(scope, load("algorithm1"), Limits(workers=threads), 1, None, lambda _: None)
    ready = ENGINES["kernel"].ready(job)
    with ready.transport:
        units = units_of_level(scope.extent, scope.extent.levels[-1])
        gather(ready.transport, ready.engine, units, Tally(1), Listener())


def _count(edges: int) -> None:
    for prefix in prefixes(edges, depth=2):
        by_vertices_and_faces(edges, edges + 1, prefix)


def _judge(edges: int) -> None:
    # A step budget that is given is kept run by run.
    budget = default_step_budget(paper_bound(edges + 1, edges))
    _check(Scope(Extent(MapClass.MAPS, edges), Rules(step_budget=budget)), 1)


def _python(edges: int) -> None:
    rules = Rules()
    examiner = Examiner(load("algorithm1"), rules)
    for map_ in rooted_maps(edges):
        examiner.examine(World(map_, Directional(0), 0), rules.choices(""))


if __name__ == "__main__":
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--edges", type=int, choices=range(4, 11), default=7, metavar="M")
    options.add_argument("--rounds", type=int, default=3, metavar="R")
    options.add_argument("--peer", action="append", default=[], metavar="NAME[@M]=COMMAND")
    asked = options.parse_args()
    print(json.dumps(bench(asked.edges, asked.rounds, asked.peer), indent=2))
