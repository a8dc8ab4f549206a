"""Whether shards that are joined make the report of the whole check.

    python benchmarks/shards.py [--edges M] [--shards N] [--in DIR]

Every command is a process of its own, and its processor time is printed.  The exit code is 1 if
the reports differ in anything but what they say of their making.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any


def done(*words: str) -> Any:
    """The document of a command, whose processor time is printed.

    Raises:
        CalledProcessError: if the verdict is not that the explorer holds.
    """
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [sys.executable, "-m", "allworlds", *words, "--json"]
    told = subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    print(f"{seconds:7.1f} s of processors: {' '.join(words)}", flush=True)
    return json.loads(told)


def main() -> None:
    """Do it, and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--edges", default="9")
    parser.add_argument("--shards", type=int, default=8)
    parser.add_argument("--in", dest="place", help="where run directories are made")
    given = parser.parse_args()
    check = ["check", "--edges", given.edges]
    with tempfile.TemporaryDirectory(dir=given.place) as place:
        runs = [str(Path(place) / str(k)) for k in range(given.shards)]
        for k, run in enumerate(runs):
            done(*check, "--shard", f"{k}/{given.shards}", "--run", run)
        joined, whole = done("merge", *runs), done(*check)
    del joined["made_by"], whole["made_by"]
    if json.dumps(joined) != json.dumps(whole):
        raise SystemExit("the reports differ")
    print(f"the reports are equal: {whole['worlds']:,} worlds, {whole['runs']:,} runs")


if __name__ == "__main__":
    main()
