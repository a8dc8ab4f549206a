"""What several claims have in common: refute a formula, and tie it to what it says."""

from __future__ import annotations

import random
from collections.abc import Sequence
from pathlib import Path

import lrat
from meaning import answers, read_comments, require_meaning

from maps import Code, Map, code, marked_code, orbit, positioned

PAIRS = 60
"""Pairs of worlds on which the meaning of a formula is tested."""


def refuted(folder: Path, name: str, worlds: Sequence[Map], kind: str) -> int:
    """The length of the proof that formula ``name`` of the folder has no model.

    Its meaning is tested on pairs of the rooted maps ``worlds``, a fixed random choice.

    Raises:
        Refused: if the proof is wrong, or the formula does not mean what it should.
    """
    text = lrat.read(folder / f"{name}.cnf.xz")
    variables, clauses = lrat.read_formula(text)
    try:
        proof = lrat.read(folder / f"{name}.lrat.xz").splitlines()
        derived = lrat.check(variables, clauses, proof)
    except lrat.Refused as error:
        raise lrat.Refused(f"{name}.lrat.xz: {error}") from None
    annotated = read_comments(text)
    for one, two in _pairs(worlds, kind):
        require_meaning(annotated, clauses, one, two, kind)
    return derived


def _pairs(worlds: Sequence[Map], kind: str) -> list[tuple[Map, Map]]:
    """Pairs of different worlds in canonical numbers, the one with the smaller code first."""
    chance = random.Random(0)
    pairs: list[tuple[Map, Map]] = []
    for _ in range(PAIRS if len(worlds) > 1 else 0):
        chosen = [code(*_best_rooted(map_, kind), 0) for map_ in chance.sample(worlds, 2)]
        if len({_marked(map_, kind) for map_ in chosen}) == 2:
            one, two = sorted(chosen, key=answers)
            pairs.append((one, two))
    return pairs


def _marked(map_: Map, kind: str) -> Code:
    return marked_code(positioned(map_)) if kind == "position" else code(*map_, 0)


def _best_rooted(map_: Map, kind: str) -> Map:
    """With position the start may be any dart of v0; the formula takes a best one."""
    sigma, alpha = map_
    if kind != "position":
        return map_
    around = orbit(sigma, 0)
    best = max(around, key=lambda d: len(orbit(sigma, alpha[d])))
    return code(sigma, alpha, best)
