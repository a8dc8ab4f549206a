"""Named families of maps, small and large.

The name of a member holds numbers: ``regular:3x8`` is a member of ``regular:DxN``.  In the
docstrings capital letters stand for these numbers, in the order of the arguments; m is the number
of edges.  The argument ``random`` is the source of all random choices.  Vertex 0 is the vertex of
dart 0, the root, which a robot faces at the start.

The hubs of a :func:`corridor` stand in a row: first N *near* hubs, then F *far* hubs.  A hub has
one of q *types*, which tells the darts that lead to the next hub.
"""

import re
from collections.abc import Callable, Iterator
from itertools import accumulate, cycle as repeated, islice, pairwise
from random import Random
from typing import Any, TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import InputError, not_one_of, show
from allworlds.maps.build import cycle, dense, from_cycles, lattice
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap, automorphisms, rooted_code

EdgeEnds: TypeAlias = list[tuple[int, int]]
"""The edges of a graph, each as the numbers of its two vertices."""


def torus(rows: int, columns: int, random: Random) -> CombinatorialMap:
    """The square lattice of R rows and C columns on the torus, with a random root; m = 2RC."""
    if rows < 1 or columns < 1:
        raise ValueError("R and C are at least 1")
    cells = [(r, c) for r in range(rows) for c in range(columns)]
    start = random.randrange(len(cells))
    around = []
    for r, c in cells[start:] + cells[:start]:
        north, west = (r - 1) % rows, (c - 1) % columns
        around.append([("down", north, c), ("right", r, c), ("down", r, c), ("right", r, west)])
    turned = random.randrange(4)
    around[0] = around[0][turned:] + around[0][:turned]
    return from_cycles(around)


def regular(degree: int, vertices: int, random: Random) -> CombinatorialMap:
    """A random connected map with N vertices of degree D; m = DN/2."""
    if degree < 3 or vertices < 1 or degree * vertices % 2:
        raise ValueError("D is at least 3, and D times N is even")
    darts = [v for v in range(vertices) for _ in range(degree)]
    return _connected(lambda: _drawn(vertices, _matched(darts, random), random))


def cubic(vertices: int, random: Random) -> CombinatorialMap:
    """A random connected map with N vertices of degree 3; m = 3N/2."""
    if vertices < 1 or vertices % 2:
        raise ValueError("N is even, and at least 2")
    return regular(3, vertices, random)


def sparse(vertices: int, edges: int, random: Random) -> CombinatorialMap:
    """A random tree with N vertices, and further random edges, which may be loops or parallel.

    The map has M edges in all.
    """
    if not 0 < vertices <= edges + 1 or edges < 1:
        raise ValueError("N vertices need N - 1 edges at least, and a map has 1")
    ends = [(v, random.randrange(v)) for v in range(1, vertices)]
    more = edges - len(ends)
    ends += [(random.randrange(vertices), random.randrange(vertices)) for _ in range(more)]
    return _drawn(vertices, ends, random)


