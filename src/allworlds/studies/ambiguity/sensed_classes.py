"""Arrays for many worlds with equally many darts, and names of worlds that show which look alike.

The first index of a matrix is a world, the second a dart.  Every world starts at dart 0.  Some
lighthouses *tell* the robot a value before the start: ``natural``, for example, the degree of v1.
"""

import json
from collections.abc import Iterator, Sequence
from functools import lru_cache
from hashlib import blake2b
from threading import get_ident
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from allworlds.engines.engine_table import COMPILED_FROM, COMPILER, kind_of
from allworlds.engines.kernel import capabilities
from allworlds.engines.units import LevelUnit
from allworlds.inputs.checks import InputError, lack_of, show
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol.actions import Percept, Told
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.composed import Nothing
from allworlds.world.lighthouses.marked import Door, Labels, SensedByBearing, word_of

if TYPE_CHECKING:
    import numpy as np

Matrix: TypeAlias = "np.ndarray[Any, np.dtype[np.int64]]"
LitMap: TypeAlias = tuple[CombinatorialMap, Lighthouse]
"""A map rooted at dart 0, and a lighthouse at one of its places in this map."""

BITS = 20
"""The number of bits for a degree, and for a bearing, in the number of a percept."""

MOST_MARKS = 1 << (63 - 2 * BITS)
ENTRIES = 1 << 20
"""The most entries of a matrix of codes."""


class SensedWorlds(NamedTuple):
    """Worlds with equally many darts.

    Attributes:
        sigma, alpha: for each dart the dart to which sigma or alpha leads.
        sensed: for each dart the number that stands for the percept there; see :func:`matrices`.
        told: for each world the value that its lighthouse tells the robot before the start; None
            for most lighthouses, which tell nothing.
        vertices: for each world the number of its vertices.
    """

    sigma: Matrix
    alpha: Matrix
    sensed: Matrix
    told: Sequence[Told]
    vertices: Sequence[int]

    def chosen(self, indices: Any) -> "SensedWorlds":
        """Return the worlds with these indices, without the fields ``told`` and ``vertices``."""
        return SensedWorlds(self.sigma[indices], self.alpha[indices], self.sensed[indices], (), ())


def matrices(worlds: Sequence[LitMap]) -> SensedWorlds:
    """The worlds as arrays, in which a number stands for each percept.

    The number is made of the degree, the bearing and the marks.  So equal percepts have equal
    numbers, also in different worlds, and different percepts have different numbers.

    Args:
        worlds: maps with equally many darts, each with a lighthouse at a place.

    Raises:
        InputError: for a percept with more marks than fit into its number.
    """
    import numpy as np

    def number(percept: Percept) -> int:
        bearing = 0 if percept.bearing is None else percept.bearing + 1
        if percept.marks >= MOST_MARKS:
            raise InputError(f"marks = {show(percept.marks)} is not below {MOST_MARKS}")
        return (percept.marks << BITS | bearing) << BITS | percept.degree

    every = [lighthouse.percepts(map_) for map_, lighthouse in worlds]
    # Equal percepts are mostly one object.
    different = {id(percept): percept for percepts in every for percept in percepts}
    numbers = {key: number(percept) for key, percept in different.items()}
    sensed = [[numbers[id(percept)] for percept in percepts] for percepts in every]
    permutations = ([map_.sigma for map_, _ in worlds], [map_.alpha for map_, _ in worlds])
    shape = len(worlds), len(worlds[0][0].sigma) if worlds else 0
    made = [np.array(rows, np.int64).reshape(shape) for rows in (*permutations, sensed)]
    told = [lighthouse.told(map_) for map_, lighthouse in worlds]
    return SensedWorlds(made[0], made[1], made[2], told, [m.vertex_count for m, _ in worlds])


def compiled_name(kind: type[Lighthouse], extent: Extent) -> str:
    """The name of the lighthouse with which compiled code makes the worlds of an extent.

    The name is empty if Python must make the worlds.  This is so in each of these cases:

    - The compiled code does not know the lighthouse.
    - The extent has a condition, or consists of maps that the user has given.
    - The largest maps have fewer than :data:`COMPILED_FROM` edges, so that compiling takes longer
      than it saves.
    - The largest maps have more edges than the compiled code can hold.
    - The compiler is missing.

    For some lighthouses the compiled code makes the worlds with another lighthouse.  Then
    :func:`laid_out` computes the percepts from the place of that lighthouse, and the name of that
    lighthouse is returned: ``door`` for every lighthouse that shows letters at v0, and ``none``
    (the lighthouse that shows degrees alone) for the lighthouse ``labels``.
    """
    name = Door.kind if issubclass(kind, SensedByBearing) else kind_of(kind)
    name = Nothing.kind if kind is Labels else name
    able = name in capabilities.LIGHTHOUSES and not (extent.given or extent.where)
    large = COMPILED_FROM <= extent.levels[-1] <= capabilities.MOST_EDGES
    return name if able and large and not lack_of(*COMPILER) else ""


