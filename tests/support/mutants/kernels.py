"""Wrong kernels that are right in every world with at most 4 edges, and an interpreter of kernels.

    PYTHONPATH=proofs/coq python tests/support/mutants/kernels.py

says of each which piece of a larger level tells it from ``examine``.  Exit code 1: one is seen in a
world with at most 4 edges, or is not seen at all.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from random import Random
from types import FunctionType, SimpleNamespace
from typing import Any

import numpy as np
from msgspec import Struct

from allworlds.engines.kernel import code, demand_driven, engine
from allworlds.engines.kernel.records import Rows
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
        return interpreted(source.replace(self.before, self.after))


def interpreted(source: str) -> Walk:
    """The function ``walk`` of a kernel with this source, run by Python: no compiler is needed.

    Numbers have no limit here, and there is a world or two a millisecond.
    """
    words = {
        **dict.fromkeys(("entry", "inner", "inlined"), lambda function: function),
        "lowest": lambda mask: (mask & -mask).bit_length() - 1,
        "highest": lambda mask: mask.bit_length() - 1,
        "size": int.bit_count,
        "copy": lambda target, other: vars(target).update(vars(other)),
        "neighbours": _neighbours,
    }
    codes = _namespace(Path(code.__file__).read_text(encoding="utf-8"), words)
    names = _namespace(source, {**words, **codes})
    free = {
        **engine.walk.__globals__,
        "walks": SimpleNamespace(**names),
        "new": _plain,
        "array": lambda values, _type: list(map(int, values)),
    }
    walked = FunctionType(engine.walk.__code__, free, "walk")
    walked.__kwdefaults__ = engine.walk.__kwdefaults__

    def walk(*question: Any, **options: Any) -> Rows:
        try:
            return walked(*question, **options)  # type: ignore[no-any-return]  # as the kernel
        except (ArithmeticError, LookupError, ValueError):  # compiled it would go on, somewhere
            return Rows((), {}, (), (), ())

    return walk


def _namespace(source: str, words: dict[str, Any]) -> dict[str, Any]:
    """The names of a module of the kernel, whose imports from beside it are these words."""
    tree = ast.parse(source)
    beside = {"allworlds.engines.kernel.compiling", "allworlds.engines.kernel.code"}
    tree.body = [
        each
        for each in tree.body
        if not (isinstance(each, ast.ImportFrom) and each.module in beside)
    ]
    names = dict(words)
    exec(compile(tree, "kernel", "exec"), names)
    return names


def _neighbours(graph: Any, front: int) -> int:
    joined = 0
    while front:
        joined |= graph.adjacent[(front & -front).bit_length() - 1]
        front &= front - 1
    return joined


def _plain(kind: np.dtype[Any]) -> Any:
    """A record of the kind in plain Python, all zero; arrays of two dimensions stay arrays."""
    if kind.subdtype is not None:
        inner, shape = kind.subdtype
        if len(shape) == 2:
            return np.zeros(shape, np.int64)
        return [_plain(inner) for _ in range(shape[0])]
    if kind.names is None:
        return 0
    return SimpleNamespace(**{name: _plain(kind.fields[name][0]) for name in kind.names})


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
