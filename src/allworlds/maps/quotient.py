"""The least quotient of a map with labelled darts, and the number of worlds that share a quotient.

In the quotient, darts that look alike are merged into one *class*.  All classes have the same size
k, the number of *sheets*.  A class that alpha maps to itself is a *semi-edge*; all other edges of
the quotient are *ordinary*.  The root of the quotient is a class at the vertex v0.  A vertex of the
quotient is a cycle of classes.  Round a vertex of the map with darts in these classes, the cycle is
repeated; the number of its repetitions is the *cone index* of the quotient's vertex.

The lighthouse ``position`` is one mark at v0, without a direction.  Under this lighthouse finitely
many worlds share a rooted quotient.  Each of them is made from the quotient and k sheets by a
*choice*: some permutations of the sheets.  (The choices of an explorer are something else.)

Each vertex but v0 has a permutation, in which every cycle has the vertex's cone index as its
length.  The permutation tells to which sheet a robot comes from each sheet when it turns clockwise
past every class of the vertex once.  At v0 the permutation is fixed: a cyclic shift c of all k
sheets.

Each edge has a permutation, too, which tells to which sheet the edge leads from each sheet.  For a
semi-edge, all cycles of the permutation have length 2.  For an ordinary edge outside a spanning
tree, it is any permutation.  For an edge of the tree, it is the identity.

Two choices make the same world if and only if a renumbering of the sheets by a power of c takes one
choice to the other (docs/ambiguity.md): each permutation p becomes ``c^i p c^-i`` with the same i.
"""

from collections import Counter
from collections.abc import Hashable, Sequence
from functools import cached_property
from itertools import accumulate
from math import factorial, gcd, perm, prod
from typing import NamedTuple, TypeAlias

from msgspec import Struct

from allworlds.maps import combinatorial


def coarsest_partition(
    labels: Sequence[Hashable], permutations: Sequence[Sequence[int]]
) -> list[int]:
    """For each element the number of its block in the coarsest partition with two properties.

    The properties: elements of the same block have equal labels; and each permutation maps every
    block into one block.  Blocks are numbered from 0; the order of the blocks has no meaning, but
    depends only on the arguments.

    Args:
        labels: the label of each of the elements ``0..n-1``.
        permutations: permutations of the elements.

    Cost: O(n log n) for each permutation.  Source: Hopcroft 1971 ('process the smaller
    half').
    """
    parts = _Partition(labels)
    inverses = [combinatorial.inverse(permutation) for permutation in permutations]
    # A split by the largest block follows from the splits by the other ones.
    sizes = [past - first for first, past in zip(parts.first, parts.past, strict=True)]
    largest = sizes.index(max(sizes))
    waiting = [block for block in range(len(sizes)) if block != largest]
    while waiting:
        splitter = waiting.pop()
        members = parts.elements[parts.first[splitter] : parts.past[splitter]]
        for back in inverses:
            waiting += parts.split([back[element] for element in members])
    return parts.block


class _Partition:
    """A partition of elements; block ``b`` is ``elements[first[b]:past[b]]``.

    At first each block holds all elements with one label.
    """

    def __init__(self, labels: Sequence[Hashable]) -> None:
        number: dict[Hashable, int] = {}
        self.block = [number.setdefault(label, len(number)) for label in labels]
        self.elements = sorted(range(len(labels)), key=self.block.__getitem__)
        self.position = combinatorial.inverse(self.elements)
        sizes = Counter(self.block)
        self.past = [*accumulate(sizes[block] for block in range(len(sizes)))]
        self.first = [0, *self.past[:-1]]

    def split(self, chosen: Sequence[int]) -> list[int]:
        """Split each block into its elements in ``chosen`` and its other elements.

        Return the numbers of the new blocks.  The smaller part of a block becomes the new block; a
        block without chosen elements, or without others, stays.  Cost: O(len(chosen)).
        """
        elements, position, block, first = self.elements, self.position, self.block, self.first
        border: dict[int, int] = {}  # the chosen elements of a block lie before its border
        for x in chosen:
            b = block[x]
            here, there = position[x], border.get(b, first[b])
            y = elements[there]
            elements[here], elements[there] = y, x
            position[y], position[x] = here, there
            border[b] = there + 1
        new = []
        for b, middle in border.items():
            start, end = first[b], self.past[b]
            if middle == end:
                continue
            if middle - start <= end - middle:
                first[b], end = middle, middle
            else:
                self.past[b], start = middle, middle
            new.append(len(first))
            for x in elements[start:end]:
                block[x] = len(first)
            first.append(start)
            self.past.append(end)
        return new


