"""The map: two permutations of darts, which are checked once; codes and isomorphisms of maps.

The canonical numbering of a map rooted at ``r`` gives ``r`` the number 0; then, for each numbered
dart ``x`` in order, ``sigma(x)`` and ``alpha(x)`` get the next free numbers.  The code of the
rooted map is ``(sigma, alpha)`` in these numbers.  Two rooted maps are the same exactly if their
codes are equal, because an isomorphism is determined by the image of one dart.  Codes are compared
lexicographically, sigma first.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from operator import eq
from typing import Annotated, Any, TypeAlias

from allworlds.documents.document import Natural, Permutation, WrittenByFields, about
from allworlds.documents.shown import Pictured
from allworlds.inputs.checks import InputError, are_plain, integer, parse_json, show

Dart: TypeAlias = Natural
"""A dart: an integer in ``0..2m-1``."""

Vertex: TypeAlias = int
"""A vertex: an index into :attr:`CombinatorialMap.vertices`."""

Sigma: TypeAlias = Annotated[
    Permutation, about("for each dart the next one clockwise round its vertex")
]
Alpha: TypeAlias = Annotated[Permutation, about("for each dart the other one of its edge")]


class InvalidMap(InputError):
    """Raised for a pair of sequences that is no map; the message says why it is none.

    Attributes:
        sigma, alpha: the entries of the two sequences; empty if one of them is no sequence.
    """

    def __init__(
        self, message: str, sigma: Sequence[object] = (), alpha: Sequence[object] = ()
    ) -> None:
        super().__init__(message)
        self.sigma, self.alpha = tuple(sigma), tuple(alpha)

    @property
    def tried(self) -> str:
        """The two sequences, one line for each; a long line is cut.

        The text is empty if :attr:`sigma` and :attr:`alpha` are empty.
        """
        sequences = {"sigma": self.sigma, "alpha": self.alpha}
        return "\n".join(f"{name} {show([*each])}" for name, each in sequences.items() if each)


@dataclass(frozen=True, init=False)
class CombinatorialMap(Pictured, WrittenByFields):
    """A connected embedded graph: ``sigma`` clockwise round vertices, ``alpha`` across edges.

    Only this is demanded: ``sigma`` is a permutation of ``0..2m-1`` with ``m >= 1``; ``alpha`` is
    an involution without fixed points on the same darts; the two permutations together lead from
    every dart to every dart.  Everything else, such as vertices and faces, follows from the two.

    Two maps are equal if both permutations are equal.  For 'the same map up to the names of the
    darts' see :func:`allworlds.maps.combinatorial.isomorphism`.

    Raises:
        InvalidMap: naming the first offending entry and what would be legal.

    Cost: O(m).  Source: Section II.A of the paper; docs/theory.md.
    """

    sigma: Sigma
    alpha: Alpha

    def __init__(self, sigma: Iterable[int], alpha: Iterable[int]) -> None:
        tried = {"sigma": _entries("sigma", sigma), "alpha": _entries("alpha", alpha)}
        valid_sigma, valid_alpha = _integers("sigma", tried), _integers("alpha", tried)
        if not _are_lawful(valid_sigma, valid_alpha):
            message = next(_broken_laws(valid_sigma, valid_alpha))
            raise InvalidMap(message, valid_sigma, valid_alpha)
        object.__setattr__(self, "sigma", valid_sigma)
        object.__setattr__(self, "alpha", valid_alpha)

    @classmethod
    def trusted(cls, sigma: Sequence[Dart], alpha: Sequence[Dart]) -> CombinatorialMap:
        """The map of two permutations, without the check that they are a map.

        This method is for functions whose construction always makes maps; it is not for users.
        """
        self = object.__new__(cls)
        object.__setattr__(self, "sigma", tuple(sigma))
        object.__setattr__(self, "alpha", tuple(alpha))
        return self

    @property
    def darts(self) -> range:
        """All darts, ``0..2m-1``."""
        return range(len(self.sigma))

    @property
    def edge_count(self) -> int:
        """The number of edges, m."""
        return len(self.sigma) // 2

    @property
    def vertex_count(self) -> int:
        """The number of vertices, n."""
        return len(self.vertices)

    @cached_property
    def vertices(self) -> tuple[tuple[Dart, ...], ...]:
        """The cycles of sigma: for each vertex its darts, clockwise from the smallest one.

        The vertices are in the order of their smallest darts.
        """
        return cycles(self.sigma)

    @cached_property
    def edges(self) -> tuple[tuple[Dart, Dart], ...]:
        """The edges as pairs ``(d, alpha[d])`` with ``d < alpha[d]``, ascending."""
        return tuple((d, e) for d, e in enumerate(self.alpha) if d < e)

    @cached_property
    def faces(self) -> tuple[tuple[Dart, ...], ...]:
        """The cycles of ``phi = sigma . alpha``: for each face its darts, in the order round it.

        Each face begins with its smallest dart; the faces are in the order of these darts.
        """
        sigma, alpha = self.sigma, self.alpha
        return cycles([sigma[alpha[d]] for d in self.darts])

    @cached_property
    def vertex_of(self) -> tuple[Vertex, ...]:
        """For each dart the index of its vertex in :attr:`vertices`."""
        return self._places[0]

    @cached_property
    def degree_at(self) -> tuple[int, ...]:
        """For each dart the degree of its vertex."""
        degrees = self.degrees
        return tuple(degrees[v] for v in self.vertex_of)

    @property
    def degrees(self) -> tuple[int, ...]:
        """The degree of each vertex, in the order of :attr:`vertices`."""
        return tuple(len(vertex) for vertex in self.vertices)

    @cached_property
    def genus(self) -> int:
        """The genus g of the surface, from ``n - m + f = 2 - 2g``."""
        return (2 - self.vertex_count + self.edge_count - len(self.faces)) // 2

    @cached_property
    def diameter(self) -> int:
        """The largest distance between two vertices: the length of a shortest walk between them.

        Cost: O(m) for each vertex.
        """
        return max(max(distances(self, v).values()) for v in range(self.vertex_count))

    @cached_property
    def loop_count(self) -> int:
        """The number of edges with both ends at one vertex."""
        owner = self.vertex_of
        return sum(owner[d] == owner[e] for d, e in self.edges)

    @cached_property
    def parallel_count(self) -> int:
        """The number of parallel edges beyond the first one between each two vertices.

        Loops do not count, not even two loops at the same vertex.
        """
        owner = self.vertex_of
        joined = [frozenset((owner[d], owner[e])) for d, e in self.edges]
        proper = [ends for ends in joined if len(ends) == 2]
        return len(proper) - len(set(proper))

    @property
    def is_simple(self) -> bool:
        """Whether there are no loops and no two edges with the same two ends."""
        return not self.loop_count and not self.parallel_count

    @property
    def is_planar(self) -> bool:
        """Whether the genus is 0."""
        return self.genus == 0

    def turn(self, dart: Dart, offset: int) -> Dart:
        """``sigma^offset(dart)``: the dart that comes ``offset`` darts after ``dart``, clockwise.

        ``offset`` may be any integer.

        Cost: O(1) after the first call.
        """
        vertex = self.vertices[self.vertex_of[dart]]
        return vertex[(self._places[1][dart] + offset) % len(vertex)]

    def move(self, dart: Dart, offset: int) -> Dart:
        """``alpha(sigma^offset(dart))``: the dart of arrival of ``Move(offset)`` from ``dart``."""
        return self.alpha[self.turn(dart, offset)]

    def offset(self, start: Dart, end: Dart) -> int:
        """The ``k`` in ``0..degree-1`` with ``sigma^k(start) == end``.

        Raises:
            ValueError: if the two darts are not at one vertex.
        """
        if self.vertex_of[start] != self.vertex_of[end]:
            raise ValueError(f"darts {start} and {end} are not at one vertex")
        positions = self._places[1]
        return (positions[end] - positions[start]) % self.degree_at[start]

    @cached_property
    def _places(self) -> tuple[tuple[Vertex, ...], tuple[int, ...]]:
        return places(self.vertices)

    def relabelled(self, names: Sequence[Dart]) -> CombinatorialMap:
        """Return the map in which dart ``d`` has the number ``names[d]``.

        Raises:
            ValueError: if ``names`` is no permutation of the darts.
        """
        if sorted(names) != list(self.darts):
            last = len(self.sigma) - 1
            raise ValueError(f"{show(list(names))} is no permutation of the darts 0..{last}")
        sigma, alpha = [0] * len(names), [0] * len(names)
        for d, name in enumerate(names):
            sigma[name] = names[self.sigma[d]]
            alpha[name] = names[self.alpha[d]]
        return CombinatorialMap.trusted(sigma, alpha)

    def mirrored(self) -> CombinatorialMap:
        """The mirror image: anticlockwise becomes clockwise, the darts keep their numbers."""
        return CombinatorialMap.trusted(inverse(self.sigma), self.alpha)

    def dual(self) -> CombinatorialMap:
        """The dual map: sigma becomes phi, alpha stays.  Faces become vertices; the genus stays."""
        sigma, alpha = self.sigma, self.alpha
        return CombinatorialMap.trusted([sigma[alpha[d]] for d in self.darts], alpha)

    def to_networkx(self) -> Any:
        """The graph of the map; see :func:`allworlds.maps.networks.to_networkx`."""
        from allworlds.maps.networks import to_networkx

        return to_networkx(self)

    @classmethod
    def from_json(cls, document: str | Mapping[str, Any]) -> CombinatorialMap:
        """The map that a JSON object tells, as :meth:`to_json` returns it; other keys are ignored.

        ``document`` is the object, or its text.

        Raises:
            InvalidMap: if ``document`` is no JSON object with the two lists ``sigma`` and
                ``alpha``, or the lists are no map.
        """
        if isinstance(document, str):
            document = parse_json(document, InvalidMap)
        if not isinstance(document, Mapping):
            raise InvalidMap(f"a map is an object with 'sigma' and 'alpha', not {show(document)}")
        for key in ("sigma", "alpha"):
            if key not in document:
                raise InvalidMap(f"{key!r} is missing; a map has 'sigma' and 'alpha'")
            if not isinstance(document.get(key), list | tuple):
                raise InvalidMap(f"{key!r} must be a list of darts, not {show(document.get(key))}")
        return cls(document["sigma"], document["alpha"])


def cycles(permutation: Sequence[int]) -> tuple[tuple[int, ...], ...]:
    """The cycles of a permutation of ``0..n-1``.

    Each cycle begins with its smallest element; the cycles are in the order of these elements.
    """
    seen = [False] * len(permutation)
    found = []
    for first in range(len(permutation)):
        if seen[first]:
            continue
        cycle = []
        x = first
        while not seen[x]:
            seen[x] = True
            cycle.append(x)
            x = permutation[x]
        found.append(tuple(cycle))
    return tuple(found)


def places(cycles: Sequence[Sequence[int]]) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """For each element the index of its cycle in ``cycles``, and its position in this cycle.

    ``cycles`` are the cycles of a permutation.  The result is a pair of tuples, both indexed by
    element.  The element that ``cycles`` lists first in a cycle has the position 0.  These places
    have nothing to do with the places of a lighthouse.
    """
    size = sum(map(len, cycles))
    owner, positions = [0] * size, [0] * size
    for index, cycle in enumerate(cycles):
        for i, x in enumerate(cycle):
            owner[x], positions[x] = index, i
    return tuple(owner), tuple(positions)


def distances(map_: CombinatorialMap, vertex: Vertex) -> dict[Vertex, int]:
    """The distance of each vertex from ``vertex``: the number of edges of a shortest walk.

    Cost: O(m).
    """
    far = {vertex: 0}
    for v in (queue := [vertex]):
        for dart in map_.vertices[v]:
            w = map_.vertex_of[map_.alpha[dart]]
            if w not in far:
                far[w] = far[v] + 1
                queue.append(w)
    return far


def inverse(permutation: Sequence[int]) -> list[int]:
    """The inverse permutation."""
    found = [0] * len(permutation)
    for x, y in enumerate(permutation):
        found[y] = x
    return found


def _entries(name: str, values: Iterable[object]) -> tuple[object, ...]:
    if isinstance(values, str | bytes | Mapping):
        raise InvalidMap(f"{name} must be a sequence of darts, not {show(values)}")
    try:
        return tuple(values)
    except TypeError:
        raise InvalidMap(f"{name} must be a sequence of darts, not {show(values)}") from None


def _integers(name: str, tried: Mapping[str, tuple[object, ...]]) -> tuple[int, ...]:
    entries = tried[name]
    if are_plain(entries):
        return entries  # type: ignore[return-value]
    result = []
    for d, value in enumerate(entries):
        try:
            result.append(integer(value))
        except TypeError:
            message = f"{name}[{d}] = {show(value)} is not an integer"
            raise InvalidMap(message, **tried) from None
    return tuple(result)


def _are_lawful(sigma: tuple[int, ...], alpha: tuple[int, ...]) -> bool:
    """Whether the sequences are a map; if they are none, :func:`_broken_laws` tells the reason."""
    darts = [*range(len(sigma))]
    if not darts or not sorted(sigma) == darts == sorted(alpha):
        return False
    if [alpha[e] for e in alpha] != darts or any(map(eq, alpha, darts)):
        return False
    return len(numbering(sigma, alpha, 0)) == len(darts)


def _broken_laws(sigma: tuple[int, ...], alpha: tuple[int, ...]) -> Iterator[str]:
    size = len(sigma)
    if len(alpha) != size:
        yield f"sigma has {size} darts and alpha {len(alpha)}; they must agree"
    if size == 0 or size % 2:
        yield f"a map has 2m darts with m >= 1, not {size}"
    for name, permutation in (("sigma", sigma), ("alpha", alpha)):
        seen: dict[int, int] = {}
        for d, e in enumerate(permutation):
            if not 0 <= e < size:
                yield f"{name}[{d}] = {show(e)} is no dart; darts are 0..{size - 1}"
            if e in seen:
                yield f"{name}[{seen[e]}] = {name}[{d}] = {e}, but {name} must be a permutation"
            seen[e] = d
    for d, e in enumerate(alpha):
        if e == d:
            yield f"alpha[{d}] = {d}, but alpha must have no fixed point"
        if alpha[e] != d:
            yield f"alpha[{d}] = {e} but alpha[{e}] = {alpha[e]}; alpha must be an involution"
    if lost := unreached(sigma, alpha):
        yield f"dart {lost[0]} cannot be reached from dart 0; a map is connected"


def unreached(sigma: Sequence[Dart], alpha: Sequence[Dart]) -> list[Dart]:
    """The darts that cannot be reached from dart 0 by sigma and alpha, ascending."""
    reached = numbering(sigma, alpha, 0)
    return sorted({*range(len(sigma))} - {*reached}) if len(reached) < len(sigma) else []


Code: TypeAlias = tuple[tuple[int, ...], tuple[int, ...]]
"""A canonical code: ``(sigma, alpha)`` of a rooted map whose root is dart 0."""


def numbering(sigma: Sequence[Dart], alpha: Sequence[Dart], root: Dart) -> list[Dart]:
    """The darts in the order of their canonical numbers in the map rooted at ``root``.

    Shape: the result at index ``i`` is the dart with the canonical number ``i``.  Darts that cannot
    be reached from ``root`` are left out.  Cost: O(m).
    """
    seen = [False] * len(sigma)
    seen[root] = True
    order = [root]
    for x in order:
        y = sigma[x]
        if not seen[y]:
            seen[y] = True
            order.append(y)
        y = alpha[x]
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
    """The code of a map without a root: the least of the codes for all its darts as roots.

    Two maps are the same exactly if their codes are equal.  Cost: O(m^2).
    """
    return min(rooted_code(map_.sigma, map_.alpha, root) for root in map_.darts)


def automorphisms(map_: CombinatorialMap) -> int:
    """The number of automorphisms of the map (orientation preserving; at least 1).

    The image of dart 0 determines an automorphism, so their number divides 2m.
    Cost: O(m^2) at worst.
    """
    return isomorphisms(map_, map_)


def isomorphisms(one: CombinatorialMap, other: CombinatorialMap) -> int:
    """The number of isomorphisms (orientation preserving) from the map ``one`` to ``other``.

    The two maps must have equally many darts.  Cost: O(m^2) at worst.
    """
    order = numbering(one.sigma, one.alpha, 0)
    return sum(
        carries(one.sigma, one.alpha, order, other.sigma, other.alpha, d) for d in other.darts
    )


def carries(
    sigma: Sequence[Dart],
    alpha: Sequence[Dart],
    order: Sequence[Dart],
    other_sigma: Sequence[Dart],
    other_alpha: Sequence[Dart],
    image: Dart,
) -> bool:
    """Whether an isomorphism from the first map to the other map takes ``order[0]`` to ``image``.

    The first map is ``sigma`` and ``alpha``; ``order`` is its :func:`numbering` from any root.  The
    other map is ``other_sigma`` and ``other_alpha``; ``image`` is one of its darts.  Both maps must
    have equally many darts.  Cost: O(m); usually much less if there is no such isomorphism, because
    the function stops at the first contradiction.
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
    # A function that commutes with two transitive actions on equally many darts is onto.
    return True


