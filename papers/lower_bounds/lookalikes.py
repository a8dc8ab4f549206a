"""Beyond the paper: worlds that look alike when only the position is marked, and their number."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from fractions import Fraction
from math import factorial, prod

from allworlds import CombinatorialMap, World, ambiguity
from allworlds.claims import Found, Means, truth
from allworlds.maps import (
    Quotient,
    automorphisms,
    class_size,
    is_ambiguous,
    project,
    rooted_code,
    rooted_maps,
    unrooted_code,
)


def _by_quotient(edges: int) -> Iterator[dict[object, list[tuple[CombinatorialMap, Quotient]]]]:
    """For each number of edges all rooted maps, by the quotient with the root's vertex marked."""
    for m in range(1, edges + 1):
        alike: dict[object, list[tuple[CombinatorialMap, Quotient]]] = defaultdict(list)
        for map_ in rooted_maps(m):
            quotient = project((map_, World(map_, "position").percepts, 0)).quotient
            alike[quotient.sigma, quotient.alpha, quotient.degree, quotient.labels].append(
                (map_, quotient)
            )
        yield alike


def _marked(map_: CombinatorialMap) -> object:
    """The least of the codes of all darts of the marked vertex."""
    around = map_.vertices[map_.vertex_of[0]]
    return min(rooted_code(map_.sigma, map_.alpha, dart) for dart in around)


def criterion(_: Means, *, edges: int) -> Found:
    """Compare the quotient's criterion, which needs no world, with the grouping of all worlds."""
    worlds = ambiguous = wrong = exceptions = 0
    for alike in _by_quotient(edges):
        for group in alike.values():
            members = {_marked(map_) for map_, _quotient in group}
            for _map, quotient in group:
                worlds += 1
                ambiguous += len(members) > 1
                wrong += not is_ambiguous(quotient) == _said(quotient) == (len(members) > 1)
                exception = quotient.sheets == 2 and not quotient.beta1 and _turned(quotient)
                exceptions += exception
    seen = {"worlds": worlds, "ambiguous": ambiguous, "with k = 2 and no cycle": exceptions}
    return Found(truth(wrong == 0), seen)


def _said(quotient: Quotient) -> bool:
    """The criterion: a cycle with k >= 2, or a semi-edge or a cone elsewhere with k >= 3."""
    k = quotient.sheets
    return (k >= 2 and quotient.beta1 > 0) or (k >= 3 and _turned(quotient))


def _turned(quotient: Quotient) -> bool:
    """Whether there is a semi-edge, or a cone at another vertex than that of v0."""
    return bool(quotient.semi_edges) or any(b > 1 for b in quotient.cone_indices[1:])


def class_sizes(_: Means, *, edges: int) -> Found:
    """Compare Burnside's count of the class with its members among all worlds."""
    classes = larger = wrong = 0
    for alike in _by_quotient(edges):
        for group in alike.values():
            members = {_marked(map_) for map_, _quotient in group}
            classes += 1
            larger += len(members) > 1
            wrong += class_size(group[0][1]) != len(members)
    seen = {"classes": classes, "of two or more": larger}
    return Found(truth(wrong == 0), seen)


def mass_formula(_: Means, *, edges: int) -> Found:
    """Compare P by the formula with the sum of k / |Aut| over the enumerated members."""
    classes = wrong = 0
    for alike in _by_quotient(edges):
        for group in alike.values():
            quotient = group[0][1]
            members = {_marked(map_): map_ for map_, _quotient in group}
            mass = sum(Fraction(quotient.sheets, _symmetries(map_)) for map_ in members.values())
            classes += 1
            poses = ambiguity.class_of(World(group[0][0], "position")).poses
            wrong += not mass == poses == _choices(quotient)
    return Found(truth(wrong == 0), {"classes": classes})


def _choices(quotient: Quotient) -> int:
    """``(k!)^beta1 N(k,2)^s prod N(k,b_v)``, with ``N(k,b) = k! / (b^(k/b) (k/b)!)``."""
    k = quotient.sheets
    lengths = [2] * len(quotient.semi_edges) + [*quotient.cone_indices[1:]]
    free: int = factorial(k) ** quotient.beta1
    ways: int = prod(factorial(k) // (b ** (k // b) * factorial(k // b)) for b in lengths)
    return free * ways


def _symmetries(map_: CombinatorialMap) -> int:
    """The automorphisms that leave the marked vertex where it is."""
    code = rooted_code(map_.sigma, map_.alpha, 0)
    around = map_.vertices[map_.vertex_of[0]]
    return sum(rooted_code(map_.sigma, map_.alpha, dart) == code for dart in around)


def lookalikes_one_size(_: Means, *, edges: int) -> Found:
    """Group all rooted maps of any size by quotient, and compare m, n and the degrees."""
    alike: dict[object, set[object]] = defaultdict(set)
    worlds = 0
    for level in _by_quotient(edges):
        for learnt, group in level.items():
            for map_, _quotient in group:
                worlds += 1
                alike[learnt].add((map_.edge_count, tuple(sorted(map_.degrees))))
    several = sum(len(sizes) > 1 for sizes in alike.values())
    return Found(truth(not several), {"worlds": worlds, "quotients": len(alike)})


def two_sheets(_: Means, *, edges: int) -> Found:
    """Check that for k = 2 the class has 2^beta1 members, each class made by lifting."""
    classes = wrong = 0
    for alike in _by_quotient(edges):
        for group in alike.values():
            map_, quotient = group[0]
            if quotient.sheets == 2:
                classes += 1
                made = ambiguity.class_of(World(map_, "position"))
                wrong += not len(made.worlds) == made.size == 2**quotient.beta1
    return Found(truth(wrong == 0), {"classes": classes})


def counts(_: Means, *, edges: int) -> Found:
    """Check that the sum of 2m / |Aut| over unrooted maps is the number of rooted ones."""
    rooted = []
    agree = True
    for m in range(1, edges + 1):
        every = list(rooted_maps(m))
        unrooted = {unrooted_code(map_): map_ for map_ in every}
        weight = sum(Fraction(2 * m, automorphisms(map_)) for map_ in unrooted.values())
        agree = agree and weight == len(every)
        rooted.append(len(every))
    return Found(truth(agree), {"maps": sum(rooted)}, {"rooted": rooted})
