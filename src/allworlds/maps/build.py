"""Maps made by hand, by name and from sizes; and small changes to maps.

There are two notations.  A *rotation* lists the neighbours of each vertex clockwise, with keys for
parallel edges.  *Cycles* list the names of the edges round each vertex clockwise.  Each notation
can express all maps, also maps with loops and parallel edges.  Maps with a name, or of given sizes,
are made from one of these notations.

The changes remove or contract edges, move a dart, or complete an explored part.
"""

import random
from collections import Counter
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from typing import Any

from allworlds.inputs.checks import InputError, show
from allworlds.maps.combinatorial import (
    CombinatorialMap,
    Dart,
    InvalidMap,
    numbering,
    unreached,
)
from allworlds.words import plural

LARGEST = 10_000
"""The largest N in a name such as ``wheel-N``."""


class NoSuchMap(InputError):
    """Raised for a text that is not the name of a map."""


def from_rotation(
    rotation: Mapping[Any, Sequence[Any]] | Sequence[Sequence[Any]],
) -> CombinatorialMap:
    """The map from the clockwise list of neighbours of each vertex.

    Args:
        rotation: for each vertex the list of its neighbours; a plain sequence of lists is for the
            vertices ``0, 1, ...``.  A neighbour is the name of a vertex, or a list ``[name, key]``;
            parallel edges have different keys.  Each edge is in the lists of both its ends; a loop
            is twice in the list of its vertex.

    Darts are numbered vertex by vertex in the given order, and within a vertex in the order of
    its list; the vertices of the map are also in this order.

    Raises:
        InvalidMap: naming the vertex: an empty list, an unknown neighbour, an edge that is
            listed too often or only at one end, or a graph that is not connected.

    Cost: O(m).
    """
    given = rotation if isinstance(rotation, Mapping) else dict(enumerate(rotation))
    listed = {v: [_neighbour(v, entry) for entry in _around(v, given[v])] for v in given}
    edges = {v: [(frozenset((v, w)), *key) for w, *key in listed[v]] for v in listed}
    count = {v: Counter(edges[v]) for v in edges}
    for v, around in edges.items():
        for entry, (w, *key), edge in zip(given[v], listed[v], around, strict=True):
            ends_here = 3 - len(edge[0])  # 2 of a loop
            if w not in count:
                legal = show([*given])
                raise InvalidMap(f"vertex {show(v)} lists {show(entry)}; the vertices are {legal}")
            if count[v][edge] != ends_here:
                keys = f"{show([w, 0])} and {show([w, 1])}"
                raise InvalidMap(
                    f"vertex {show(v)} lists {show(entry)} {plural(count[v][edge], 'time')}; a "
                    f"loop stands twice, and parallel edges have keys, as in {keys}"
                )
            if edge not in count[w]:
                back = show([v, *key] if key else v)
                raise InvalidMap(
                    f"vertex {show(v)} lists {show(entry)}, but {show(w)} does not list {back}; "
                    "an edge is listed at both its ends"
                )
    return _assembled(edges)


def _neighbour(vertex: object, entry: object) -> tuple[Any, ...]:
    """The neighbour in ``entry``, and the key of the edge if there is one.

    ``entry`` stands in the list of ``vertex``, which error messages name.
    """
    if isinstance(entry, list) and len(entry) != 2:
        legal = "a neighbour, or [neighbour, key]"
        raise InvalidMap(f"vertex {show(vertex)} lists {show(entry)}; legal is {legal}")
    return tuple(_name(vertex, each) for each in (entry if isinstance(entry, list) else [entry]))


