"""The cost of a run directory for a check.

    python benchmarks/run_directory.py [--edges M] [--workers W] [--rounds N] [--in DIR]

The same check is done without and with a new directory, in turns.  Their ratio is what a user sees,
and as noisy as the machine.  The directory is also measured from inside: the seconds of this thread
from the moment when a result is handed over, or asked for, to the moment when the loop goes on.
These are the cost itself, told as a share of the processor time of the checks without a directory.
The program requires only that the reports are equal.
"""

from __future__ import annotations

import argparse
import statistics
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from time import perf_counter, process_time, thread_time
from typing import Any
from unittest.mock import patch

from allworlds import check
from allworlds.engines import run_directory


@dataclass(slots=True)
class Meter:
    """A counter of calls, with their seconds of the clock and of the processor."""

    times: int = 0
    wall: float = 0.0
    cpu: float = 0.0

    def around(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """The function, measured."""

        def measured(*arguments: Any, **named: Any) -> Any:
            wall, cpu = perf_counter(), thread_time()
            try:
                return function(*arguments, **named)
            finally:
                self.times += 1
                self.wall += perf_counter() - wall
                self.cpu += thread_time() - cpu

        return measured


@dataclass(slots=True)
class Meters:
    """The parts of what a directory costs."""

    asked: Meter = field(default_factory=Meter)
    kept: Meter = field(default_factory=Meter)
    opened: Meter = field(default_factory=Meter)

    @property
    def cpu(self) -> float:
        """Seconds of the processor, all together."""
        return self.asked.cpu + self.kept.cpu + self.opened.cpu

    @property
    def wall(self) -> float:
        """Seconds of the clock."""
        return self.asked.wall + self.kept.wall + self.opened.wall


@contextmanager
def measured() -> Iterator[Meters]:
    """The meters of what happens in this context."""
    meters, kept = Meters(), run_directory.RunDirectory
    with (
        patch.object(kept, "result", meters.asked.around(kept.result)),
        patch.object(kept, "keep", meters.kept.around(kept.keep)),
        patch.object(run_directory, "_of_job", meters.opened.around(run_directory._of_job)),  # noqa: SLF001  # looked at from inside
    ):
        yield meters


@dataclass(frozen=True, slots=True)
class Turn:
    """A check: seconds of the clock and of the processors."""

    wall: float
    cpu: float


def turn(**options: Any) -> tuple[Turn, Any]:
    """The time that a check takes, and its document."""
    wall, cpu = perf_counter(), process_time()
    document = check(engine="kernel", **options).uninterrupted().to_json()
    return Turn(perf_counter() - wall, process_time() - cpu), document


def told(name: str, values: list[float]) -> str:
    """The median, and in parentheses the least and the largest."""
    return f"{name} {statistics.median(values):.3f} ({min(values):.3f} to {max(values):.3f})"


def main() -> None:
    """Measure, and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--edges", type=int, default=8)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--in", dest="place", help="where directories are made")
    given = parser.parse_args()
    options = {"edges": given.edges, "workers": given.workers}
    turn(**options)
    without: list[Turn] = []
    with_one: list[Turn] = []
    inside: list[Meters] = []
    for number in range(given.rounds):
        plain, whole = turn(**options)
        with tempfile.TemporaryDirectory(dir=given.place) as place, measured() as meters:
            kept, same = turn(**options, run=Path(place) / str(number))
        if same != whole:
            raise SystemExit("the reports differ: this measures nothing")
        without.append(plain)
        with_one.append(kept)
        inside.append(meters)
    both = list(zip(with_one, without, strict=True))
    shares = [meters.cpu / plain.cpu for meters, plain in zip(inside, without, strict=True)]
    print(told("with / without, clock", [a.wall / b.wall for a, b in both]))
    print(told("with / without, processors", [a.cpu / b.cpu for a, b in both]))
    print(told("the directory's share of the processors", shares))
    for name in ("opened", "asked", "kept"):
        parts: list[Meter] = [getattr(meters, name) for meters in inside]
        wall = statistics.median(part.wall for part in parts)
        cpu = statistics.median(part.cpu for part in parts)
        print(f"{name}: {parts[0].times} times, {wall:.4f} s, {cpu:.4f} s of a processor")
    seconds = statistics.median(plain.cpu for plain in without)
    print(f"without: {seconds:.2f} s of processors")


if __name__ == "__main__":
    main()
