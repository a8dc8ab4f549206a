"""Engines and other programs measured side by side, in worlds per second.

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
from pathlib import Path
from statistics import median
from typing import Annotated

from msgspec import Struct

from allworlds.document import (
    Aside,
    Document,
    Figure,
    Meta,
    Natural,
    Positive,
    Seconds,
    Some,
    Text,
    about,
    computed,
)
from allworlds.engines import (
    COMPILER,
    ENGINES,
    WALKED_FROM,
    AskedListener,
    Examiner,
    Job,
    Limits,
    Listener,
    RowsReport,
    Scope,
    Silent,
    Tally,
    gather,
)
from allworlds.explorers import load
from allworlds.inputs import (
    EFFORT,
    SCOPE,
    InputError,
    Option,
    Taken,
    a_text,
    an_integer,
    answers,
    at_most,
    ensure_installed,
    integer_of,
    show,
)
from allworlds.judging import Rules, default_step_budget, paper_bound
from allworlds.maps import Extent, MapClass, prefixes, rooted_maps, source_for
from allworlds.outcome import until_interrupted
from allworlds.world import Directional, World

REFERENCE = "kernel"
"""The contender to whose rate all others are compared."""

MOST_ROUNDS = 1000

PYTHON_EDGES = 4
JUDGED_EDGES = 6


class Contender(Struct, frozen=True):
    """Anything that walks every world with ``edges`` edges when it is called.

    Attributes:
        name: how it is called in the report.
        edges: m.
        does: its work in words, or its command.
        work: does it once.
    """

    name: str
    edges: int
    does: str
    work: Callable[[], object]

    def measured(self, seconds: Sequence[float]) -> Measured:
        """The contender with the seconds that each of its rounds took."""
        worlds = sum(source_for("maps").cells(self.edges).values())
        return Measured(
            name=self.name,
            does=self.does,
            edges=self.edges,
            worlds=worlds,
            seconds=tuple(round(each, 4) for each in seconds),
            rates=tuple(worlds / each for each in seconds),
        )


class RateSpread(Document):
    """Median, smallest and largest value of a figure over the rounds."""

    median: Annotated[Figure, about("over the rounds")]
    lowest: Annotated[Figure, about("of a round")]
    highest: Annotated[Figure, about("of a round")]

    @classmethod
    def over(cls, values: Sequence[float], digits: int) -> RateSpread:
        """Return the spread of these values, rounded."""
        return cls(
            median=round(median(values), digits),
            lowest=round(min(values), digits),
            highest=round(max(values), digits),
        )


class Measured(Document):
    """A contender and what was measured of it.

    ``rates`` are worlds a second in each round.
    """

    name: Annotated[Text, about("its name")]
    does: Annotated[Text, about("its work in words, or its command")]
    edges: Annotated[Positive, about("the level that it walks")]
    worlds: Annotated[Positive, about("the rooted maps of that level")]
    seconds: Annotated[Some[Seconds], about("of each round")]
    worlds_per_second: Annotated[RateSpread, about("over the rounds")] = computed(
        lambda measured: RateSpread.over(measured.rates, 1)
    )
    rates: Aside[tuple[float, ...]]


class Ratio(Document):
    """The ratio of two rates."""

    of: Annotated[Text, about("the kernel on one thread")]
    to: Annotated[Text, about("another contender")]
    ratio: Annotated[RateSpread, about("the rate of the one divided by that of the other")]


class BenchReport(RowsReport):
    """Report of 'bench'.

    All contenders of one run.
    """

    commit: Annotated[Text | None, about("of the sources; null outside a checkout")]
    edges: Annotated[int, Meta(ge=4, le=10), about("the level of the compiled engines")]
    rounds: Annotated[Positive, about("that were measured")] = computed(
        lambda report: len(report.contenders[0].seconds)
    )
    peak_mb: Annotated[Natural, about("the largest memory that the process has had")]
    contenders: Annotated[Some[Measured], about("the reference first")]
    ratios: Annotated[tuple[Ratio, ...], about("the reference to each other one")] = computed(
        lambda report: _ratios(*report.contenders)
    )


def _ratios(reference: Measured, *others: Measured) -> tuple[Ratio, ...]:
    """Ratios of the reference's rate to that of each other contender, round by round."""
    return tuple(
        Ratio(
            of=reference.name,
            to=other.name,
            ratio=RateSpread.over(
                [a / b for a, b in zip(reference.rates, other.rates, strict=True)], 4
            ),
        )
        for other in others
    )


def _level(given: int) -> int:
    if not 4 <= (edges := an_integer("edges", given)) <= 10:
        raise InputError(f"edges = {show(edges)}; a benchmark takes 4 up to 10")
    return edges


def _rounds(given: int) -> int:
    if (rounds := an_integer("rounds", given)) < 1:
        raise InputError(f"rounds = {show(rounds)} is not positive")
    at_most("rounds", rounds, MOST_ROUNDS)
    return rounds


def _peers(given: Sequence[str]) -> tuple[str, ...]:
    if isinstance(given, str):
        raise InputError(f"peers = {show(given)} is not a list of NAME=COMMAND")
    return tuple(given)


class BenchRequest(AskedListener):
    """Request of ``self bench``: who is measured, and how often."""

    edges: Annotated[
        Taken[int, int],
        Option(
            SCOPE,
            "M",
            "The number of edges of the worlds for the compiled engines.",
            parse=integer_of,
        ),
    ] = Taken(_level, 7)
    rounds: Annotated[
        Taken[int, int],
        Option(
            EFFORT,
            "R",
            "The number of rounds; each contender runs once in a round.",
            parse=integer_of,
        ),
    ] = Taken(_rounds, 3)
    peers: Annotated[
        Taken[Sequence[str], tuple[str, ...]],
        Option(
            SCOPE,
            "NAME[@M]=COMMAND",
            "Another program that walks every world with M edges (default: those of --edges); "
            "repeatable.",
            "peer",
            repeated=True,
        ),
    ] = Taken(_peers, ())


@answers(BenchRequest)
def bench(request: BenchRequest) -> BenchReport:
    """Measure the engines of this package and other programs, side by side.

    Raises:
        InputError: naming the offending option, or the peer that failed.
        KeyboardInterrupt: if the user interrupts before the first round is over.
    """
    ensure_installed(*COMPILER, "self bench")
    edges, rounds, peers = request.edges, request.rounds, request.peers
    contenders = [*own_contenders(edges), *(peer(text, edges) for text in peers)]
    for contender in contenders[: -len(peers) or None]:
        # Compiling and loading is not what is measured.
        _warm(contender)
    heard = request.listener
    heard.stage("bench", rounds * len(contenders), "turns")
    finished, ending = until_interrupted(_round(contenders, heard) for _ in range(rounds))
    if not finished:
        raise KeyboardInterrupt
    taken = zip(contenders, zip(*finished, strict=True), strict=True)
    return BenchReport(
        commit=commit(),
        edges=edges,
        ending=ending,
        peak_mb=resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024,
        contenders=tuple(contender.measured(seconds) for contender, seconds in taken),
    )


def _round(contenders: Sequence[Contender], listener: Listener) -> list[float]:
    """The seconds that each contender takes for its turn."""
    seconds = []
    for contender in contenders:
        start = time.perf_counter()
        contender.work()
        seconds.append(time.perf_counter() - start)
        listener.progress(1)
    return seconds


def own_contenders(edges: int) -> list[Contender]:
    """The engines of this package, the reference first."""
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
    job = Job(scope, load("algorithm1"), Limits(workers=threads), 1, None, lambda _: None)
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
