"""Many worlds of one size at once, in arrays: which look alike, and which are the same.

A row of a matrix is a world, a column a dart.  Every world is rooted at dart 0, its start.
"""

import json
from collections.abc import Iterator, Sequence
from hashlib import blake2b
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from allworlds.inputs.checks import InputError, show
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol.actions import Percept, Told
from allworlds.world.lighthouses.base import Lighthouse

if TYPE_CHECKING:
    import numpy as np

Matrix: TypeAlias = "np.ndarray[Any, np.dtype[np.int64]]"
Placed: TypeAlias = tuple[CombinatorialMap, Lighthouse]
"""A map rooted at dart 0, and a lighthouse at a place of it."""

BITS = 20
"""The bits of a degree, and of a bearing, in the number of what is sensed."""

MOST_MARKS = 1 << (63 - 2 * BITS)
ENTRIES = 1 << 20
"""The entries of a matrix of codes that is made at once."""


class SensedWorlds(NamedTuple):
    """Worlds with equally many darts.

    Attributes:
        sigma, alpha: the permutations.
        sensed: for each dart a number that stands for what is sensed there, with the degree.
    """

    sigma: Matrix
    alpha: Matrix
    sensed: Matrix

    def chosen(self, rows: Any) -> "SensedWorlds":
        """Return some of them, by their numbers."""
        return SensedWorlds(*(matrix[rows] for matrix in self))


def matrices(worlds: Sequence[Placed]) -> SensedWorlds:
    """The worlds, each percept as a number that is the same in every world.

    Raises:
        InputError: for more marks than the number has room for.
    """
    import numpy as np

    def number(percept: Percept) -> int:
        bearing = 0 if percept.bearing is None else percept.bearing + 1
        if percept.marks >= MOST_MARKS:
            raise InputError(f"marks = {show(percept.marks)} is not below {MOST_MARKS}")
        return (percept.marks << BITS | bearing) << BITS | percept.degree

    every = [place.percepts(map_) for map_, place in worlds]
    # Equal percepts are mostly one object.
    different = {id(percept): percept for percepts in every for percept in percepts}
    numbers = {key: number(percept) for key, percept in different.items()}
    sensed = [[numbers[id(percept)] for percept in percepts] for percepts in every]
    permutations = ([map_.sigma for map_, _ in worlds], [map_.alpha for map_, _ in worlds])
    shape = len(worlds), len(worlds[0][0].sigma) if worlds else 0
    made = (np.array(rows, np.int64).reshape(shape) for rows in (*permutations, sensed))
    return SensedWorlds(*made)


def _ranks(keys: Matrix) -> Matrix:
    """For each entry the number of smaller values in its row."""
    import numpy as np

    order = np.argsort(keys, axis=1, kind="stable")
    ordered = np.take_along_axis(keys, order, 1)
    ranks = np.zeros_like(keys)
    ranks[:, 1:] = np.cumsum(ordered[:, 1:] != ordered[:, :-1], axis=1)
    found = np.empty_like(keys)
    np.put_along_axis(found, order, ranks, 1)
    return found


def classes(worlds: SensedWorlds) -> Matrix:
    """For each dart its class in the quotient of its world, from 0 on.

    Two darts are in one class if no motion tells them apart.  Classes are split by what is sensed,
    then by the classes to which sigma and alpha lead, until none is split.  Their numbers do not
    depend on those of the darts.

    Cost: O(m log m) for each world and each round, of which there are at most as many as classes.
    """
    import numpy as np

    found, darts = _ranks(worlds.sensed), worlds.sigma.shape[1]
    left = np.arange(len(found))
    while len(left):
        sigma, alpha, _ = worlds.chosen(left)
        before = found[left]
        keys = (before * darts + np.take_along_axis(before, sigma, 1)) * darts
        after = _ranks(keys + np.take_along_axis(before, alpha, 1))
        found[left] = after
        count = after.max(axis=1)
        left = left[(count > before.max(axis=1)) & (count < darts - 1)]
    return found


def rooted_codes(worlds: SensedWorlds, of: Matrix, roots: Matrix) -> Iterator[bytes]:
    """For each world the code of its quotient, rooted at the class of a dart.

    Classes are numbered from the root's on: the oldest numbered one has the class to which sigma
    leads numbered, then that to which alpha does.  The code holds for each class these two and
    what is sensed, so equal codes mean that one quotient is the other, root included.

    Args:
        worlds: each with one root.
        of: for each dart its class.
        roots: for each world a dart.

    Cost: O(m) a world.
    """
    import numpy as np

    (count, darts), every = worlds.sigma.shape, np.arange(len(roots))
    sizes = of.max(axis=1) + 1
    number, known = np.full((count, darts), -1), np.ones(count, np.int64)
    dart_of = np.zeros((count, darts), np.int64)
    number[every, of[every, roots]], dart_of[:, 0] = 0, roots
    codes = np.zeros((count, darts, 3), np.int64)
    for x in range(int(sizes.max(initial=0))):
        rows = every[sizes > x]
        dart = dart_of[rows, x]
        for column, permutation in enumerate(worlds[:2]):
            to = permutation[rows, dart]
            into = of[rows, to]
            new = number[rows, into] < 0
            fresh, at = rows[new], known[rows[new]]
            number[fresh, into[new]], dart_of[fresh, at] = at, to[new]
            known[fresh] += 1
            codes[rows, x, column] = number[rows, into]
        codes[rows, x, 2] = worlds.sensed[rows, dart]
    for size, code in zip(sizes.tolist(), codes, strict=True):
        yield code[:size].tobytes()


def digest(code: bytes, told: Told = None) -> str:
    """A name for a code, with what is told before the start."""
    text = "" if told is None else json.dumps(told, sort_keys=True)
    return blake2b(text.encode() + b"\0" + code, digest_size=16).hexdigest()


class NamedWorld(NamedTuple):
    """Names by which worlds are compared.

    Attributes:
        look: the same for two worlds if no motion tells them apart from their starts.
        name: the same if they are the same, whatever their starts: in map, percepts and what is
            told.
        sheets: the number of darts in each class of its quotient.
    """

    look: str
    name: str
    sheets: int


def named(worlds: Sequence[Placed], arrays: SensedWorlds) -> Iterator[NamedWorld]:
    """The names of worlds with equally many darts, of which these are the matrices."""
    import numpy as np

    if not worlds:
        return
    told = [place.told(map_) for map_, place in worlds]
    of = classes(arrays)
    looks = rooted_codes(arrays, of, np.zeros(len(worlds), np.int64))
    least = [""] * len(worlds)
    rows, roots = np.nonzero(of == 0)
    darts = of.shape[1]
    step = max(1, ENTRIES // darts)
    for first in range(0, len(rows), step):
        some = rows[first : first + step]
        each = np.broadcast_to(np.arange(darts), (len(some), darts))
        codes = rooted_codes(arrays.chosen(some), each, roots[first : first + step])
        for row, code in zip(some.tolist(), codes, strict=True):
            name = digest(code, told[row])
            least[row] = min(least[row], name) if least[row] else name
    sheets = (of == 0).sum(axis=1).tolist()
    for look, name, said, number in zip(looks, least, told, sheets, strict=True):
        yield NamedWorld(digest(look, said), name, number)
