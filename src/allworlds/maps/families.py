"""Families of large maps, by a text: ``lattice:5x6``, ``dense:7``, ``regular:4x10``, ..."""

from __future__ import annotations

import re
from collections.abc import Callable
from random import Random

from msgspec import Struct

from allworlds.inputs import InputError, show
from allworlds.maps import drawn_families as large
from allworlds.maps.build import cycle, dense, lattice
from allworlds.maps.canonical import automorphisms, rooted_code
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.maps.corridor import corridor, corridor_edges, usual_degree

LARGEST = 100_000
"""Larger maps are refused: a robot would not come to an end in them."""


class Family(Struct, frozen=True):
    """Maps of one kind, large or small.

    Attributes:
        form: how a member is written; a capital letter stands for a number.
        edges: the number of edges of the member with these numbers, without holes.
        build: the member, from these numbers, the fraction of holes, and a seed.
        has_holes: edges can be removed from it.
        one_map: without holes a seed draws no more than the dart where a robot starts.
    """

    form: str
    edges: Callable[..., int]
    build: Callable[[tuple[int, ...], float, int], CombinatorialMap]
    has_holes: bool = False
    one_map: bool = False

    @property
    def pattern(self) -> str:
        """A regular expression for the members' texts."""
        return re.sub(r"[A-Z]", r"(\\d+)", self.form)


def family(text: str, *, holes: float = 0.0, seed: int = 0) -> CombinatorialMap:
    """The map of a family.

    Args:
        text: of one of :data:`FAMILIES`, such as ``lattice:5x6`` (5 x 6 vertices in the plane),
            ``dense:7`` (a complete graph) or ``random:9`` (see :func:`random_map`).
        holes: the fraction of edges that are removed at random; lattice, strip and dense only.
        seed: of all random choices.  In a lattice or a strip these are the holes; without holes
            any seed but 0 draws dart 0, where a robot starts.

    Raises:
        InputError: naming the text, or the holes, and what would be legal.
    """
    kind, sizes = _parsed(text)
    if kind.edges(*sizes) > LARGEST:
        raise InputError(f"family {show(text)} has more than {LARGEST:,} edges")
    if holes and not kind.has_holes:
        raise InputError(f"holes are for {_WITH_HOLES}, not for {text}")
    try:
        return kind.build(sizes, holes, seed)
    except ValueError as error:
        raise InputError(f"family {text}: {error}") from None


def edges_of(text: str) -> int:
    """The number of edges of a member, without holes.  Whether it can be built is not checked.

    Raises:
        InputError: if the text is that of no family.
    """
    kind, sizes = _parsed(text)
    return kind.edges(*sizes)


def rootings(text: str, map_: CombinatorialMap, holes: float | str | None = None) -> int | None:
    """The number of rooted maps that seeds draw of a member, each with the same chance.

    Args:
        text: of the member.
        map_: the member from any seed.
        holes: of the member.

    Returns:
        The number; None where a seed draws more than the dart at which a robot starts.

    Cost: O(m^2).
    """
    kind, _ = _parsed(text)
    if not kind.one_map or holes:
        return None
    # No automorphism but the identity fixes a dart, so that all orbits of darts have one size.
    return len(map_.sigma) // automorphisms(map_)


def _parsed(text: str) -> tuple[Family, tuple[int, ...]]:
    for kind in FAMILIES:
        match = re.fullmatch(kind.pattern, text, re.ASCII)
        if match is not None:
            return kind, tuple(int(size[:7]) for size in match.groups())
    raise InputError(f"family {show(text)} is not one of {FORMS}")


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


def _random(sizes: tuple[int, ...], _holes: float, seed: int) -> CombinatorialMap:
    if sizes[0] < 1:
        raise InputError("a map has at least 1 edge")
    return random_map(sizes[0], Random(seed))  # noqa: S311  # reproducible, not secret


def _lattice(rows: int, columns: int, holes: float, seed: int) -> CombinatorialMap:
    map_ = lattice(rows, columns, holes, seed)
    if holes or not seed:
        return map_
    start = Random(seed).randrange(len(map_.sigma))  # noqa: S311  # reproducible, not secret
    return CombinatorialMap(*rooted_code(map_.sigma, map_.alpha, start))


def _drawn(
    draw: Callable[..., CombinatorialMap],
) -> Callable[[tuple[int, ...], float, int], CombinatorialMap]:
    """A family of :mod:`allworlds.maps.drawn_families`; each size is drawn independently."""

    def build(sizes: tuple[int, ...], _holes: float, seed: int) -> CombinatorialMap:
        name = "x".join(map(str, sizes))
        return draw(*sizes, Random(f"{draw.__name__}/{name}/{seed}"))  # noqa: S311  # as above

    return build


FAMILIES = (
    Family(
        "lattice:RxC",
        lambda r, c: r * (c - 1) + c * (r - 1),
        lambda size, holes, seed: _lattice(size[0], size[1], holes, seed),
        has_holes=True,
        one_map=True,
    ),
    Family(
        "strip:C",
        lambda c: 3 * c - 2,
        lambda size, holes, seed: _lattice(2, size[0], holes, seed),
        has_holes=True,
        one_map=True,
    ),
    Family(
        "dense:N",
        lambda n: n * (n - 1) // 2,
        lambda size, holes, seed: dense(size[0], holes, seed),
        has_holes=True,
    ),
    Family("cycle:N", lambda n: n, lambda size, _holes, _seed: cycle(size[0]), one_map=True),
    Family("torus:RxC", lambda r, c: 2 * r * c, _drawn(large.torus), one_map=True),
    Family("cubic:N", lambda n: 3 * n // 2, _drawn(large.cubic)),
    Family("regular:DxN", lambda d, n: d * n // 2, _drawn(large.regular)),
    Family("random:M", lambda m: m, _random),
    Family("random:NxM", lambda _n, m: m, _drawn(large.sparse)),
    Family("bouquet:C", lambda c: c + 1, _drawn(large.bouquet)),
    Family("lollipop:DxL", large.lollipop_edges, _drawn(large.lollipop)),
    Family("prism:N", lambda n: 3 * n, _drawn(large.switched_prism)),
    Family("thick:DxL", large.thick_edges, _drawn(large.thick)),
    Family("cover:K", lambda k: large.BASE_EDGES * k, _drawn(large.cover)),
    Family(
        "corridor:F",
        lambda f: corridor_edges(f, usual_degree(f)),
        lambda size, _holes, seed: corridor(size[0], usual_degree(size[0]), seed),
    ),
    Family(
        "corridor:FxR",
        corridor_edges,
        lambda size, _holes, seed: corridor(size[0], size[1], seed),
    ),
)
"""Every family."""

FORMS: str = ", ".join(kind.form for kind in FAMILIES)
"""How their members are written."""

_WITH_HOLES = " and ".join(kind.form.partition(":")[0] for kind in FAMILIES if kind.has_holes)