def planar(edges: int, random: Random) -> CombinatorialMap:
    """A random rooted map of genus 0 with ``edges`` edges; all such maps are equally likely.

    The map is made at the first attempt.  The vertices of a random plane tree get labels, which
    change by -1, 0 or 1 along each edge.  Each corner of the tree is joined to the next corner with
    a smaller label, or to an additional vertex if there is no such corner.  The new edges are a
    quadrangulation, whose vertices have two colours; the diagonals between the vertices of one
    colour are the edges of the map.

    Source: G. Schaeffer, Conjugaison d'arbres et cartes combinatoires aleatoires, 1998; with a
    random plane tree by the cycle lemma.  Cost: O(m).
    """
    steps = [1] * edges + [-1] * (edges + 1)
    random.shuffle(steps)
    low = list(accumulate(steps))
    last = low.index(min(low)) + 1
    label, vertex, path, corners = [0], 0, [0], [0]
    for step in (steps[last:] + steps[:last])[:-2]:
        if step == 1:
            vertex += 1
            label.append(label[path[-1]] + random.randint(-1, 1))
            path.append(vertex)
        else:
            path.pop()
        corners.append(path[-1])
    # The dart of corner i is 2i, and its successor's dart 2i + 1; darts that arrive at a corner
    # come before the corner's own dart, the nearest first.
    size, least = len(corners), min(label)
    coming: list[list[int]] = [[] for _ in range(size)]
    top, waiting = list[int](), dict[int, int]()
    for i in reversed(range(2 * size)):
        at, mine = i % size, label[corners[i % size]]
        if i < size:
            (coming[waiting[mine - 1]] if mine > least else top).append(2 * at + 1)
        waiting[mine] = at
    around: list[list[int]] = [[] for _ in label]
    for i, v in enumerate(corners):
        before = sorted(coming[i], key=lambda dart: (i - dart // 2) % size)
        around[v] += [*before, 2 * i]
    previous = {d: around_v[k - 1] for around_v in [*around, top] for k, d in enumerate(around_v)}
    return _diagonals(previous, random.randint(0, 1))


def _diagonals(previous: dict[int, int], root: int) -> CombinatorialMap:
    """The map of the diagonals of a quadrangulation that join its vertices of one colour.

    The colour is that of the vertex of ``root``, a dart of the quadrangulation.  Edge i of the
    quadrangulation has the darts ``2i`` and ``2i + 1``.  ``previous`` gives for each dart the dart
    before it, clockwise round its vertex; a walk round a quadrangle needs this inverse of sigma.

    Each dart d of the quadrangulation at a vertex of this colour becomes a dart of the map.  The
    dart of the map begins at the same vertex; its diagonal lies in the quadrangle between d and
    sigma(d).  ``root`` becomes dart 0 of the map.
    """
    following = {d: e for e, d in previous.items()}

    def across(dart: int) -> int:
        for _ in range(2):
            dart = previous[dart ^ 1]
        return dart

    number, darts = {root: 0}, [root]
    for dart in darts:
        for other in (following[dart], across(dart)):
            if other not in number:
                number[other] = len(darts)
                darts.append(other)
    return CombinatorialMap(
        [number[following[d]] for d in darts], [number[across(d)] for d in darts]
    )


def bouquet(loops: int, random: Random) -> CombinatorialMap:
    """A vertex with C loops, joined to vertex 0, which has degree 1; m = C + 1.

    The order of the loops' ends round their vertex is random.
    """
    names = [loop for loop in range(loops) for _ in range(2)]
    random.shuffle(names)
    return from_cycles([["stem"], ["stem", *names]])


def lollipop(degree: int, length: int, random: Random) -> CombinatorialMap:
    """A path from vertex 0, of degree 1, to a *knot*: a part whose edges are random.

    The path has L inner vertices; loops raise their degree to D.  The knot has L vertices, numbered
    after those of the path.  All of them have the degree D, too, so that the degrees do not show
    where the path ends.  Only the vertex with the largest number has the degree D + 1, because
    otherwise one dart would be left without a partner.
    """
    if degree < 4 or degree % 2 or length < 1:
        raise ValueError("D is even and at least 4, L at least 1")
    path = list(pairwise(range(length + 2)))
    path += [(v, v) for v in range(1, length + 1) for _ in range(degree // 2 - 1)]
    knot = [v for v in range(length + 1, 2 * length + 1) for _ in range(degree)][1:]
    # The number of darts of the knot is odd, because its last vertex has one more.
    knot.append(2 * length)

    return _connected(lambda: _drawn(2 * length + 1, path + _matched(knot, random), random))


def thick(degree: int, length: int, random: Random) -> CombinatorialMap:
    """A path of L edges from vertex 0 on, with loops at its vertices.

    The loops raise the degree of each inner vertex to D, and the degree of both ends of the path to
    D - 1.
    """
    if degree < 2 or degree % 2 or length < 1:
        raise ValueError("D is even and at least 2, L at least 1")
    ends = list(pairwise(range(length + 1)))
    for v in range(length + 1):
        on_path = 1 if v in (0, length) else 2
        ends += [(v, v)] * ((degree - on_path) // 2)
    return _drawn(length + 1, ends, random)


def switched_prism(length: int, random: Random) -> CombinatorialMap:
    """Two rings of N vertices each, joined by N edges, the rungs; m = 3N.

    Two neighbouring rungs have exchanged their ends in one of the rings, so that the graph is only
    nearly symmetric.  The order of the edges round each vertex is random.
    """
    if length < 3:
        raise ValueError("N is at least 3")
    rungs = [(i, length + i) for i in range(length)]
    half = length // 2
    rungs[half], rungs[half - 1] = (half, length + half - 1), (half - 1, length + half)
    ring = [(i, (i + 1) % length) for i in range(length)]
    return _drawn(2 * length, [*ring, *((length + a, length + b) for a, b in ring), *rungs], random)


BASE_VERTICES, BASE_EDGES = 3, 5


def cover(sheets: int, random: Random) -> CombinatorialMap:
    """A connected cover, with K sheets, of a random map with 3 vertices and 5 edges; m = 5K.

    A robot can distinguish the sheets only by the lighthouse.
    """
    if sheets < 1:
        raise ValueError("K is at least 1")

    def draw() -> CombinatorialMap:
        base = sparse(BASE_VERTICES, BASE_EDGES, random)
        names: dict[tuple[int, int], tuple[int, int]] = {}
        for edge, (d, e) in enumerate((d, e) for d, e in enumerate(base.alpha) if d < e):
            sheet = list(range(sheets))
            random.shuffle(sheet)
            for s in range(sheets):
                names[d, s] = names[e, sheet[s]] = edge, s
        return from_cycles(
            [[names[d, s] for d in around] for around in base.vertices for s in range(sheets)]
        )

    return _connected(draw)


def _matched(darts: list[int], random: Random) -> EdgeEnds:
    """The elements of ``darts`` in random pairs; each pair is an edge.

    The number of elements is even.  The elements are darts, or vertices in place of their darts:
    then a vertex occurs once for each of its darts.
    """
    shuffled = darts[:]
    random.shuffle(shuffled)
    return list(zip(shuffled[::2], shuffled[1::2], strict=True))


def _drawn(vertices: int, ends: EdgeEnds, random: Random) -> CombinatorialMap:
    """The map with the vertices ``0..vertices-1`` and the edges ``ends``.

    The order of the edges round each vertex is random.
    """
    around: list[list[int]] = [[] for _ in range(vertices)]
    for edge, pair in enumerate(ends):
        for v in pair:
            around[v].append(edge)
    for names in around:
        random.shuffle(names)
    return from_cycles(around)


def _connected(draw: Callable[[], CombinatorialMap]) -> CombinatorialMap:
    """The first connected map that ``draw`` returns; ``draw`` is called until it returns one."""
    while True:
        try:
            return draw()
        except InvalidMap:
            continue


LEAST_DEGREE = 14
"""The least degree of the hubs of a :func:`corridor`; hubs of this degree can have two types."""


def usual_degree(far: int) -> int:
    """The default degree of the hubs of a :func:`corridor` with F = ``far`` far hubs: 12F + 6.

    With this degree all hubs have different types.
    """
    return 12 * far + 6


def out_darts(kind: int) -> tuple[int, int]:
    """The positions of the two darts by which a hub of the type ``kind`` leads to the next hub.

    ``kind`` is an integer from 1 to q.  The position of a dart is the number of darts, clockwise,
    from the first dart of the hub to this dart.  The first dart is one of the two that lead to the
    previous vertex of the row.  The results are negative numbers; the caller takes them modulo the
    degree R.  Hubs of different types have different positions modulo R.
    """
    return -4 * kind, -4 * kind - 2


class CorridorShape(Struct, frozen=True):
    """The numbers that describe a :func:`corridor`.

    Attributes:
        far: F, the number of far hubs.
        degree: R, the degree of every hub.

    Raises:
        ValueError: for F < 1, an odd R, or R < 14.
    """

    far: int
    degree: int

    def __post_init__(self) -> None:
        """Check that the numbers F and R are legal."""
        if self.far < 1 or self.degree < LEAST_DEGREE or self.degree % 2:
            raise ValueError(f"F is at least 1, R even and at least {LEAST_DEGREE}")

    @property
    def types(self) -> int:
        """The number q of types of hubs."""
        return (self.degree - 6) // 4

    @property
    def window(self) -> int:
        """The number g: the types of g consecutive near hubs show which hubs these are.

        g is the least positive number with ``q^g >= (g + 1)F``.  Since there are (g + 1)F near
        hubs, there are enough sequences of g types for all near hubs.
        """
        window = 1
        while self.types**window < (window + 1) * self.far:
            window += 1
        return window

    @property
    def near(self) -> int:
        """The number N of near hubs."""
        return (self.window + 1) * self.far

    @property
    def hubs(self) -> int:
        """The number of all hubs."""
        return self.near + self.far

    @property
    def edges(self) -> int:
        """The number m of edges."""
        return self.hubs * self.degree // 2 + 1


def corridor(far: int, degree: int, seed: int) -> CombinatorialMap:
    """A corridor: a row of vertex 0, N near hubs, then F far hubs; all hubs have degree R.

    F is ``far``, R is ``degree``, and ``seed`` determines all random choices.  Two edges lead from
    each vertex of the row to the next vertex; the *type* of a hub determines by which darts these
    edges leave the hub (see :func:`out_darts`).  The remaining darts of a near hub are joined in
    random pairs, and so become loops; the remaining darts of all far hubs are joined in random
    pairs, too.  Vertex 0 has the darts 0 and 1; hub l has the R darts from 2 + (l - 1)R on.
    """
    shape = CorridorShape(far, degree)
    numbers = f"{far}" if degree == usual_degree(far) else f"{far}x{degree}"
    random = Random(f"corridor/{numbers}/{seed}")  # noqa: S311  # reproducible
    sigma, pairs, free = [1, 0], [(0, 2), (1, 3)], list[int]()
    for hub, kind in enumerate(hub_types(shape), 1):
        base = 2 + (hub - 1) * degree
        sigma += [*range(base + 1, base + degree), base]
        fixed = [base, base + 1]
        if hub < shape.hubs:
            outs = [base + out % degree for out in out_darts(kind)]
            pairs += zip(outs, (base + degree, base + degree + 1), strict=True)
            fixed += outs
        rest = [d for d in range(base, base + degree) if d not in fixed]
        if hub <= shape.near:
            pairs += _matched(rest, random)
        else:
            free += rest
    alpha = [0] * len(sigma)
    for d, e in pairs + _matched(free, random):
        alpha[d], alpha[e] = e, d
    return CombinatorialMap(sigma, alpha)


def hub_types(shape: CorridorShape) -> Iterator[int]:
    """The types of the hubs of a :func:`corridor`, hub by hub; each is an integer from 1 to q.

    q is ``shape.types``, and g is ``shape.window``.  Any two different groups of g consecutive near
    hubs have different sequences of types.
    """
    return islice(repeated(_de_bruijn(shape.types, shape.window)), shape.hubs)


def _de_bruijn(letters: int, length: int) -> Iterator[int]:
    """The letters, one by one, of a cyclic word that holds each word of length ``length`` once.

    The letters are the integers 1..letters; of all such cyclic words, the result is the first one
    in lexicographic order.

    Source: H. Fredricksen, J. Maiorana, Necklaces of beads in k colors and k-ary de Bruijn
    sequences, Discrete Math. 23 (1978): the ascending Lyndon words whose lengths divide ``length``.
    """
    word = [0]
    while word:
        if length % len(word) == 0:
            yield from (letter + 1 for letter in word)
        word = list(islice(repeated(word), length))
        while word and word[-1] == letters - 1:
            word.pop()
        if word:
            word[-1] += 1


def corridor_edges(far: int, degree: int) -> int:
    """The number of edges of a :func:`corridor`; 0 if ``far`` or ``degree`` is illegal."""
    try:
        return CorridorShape(far, degree).edges
    except ValueError:
        return 0


LARGEST = 100_000
"""The largest number of edges of a family's member; in larger maps no run would come to its end."""


class Family(Struct, frozen=True):
    """Maps of one kind, large or small.

    Attributes:
        form: the form of a member's name; a capital letter stands for a number.
        edges: the function that takes the numbers in a name, and returns how many edges the member
            has before any edges are removed.
        build: the function that makes a member from the numbers in its name, the fraction of holes,
            and a seed.
        has_holes: whether the members can have *holes*: edges that are removed at random.
        one_map: whether all members without holes that have the same name are rootings of one map.
            The seed then chooses the rooting; all rootings have the same probability.
    """

    form: str
    edges: Callable[..., int]
    build: Callable[..., CombinatorialMap]
    has_holes: bool = False
    one_map: bool = False


def family(text: str, *, holes: float = 0.0, seed: int = 0) -> CombinatorialMap:
    """The member of a family of maps that a name and a seed determine.

    Args:
        text: the name of a family's member, such as ``lattice:5x6`` (5 x 6 vertices in the plane),
            ``dense:7`` (a complete graph) or ``random:9`` (see :func:`random_map`).
        holes: the fraction of edges that are removed at random; only a lattice, a strip or a dense
            map can have holes.
        seed: the seed of all random choices: in a lattice, a strip or a dense map, which edges are
            removed.  In a lattice or a strip without holes, any seed but 0 chooses a random dart as
            the root: this dart becomes dart 0, which a robot faces at the start.

    Raises:
        InputError: naming the text, or the holes, and what would be legal.
    """
    kind, sizes = _parsed(text)
    if kind.edges(*sizes) > LARGEST:
        raise InputError(f"family {show(text)} has more than {LARGEST:,} edges")
    if holes and not kind.has_holes:
        raise InputError(f"holes are for {_WITH_HOLES}, not for {text}")
    try:
        return kind.build(*sizes, holes, seed)
    except ValueError as error:
        raise InputError(f"family {text}: {error}") from None


def edges_of(text: str) -> int:
    """The number of edges that the member with the name ``text`` has without holes.

    The number is computed from the name alone, even if no map has these sizes.

    Raises:
        InputError: if ``text`` is not the name of a member of a family.
    """
    kind, sizes = _parsed(text)
    return kind.edges(*sizes)


def rootings(text: str, map_: CombinatorialMap, holes: float | str | None = None) -> int | None:
    """The number of different rooted maps with the name ``text``, for all seeds, if known.

    The number is known if all these maps are rootings of one map (:attr:`Family.one_map`), and
    there are no holes.  Then all rootings have the same probability.  Otherwise the result is None.

    Args:
        text: the name.
        map_: the member for any one of the seeds; the result is the same for each of them.
        holes: the fraction of edges that are removed, as a number or a text; None, 0 or an empty
            text if there are no holes.

    Cost: O(m^2).
    """
    kind, _ = _parsed(text)
    if not kind.one_map or holes:
        return None
    # No automorphism but the identity fixes a dart, so that all orbits of darts have one size.
    return len(map_.sigma) // automorphisms(map_)


def _parsed(text: str) -> tuple[Family, tuple[int, ...]]:
    for kind in FAMILIES:
        match = re.fullmatch(re.sub(r"[A-Z]", r"(\\d+)", kind.form), text, re.ASCII)
        if match is not None:
            return kind, tuple(int(size[:7]) for size in match.groups())
    raise not_one_of("family", text, FORMS.split(", "), also=OTHER_WORDS)


def random_map(edges: int, random: Random) -> CombinatorialMap:
    """A random map with ``edges`` edges, rooted at dart 0; all such rooted maps are equally likely.

    A random permutation sigma is drawn, with a fixed alpha, until the map is connected.  All rooted
    maps are equally likely, because each of them has the same number of labellings of its darts
    with this alpha and the root 0.

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


def _lattice(rows: int, columns: int, holes: float, seed: int) -> CombinatorialMap:
    map_ = lattice(rows, columns, holes, seed)
    if holes or not seed:
        return map_
    start = Random(seed).randrange(len(map_.sigma))  # noqa: S311  # reproducible, not secret
    return CombinatorialMap(*rooted_code(map_.sigma, map_.alpha, start))


def _random(edges: int, _holes: float, seed: int) -> CombinatorialMap:
    if edges < 1:
        raise ValueError("a map has at least 1 edge")
    return random_map(edges, Random(seed))  # noqa: S311  # reproducible, not secret


def _from_seed(draw: Callable[..., CombinatorialMap]) -> Callable[..., CombinatorialMap]:
    """The field ``build`` of a :class:`Family`: a function that makes a member with ``draw``.

    The function calls ``draw`` with the numbers in the member's name and a random generator.  The
    generator depends on these numbers and the seed, so members of different sizes are independent.
    """

    def build(*numbers: Any) -> CombinatorialMap:
        *sizes, _holes, seed = numbers
        name = "x".join(map(str, sizes))
        return draw(*sizes, Random(f"{draw.__name__}/{name}/{seed}"))  # noqa: S311  # as above

    return build


FAMILIES = (
    Family(
        "lattice:RxC",
        lambda r, c: r * (c - 1) + c * (r - 1),
        _lattice,
        has_holes=True,
        one_map=True,
    ),
    Family(
        "strip:C",
        lambda c: 3 * c - 2,
        lambda c, holes, seed: _lattice(2, c, holes, seed),
        has_holes=True,
        one_map=True,
    ),
    Family("dense:N", lambda n: n * (n - 1) // 2, dense, has_holes=True),
    Family("cycle:N", lambda n: n, lambda n, _holes, _seed: cycle(n), one_map=True),
    Family("torus:RxC", lambda r, c: 2 * r * c, _from_seed(torus), one_map=True),
    Family("cubic:N", lambda n: 3 * n // 2, _from_seed(cubic)),
    Family("regular:DxN", lambda d, n: d * n // 2, _from_seed(regular)),
    Family("random:M", lambda m: m, _random),
    Family("random:NxM", lambda _n, m: m, _from_seed(sparse)),
    Family("bouquet:C", lambda c: c + 1, _from_seed(bouquet)),
    Family("lollipop:DxL", lambda d, n: n * (d // 2) + n * d // 2 + 1, _from_seed(lollipop)),
    Family("prism:N", lambda n: 3 * n, _from_seed(switched_prism)),
    Family(
        "thick:DxL", lambda d, n: n * (d // 2) - d // 2 + 1 + 2 * ((d - 1) // 2), _from_seed(thick)
    ),
    Family("cover:K", lambda k: BASE_EDGES * k, _from_seed(cover)),
    Family(
        "corridor:F",
        lambda f: corridor_edges(f, usual_degree(f)),
        lambda f, _holes, seed: corridor(f, usual_degree(f), seed),
    ),
    Family("corridor:FxR", corridor_edges, lambda f, r, _holes, seed: corridor(f, r, seed)),
)
"""All families of maps."""

FORMS: str = ", ".join(kind.form for kind in FAMILIES)
"""The forms of the names of the families' members."""

OTHER_WORDS = {
    "grid": "lattice",
    "mesh": "lattice",
    "ladder": "strip",
    "ring": "cycle",
    "complete": "dense",
}
"""Other words that users may write for families, each with the name of the family."""

_WITH_HOLES = " and ".join(kind.form.partition(":")[0] for kind in FAMILIES if kind.has_holes)
