"""The most memory that a check holds.

    python benchmarks/memory.py [--kind KIND] [--edges M...] [--workers W]

Each check is a command of its own.  Until it ends, the program reads the largest resident set that
the command and each of its workers ever had: the high-water mark that Linux keeps of a process.  It
prints these in MB, without and with a run directory.  Memory that several processes share, as that
of the interpreter's own code, counts for each.  The program requires only that the checks hold.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

EXPLORER = """
from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    return (yield from algorithm1(first))
"""

KINDS = {
    "compiled": ((6, 7, 8), ["--engine", "kernel"]),
    "python": ((3, 4, 5), ["--engine", "python"]),
    "foreign": ((4, 5), []),
}
"""The sizes of each kind of check, and the words that ask for it."""


def children(pid: int) -> Iterator[int]:
    """The process, and all that descend from it."""
    yield pid
    with suppress(OSError):
        for task in Path(f"/proc/{pid}/task").iterdir():
            for child in (task / "children").read_text().split():
                yield from children(int(child))


def high_water(pid: int) -> int:
    """The largest resident set of a process so far, in kB; 0 if it is gone."""
    with suppress(OSError):
        for line in Path(f"/proc/{pid}/status").read_text().splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1])
    return 0


def peaks(words: list[str]) -> tuple[float, list[float]]:
    """The most memory that the command and each process that it started held, in MB.

    Raises:
        SystemExit: if the check does not hold.
    """
    command = [sys.executable, "-m", "allworlds", "check", *words, "--quiet"]
    seen: dict[int, int] = {}
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        while process.poll() is None:
            for pid in children(process.pid):
                seen[pid] = max(seen.get(pid, 0), high_water(pid))
            time.sleep(0.02)
    if process.returncode:
        raise SystemExit(f"{' '.join(command)}: exit code {process.returncode}")
    own = seen.pop(process.pid)
    return own / 1024, sorted((peak / 1024 for peak in seen.values()), reverse=True)


def main() -> None:
    """Measure, and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kind", choices=KINDS, action="append")
    parser.add_argument("--edges", type=int, nargs="+")
    parser.add_argument("--workers", default="2")
    given = parser.parse_args()
    print(f"{'check':10} {'edges':>5} {'--run':>5} {'command':>8} {'others, largest first'}")
    for kind in given.kind or KINDS:
        sizes, words = KINDS[kind]
        for edges in given.edges or sizes:
            for kept in ("no", "yes"):
                with tempfile.TemporaryDirectory() as place:
                    mine = Path(place) / "mine.py"
                    mine.write_text(EXPLORER)
                    asked = [f"{mine}:explore"] if kind == "foreign" else []
                    asked += [*words, "--edges", str(edges), "--workers", given.workers]
                    if kept == "yes":
                        asked += ["--run", str(Path(place) / "run")]
                    own, others = peaks(asked)
                told = " ".join(f"{peak:.0f}" for peak in others)
                print(f"{kind:10} {edges:5} {kept:>5} {own:8.0f} {told}", flush=True)


if __name__ == "__main__":
    main()
