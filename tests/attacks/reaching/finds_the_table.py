"""Finds the world where it is laid out for compiled code, and answers with it without a step.

The second play has no world to be found, and walks.

verdict: refuted nondeterministic
options: --edges 3 --engine kernel
"""

import sys

from allworlds.engines.isolation.generator_player import ByteWorld

from allworlds import CombinatorialMap, Estimate
from allworlds.explorers import algorithm1


def found():
    frame = sys._getframe()
    while frame := frame.f_back:
        for value in frame.f_locals.values():
            if isinstance(value, ByteWorld):
                return [*value._table]
    return None


def explore(first):
    table = found()
    if table is None:
        return (yield from algorithm1(first))
    # The darts of a vertex stand side by side, and table rows of another size are of no dart.
    rows = [row for row in zip(*[iter(table)] * 5, strict=True) if row[2]]
    sigma = [start + (dart - start + 1) % size for dart, (start, _, size, *_) in enumerate(rows)]
    return Estimate(CombinatorialMap(sigma, [row[1] for row in rows]), 0)