def from_cycles(
    vertices: Mapping[Any, Sequence[Hashable]] | Sequence[Sequence[Hashable]],
) -> CombinatorialMap:
    """The map from the clockwise list of edge names round each vertex.

    ``vertices`` holds the list of each vertex; a plain sequence of lists is for the vertices
    ``0, 1, ...``.  Each name of an edge occurs exactly twice: ``["aab", "b"]`` is a loop ``a``, and
    an edge ``b`` to a second vertex.  Darts are numbered vertex by vertex, and within a vertex in
    the order of its list.

    Raises:
        InvalidMap: naming the edge or the vertex: an empty list, a name that does not occur
            exactly twice, or a graph that is not connected.

    Cost: O(m).
    """
    given = vertices if isinstance(vertices, Mapping) else dict(enumerate(vertices))
    return _assembled({v: [_name(v, e) for e in _around(v, given[v])] for v in given})


def _around(vertex: object, listed: object) -> Sequence[Any]:
    if not isinstance(listed, Sequence):
        raise InvalidMap(f"vertex {show(vertex)} must have a clockwise list, not {show(listed)}")
    if not listed:
        raise InvalidMap(f"vertex {show(vertex)} has an empty list; a vertex has at least one edge")
    return listed


def _name(vertex: object, entry: object) -> Any:
    try:
        hash(entry)
    except TypeError:
        raise InvalidMap(
            f"vertex {show(vertex)} lists {show(entry)}, which cannot be a name; "
            "use numbers, strings or tuples of them"
        ) from None
    return entry


def _assembled(vertices: Mapping[Any, Sequence[Any]]) -> CombinatorialMap:
    darts_of: dict[Any, list[int]] = {}
    vertex_at: list[Any] = []
    sigma: list[int] = []
    for v, names in vertices.items():
        first = len(sigma)
        sigma += [*range(first + 1, first + len(names)), first]
        for dart, name in enumerate(names, first):
            darts_of.setdefault(name, []).append(dart)
            vertex_at.append(v)
    alpha = [0] * len(sigma)
    for name, darts in darts_of.items():
        if len(darts) != 2:
            raise InvalidMap(
                f"edge {show(name)} has {len(darts)} ends; every name must stand exactly twice"
            )
        d, e = darts
        alpha[d], alpha[e] = e, d
    return map_at(sigma, alpha, vertex_at)


def map_at(
    sigma: Sequence[int], alpha: Sequence[int], vertex_at: Sequence[object]
) -> CombinatorialMap:
    """The map of the two permutations ``sigma`` and ``alpha``.

    ``vertex_at`` holds the name of each dart's vertex; only error messages use these names.

    Raises:
        InvalidMap: naming a vertex that cannot be reached, or if there is no dart.
    """
    if lost := sigma and unreached(sigma, alpha):
        raise InvalidMap(
            f"vertex {show(vertex_at[lost[0]])} cannot be reached from vertex "
            f"{show(vertex_at[0])}; a map is connected"
        )
    return CombinatorialMap(sigma, alpha)


def cycle(n: int) -> CombinatorialMap:
    """The cycle of ``n >= 1`` vertices: a loop for 1, two parallel edges for 2.

    Raises:
        ValueError: if ``n < 1``.
    """
    _at_least(1, n=n)
    return from_cycles([((i - 1) % n, i) for i in range(n)])


def lattice(rows: int, columns: int, holes: float = 0.0, seed: int = 0) -> CombinatorialMap:
    """The grid of ``rows x columns`` vertices in the plane, in which some edges may be missing.

    The vertices are numbered row by row; the clockwise order is up, right, down, left.  ``holes``
    is the fraction of the ``m`` edges to remove: ``round(holes * m)`` random edges are removed, and
    the rest stays connected.  ``seed`` determines the removed edges.

    Raises:
        ValueError: if there is no edge; if ``holes`` is not in 0..1; or if so many edges cannot be
            removed from a map that stays connected.

    Cost: O(m log m).  Source: Section VII of the paper (Fig. 3: holes = 0.1).
    """
    _at_least(1, rows=rows, columns=columns)
    _at_least(2, **{"rows * columns": rows * columns})
    rotation = {}
    for r in range(rows):
        for c in range(columns):
            around = ((r - 1, c), (r, c + 1), (r + 1, c), (r, c - 1))
            rotation[r * columns + c] = [
                y * columns + x for y, x in around if 0 <= y < rows and 0 <= x < columns
            ]
    return from_rotation(_with_holes(rotation, holes, seed))