class Quotient(Struct, frozen=True, dict=True):
    """A quotient rooted at class 0, in canonical numbering.

    Attributes:
        sigma, alpha: the permutations of the classes; alpha may have fixed points.
        degree: for each class the degree of those vertices of the map that have a dart in the
            class.
        labels: for each class the label of its darts.
        sheets: k, the number of darts in each class.
    """

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    degree: tuple[int, ...]
    labels: tuple[Hashable, ...]
    sheets: int

    @cached_property
    def vertices(self) -> tuple[tuple[int, ...], ...]:
        """The cycles of sigma: for each vertex its classes, clockwise from the smallest one.

        The vertices are in the order of their smallest classes, so the first vertex is that of the
        root.
        """
        return combinatorial.cycles(self.sigma)

    @cached_property
    def vertex_of(self) -> tuple[int, ...]:
        """For each class the index of its vertex in :attr:`vertices`."""
        return combinatorial.places(self.vertices)[0]

    @cached_property
    def cone_indices(self) -> tuple[int, ...]:
        """For each vertex of the quotient its cone index, which divides k.

        The cone index is the degree of a vertex of the map, divided by the number of classes of
        the vertex's darts: the number of times that these classes repeat round the vertex.
        """
        return tuple(self.degree[vertex[0]] // len(vertex) for vertex in self.vertices)

    @cached_property
    def semi_edges(self) -> tuple[int, ...]:
        """The classes that alpha maps to themselves, ascending."""
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
        """The ordinary edges outside the spanning tree of a breadth-first search from the root."""
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

    def rerooted(self, root: int) -> "Quotient":
        """Return this quotient with the class ``root`` as the root, in canonical numbering."""
        order = combinatorial.numbering(self.sigma, self.alpha, root)
        return Quotient(
            *combinatorial.rooted_code(self.sigma, self.alpha, root),
            tuple(self.degree[q] for q in order),
            tuple(self.labels[q] for q in order),
            self.sheets,
        )


class Projection(NamedTuple):
    """A quotient of a map, and the projection: ``classes[d]`` is the class of dart ``d``."""

    quotient: Quotient
    classes: tuple[int, ...]


Labelled: TypeAlias = tuple[combinatorial.CombinatorialMap, Sequence[Hashable], combinatorial.Dart]
"""A rooted map with a label at every dart: map, labels by dart, root."""


def project(labelled: Labelled) -> Projection:
    """The quotient of a labelled map, rooted at the class of the map's root; and each dart's class.

    Darts at vertices of different degrees are in different classes, even if their labels are equal.

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
    """For each of several maps the class of each dart.

    The classes are common to all maps: two darts that look alike have the same class, also in
    different maps.  The classes are numbered in canonical order from the root of the first map;
    then the classes that are not yet numbered, from the root of the second map; and so on.

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
        queue = [root]
        for x in queue:
            if block[x] not in number:
                number[block[x]] = len(number)
                queue += sigma[x], alpha[x]
    all_classes = iter([number[b] for b in block])
    return tuple(tuple(next(all_classes) for _ in map_.darts) for map_, _, _ in parts)


def is_ambiguous(quotient: Quotient) -> bool:
    """Whether two or more worlds with the lighthouse ``position`` have this quotient.

    The root must be at v0.  The result is false in three cases, in which there is only one choice
    of permutations (see the module's docstring).  First: there is one sheet.  Second: there are two
    sheets, and beta1 = 0.  Third: beta1 = 0, there is no semi-edge, and all vertices except v0 have
    the cone index 1.  In all other cases the result is true (docs/ambiguity.md, Criterion).

    Cost: O(m).
    """
    if quotient.sheets == 1 or quotient.beta1:
        return quotient.sheets > 1
    rigid = not quotient.semi_edges and all(b == 1 for b in quotient.cone_indices[1:])
    return quotient.sheets > 2 and not rigid


def pose_count(quotient: Quotient) -> int:
    """The number P of pairs of a world and a dart in it at which the robot may be.

    The world has this quotient; the dart is one of the k darts at v0 in the class of the root;
    isomorphic pairs count once.  Reports call such a pair a pose.

    P is also the number of choices (see the module's docstring).  For if the sheet of the dart gets
    the number 0, the shift c numbers all other sheets; so each pair belongs to exactly one choice.
    Therefore P = (k!)^beta1 N(k,2)^s prod N(k,b_v).  Here s is the number of semi-edges, and b_v
    the cone index of the vertex v; the product is over all vertices except v0.  N(k,b) is the
    number of permutations of k things in which all cycles have length b.
    """
    return _fixed_by_rotations(quotient, quotient.sheets)


def class_size(quotient: Quotient) -> int:
    """The number of worlds with the lighthouse ``position`` and this quotient.

    The worlds are the orbits of the choices under the powers of c, as the module's docstring
    explains; Burnside's lemma counts the orbits.

    Cost: at most k products of large integers for each vertex, each edge and each divisor of
    k; no world is made.
    """
    k = quotient.sheets
    divisors = [g for g in range(1, k + 1) if k % g == 0]
    # totient(k / g) powers of c have g cycles.
    return sum(_totient(k // g) * _fixed_by_rotations(quotient, g) for g in divisors) // k


def _fixed_by_rotations(quotient: Quotient, cycles: int) -> int:
    """The number of choices whose permutations all commute with a power of c, a *rotation*.

    The power has ``cycles`` cycles.  Several powers may have so many cycles; the number is the same
    for each of them.  The module's docstring says what a choice and c are.
    """
    k = quotient.sheets
    lengths = Counter(quotient.cone_indices[1:])
    lengths[2] += len(quotient.semi_edges)
    uniform: int = prod(_uniform(k, cycles, b) ** times for b, times in lengths.items())
    free: int = ((k // cycles) ** cycles * factorial(cycles)) ** quotient.beta1
    return uniform * free


def _uniform(k: int, cycles: int, b: int) -> int:
    """The number of permutations p of k things, with all cycles of length b, that commute with c^i.

    c is a cyclic shift of the k things, and c^i a power of c with ``cycles`` cycles; any such power
    yields the same number.  Each of these cycles has the length ``r = k / cycles``; call it a ring.
    Since p commutes with c^i, p permutes the rings.  When p takes a ring to a ring, it also turns
    the ring by some number of steps modulo r, the ring's turn.

    Suppose that p permutes t rings cyclically.  Let o be the order of the sum of their t turns in
    the integers modulo r.  Then p has only cycles of length ``t * o`` on the things in these t
    rings; so ``t * o = b``.  There are ``r^(t-1) phi(o)`` ways to choose the t turns, where phi is
    Euler's totient function.  For each permutation of the rings the function multiplies these
    numbers over its cycles; the result is the sum of the products.
    """
    r = k // cycles
    weight = {
        t: r ** (t - 1) * _totient(b // t)
        for t in range(1, min(b, cycles) + 1)
        if b % t == 0 and r % (b // t) == 0
    }
    ways = [1]
    for g in range(1, cycles + 1):
        # The cycle of the g-th thing has t things: the others of it come in (g-1)!/(g-t)! ways.
        ways.append(sum(perm(g - 1, t - 1) * w * ways[g - t] for t, w in weight.items() if t <= g))
    return ways[cycles]


def _totient(n: int) -> int:
    return sum(gcd(n, j) == 1 for j in range(1, n + 1))
