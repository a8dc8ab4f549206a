"""Every two cycles look alike without position, and differ with it: instances.  See README.md.

The conditions for all sizes are proved by z3 (``prove.py``), and by hand in README.md; here the
same files are evaluated, without a solver, at every point of small cycles, and the conclusion is
checked of the cycles themselves up to 50 vertices.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import product
from pathlib import Path
from typing import Any

from lrat import Refused, read

from maps import World, percepts, replay, require_bisimulation, require_map

FILES = ["1-start.smt2", "2-sigma.smt2", "3-alpha.smt2", "4-percepts.smt2"]
EVALUATED = 5
LARGEST = 50
SHORTEST = 9


def check(folder: Path) -> list[str]:
    """What has been checked, sentence by sentence."""
    points = sum(_evaluate(name, read(folder / name)) for name in FILES)
    pairs = 0
    worlds = {n: cycle(n, "compass") for n in range(3, LARGEST + 1)}
    marked = {n: cycle(n, "position") for n in range(3, LARGEST + 1)}
    for a, b in product(worlds, repeat=2):
        if a < b:
            _require_alike(worlds[a], worlds[b])
            _require_told_apart(marked[a], marked[b], a, b)
            pairs += 1
    return [
        f"4 conditions hold at {points:,} points of cycles with 3 to {EVALUATED} vertices",
        f"{pairs:,} pairs of cycles up to {LARGEST} vertices: alike with a compass",
        "told apart with position by as many motions as the smaller has vertices, not by fewer",
    ]


def cycle(n: int, kind: str) -> World:
    """Dart 2i leads from vertex i to the next one, dart 2i + 1 to the one before."""
    sigma = [d ^ 1 for d in range(2 * n)]
    alpha = [(d + 3) % (2 * n) if d % 2 == 0 else (d - 3) % (2 * n) for d in range(2 * n)]
    require_map(sigma, alpha)
    lighthouse = {"kind": kind, "dart": 0, "darts": list(range(0, 2 * n, 2))}
    return {"sigma": sigma, "alpha": alpha, "start": 0, "lighthouse": lighthouse}


def _require_alike(a: World, b: World) -> None:
    sides = [[d % 2 for d in range(len(world["sigma"]))] for world in (a, b)]
    require_bisimulation([a, b], sides)


def _require_told_apart(a: World, b: World, n: int, other: int) -> None:
    round_trip = [0] + [1] * (n - 1)
    mine, theirs = replay(a, 0, round_trip), replay(b, 0, round_trip)
    if mine[:-1] != theirs[:-1] or mine[-1] == theirs[-1]:
        raise Refused(f"{n} motions do not tell the cycles {n} and {other} apart")
    if other <= SHORTEST and _shortest(a, b) != n:
        raise Refused(f"fewer than {n} motions tell the cycles {n} and {other} apart")


def _shortest(a: World, b: World) -> int:
    """The least number of motions after which the two robots sense different things."""
    sensed = percepts(a), percepts(b)
    front, seen, length = {(0, 0)}, {(0, 0)}, 0
    while all(sensed[0][x] == sensed[1][y] for x, y in front):
        turned = front | {(a["sigma"][x], b["sigma"][y]) for x, y in front}
        front = {(a["alpha"][x], b["alpha"][y]) for x, y in turned} - seen
        seen |= front
        length += 1
    return length


def _evaluate(name: str, text: str) -> int:
    """The number of points at which the file's assertions are not all true: all of them."""
    points = 0
    definitions: dict[str, tuple[list[str], Any]] = {}
    assertions = []
    for command in _expressions(text):
        if command[0] == "define-fun":
            definitions[command[1]] = ([argument[0] for argument in command[2]], command[4])
        elif command[0] == "assert":
            assertions.append(command[1])
    _require_cycles(name, definitions)
    sizes = range(3, EVALUATED + 1)
    for n1, n2 in product(sizes, repeat=2):
        for i, j, s, t in product(range(n1), range(n2), (0, 1), (0, 1)):
            point = {"n1": n1, "n2": n2, "i": i, "j": j, "s": s, "t": t}
            if all(_value(assertion, point, definitions) for assertion in assertions):
                raise Refused(f"{name}: the condition fails at {point}")
            points += 1
    if not assertions or assertions[-1][0] != "not":
        raise Refused(f"{name}: the last assertion is no negation")
    return points


def _require_cycles(name: str, definitions: dict[str, Any]) -> None:
    """Nothing, if the file's sigma, alpha and bearing are a cycle's; dart 2i + s is (i, s)."""

    def file(function: str, *arguments: int) -> Any:
        return _value([function, *map(str, arguments)], {}, definitions)

    for n in range(3, EVALUATED + 1):
        world = cycle(n, "compass")
        for d, (degree, bearing) in enumerate(percepts(world)):
            i, s = divmod(d, 2)
            beyond = 2 * file("alpha-vertex", n, i, s) + file("alpha-side", s)
            told = (2 * i + file("sigma-side", s), beyond, file("bearing", s))
            if told != (world["sigma"][d], world["alpha"][d], bearing) or degree != 2:
                raise Refused(f"{name}: what it defines is not the cycle, at dart ({i}, {s})")


def _expressions(text: str) -> Iterator[Any]:
    """The commands of an SMT-LIB text as nested lists."""
    stack: list[list[Any]] = [[]]
    for sign in re.findall(r"[()]|[^\s()]+", re.sub(r";.*", "", text)):
        if sign == "(":
            stack.append([])
        elif sign == ")":
            if len(stack) == 1:
                raise Refused("a parenthesis too many")
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(sign)
    if len(stack) != 1:
        raise Refused("a parenthesis is missing")
    yield from stack[0]


def _value(term: Any, point: dict[str, int], definitions: dict[str, Any]) -> Any:
    if isinstance(term, str):
        if term in definitions:
            return _value(definitions[term][1], {}, definitions)
        return point[term] if term in point else int(term)
    head, *arguments = term
    if head == "ite":
        chosen = arguments[1 if _value(arguments[0], point, definitions) else 2]
        return _value(chosen, point, definitions)
    values = [_value(argument, point, definitions) for argument in arguments]
    if head in definitions:
        names, body = definitions[head]
        return _value(body, dict(zip(names, values, strict=True)), definitions)
    known: dict[str, Any] = {
        "and": lambda: all(values),
        "or": lambda: any(values),
        "not": lambda: not values[0],
        "=": lambda: values[0] == values[1],
        "<=": lambda: values[0] <= values[1],
        "<": lambda: values[0] < values[1],
        "+": lambda: sum(values),
        "-": lambda: values[0] - sum(values[1:]),
    }
    if head not in known:
        raise Refused(f"{head} is no operation that is known here")
    return known[head]()