def dense(vertices: int, holes: float = 0.0, seed: int = 0) -> CombinatorialMap:
    """The complete graph, in which some edges may be missing.

    Every vertex has its neighbours clockwise in ascending order; the genus follows from this order.
    ``holes`` and ``seed`` mean the same as in :func:`lattice`.

    Raises:
        ValueError: if ``vertices < 2``; if ``holes`` is not in 0..1; or if so many edges cannot be
            removed from a map that stays connected.

    Cost: O(m log m).  Source: Section VII of the paper (Fig. 3: holes = 0.1).
    """
    _at_least(2, vertices=vertices)
    rotation = {v: [w for w in range(vertices) if w != v] for v in range(vertices)}
    return from_rotation(_with_holes(rotation, holes, seed))


def _with_holes(rotation: dict[int, list[int]], holes: float, seed: int) -> dict[int, list[int]]:
    """The rotation ``rotation`` without ``round(holes * m)`` of its m edges; the rest is connected.

    ``seed`` determines the removed edges.  The result is as if the function shuffled the edges,
    then tried them one after another, and removed an edge whenever the rest stayed connected, until
    enough edges were removed.  A spanning tree gives the same result faster.  Each edge gets a
    smaller weight than the edge before, so the minimum spanning tree keeps late edges rather than
    early ones.  The edges outside this tree can be removed; the function removes the first
    ``round(holes * m)`` of them, in the shuffled order.

    Raises:
        ValueError: if ``holes`` is not in 0..1, or if fewer than ``round(holes * m)`` edges are
            outside the tree.
    """
    if not 0 <= holes <= 1:
        raise ValueError(f"holes = {holes} is not a fraction in 0..1")
    if not holes:
        return rotation
    import networkx as nx  # 'import allworlds' stays fast

    edges = [(v, w) for v, around in rotation.items() for w in around if v < w]
    wanted = round(holes * len(edges))
    random.Random(seed).shuffle(edges)  # noqa: S311  # reproducible, not secret
    graph = nx.Graph()
    graph.add_weighted_edges_from((v, w, -i) for i, (v, w) in enumerate(edges))
    tree = {(min(edge), max(edge)) for edge in nx.minimum_spanning_edges(graph, data=False)}
    removable = [edge for edge in edges if edge not in tree]
    if wanted > len(removable):
        raise ValueError(
            f"holes = {holes} would remove {wanted} of {len(edges)} edges, "
            f"but at most {len(removable)} can go while the rest stays connected"
        )
    gone = set(removable[:wanted])
    return {
        v: [w for w in around if (min(v, w), max(v, w)) not in gone]
        for v, around in rotation.items()
    }


def _at_least(least: int, **values: int) -> None:
    for name, value in values.items():
        if value < least:
            raise ValueError(f"{name} = {value} is too small; it must be at least {least}")


def named_map(name: str) -> CombinatorialMap:
    """The map called ``name``; see :func:`named_maps` for the names.

    In a name such as ``wheel-N``, N is the number of edges (dipole), loops (bouquet), leaves
    (star), vertices (cycle, path), or spokes (wheel).  Dart 0 is at the hub of a wheel or star.
    All maps with an N are planar.  ``theta`` has three parallel edges; ``k4-torus`` is K4 with
    faces of 4 and 8 edges.  ``fig1-left`` and ``fig1-right`` are two planar simple maps with all
    properties that the caption of the paper's Fig. 1 states.  The vertex that the paper marks
    is vertex 0 in both maps.  The paper may show another pair with these properties.

    Raises:
        NoSuchMap: for another name, or an N out of range, naming the legal names or numbers.
    """
    if name in _SINGLE:
        return _SINGLE[name]()
    family, dash, number = name.rpartition("-")
    if not dash or family not in _NUMBERED:
        raise NoSuchMap(f"no map is called {show(name)}; the names are {', '.join(named_maps())}")
    least, build = _NUMBERED[family]
    digits = number.isascii() and number.isdigit()
    if not digits or not least <= int(number[:7]) <= LARGEST:
        legal = f"{family}-N needs an integer N >= {least}, and at most {LARGEST}"
        raise NoSuchMap(f"{show(name)} is no map: {legal}")
    return build(int(number))


