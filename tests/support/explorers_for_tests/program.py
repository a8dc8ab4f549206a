"""A program that speaks JSON lines: Algorithm 1, and everything that can be done wrong.

Usage: program.py KIND [FILE].  It knows nothing of the package.
"""

# ruff: noqa: PTH123, T201
import json
import os
import sys
import time


def say(**message):
    sys.stdout.write(json.dumps(message) + "\n")
    sys.stdout.flush()


def raw(data):
    sys.stdout.buffer.write(data)
    sys.stdout.buffer.flush()


def hear():
    line = sys.stdin.readline()
    if not line:
        sys.exit()
    return json.loads(line)["percept"]


def move(k, **more):
    say(move=k, **more)
    return hear()


def way(glue, degree, start, goal):
    """The darts of a shortest path in S between two vertices."""
    queue = [(start, ())]
    seen = {start}
    for vertex, path in queue:
        if vertex == goal:
            return path
        for i in range(degree[vertex]):
            other = glue.get((vertex, i), (vertex, 0))[0]
            if other not in seen:
                seen.add(other)
                queue.append((other, (*path, (vertex, i))))
    raise AssertionError


def explore(first, walk=move):
    degree, glue, here = [first["degree"]], {}, (0, 0)
    unexplored = [(0, i) for i in range(first["degree"])]

    def expected(dart):
        v, i = dart
        bearing = (first["bearing"] - i) % degree[0] if v == 0 else None
        return {"degree": degree[v], "marks": int(v == 0), "bearing": bearing}

    while unexplored:
        edge = unexplored.pop(0)
        for dart in way(glue, degree, here[0], edge[0]):
            walk(dart[1] - here[1])
            here = glue[dart]
        seen = walk(edge[1] - here[1])
        turned, found = 0, None
        for guess in [dart for dart in unexplored if expected(dart) == seen]:
            path, at, motions, matches = way(glue, degree, guess[0], 0), guess, [], True
            for dart in path:
                motions.append(dart[1] - at[1])
                at = glue[dart]
                if walk(motions[-1] - turned) != expected(at):
                    matches = False
                turned = 0
                if not matches:
                    break
            if matches:
                found, here = guess, at
                break
            back = 0
            for motion in reversed(motions):
                walk(back)
                back = -motion
            turned = motions[0]
        if found is None:
            found = (len(degree), 0)
            degree.append(seen["degree"])
            unexplored += [(found[0], i) for i in range(1, seen["degree"])]
            here = (found[0], turned % seen["degree"])
        else:
            unexplored.remove(found)
        glue[edge], glue[found] = found, edge
    darts = [(v, i) for v, d in enumerate(degree) for i in range(d)]
    return {
        "sigma": [darts.index((v, (i + 1) % degree[v])) for v, i in darts],
        "alpha": [darts.index(glue[dart]) for dart in darts],
        "here": darts.index(here),
    }


def misbehave(kind, first):
    match kind:
        case "silent":
            time.sleep(1000)
        case "silent-later":
            move(0)
            time.sleep(1000)
        case "ends":
            print("I am tired", file=sys.stderr)
            sys.exit(7)
        case "no-json":
            raw(b"move 0\n")
        case "empty-line":
            raw(b"\n")
        case "no-object":
            raw(b"[1, 2]\n")
        case "bad-utf8":
            raw(b'{"move": "\xff\xfe"}\n')
        case "huge-line":
            raw(b"x" * (1 << 24) + b"xx")
            time.sleep(1000)
        case "deep":
            raw(b"[" * 100_000 + b"\n")
        case "bool-move":
            say(move=True)
        case "float-move":
            say(move=1.0)
        case "unknown":
            say(jump=1)
        case "drop":
            say(drop=True)
        case "checkpoint-no-object":
            say(checkpoint=3)
        case "no-map":
            return say(estimate={"sigma": [0], "alpha": [0], "here": 0})
        case "no-object-estimate":
            return say(estimate=None)
        case "here-is-none":
            return say(estimate={"sigma": [0, 1], "alpha": [1, 0]})
        case "checkpoint-of-sigma":
            return say(checkpoint={"sigma": [0, 1]})
        case "two-estimates":
            line = json.dumps({"estimate": explore(first)}) + "\n"
            raw(line.encode() * 2)
        case "deaf":
            while True:
                raw(b'{"move": 0}\n')
    return hear()


def main(kind, file=None):
    if file:
        with open(file, "a") as pids:
            pids.write(f"{os.getpid()}\n")
    while True:
        line = sys.stdin.readline()
        if not line:
            break
        message = json.loads(line)
        first = message["percept"]
        if kind in ("right", "never-exits"):
            say(estimate=explore(first))
        elif kind == "chatty":
            say(checkpoint={"sigma": [0], "alpha": [0], "here": 0, "mood": "good"})
            answer = explore(first, lambda k: move(k + 7 * 60, why="because"))
            say(estimate=answer, sure=True)
        elif kind == "dies-between":
            say(estimate=explore(first))
            break
        elif kind == "lazy":
            say(estimate={"sigma": [0, 1], "alpha": [1, 0], "here": 0})
        else:
            misbehave(kind, first)
    while kind == "never-exits":
        time.sleep(1000)


main(*sys.argv[1:])
