"""Wrong kernels that are right in every world with at most 4 edges.

    PYTHONPATH=proofs/coq python tests/support/mutants/kernels.py

says of each which piece of a larger level tells it from ``examine``.  Exit code 1: one is seen in a
world with at most 4 edges, or is not seen at all.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from random import Random

from msgspec import Struct

from allworlds.engines.kernel import demand_driven
from allworlds.engines.units import LevelUnit
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.enumeration import prefixes
from certified_sample import (
    MOST,
    POLICIES,
    UNITS,
    Piece,
    Walk,
    piece_apart,
    piece_of,
    sample,
    units_drawn,
)
from interpreted import interpreted

RIGHT_TO = 4
RUNS = 500
"""The number of runs of the sample that are looked at, at most."""


class WrongKernel(Struct, frozen=True):
    """A kernel that walks on demand, with a mistake in its source.

    Attributes:
        name: for the table.
        breaks: what goes wrong, and from where on.
        before, after: the text that is replaced, and by what.
        policy: under which it is wrong.
    """

    name: str
    breaks: str
    before: str
    after: str
    policy: str = "fifo"

    def walk(self) -> Walk:
        """The kernel, interpreted."""
        source = Path(demand_driven.__file__).read_text(encoding="utf-8")
        assert source.count(self.before) == 1, self.name
        return interpreted({"demand_driven": source.replace(self.before, self.after)}).walk


WRONG_KERNELS = (
    WrongKernel(
        "parents-of-3-bits",
        "The way home begins with a dart modulo 8.",
        "s.parent >> (5 * (w.s_owner[dart] - 1)) & 31",
        "s.parent >> (5 * (w.s_owner[dart] - 1)) & 7",
    ),
    WrongKernel(
        "levels-of-2-bits",
        "From v0 the way to a vertex is counted modulo 4.",
        "        s.total += s.level >> (4 * v) & 15",
        "        s.total += s.level >> (4 * v) & 3",
    ),
    WrongKernel(
        "eight-hypotheses",
        "Only the first 8 darts of S are hypotheses.",
        "s.unexplored & w.of_degree[w.degree[z]]",
        "s.unexplored & w.of_degree[w.degree[z]] & 255",
    ),
    WrongKernel(
        "three-steps-away",
        "The way from a vertex to another counts for 3 steps at most.",
        "    while not reached >> goal & 1:",
        "    while steps < 3 and not reached >> goal & 1:",
    ),
    WrongKernel("events-of-4-bits", "Events are counted modulo 16.", "_FEW = 0xFF", "_FEW = 0xF"),
    WrongKernel("costs-of-6-bits", "Costs are counted modulo 64.", "COST = 0xFFFFF", "COST = 0x3F"),
    WrongKernel(
        "eight-darts-kept",
        "Of a world that is kept only the first 8 darts are written anew.",
        "    for dart in range(s.darts):\n        end",
        "    for dart in range(min(s.darts, 8)):\n        end",
    ),
    WrongKernel(
        "four-vertices-near",
        "The nearest dart is looked for round the first 4 vertices.",
        "        front = after & ~reached\n",
        "        front = after & ~reached & 15\n",
        "nearest",
    ),
    WrongKernel(
        "four-vertices-joined",
        "An edge that closes a loop joins one of the first 4 vertices.",
        "        w.adjacent[a] |= 1 << b\n        w.adjacent[b] |= 1 << a\n",
        "        w.adjacent[a] |= 1 << b & 15\n        w.adjacent[b] |= 1 << a & 15\n",
    ),
    WrongKernel(
        "eight-darts-last",
        "The last dart of U is one of the first 8 darts of S, if there is one.",
        "e = highest(s.unexplored)",
        "e = highest(s.unexplored & 255 or s.unexplored)",
        "lifo",
    ),
    WrongKernel(
        "eight-darts-new",
        "Worlds are left out that have a vertex with 9 darts or more which is not v0.",
        "if degree > owed or s.vertices >= w.limit:",
        "if degree > min(owed, 8) or s.vertices >= w.limit:",
    ),
    WrongKernel(
        "one-step-undecided",
        "A test that cannot match, wherever y leads, costs one step at most.",
        "            s.total += s.steps + 2 + ONE_CASE_2",
        "            s.total += min(s.steps, 1) + 2 + ONE_CASE_2",
        "nearest",
    ),
)
"""Each is wrong in some world with 5 to 9 edges, and in none with fewer.

The last two are wrong where a dart is decided: they are right in a unit of one world.
"""


def small_pieces() -> Iterator[Piece]:
    """All worlds with at most 4 edges."""
    for m in range(1, RIGHT_TO + 1):
        for prefix in prefixes(m, depth=2):
            yield Piece(LevelUnit(m, prefix), Extent(MapClass.MAPS, m))


def larger_pieces(policy: str) -> Iterator[Piece]:
    """The units that ``certified.py --sample`` draws, and worlds drawn as there, one by one."""
    yield from islice(units_drawn(0, policy, MOST), UNITS // len(POLICIES))
    for _, world in sample(RUNS, MOST, policy, Random(policy)):
        yield piece_of(world.map)


def seen_in(wrong: WrongKernel, every: Iterable[Piece]) -> LevelUnit | None:
    """The unit of the first piece that tells a wrong kernel from ``examine``; None if none does."""
    walk = wrong.walk()
    apart = (piece.unit for piece in every if piece_apart(piece, wrong.policy, walk))
    return next(apart, None)


def main() -> int:
    """Tell of each."""
    code_ = 0
    for wrong in WRONG_KERNELS:
        small = seen_in(wrong, small_pieces())
        larger = seen_in(wrong, larger_pieces(wrong.policy))
        code_ = 1 if small or larger is None else code_
        where = f"in {larger.key}" if larger else "NOT SEEN"
        sys.stdout.write(f"{wrong.name}: {f'in {small.key}, TOO SMALL' if small else where}\n")
    return code_


if __name__ == "__main__":
    sys.exit(main())