@lru_cache(16)
def _room(edges: int, thread: int) -> tuple[Any, ...]:  # noqa: ARG001  # each has its own
    """The memory in which compiled code makes worlds with ``edges`` edges: four arrays.

    Each thread has arrays of its own; ``thread`` is the number of the thread.  The first array
    holds the state of the unit that is being done.  The second one holds the state of an explorer,
    which the compiled code asks for, although no explorer runs here.  The third one has an entry
    for each world, the fourth one an entry for each dart of each world.
    """
    from allworlds.engines.kernel import arrays

    made = arrays.Stretch.of(edges)
    return arrays.new(arrays.JOB), arrays.new(arrays.ROBOT), made.heads, made.worlds


def laid_out(
    unit: LevelUnit, extent: Extent, kind: type[Lighthouse]
) -> Iterator[tuple[int, SensedWorlds]]:
    """Yield the worlds of a unit, made by compiled code, in batches: (number of maps, worlds).

    The number is that of the batch's rooted maps.  Maps in which the lighthouse has no place are
    counted, too.
    """
    import numpy as np

    from allworlds.engines.kernel import arrays, engine

    of, name, at = extent.map_class, compiled_name(kind, extent), np.arange(2 * unit.edges)
    asked = unit.edges, extent.vertex_limit(unit.edges), of.simple, of.planar, "", name, "fifo", ()
    level = arrays.Level(*asked, [[[0]]], (0,) * (unit.edges + 2))
    job, robot, heads, laid = _room(unit.edges, get_ident())
    job.gluing = job.world = job.number = 0
    engine.set_up(job, robot, level)
    wanted = engine.unit_of(level, unit.prefix)
    while job.until:
        before = int(job.number)
        job.until = before + arrays.LONGEST_STRETCH
        runs = engine.lay_out(job, wanted, heads, laid)
        fields = laid[:runs].reshape(-1, len(at), arrays.WIDE).astype(np.int64)
        first, alpha, degree, marks, bearing = np.moveaxis(fields, 2, 0)
        if issubclass(kind, SensedByBearing):
            words = [word_of(kind.pattern, d) + (0,) * (len(at) - d) for d in range(1, len(at) + 1)]
            back = (marks.argmax(axis=1)[:, None] - at) % degree[:, :1]
            marks = np.where(first == 0, np.array(words)[degree - 1, back], 0)
        maps = int((fields[1:, :, :2] != fields[:-1, :, :2]).any(axis=(1, 2)).sum()) + (runs > 0)
        told = [None if each < 0 else each for each in heads[:runs, arrays.RUN_TOLD].tolist()]
        sigma = first + (at - first + 1) % degree
        sensed = (marks << BITS | bearing) << BITS | degree
        vertices = (first == at).sum(axis=1).tolist()
        # A map without a place has its number, too.
        without = int(job.number) - before - runs
        worlds = SensedWorlds(sigma, alpha, sensed, told, vertices)
        yield maps + without, _labelled(worlds, first) if kind is Labels else worlds


def _labelled(worlds: SensedWorlds, first: Matrix) -> SensedWorlds:
    """The worlds with the percepts of the lighthouse ``labels`` in place of the degrees alone.

    The vertices of a world have the numbers 1, 2, 3, ... in the order of their first darts, and the
    reference dart of a vertex is its first dart.  "First" means: with the smallest canonical
    number.  The marks at a vertex are its number.  The bearing at a dart is the number of darts,
    clockwise, from this dart to the reference dart.

    Args:
        worlds: the worlds, under the lighthouse ``none``.
        first: for each dart the dart with the smallest index at the same vertex.  Indices of darts
            are not canonical numbers.
    """
    import numpy as np

    at, degree = np.broadcast_to(np.arange(first.shape[1]), first.shape), worlds.sensed
    number, order = numbered(worlds, at, at[:, 0])
    together = first[:, :, None] == first[:, None, :]
    least = np.where(together, number[:, None, :], first.shape[1]).min(axis=2)
    marks = ((number == least)[:, None, :] & (number[:, None, :] <= least[:, :, None])).sum(axis=2)
    bearing = (np.take_along_axis(order, least, 1) - at) % degree + 1
    return worlds._replace(sensed=(marks << BITS | bearing) << BITS | degree)


def _ranks(keys: Matrix) -> Matrix:
    """The matrix in which each entry is replaced by its rank among the entries of its world.

    The rank is the number of different smaller entries.
    """
    import numpy as np

    order = np.argsort(keys, axis=1, kind="stable")
    ordered = np.take_along_axis(keys, order, 1)
    ranks = np.zeros_like(keys)
    ranks[:, 1:] = np.cumsum(ordered[:, 1:] != ordered[:, :-1], axis=1)
    found = np.empty_like(keys)
    np.put_along_axis(found, order, ranks, 1)
    return found


