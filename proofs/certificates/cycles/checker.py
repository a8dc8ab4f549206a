"""Every two cycles look alike without position, and differ with it.  See README.md.

The four conditions are written down here once more; the files must say the same.  They are
then evaluated at every point that decides them for all sizes (README.md says why these few
do), and the conclusion is checked of the cycles themselves up to 50 vertices.
"""

from __future__ import annotations

from itertools import product, zip_longest
from pathlib import Path
from typing import Any

from lrat import Refused, read
from maps import World, percepts, replay, require_bisimulation, require_map
from smtlib import Definitions, Term, assertions, commands, definitions

NUMBERS = ("n1", "n2", "i", "j", "s", "t")
"""The numbers of vertices, and a dart (i, s) of the one and (j, t) of the other cycle."""

DEFINED = """
(define-fun in-cycle ((n Int) (x Int) (a Int)) Bool
  (and (<= 0 x) (< x n) (or (= a 0) (= a 1))))
(define-fun related ((a Int) (b Int)) Bool (= a b))
(define-fun sigma-side ((a Int)) Int (- 1 a))
(define-fun alpha-vertex ((n Int) (x Int) (a Int)) Int
  (ite (= a 0) (ite (= x (- n 1)) 0 (+ x 1)) (ite (= x 0) (- n 1) (- x 1))))
(define-fun alpha-side ((a Int)) Int (- 1 a))
(define-fun degree () Int 2)
(define-fun bearing ((a Int)) Int (ite (= a 0) 0 1))
(assert (and (<= 3 n1) (<= 3 n2)))
"""

RELATED = "(and (in-cycle n1 i s) (in-cycle n2 j t) (related s t))"
CONDITIONS = {
    "1-start.smt2": ("(and (= i 0) (= j 0) (= s 0) (= t 0))", RELATED),
    "2-sigma.smt2": (
        RELATED,
        """(and (in-cycle n1 i (sigma-side s)) (in-cycle n2 j (sigma-side t))
                (related (sigma-side s) (sigma-side t)))""",
    ),
    "3-alpha.smt2": (
        RELATED,
        """(and (in-cycle n1 (alpha-vertex n1 i s) (alpha-side s))
                (in-cycle n2 (alpha-vertex n2 j t) (alpha-side t))
                (related (alpha-side s) (alpha-side t))
                (= i (alpha-vertex n1 (alpha-vertex n1 i s) (alpha-side s)))
                (= s (alpha-side (alpha-side s)))
                (= j (alpha-vertex n2 (alpha-vertex n2 j t) (alpha-side t))))""",
    ),
    "4-percepts.smt2": (
        RELATED,
        """(and (= degree degree) (= (bearing s) (bearing t))
                (= 0 (ite (= (bearing s) 0) s (sigma-side s))))""",
    ),
}
"""For each file the hypothesis and what follows from it."""

DECIDING = 8
"""Cycles with 3 to so many vertices decide the conditions for all; README.md says why."""

LARGEST = 50
SHORTEST = 9


def check(folder: Path) -> list[str]:
    """Check the claim, and return in sentences what holds."""
    points = sum(_require_condition(name, read(folder / name)) for name in CONDITIONS)
    pairs = 0
    worlds = {n: cycle(n, "compass") for n in range(3, LARGEST + 1)}
    marked = {n: cycle(n, "position") for n in range(3, LARGEST + 1)}
    for a, b in product(worlds, repeat=2):
        if a < b:
            _require_alike(worlds[a], worlds[b])
            _require_told_apart(marked[a], marked[b], a, b)
            pairs += 1
    return [
        f"4 conditions hold for all sizes: at {points:,} points, which decide them",
        f"{pairs:,} pairs of cycles up to {LARGEST} vertices: alike with a compass",
        "told apart with position by as many motions as the smaller has vertices, not by fewer",
    ]


def cycle(n: int, lighthouse: str) -> World:
    """Dart 2i leads from vertex i to the next one, dart 2i + 1 to the one before."""
    sigma = [d ^ 1 for d in range(2 * n)]
    alpha = [(d + 3) % (2 * n) if d % 2 == 0 else (d - 3) % (2 * n) for d in range(2 * n)]
    require_map(sigma, alpha)
    return World(sigma, alpha, 0, lighthouse, tuple(range(0, 2 * n, 2)))


def _require_alike(a: World, b: World) -> None:
    sides = [[d % 2 for d in range(len(world.sigma))] for world in (a, b)]
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
        turned = front | {(a.sigma[x], b.sigma[y]) for x, y in front}
        front = {(a.alpha[x], b.alpha[y]) for x, y in turned} - seen
        seen |= front
        length += 1
    return length


def script(name: str) -> list[list[Any]]:
    """The commands of a file: the hypothesis holds and what should follow does not."""
    hypothesis, conclusion = CONDITIONS[name]
    declared = "".join(f"(declare-const {number} Int)" for number in NUMBERS)
    return commands(
        f"(set-logic QF_LIA) {declared} {DEFINED} "
        f"(assert {hypothesis}) (assert (not {conclusion})) (check-sat)"
    )


def _require_condition(name: str, text: str) -> int:
    """The number of points at which the file's assertions are not all true: all of them.

    Raises:
        Refused: if the file says anything else, or the condition fails.
    """
    wanted, found = script(name), commands(text)
    for i, (mine, theirs) in enumerate(zip_longest(wanted, found), 1):
        if mine != theirs:
            raise Refused(f"{name}: command {i} is {_text(theirs)}, which is not what it should be")
    defined = definitions(wanted)
    _require_cycles(defined)
    asserted = assertions(wanted)
    points = 0
    for n1, n2 in product(range(3, DECIDING + 1), repeat=2):
        for numbers in product([n1], [n2], range(n1), range(n2), (0, 1), (0, 1)):
            point = dict(zip(NUMBERS, numbers, strict=True))
            if all(defined.value(term, point) for term in asserted):
                raise Refused(f"{name}: the condition fails at {point}")
            points += 1
    return points


def _text(term: Term | None) -> str:
    if term is None:
        return "missing"
    return term if isinstance(term, str) else f"({' '.join(map(_text, term))})"


def _require_cycles(defined: Definitions) -> None:
    """Raise Refused unless the definitions give a cycle's sigma, alpha and percepts.

    Dart 2i + s is the pair (i, s).
    """
    for n in range(3, DECIDING + 1):
        world = cycle(n, "compass")
        for d, percept in enumerate(percepts(world)):
            point = {"n": n, "i": d // 2, "s": d % 2}
            sigma, beyond, side, degree, bearing = (
                defined.value(term, point)
                for term in (
                    ["sigma-side", "s"],
                    ["alpha-vertex", "n", "i", "s"],
                    ["alpha-side", "s"],
                    "degree",
                    ["bearing", "s"],
                )
            )
            told = (2 * point["i"] + sigma, 2 * beyond + side, (degree, bearing))
            if told != (world.sigma[d], world.alpha[d], percept):
                raise Refused(f"what is defined is not the cycle with {n} vertices, at dart {d}")
