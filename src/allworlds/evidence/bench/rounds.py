"""Engines and other programs side by side: who walks how many worlds a second.

Contenders take turns, round after round, and a ratio is taken within each round: what else
the machine does then befalls both sides.
"""

from __future__ import annotations

import re
import resource
import shlex
import subprocess
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING

from allworlds.engines import ENGINES, WALKED_FROM, Examiner, Job, Limits, Scope, Tally, gather
from allworlds.explorers import load
from allworlds.inputs import InputError, a_text, an_integer, at_most, show
from allworlds.judging import Rules, default_step_budget, paper_bound
from allworlds.maps import Extent, MapClass, prefixes, rooted_maps, source_for
from allworlds.outcome import SCHEMA, Exit, until_interrupted
from allworlds.progress import Listener, Silent
from allworlds.world import Directional, World

if TYPE_CHECKING:
    from allworlds import documents

REFERENCE = "kernel"
"""The contender to whose rate all others are compared."""

MOST_ROUNDS = 1000

PYTHON_EDGES = 4
JUDGED_EDGES = 6


@dataclass(frozen=True, slots=True)
class Contender:
    """Something that walks every world with ``edges`` edges when it is called.

    Attributes:
        name: how it is called in the report.
        edges: m.
        does: what it does, in words, or its command.
        work: does it once.
    """

    name: str
    edges: int
    does: str
    work: Callable[[], object]

    @property
    def worlds(self) -> int:
        """The rooted maps of the level, from the count's source."""
        return sum(source_for("maps").cells(self.edges).values())


@dataclass(frozen=True, slots=True)
class Measured:
    """A contender with the seconds that each of its rounds took."""

    contender: Contender
    seconds: tuple[float, ...]

    @property
    def rates(self) -> list[float]:
        """Worlds a second in each round."""
        return [self.contender.worlds / seconds for seconds in self.seconds]

    def to_json(self) -> documents.ContenderDocument:
        """One row of the document."""
        return {
            "name": self.contender.name,
            "does": self.contender.does,
            "edges": self.contender.edges,
            "worlds": self.contender.worlds,
            "seconds": [round(seconds, 4) for seconds in self.seconds],
            "worlds_per_second": _spread(self.rates, 1),
        }


@dataclass(frozen=True, slots=True)
class BenchReport:
    """All contenders of one run.

    Attributes:
        edges: the level of the compiled engines.
        measured: the contenders; the first is the reference.
        peak_mb: the largest memory that this process has had.
        complete: False if the user has interrupted, and rounds are missing.
    """

    edges: int
    measured: tuple[Measured, ...]
    peak_mb: int
    complete: bool = True

    @property
    def exit_code(self) -> Exit:
        """0 measured, 130 interrupted."""
        return Exit.ANSWERED if self.complete else Exit.INTERRUPTED

    def ratios(self) -> list[documents.Ratio]:
        """How many times the rate of each other contender the reference's is."""
        reference = self.measured[0]
        return [
            {
                "of": reference.contender.name,
                "to": other.contender.name,
                "ratio": _spread(
                    [a / b for a, b in zip(reference.rates, other.rates, strict=True)], 4
                ),
            }
            for other in self.measured[1:]
        ]

    def to_json(self) -> documents.BenchDocument:
        """The document of ``bench --json``."""
        return {
            "schema": SCHEMA,
            "commit": commit(),
            "edges": self.edges,
            "complete": self.complete,
            "rounds": len(self.measured[0].seconds),
            "peak_mb": self.peak_mb,
            "contenders": [measured.to_json() for measured in self.measured],
            "ratios": self.ratios(),
        }


