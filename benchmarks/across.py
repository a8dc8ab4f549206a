"""How often a check finds a state that one single run leaves behind for another one.

    python benchmarks/across.py [--edges M] [--pairs P] [--seed S] [--workers W] [--kind KIND]

An explorer in Python, one in C and a program that speaks JSON lines are each given pairs of runs,
drawn from all of up to M edges: once the first run has ended, the answer of the second is wrong.  A
run is known by a digest of its percepts.  A line for each kind has the number of pairs, of those
that a check refutes, and of those whose finding names the first run.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from random import Random

import allworlds
from allworlds.explorers import shared_library

ROOT = Path(__file__).parents[1]

LATCH = """
import os

FACTOR, MASK = 1099511628211, (1 << 64) - 1
SEEN = []

def digest(percepts):
    found = 14695981039346656037
    for degree, marks, bearing in percepts:
        for number in (degree, marks, 0 if bearing is None else bearing + 1):
            found = ((found ^ number) * FACTOR) & MASK
    return found

def is_wrong(percepts):
    known = digest(percepts)
    if path := os.environ.get("ALLWORLDS_DIGESTS"):
        with open(path, "a") as file:
            file.write(f"{known}\\n")
    wrong = bool(SEEN) and known == LATER
    if known == EARLIER:
        SEEN.append(known)
    return wrong
"""

PYTHON = """
from allworlds import CombinatorialMap, Estimate
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    percepts, walk = [(first.degree, first.marks, first.bearing)], algorithm1(first)
    action = next(walk)
    try:
        while True:
            percept = yield action
            if percept is not None:
                percepts.append((percept.degree, percept.marks, percept.bearing))
            action = walk.send(percept)
    except StopIteration as end:
        answer = end.value
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 0) if is_wrong(percepts) else answer
"""

PROGRAM = """
import json, sys
from allworlds import Move, Percept

def heard():
    line = sys.stdin.readline()
    return Percept(**json.loads(line)["percept"]) if line else sys.exit()

def say(**message):
    print(json.dumps(message), flush=True)

while True:
    walk = explore(heard())
    action = next(walk)
    try:
        while True:
            moves = isinstance(action, Move)
            if moves:
                say(move=action.k)
            action = walk.send(heard() if moves else None)
    except StopIteration as end:
        say(estimate=end.value.to_json())
"""

C = """
#define allworlds_start right_start
#define allworlds_step right_step
#define allworlds_answer right_answer
#include "{source}"
#undef allworlds_start
#undef allworlds_step
#undef allworlds_answer
#include <stdio.h>
#include <stdlib.h>
static uint64_t known;
static int seen;
static void add(const allworlds_percept *p)
{{
    const uint64_t numbers[] = {{p->degree, p->marks, p->bearing + 1}};
    for (int i = 0; i < 3; i++)
        known = (known ^ numbers[i]) * 1099511628211u;
}}
void allworlds_start(void *s, const allworlds_percept *p, int32_t told, allworlds_action *a)
{{
    known = 14695981039346656037u;
    add(p);
    right_start(s, p, told, a);
}}
void allworlds_step(void *s, const allworlds_percept *p, allworlds_action *a)
{{
    add(p);
    right_step(s, p, a);
    if (a->kind != ALLWORLDS_ANSWER)
        return;
    const char *path = getenv("ALLWORLDS_DIGESTS");
    FILE *file = path ? fopen(path, "a") : NULL;
    if (file) {{
        fprintf(file, "%llu\\n", (unsigned long long)known);
        fclose(file);
    }}
}}
int32_t allworlds_answer(void *s, int32_t room, int32_t *sigma, int32_t *alpha, int32_t *here)
{{
    int wrong = seen && known == {later}u;
    seen |= known == {earlier}u;
    if (!wrong)
        return right_answer(s, room, sigma, alpha, here);
    sigma[0] = alpha[1] = *here = 0, sigma[1] = alpha[0] = 1;
    return 2;
}}
"""


def written(kind: str, folder: Path, earlier: int, later: int) -> str:
    """The name of an explorer of that kind with these two runs."""
    head = f"EARLIER, LATER = {earlier}, {later}\n{LATCH}"
    if kind == "python":
        module = folder / f"latch_{later}.py"
        module.write_text(head + PYTHON)
        return f"{module}:explore"
    if kind == "json":
        module = folder / f"program_{later}.py"
        module.write_text(head + PYTHON + PROGRAM)
        return f"exec:{sys.executable} {module}"
    source, library = folder / f"latch_{later}.c", folder / f"latch_{later}.so"
    right = ROOT / "examples/c/algorithm1.c"
    source.write_text(C.format(source=right, earlier=earlier, later=later))
    header = str(Path(shared_library.__file__).parent)
    command = ["cc", "-std=gnu99", "-O1", "-shared", "-fPIC", "-I", header, "-o", str(library)]
    subprocess.run([*command, str(source)], check=True)  # the compiler
    return f"native:{library}"


def digests(kind: str, folder: Path, edges: int) -> list[int]:
    """The digests of all runs of an explorer of that kind."""
    path, name = folder / "digests", written(kind, folder, 0, 1)
    os.environ["ALLWORLDS_DIGESTS"] = str(path)
    try:
        allworlds.check(name, edges=edges)
    finally:
        del os.environ["ALLWORLDS_DIGESTS"]
    found = sorted({int(line) for line in path.read_text().split()})
    path.unlink()
    return found


def tried(kind: str, folder: Path, asked: argparse.Namespace) -> Iterator[tuple[bool, bool]]:
    """Of each pair whether it is refuted, and whether the first run is named."""
    runs, draw = digests(kind, folder, asked.edges), Random(asked.seed)  # a sample
    for _ in range(asked.pairs):
        earlier, later = draw.sample(runs, 2)
        name = written(kind, folder, earlier, later)
        report = allworlds.check(name, edges=asked.edges, workers=asked.workers)
        named = any(len(found.after) == 1 for found in report.findings)
        yield report.exit_code == 1, named


def main() -> None:
    """Print a line for each kind of explorer."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, default in (("edges", 3), ("pairs", 200), ("seed", 0), ("workers", 1)):
        parser.add_argument(f"--{name}", type=int, default=default)
    parser.add_argument("--kind", choices=["python", "c", "json"], action="append")
    asked = parser.parse_args()
    for kind in asked.kind or ["python", "c", "json"]:
        with tempfile.TemporaryDirectory() as folder:
            found = [*tried(kind, Path(folder), asked)]
        refuted, named = (sum(one) for one in zip(*found, strict=True))
        print(json.dumps({"kind": kind, "pairs": len(found), "refuted": refuted, "named": named}))


if __name__ == "__main__":
    main()
