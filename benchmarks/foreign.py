"""The cost of checking a user's explorer, compared with the cost of the explorer itself.

    python benchmarks/foreign.py [--repeats N] [--edges M] [--kind python|pipe]

The explorer is Algorithm 1, in Python and as a program behind a pipe.  The program measures CPU
time, child processes included, so that the number of cores and their other work do not matter.
Each repeat compares the check with two plays of every run and nothing else, which no check can
do without.  The program prints the median, the least and the largest ratio.
"""

from __future__ import annotations

import argparse
import json
import resource
import statistics
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import allworlds
from allworlds import Checkpoint, Choices, Move, Percept
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.world import World

PROGRAM = [sys.executable, str(Path(__file__).resolve()), "--program"]


def explore(first: Percept):  # noqa: ANN201  # a generator, as users write them
    """Algorithm 1, as an explorer of one's own."""
    return (yield from algorithm1(first))


def program() -> None:
    """Play Algorithm 1 as a program, over JSON lines."""
    for line in sys.stdin:
        message = json.loads(line)
        percept = Percept(**message["percept"])
        try:
            if "episode" in message:
                run = algorithm1(percept)
                action = next(run)
            else:
                action = run.send(percept)
            while isinstance(action, Checkpoint):
                action = run.send(None)
            print(json.dumps({"move": action.k}), flush=True)
        except StopIteration as stop:
            answer = {**stop.value.map.to_json(), "here": stop.value.here}
            print(json.dumps({"estimate": answer}), flush=True)


def plays(worlds: list[World]) -> None:
    """Every run played once, and nothing looked at."""
    for world in worlds:
        state, step = world.initial, world.step
        run = algorithm1(world.first, choices=Choices())
        reply = None
        while True:
            try:
                action = run.send(reply)
            except StopIteration:
                break
            reply = None
            if isinstance(action, Move):
                state, reply = step(state, action)


def round_trips(worlds: list[World]) -> None:
    """Every run played once over the pipe, and nothing looked at."""
    with subprocess.Popen(PROGRAM, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdin
        assert process.stdout
        for number, world in enumerate(worlds):
            state = world.initial
            message: dict[str, object] = {"episode": number, "percept": world.first.to_json()}
            while True:
                process.stdin.write(json.dumps(message).encode() + b"\n")
                process.stdin.flush()
                said = json.loads(process.stdout.readline())
                if "move" not in said:
                    break
                state, percept = world.step(state, Move(said["move"]))
                message = {"percept": percept.to_json()}
        process.stdin.close()


def cpu_seconds(work: Callable[[], object]) -> float:
    """The CPU time of the work, that of ended children included."""

    def spent() -> float:
        return sum(
            usage.ru_utime + usage.ru_stime
            for usage in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
        )

    start = spent()
    work()
    return spent() - start


def checked(explorer: list[str], edges: int) -> float:
    """CPU seconds of a whole check, without what a check of one edge takes to start and to end.

    The compiled judge has been compiled before; to load it is part of what is measured.
    """

    def command(bound: int, *more: str) -> float:
        line = [sys.executable, "-m", "allworlds", "check", *explorer, "--edges", str(bound)]
        line += ["--workers", "1", "-q", *more]
        return cpu_seconds(lambda: subprocess.run(line, check=True, stdout=subprocess.DEVNULL))

    command(1, "--engine", "kernel")
    return command(edges) - command(1)


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeats", type=int, default=3, metavar="N")
    parser.add_argument("--edges", type=int, default=5, metavar="M")
    parser.add_argument("--kind", choices=("python", "pipe"), action="append", metavar="KIND")
    parser.add_argument("--program", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.program:
        program()
        return
    worlds = [*allworlds.worlds(edges=options.edges, places="all")]
    for world in worlds:
        assert world.percepts
    kinds: dict[str, tuple[Callable[[list[World]], None], list[str]]] = {
        "python": (plays, [f"{Path(__file__).resolve()}:explore"]),
        "pipe": (round_trips, ["--exec", " ".join(PROGRAM)]),
    }
    for name in options.kind or kinds:
        bare, explorer = kinds[name]
        ratios = []
        for _ in range(options.repeats):
            alone = 2 * cpu_seconds(lambda bare=bare: bare(worlds))
            ratios.append(checked(explorer, options.edges) / alone)
        print(
            f"{name:6} a check is {statistics.median(ratios):.2f} "
            f"({min(ratios):.2f}..{max(ratios):.2f}) times two plays of its {len(worlds):,} runs"
        )


if __name__ == "__main__":
    main()