def bench(
    *,
    edges: int = 7,
    rounds: int = 3,
    peers: Sequence[str] = (),
    listener: Listener | None = None,
) -> BenchReport:
    """Measure the engines of this package and other programs, side by side.

    Args:
        edges: the level m that the compiled engines do.
        rounds: how often each contender takes its turn.
        peers: ``NAME=COMMAND``, or ``NAME@M=COMMAND`` for a program that does another level.
        listener: is told of the progress.

    Raises:
        InputError: naming the offending option, or the peer that failed.
        KeyboardInterrupt: if the user interrupts before the first round is over.
    """
    if isinstance(peers, str):
        raise InputError(f"peers = {show(peers)} is not a list of NAME=COMMAND")
    if not 4 <= an_integer("edges", edges) <= 10:
        raise InputError(f"edges = {show(edges)}; a benchmark takes 4 up to 10")
    if an_integer("rounds", rounds) < 1:
        raise InputError(f"rounds = {show(rounds)} is not positive")
    at_most("rounds", rounds, MOST_ROUNDS)
    contenders = [*own_contenders(edges), *(peer(text, edges) for text in peers)]
    for contender in contenders[: -len(peers) or None]:
        # Compiling and loading is not what is measured.
        _warm(contender)
    heard = listener or Silent()
    heard.stage("bench", rounds * len(contenders), "turns")
    finished, complete = until_interrupted(_round(contenders, heard) for _ in range(rounds))
    if not finished:
        raise KeyboardInterrupt
    taken = zip(contenders, zip(*finished, strict=True), strict=True)
    measured = tuple(Measured(contender, seconds) for contender, seconds in taken)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
    return BenchReport(edges, measured, peak, complete)


def _round(contenders: Sequence[Contender], listener: Listener) -> list[float]:
    """The seconds that each of them takes for its turn."""
    seconds = []
    for contender in contenders:
        start = time.perf_counter()
        contender.work()
        seconds.append(time.perf_counter() - start)
        listener.progress(1)
    return seconds


def own_contenders(edges: int) -> list[Contender]:
    """The engines of this package; the reference comes first."""
    less = min(edges, JUDGED_EDGES)
    least = min(edges, PYTHON_EDGES)
    return [
        Contender(REFERENCE, edges, "check --engine kernel, 1 thread", lambda: _walk(edges, 1)),
        Contender("kernel-2", edges, "check --engine kernel, 2 threads", lambda: _walk(edges, 2)),
        Contender("count", edges, "count, compiled", lambda: _count(edges)),
        Contender("judge", less, "every bearing played and judged", lambda: _judge(less)),
        Contender("python", least, "the python engine, one bearing", lambda: _python(least)),
    ]


def peer(text: str, edges: int) -> Contender:
    """The contender of ``NAME=COMMAND`` or ``NAME@M=COMMAND``.

    Raises:
        InputError: if it is of another form.
    """
    match = re.fullmatch(r"([^=@]+)(?:@([0-9]+))?=(.+)", a_text("peer", text))
    if match is None:
        raise InputError(f"peer {show(text)} is not of the form NAME=COMMAND or NAME@M=COMMAND")
    name, level, command = match.groups()
    return Contender(name, int(level or edges), command, lambda: _run(name, command))


def _run(name: str, command: str) -> None:
    try:
        done = subprocess.run(  # noqa: S603  # the user's own command
            shlex.split(command), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False
        )
    except (OSError, ValueError) as error:
        raise InputError(f"peer {show(name)} does not start: {error}") from None
    if done.returncode:
        said = done.stderr.decode(errors="replace").strip().splitlines()
        what = said[-1] if said else "it has printed nothing on stderr"
        raise InputError(f"peer {show(name)} ended with {done.returncode}: {what}")


def _warm(contender: Contender) -> None:
    match contender.name:
        case "kernel" | "kernel-2":
            _walk(WALKED_FROM)
        case "count":
            _count(PYTHON_EDGES)
        case "judge":
            _judge(PYTHON_EDGES)


def _walk(edges: int, threads: int = 1) -> None:
    _check(Scope(Extent(MapClass.MAPS, edges), Rules()), threads)


def _check(scope: Scope, threads: int) -> None:
    """The last level of the scope."""
    job = Job(scope, load("algorithm1"), Limits(threads), 1, None, lambda _: None)
    ready = ENGINES["kernel"].ready(job)
    with ready.transport:
        units = scope.units(scope.extent.levels[-1])
        gather(ready.transport, ready.engine, units, Tally(1), Silent())


def _count(edges: int) -> None:
    from allworlds.engines import by_vertices_and_faces

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


def commit() -> str | None:
    """The commit of the sources; None outside a checkout."""
    try:
        said = subprocess.run(
            ["git", "describe", "--always", "--dirty"],  # noqa: S607  # whichever git there is
            cwd=Path(__file__).parent,
            capture_output=True,
            text=True,
            check=True,
        )
    except (OSError, subprocess.CalledProcessError):
        return None
    return said.stdout.strip()


def _spread(values: Sequence[float], digits: int) -> documents.SpreadDocument:
    return {
        "median": round(median(values), digits),
        "lowest": round(min(values), digits),
        "highest": round(max(values), digits),
    }
