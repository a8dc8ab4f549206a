"""Quotients: labelled maps in which indistinguishable darts are identified.

Two darts are *alike* if every word of sigmas and alphas leads from both to equal labels; a
*class* holds all darts that are alike.  Classes are numbered in canonical order: the class
of the root is 0, and then the oldest numbered class q gives the next free numbers to
``sigma[q]`` and ``alpha[q]``.  So two rooted quotients are isomorphic exactly if they are
equal.

The map is a cover of its quotient with k = 2m / |Q| *sheets*: k darts lie over each class.
Where l classes lie round a vertex of the quotient and the vertices over it have degree
delta, ``delta / l`` is its *cone index*: a vertex of the map goes round it so often.
``alpha[q] == q`` is a *semi-edge*.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from functools import cached_property
from typing import NamedTuple, TypeAlias

from msgspec import Struct

from allworlds.maps.canonical import numbering
from allworlds.maps.combinatorial import CombinatorialMap, Dart, cycles
from allworlds.maps.refinement import coarsest_partition


class Quotient(Struct, frozen=True, dict=True):
    """A quotient rooted at class 0, in canonical numbering.

    Attributes:
        sigma, alpha: of the classes; alpha may have fixed points.
        degree: for each class the degree of the vertices over it.
        labels: for each class the label of its darts.
        sheets: k, the number of darts over each class.
    """

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    degree: tuple[int, ...]
    labels: tuple[Hashable, ...]
    sheets: int

    @cached_property
    def vertices(self) -> tuple[tuple[int, ...], ...]:
        """The cycles of sigma, each from its smallest class, ascending by it.

        The first is the vertex of the root.
        """
        return cycles(self.sigma)

    @cached_property
    def vertex_of(self) -> tuple[int, ...]:
        """For each class the index of its vertex in :attr:`vertices`."""
        owner = [0] * len(self.sigma)
        for index, vertex in enumerate(self.vertices):
            for q in vertex:
                owner[q] = index
        return tuple(owner)

    @cached_property
    def cone_indices(self) -> tuple[int, ...]:
        """For each vertex how often a vertex of the map goes round it; divides k."""
        return tuple(self.degree[vertex[0]] // len(vertex) for vertex in self.vertices)

    @cached_property
    def semi_edges(self) -> tuple[int, ...]:
        """The classes that alpha fixes."""
        return tuple(q for q, other in enumerate(self.alpha) if q == other)

    @cached_property
    def edges(self) -> tuple[tuple[int, int], ...]:
        """The ordinary edges ``(q, alpha[q])`` with ``q < alpha[q]``, ascending."""
        return tuple((q, other) for q, other in enumerate(self.alpha) if q < other)

    @property
    def beta1(self) -> int:
        """The number of ordinary edges outside a spanning tree."""
        return len(self.edges) - len(self.vertices) + 1

    @cached_property
    def cotree(self) -> tuple[tuple[int, int], ...]:
        """The edges outside the spanning tree that is found breadth-first from the root."""
        reached, tree = {0}, set()
        queue = [0]
        for v in queue:
            for q in self.vertices[v]:
                w = self.vertex_of[self.alpha[q]]
                if w not in reached:
                    reached.add(w)
                    tree.add(min(q, self.alpha[q]))
                    queue.append(w)
        return tuple(edge for edge in self.edges if edge[0] not in tree)

    def rerooted(self, root: int) -> Quotient:
        """Return the quotient rooted at another class."""
        order = numbering(self.sigma, self.alpha, root)
        number = {q: i for i, q in enumerate(order)}
        return Quotient(
            tuple(number[self.sigma[q]] for q in order),
            tuple(number[self.alpha[q]] for q in order),
            tuple(self.degree[q] for q in order),
            tuple(self.labels[q] for q in order),
            self.sheets,
        )


class Projection(NamedTuple):
    """A map onto its quotient: ``classes[d]`` is the class of dart ``d``."""

    quotient: Quotient
    classes: tuple[int, ...]


Labelled: TypeAlias = tuple[CombinatorialMap, Sequence[Hashable], Dart]
"""A rooted map with a label at every dart: map, labels by dart, root."""


def project(labelled: Labelled) -> Projection:
    """The quotient rooted at the class of the root, and the class of each dart.

    Darts of different degrees are never alike, whatever their labels.

    Cost: O(m log m).
    """
    map_, labels, _ = labelled
    (classes,) = classes_of_union(labelled)
    members = [0] * (max(classes) + 1)
    for dart, q in enumerate(classes):
        members[q] = dart
    quotient = Quotient(
        tuple(classes[map_.sigma[d]] for d in members),
        tuple(classes[map_.alpha[d]] for d in members),
        tuple(map_.degree_at[d] for d in members),
        tuple(labels[d] for d in members),
        len(classes) // len(members),
    )
    return Projection(quotient, classes)


def classes_of_union(*parts: Labelled) -> tuple[tuple[int, ...], ...]:
    """For each of several maps the class of each dart, with classes common to all maps.

    Numbered in canonical order from the root of the first; then from the root of the second
    those that are new there, and so on.

    Cost: O(M log M) for M darts in all.
    """
    sigma: list[int] = []
    alpha: list[int] = []
    labels: list[Hashable] = []
    roots = []
    for map_, given, root in parts:
        shift = len(sigma)
        roots.append(root + shift)
        sigma += [d + shift for d in map_.sigma]
        alpha += [d + shift for d in map_.alpha]
        labels += zip(map_.degree_at, given, strict=True)
    block = coarsest_partition(labels, (sigma, alpha))
    number: dict[int, int] = {}
    for root in roots:
        for representative in _breadth_first(root, block, sigma, alpha, set(number)):
            number[block[representative]] = len(number)
    all_classes = iter([number[b] for b in block])
    return tuple(tuple(next(all_classes) for _ in map_.darts) for map_, _, _ in parts)


def _breadth_first(
    root: int, block: Sequence[int], sigma: Sequence[int], alpha: Sequence[int], known: set[int]
) -> Iterator[int]:
    """One dart of each block that can be reached from the root and is not known."""
    queue = [root] if block[root] not in known else []
    known.add(block[root])
    for x in queue:
        yield x
        for y in (sigma[x], alpha[x]):
            if block[y] not in known:
                known.add(block[y])
                queue.append(y)
