"""How far a check goes while one waits for it, by the kind of explorer.

    python benchmarks/effort.py measure > benchmarks/results/effort.json
    python benchmarks/effort.py table benchmarks/results/effort.json

Each kind is Algorithm 1: built in, in C behind ``--native``, in Python, and as a program behind
``--exec``.  Whole commands are timed, from start to end, with more and more edges, until one takes
ten seconds; that one is told, and what a check of one edge takes.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from allworlds.maps.counting.any_genus import rooted_maps
from allworlds.version import __version__, host

HERE = Path(__file__).resolve().parent
KINDS = {
    "builtin": "built in",
    "native": "a library with `--native`",
    "python": "Python",
    "exec": "a program behind `--exec`",
}
LONG_ENOUGH = 10


def worlds(edges: int) -> int:
    """The rooted maps with at most so many edges."""
    return sum(sum(rooted_maps(m).values()) for m in range(1, edges + 1))


def seconds(explorer: list[str], edges: int) -> float:
    """Of a whole command, with all cores."""
    start = time.perf_counter()
    line = [sys.executable, "-m", "allworlds", "check", *explorer, "--edges", str(edges), "-q"]
    subprocess.run(line, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def measured(explorer: list[str]) -> dict[str, Any]:
    """The largest bound that was tried, its worlds, and what it and the smallest took."""
    seconds(explorer, 5)  # what is compiled once, from so many edges on, is compiled
    least, edges, took = seconds(explorer, 1), 2, 0.0
    while took < LONG_ENOUGH:
        edges += 1
        took = seconds(explorer, edges)
    told = {"edges": edges, "worlds": worlds(edges)}
    return {**told, "seconds": round(took, 3), "smallest": round(least, 3)}


def commit() -> str:
    """The commit of the sources; ``unknown`` in a copy without its history, or without git."""
    line = ["git", "-C", str(HERE), "describe", "--always", "--dirty"]
    try:
        return subprocess.run(line, check=True, capture_output=True, text=True).stdout.strip()
    except (FileNotFoundError, subprocess.CalledProcessError):
        return "unknown"


def measure() -> dict[str, Any]:
    """The document."""
    with tempfile.TemporaryDirectory() as folder:
        library, header = Path(folder) / "algorithm1.so", Path(folder) / "allworlds.h"
        named = [sys.executable, "-m", "allworlds", "init", "--header"]
        header.write_bytes(subprocess.run(named, check=True, capture_output=True).stdout)
        source = HERE.parent / "examples" / "c" / "algorithm1.c"
        build = ["cc", "-O2", "-shared", "-fPIC", "-I", folder, "-o", str(library), str(source)]
        subprocess.run(build, check=True)
        foreign = HERE / "foreign.py"
        explorers = {
            "builtin": [],
            "native": ["--native", str(library)],
            "python": [f"{foreign}:explore"],
            "exec": ["--exec", f"{sys.executable} {foreign} --program"],
        }
        kinds = {name: measured(explorer) for name, explorer in explorers.items()}
    machine = {key: value for key, value in host().to_json().items() if key not in ("name", "load")}
    made = {"schema": 1, "version": __version__, "commit": commit(), "machine": machine}
    return {**made, "kinds": kinds}


def table(document: dict[str, Any]) -> Iterator[str]:
    """The lines of the table of docs/how-to/bound.md."""
    yield "| explorer | edges | worlds | seconds | of them to start |"
    yield "|---|---:|---:|---:|---:|"
    for name, words in KINDS.items():
        kind = document["kinds"][name]
        yield (
            f"| {words} | {kind['edges']} | {kind['worlds']:,} | {kind['seconds']:.0f} | "
            f"{kind['smallest']:.1f} |"
        )


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["measure"]:
            print(json.dumps(measure(), indent=2))
        case ["table", file]:
            print("\n".join(table(json.loads(Path(file).read_text(encoding="utf-8")))))
        case _:
            sys.exit(__doc__)
