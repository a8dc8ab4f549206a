"""Families of large maps, by a text: ``lattice:5x6``, ``dense:7``, ``cycle:9``, ``random:12``."""

from __future__ import annotations

import re
from collections.abc import Callable
from math import prod
from random import Random

from allworlds.inputs import InputError, show
from allworlds.maps.build import cycle, dense, lattice
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap

LARGEST = 100_000
"""Larger maps are refused: a robot would not come to an end in them."""

_FORMS = "lattice:RxC, dense:N, cycle:N, random:M"


def family(text: str, *, holes: float = 0.0, seed: int = 0) -> CombinatorialMap:
    """The map of a family.

    Args:
        text: ``lattice:RxC`` (R x C vertices in the plane), ``dense:N`` (a complete graph),
            ``cycle:N`` or ``random:M`` (see :func:`random_map`).
        holes: the fraction of edges that are removed at random; lattice and dense only.
        seed: for the holes, and for ``random``.

    Raises:
        InputError: naming the text, or the holes, and what would be legal.
    """
    for pattern, has_holes, build in _FAMILIES:
        match = re.fullmatch(pattern, text, re.ASCII)
        if match is None:
            continue
        sizes = [int(size[:7]) for size in match.groups()]
        if prod(sizes) > LARGEST or (text.startswith("dense") and sizes[0] ** 2 > 2 * LARGEST):
            raise InputError(f"family {show(text)} has more than {LARGEST:,} edges")
        if holes and not has_holes:
            raise InputError(f"holes are for lattice and dense, not for {text}")
        try:
            return build(sizes, holes, seed)
        except ValueError as error:
            raise InputError(f"family {text}: {error}") from None
    raise InputError(f"family {show(text)} is none of {_FORMS}")


def random_map(edges: int, random: Random) -> CombinatorialMap:
    """A rooted map with that many edges, uniform among all of them; its root is dart 0.

    A uniform permutation sigma with alpha fixed is drawn until it is connected: each rooted
    map has equally many labellings that keep its root and alpha.

    Cost: O(m), and fewer than two draws on average for m >= 2.
    """
    darts = list(range(2 * edges))
    alpha = [d ^ 1 for d in darts]
    while True:
        sigma = darts[:]
        random.shuffle(sigma)
        try:
            return CombinatorialMap(sigma, alpha)
        except InvalidMap:
            continue


def _random(sizes: list[int], _holes: float, seed: int) -> CombinatorialMap:
    if sizes[0] < 1:
        raise InputError("a map has at least 1 edge")
    return random_map(sizes[0], Random(seed))  # noqa: S311  # reproducible, not secret


_FAMILIES: list[tuple[str, bool, Callable[[list[int], float, int], CombinatorialMap]]] = [
    (r"lattice:(\d+)x(\d+)", True, lambda size, *how: lattice(size[0], size[1], *how)),
    (r"dense:(\d+)", True, lambda size, *how: dense(size[0], *how)),
    (r"cycle:(\d+)", False, lambda size, _holes, _seed: cycle(size[0])),
    (r"random:(\d+)", False, _random),
]