def named_maps() -> tuple[str, ...]:
    """The names that :func:`named_map` knows, sorted; ``N`` in a name stands for a number."""
    return tuple(sorted([*_SINGLE, *(f"{family}-N" for family in _NUMBERED)]))


def _wheel(n: int) -> CombinatorialMap:
    rim = [[0, (i - 1) % n + 1, (i + 1) % n + 1] for i in range(n)]
    return from_rotation([range(1, n + 1), *rim])


def _of_digits(rotation: str) -> CombinatorialMap:
    """The map of a rotation such as ``12 20 01``: for each vertex its neighbours as digits."""
    return from_rotation([[*map(int, vertex)] for vertex in rotation.split()])


_SINGLE: dict[str, Callable[[], CombinatorialMap]] = {
    "cube": lambda: _of_digits("143 250 361 072 057 164 275 346"),
    "edge": lambda: from_cycles(["a", "a"]),
    "fig1-left": lambda: _of_digits("1235 046 067 078 156 084 214 328 537"),
    "fig1-right": lambda: _of_digits("1235 046 064 078 126 087 214 358 537"),
    "k33": lambda: _of_digits("345 345 345 012 012 012"),
    "k4": lambda: _wheel(3),
    "k4-torus": lambda: dense(4),
    "k5": lambda: dense(5),
    "loop": lambda: from_cycles(["aa"]),
    "petersen": lambda: _of_digits("145 026 137 248 039 078 189 295 356 467"),
    "theta": lambda: named_map("dipole-3"),
    "theta-torus": lambda: from_cycles(["abc", "abc"]),
    "two-loops-plane": lambda: named_map("bouquet-2"),
    "two-loops-torus": lambda: from_cycles(["abab"]),
}

