"""Canonical codes, automorphisms, and isomorphisms that come with their witness.

The code of a map rooted at ``r``: number ``r`` with 0; then take the numbered darts in the
order of their numbers and give the next free numbers to ``sigma(x)`` and ``alpha(x)``.  The
code is ``(sigma, alpha)`` written in these numbers.  Two rooted maps are the same exactly
when their codes are equal, because an isomorphism is fixed by the image of one dart.
Codes are compared lexicographically, sigma first.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from msgspec import Struct

from allworlds.maps.combinatorial import CombinatorialMap, Dart, inverse

Code: TypeAlias = tuple[tuple[int, ...], tuple[int, ...]]
"""A canonical code: ``(sigma, alpha)`` of a rooted map whose root is dart 0."""


class Mismatch(Struct, frozen=True):
    """The reason why two maps are not the same, a sentence."""

    reason: str

    def __bool__(self) -> bool:
        """Return False, so that ``if isomorphism(a, b)`` means: if they are the same map."""
        return False


def numbering(sigma: Sequence[Dart], alpha: Sequence[Dart], root: Dart) -> list[Dart]:
    """The darts in the order of their canonical numbers.

    Shape: ``order[i]`` is the dart with number ``i``.  Cost: O(m).
    """
    seen = [False] * len(sigma)
    seen[root] = True
    order = [root]
    for x in order:
        for y in (sigma[x], alpha[x]):
            if not seen[y]:
                seen[y] = True
                order.append(y)
    return order


def rooted_code(sigma: Sequence[Dart], alpha: Sequence[Dart], root: Dart) -> Code:
    """The canonical code of the map rooted at ``root``.  Cost: O(m)."""
    order = numbering(sigma, alpha, root)
    number = inverse(order)
    return tuple([number[sigma[x]] for x in order]), tuple([number[alpha[x]] for x in order])


def unrooted_code(map_: CombinatorialMap) -> Code:
    """The least code among all rootings: equal exactly for the same maps.  Cost: O(m^2)."""
    return min(rooted_code(map_.sigma, map_.alpha, root) for root in map_.darts)


def automorphisms(map_: CombinatorialMap) -> int:
    """The number of automorphisms of the map (orientation preserving; at least 1).

    Each is fixed by the image of dart 0, so the number divides 2m.  Cost: O(m^2) at worst.
    """
    sigma, alpha = map_.sigma, map_.alpha
    order = numbering(sigma, alpha, 0)
    return sum(carries(sigma, alpha, order, sigma, alpha, d) for d in map_.darts)


def carries(
    sigma: Sequence[Dart],
    alpha: Sequence[Dart],
    order: Sequence[Dart],
    other_sigma: Sequence[Dart],
    other_alpha: Sequence[Dart],
    image: Dart,
) -> bool:
    """Whether ``order[0] -> image`` extends to an isomorphism onto a map of the same size.

    ``order`` is the :func:`numbering` of the first map.  Cost: O(m), and O(1) on average
    where there is none.
    """
    to = [-1] * len(sigma)
    to[order[0]] = image
    for x in order:
        y = to[x]
        for here, there in ((sigma, other_sigma), (alpha, other_alpha)):
            a, b = here[x], there[y]
            if to[a] == -1:
                to[a] = b
            elif to[a] != b:
                return False
    # A map that commutes with two transitive actions on equally many darts is onto.
    return True


def isomorphism(a: CombinatorialMap, b: CombinatorialMap) -> tuple[Dart, ...] | Mismatch:
    """A bijection ``w`` of darts with ``w . sigma = sigma . w`` and ``w . alpha = alpha . w``.

    Shape: ``w[d]`` is the dart of ``b`` for dart ``d`` of ``a``; of all witnesses the one
    with the smallest image of dart 0.  If there is none, a :class:`Mismatch`.
    """
    counted = (
        ("edges", a.edge_count, b.edge_count),
        ("vertices", a.vertex_count, b.vertex_count),
        ("faces", len(a.faces), len(b.faces)),
        ("degrees", sorted(a.degrees), sorted(b.degrees)),
    )
    for what, mine, theirs in counted:
        if mine != theirs:
            return Mismatch(f"the {what} differ: {mine} and {theirs}")
    order = numbering(a.sigma, a.alpha, 0)
    for image in b.darts:
        if carries(a.sigma, a.alpha, order, b.sigma, b.alpha, image):
            return rooted_isomorphism(a, 0, b, image)
    return Mismatch(
        "edges, vertices, faces and degrees agree, but no image of dart 0 extends to all darts"
    )


def rooted_isomorphism(
    a: CombinatorialMap, root: Dart, b: CombinatorialMap, other: Dart
) -> tuple[Dart, ...] | Mismatch:
    """The one isomorphism with ``root -> other``, or the first place where it breaks."""
    to = {root: other}
    back = {other: root}
    todo = [root]
    for x in todo:
        y = to[x]
        if a.degree_at[x] != b.degree_at[y]:
            return Mismatch(
                f"dart {x} is at a vertex of degree {a.degree_at[x]}, "
                f"its image {y} at one of degree {b.degree_at[y]}"
            )
        for name, p, q in (("sigma", a.sigma, b.sigma), ("alpha", a.alpha, b.alpha)):
            here, there = p[x], q[y]
            if here not in to and there not in back:
                to[here], back[there] = there, here
                todo.append(here)
            elif to.get(here) != there:
                so_far = (
                    f"it is already {to[here]}"
                    if here in to
                    else f"that is already the image of {back[there]}"
                )
                return Mismatch(
                    f"{name}({x}) = {here} would have to become {name}({y}) = {there}, but {so_far}"
                )
    return tuple(to[d] for d in a.darts)