def classes(worlds: SensedWorlds) -> Matrix:
    """A matrix with the number, from 0 on, of each dart's class in the quotient of its world.

    Two darts are in one class if no motion tells them apart.  Classes are split by percepts; then,
    in rounds, by the classes to which sigma and alpha lead, until no class is split.  The numbers
    of the classes do not depend on the numbers of the darts.

    Cost: O(m log m) for each world and round; there are at most as many rounds as classes.
    """
    import numpy as np

    found, darts = _ranks(worlds.sensed), worlds.sigma.shape[1]
    left = np.arange(len(found))
    while len(left):
        sigma, alpha = worlds.sigma[left], worlds.alpha[left]
        before = found[left]
        keys = (before * darts + np.take_along_axis(before, sigma, 1)) * darts
        after = _ranks(keys + np.take_along_axis(before, alpha, 1))
        found[left] = after
        count = after.max(axis=1)
        left = left[(count > before.max(axis=1)) & (count < darts - 1)]
    return found


def numbered(worlds: SensedWorlds, of: Matrix, roots: Matrix) -> tuple[Matrix, Matrix]:
    """Number the classes of darts in each world canonically; return two matrices.

    Both matrices have a row for each world.  In the first matrix, entry q of a row is the canonical
    number of the class q.  In the second matrix, entry x is a dart of the class with the canonical
    number x.  If there are fewer classes than darts, the last entries have no meaning.

    The class of the root has number 0.  Then each numbered class is looked at in turn.  If the
    class to which sigma leads has no number yet, this class gets the next number; then the same is
    done with alpha.

    Args:
        worlds: the worlds.
        of: for each world the class of each dart.
        roots: for each world the dart from which the numbering begins; it need not be the start.

    Cost: O(m) a world.
    """
    import numpy as np

    (count, darts), every = worlds.sigma.shape, np.arange(len(roots))
    sizes, known = of.max(axis=1) + 1, np.ones(count, np.int64)
    number, order = np.full((count, darts), -1), np.zeros((count, darts), np.int64)
    number[every, of[every, roots]], order[:, 0] = 0, roots
    for x in range(int(sizes.max(initial=0))):
        left = every[sizes > x]
        dart = order[left, x]
        for permutation in worlds[:2]:
            to = permutation[left, dart]
            into = of[left, to]
            new = number[left, into] < 0
            fresh, at = left[new], known[left[new]]
            number[fresh, into[new]], order[fresh, at] = at, to[new]
            known[fresh] += 1
    return number, order


def rooted_codes(worlds: SensedWorlds, of: Matrix, roots: Matrix) -> Iterator[bytes]:
    """Yield, for each world, the code of its quotient, rooted at the class of the world's root.

    For each class, in the order of :func:`numbered`, the code has the numbers of the classes to
    which sigma and alpha lead, and the percept.  So equal codes mean isomorphic rooted quotients.
    ``of`` has the class of each dart, ``roots`` the root of each world.
    """
    import numpy as np

    number, order = numbered(worlds, of, roots)
    at = np.arange(len(roots))[:, None]
    ends = (number[at, of[at, permutation[at, order]]] for permutation in worlds[:2])
    codes = np.stack((*ends, worlds.sensed[at, order]), axis=2)
    for size, code in zip((of.max(axis=1) + 1).tolist(), codes, strict=True):
        yield code[:size].tobytes()


def digest(code: bytes, told: Told = None) -> str:
    """A digest of a world's code and of the value that the robot is told before the start.

    The code is one that :func:`rooted_codes` yields.
    """
    value = "" if told is None else told
    text = str(value) if isinstance(value, int | str) else json.dumps(value, sort_keys=True)
    return blake2b(text.encode() + b"\0" + code, digest_size=16).hexdigest()


class NamedWorld(NamedTuple):
    """Names by which worlds are compared.

    Attributes:
        look: a text.  Two worlds have the same text if and only if no motion from their starts,
            and no value told before the start, tells the worlds apart.
        name: a text.  Two worlds have the same text if and only if an isomorphism keeps percepts
            and told values; their starts do not matter.
        sheets: the number of darts in each class of the quotient.
    """

    look: str
    name: str
    sheets: int


def named(worlds: SensedWorlds) -> Iterator[NamedWorld]:
    """Yield the names of each world; all these worlds have equally many darts."""
    import numpy as np

    count, told = len(worlds.sigma), worlds.told
    if not count:
        return
    of = classes(worlds)
    looks = rooted_codes(worlds, of, np.zeros(count, np.int64))
    least = [""] * count
    indices, roots = np.nonzero(of == 0)
    darts = of.shape[1]
    step = max(1, ENTRIES // darts)
    for first in range(0, len(indices), step):
        some = indices[first : first + step]
        each = np.broadcast_to(np.arange(darts), (len(some), darts))
        codes = rooted_codes(worlds.chosen(some), each, roots[first : first + step])
        for index, code in zip(some.tolist(), codes, strict=True):
            name = digest(code, told[index])
            least[index] = min(least[index], name) if least[index] else name
    sheets = (of == 0).sum(axis=1).tolist()
    for look, name, value, number in zip(looks, least, told, sheets, strict=True):
        yield NamedWorld(digest(look, value), name, number)
