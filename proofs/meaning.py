"""What the variables of a search formula mean, and that its clauses hold of real worlds.

An LRAT proof says that a formula has no model; that the formula says what its title says is
another matter.  Here every variable gets the value that its meaning gives it in two given
worlds, from the definitions alone, and every clause is evaluated.  For two different worlds
of the title's class, the first with the smaller code, all clauses must then be true except
some of the section 'related darts sense the same': so the formula asks no more of the two
worlds than that no motion tells them apart, and it has no model only if some motion does.

This is done for worlds from an enumeration that shares no code with the formula's producer:
it would find a clause that excludes worlds that should not be excluded.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import prod

from lrat import Refused

from maps import Map, orbit

ALIKE = "related darts sense the same"


@dataclass(frozen=True)
class Annotated:
    """The comments of a formula: blocks ``name: (first variable, shape)``, sections of clauses."""

    blocks: dict[str, tuple[int, tuple[int, ...]]]
    alike: range


def read_comments(text: str) -> Annotated:
    """The blocks of variables, and the numbers of the clauses that say 'sense the same'."""
    blocks, alike = {}, range(0)
    for line in text.splitlines():
        variables = re.match(r"c variables (\d+)\.\.\d+ (\w+?)((?:\[\d+\])+): ", line)
        clauses = re.match(rf"c clauses (\d+)\.\.(\d+): {ALIKE}$", line)
        if variables:
            shape = tuple(map(int, re.findall(r"\d+", variables[3])))
            blocks[variables[2]] = (int(variables[1]), shape)
        if clauses:
            alike = range(int(clauses[1]), int(clauses[2]) + 1)
    if not blocks or not alike:
        raise Refused("the formula does not say what its variables and clauses mean")
    return Annotated(blocks, alike)


def require_meaning(
    annotated: Annotated, clauses: Sequence[Sequence[int]], one: Map, two: Map, kind: str
) -> None:
    """Nothing, if these two worlds, in canonical numbers with root 0, meet the clauses as said."""
    true = _true_variables(annotated, one, two, kind)
    wrong = [
        number
        for number, clause in enumerate(clauses, 1)
        if not any((literal > 0) == (abs(literal) in true) for literal in clause)
    ]
    unexpected = [number for number in wrong if number not in annotated.alike]
    if unexpected:
        raise Refused(f"clause {unexpected[0]} excludes the worlds {one} and {two}")
    if not wrong:
        raise Refused(f"the worlds {one} and {two} are a model: they look alike")


def answers(map_: Map) -> list[int]:
    """sigma(0), alpha(0), sigma(1), ...: the code in the order in which a formula compares it."""
    return [y for both in zip(*map_, strict=True) for y in both]


def _true_variables(annotated: Annotated, one: Map, two: Map, kind: str) -> set[int]:
    facts: dict[str, Iterable[tuple[int, ...]]] = {}
    for name, map_ in (("1", one), ("2", two)):
        facts |= {f"{block}{name}": true for block, true in _one_world(map_, kind).items()}
    facts |= _two_worlds(one, two)
    for name in annotated.blocks:
        if other := re.fullmatch(r"carried(\d+)", name):
            facts |= _other_start(one, two, int(other[1]))
    true = set()
    for name, (first, shape) in annotated.blocks.items():
        if name not in facts:
            raise Refused(f"the variables {name} have no meaning here")
        for index in facts[name]:
            if all(0 <= i < size for i, size in zip(index, shape, strict=True)):
                true.add(first + sum(i * prod(shape[k + 1 :]) for k, i in enumerate(index)))
    return true


def _ordered(permutation: Sequence[int]) -> list[int]:
    """For each dart the number of its cycle, cycles numbered by their least darts."""
    least = [min(orbit(permutation, d)) for d in range(len(permutation))]
    return [sorted(set(least)).index(d) for d in least]


def _one_world(map_: Map, kind: str) -> dict[str, Iterable[tuple[int, ...]]]:
    sigma, alpha = map_
    darts = range(len(sigma))
    vertex, face = _ordered(sigma), _ordered([sigma[e] for e in alpha])
    first = [vertex.index(vertex[d]) for d in darts]
    degree = [(d, len(orbit(sigma, d))) for d in darts]
    asked = answers(map_)
    given = [max([1, *(y + 1 for y in asked[:t])]) for t in range(len(asked) + 1)]
    pointed = [0] if kind == "directional" else []
    return {
        "sigma": list(enumerate(sigma)),
        "alpha": list(enumerate(alpha)),
        "given": [(t, j) for t, most in enumerate(given) for j in range(most + 1)],
        "vertex": list(enumerate(vertex)),
        "used": [(x, v) for x in darts for v in range(max(vertex[: x + 1]) + 1)],
        "first": [(d,) for d in darts if first[d] == d],
        "degree": degree,
        "place": [(d, orbit(sigma, first[d]).index(d)) for d in darts],
        "target": [(d, vertex[alpha[d]]) for d in darts],
        "face": list(enumerate(face)),
        "ahead": [(d, face[alpha[d]]) for d in darts],
        "met": [(x, f) for x in darts for f in range(max(face[: x + 1]) + 1)],
        "pointed": [(d,) for d in pointed],
    }


def _two_worlds(one: Map, two: Map) -> dict[str, Iterable[tuple[int, ...]]]:
    related = [(0, 0)]
    seen = {(0, 0)}
    for x, y in related:
        for pair in ((one[0][x], two[0][y]), (one[1][x], two[1][y])):
            if pair not in seen:
                seen.add(pair)
                related.append(pair)
    mine, theirs = answers(one), answers(two)
    agree = [t for t in range(len(mine) + 1) if mine[:t] == theirs[:t]]
    degree = [len(orbit(one[0], d)) for d in range(len(one[0]))]
    return {
        "related": related,
        "sigma_related": [(x, two[0][y]) for x, y in related],
        "alpha_related": [(x, two[1][y]) for x, y in related],
        "equal": [(t,) for t in agree],
        "beyond": [(d, degree[e]) for d, e in enumerate(one[1])],
    }


def _other_start(one: Map, two: Map, start: int) -> dict[str, Iterable[tuple[int, ...]]]:
    """F numbers the darts of ``two`` from ``start`` as the walk through ``one`` prescribes."""
    carried = {0: start}
    for x in range(len(one[0])):
        for mine, theirs in zip(one, two, strict=True):
            carried.setdefault(mine[x], theirs[carried[x]])
    steps = list(enumerate(zip(one, two, strict=True)))
    return {
        f"carried{start}": list(carried.items()),
        **{f"image{p}_{start}": [(x, b[y]) for x, y in carried.items()] for p, (_, b) in steps},
        f"breaks{start}": [
            (p, x) for p, (a, b) in steps for x, y in carried.items() if carried[a[x]] != b[y]
        ],
    }