_NUMBERED: dict[str, tuple[int, Callable[[int], CombinatorialMap]]] = {
    "bouquet": (1, lambda n: from_cycles([[i // 2 for i in range(2 * n)]])),
    "cycle": (1, cycle),
    "dipole": (1, lambda n: from_cycles([range(n), range(n)[::-1]])),
    "path": (
        2,
        lambda n: from_rotation([[w for w in (v - 1, v + 1) if 0 <= w < n] for v in range(n)]),
    ),
    "star": (1, lambda n: from_rotation([range(1, n + 1), *([0] for _ in range(n))])),
    "wheel": (3, _wheel),
}
"""For each family the least N, and the function from N to the map."""


def deleted(map_: CombinatorialMap, dart: Dart) -> CombinatorialMap | None:
    """The map ``map_`` without the edge of ``dart``; None if the rest is not connected, or empty.

    If an end of the edge has degree 1, this vertex is removed, too.
    """
    gone = (dart, map_.alpha[dart])
    return _rebuilt(map_, [[d for d in vertex if d not in gone] for vertex in map_.vertices])


def contracted(map_: CombinatorialMap, dart: Dart) -> CombinatorialMap | None:
    """The map ``map_`` after the edge of ``dart`` is contracted: its two ends become one vertex.

    Clockwise round the new vertex stand first the darts of the vertex of ``dart``, from the dart
    after ``dart`` on; then the darts of the other end, from the dart after ``alpha[dart]`` on.
    The two darts of the edge are removed.  The result is None for a loop, or for the only edge.
    """
    ends = [map_.vertex_of[d] for d in (dart, map_.alpha[dart])]
    if ends[0] == ends[1]:
        return None
    merged = [
        map_.turn(d, k) for d in (dart, map_.alpha[dart]) for k in range(1, map_.degree_at[d])
    ]
    others = [vertex for v, vertex in enumerate(map_.vertices) if v not in ends]
    return _rebuilt(map_, [merged, *others])


def completed(sigma: Sequence[int], alpha: Sequence[Dart]) -> CombinatorialMap:
    """The map of an explored part, in which each open dart leads to a new vertex.

    ``sigma`` and ``alpha`` are those of the explored part, in which ``alpha`` maps an open dart to
    itself.  The part may come from a wrong explorer, so ``alpha`` may map a dart d to itself, and
    another dart e to d, too.  Then d is not open, but e and d become an edge.  Each open dart
    becomes an edge to a new vertex of degree 1.

    Raises:
        InvalidMap: if the result is no map.
    """
    after, ends = [*sigma], [*alpha]
    for dart, end in enumerate(alpha):
        if end < len(ends) and ends[end] == end:
            ends[end] = dart
    for dart in [dart for dart, end in enumerate(ends) if dart == end]:
        ends[dart] = len(after)
        ends.append(dart)
        after.append(len(after))
    return CombinatorialMap(after, ends)


def without(map_: CombinatorialMap, gone: set[Dart]) -> CombinatorialMap | None:
    """The map ``map_`` without the edges whose darts are in ``gone``.

    ``gone`` holds both darts of each edge to remove.  If the rest is not connected, the result is
    the connected part with the vertex of dart 0.  The root of the result, its dart 0, is the first
    remaining dart of this vertex, clockwise from dart 0.  The result is None if no dart of this
    vertex remains.
    """

    def left(dart: Dart) -> Dart:
        while dart in gone:
            dart = map_.sigma[dart]
        return dart

    if gone.issuperset(map_.vertices[0]):
        return None
    sigma = [d if d in gone else left(map_.sigma[d]) for d in map_.darts]
    order = numbering(sigma, map_.alpha, left(0))
    number = {d: i for i, d in enumerate(order)}
    return CombinatorialMap.trusted(
        [number[sigma[d]] for d in order], [number[map_.alpha[d]] for d in order]
    )


def moved(map_: CombinatorialMap) -> Iterator[CombinatorialMap]:
    """Yield the connected maps that arise if one dart of ``map_`` is put into another position.

    The new position is between two darts of the same vertex or of another vertex.  A vertex that
    loses its only dart is removed.  The same map can come several times; ``map_`` can come, too.
    """
    for dart in map_.darts:
        without = [[d for d in vertex if d != dart] for vertex in map_.vertices]
        for v, vertex in enumerate(without):
            for index in range(len(vertex)):
                rotations = [*without[:v], [*vertex[:index], dart, *vertex[index:]]]
                other = _rebuilt(map_, [*rotations, *without[v + 1 :]])
                if other is not None:
                    yield other


def _rebuilt(
    map_: CombinatorialMap, rotations: Sequence[Sequence[Dart]]
) -> CombinatorialMap | None:
    """The map in which ``rotations`` holds for each vertex its darts, clockwise.

    The edges are those of ``map_`` whose darts are in ``rotations``; the darts are then renumbered
    in ascending order.  The result is None if the map would be empty or not connected.
    """
    number = {d: i for i, d in enumerate(sorted(d for vertex in rotations for d in vertex))}
    sigma, alpha = [0] * len(number), [0] * len(number)
    for vertex in rotations:
        for d, following in zip(vertex, [*vertex[1:], *vertex[:1]], strict=True):
            sigma[number[d]] = number[following]
            alpha[number[d]] = number[map_.alpha[d]]
    try:
        return CombinatorialMap(sigma, alpha)
    except InvalidMap:
        return None