def isomorphism(a: CombinatorialMap, b: CombinatorialMap) -> tuple[Dart, ...] | None:
    """A bijection ``w`` from the darts of ``a`` to the darts of ``b`` that keeps sigma and alpha.

    Shape: ``w[d]`` is the dart of ``b`` for dart ``d`` of ``a``.  If there are several such
    bijections, the result is the one with the smallest ``w[0]``.  The result is None if there is
    none: the two maps are different.

    Cost: O(m) on average if the maps are different, O(m^2) at worst.
    """
    if len(a.sigma) != len(b.sigma):
        return None
    order = numbering(a.sigma, a.alpha, 0)
    for image in b.darts:
        if carries(a.sigma, a.alpha, order, b.sigma, b.alpha, image):
            return rooted_isomorphism(a, 0, b, image)
    return None


def rooted_isomorphism(
    a: CombinatorialMap, root: Dart, b: CombinatorialMap, other: Dart
) -> tuple[Dart, ...] | None:
    """The only isomorphism from ``a`` to ``b`` that takes the dart ``root`` to the dart ``other``.

    The result is None if there is no such isomorphism.  Cost: O(m).
    """
    order = numbering(a.sigma, a.alpha, root)
    if len(a.sigma) != len(b.sigma) or not carries(
        a.sigma, a.alpha, order, b.sigma, b.alpha, other
    ):
        return None
    images = numbering(b.sigma, b.alpha, other)
    return tuple(images[number] for number in inverse(order))
