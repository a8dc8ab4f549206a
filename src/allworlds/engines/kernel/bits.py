"""Sets of numbers below 63 as bit masks, in compiled code."""

from __future__ import annotations

from llvmlite import ir

from allworlds.engines.kernel.calls import expression, number

_NOT_EMPTY = ir.Constant(ir.IntType(1), 0)


@expression
def lowest(builder, mask):
    """The least element of a set that is not empty."""
    return builder.cttz(mask, _NOT_EMPTY)


@expression
def highest(builder, mask):
    """The greatest element of a set that is not empty."""
    return builder.sub(number(63), builder.ctlz(mask, _NOT_EMPTY))


@expression
def size(builder, mask):
    """The number of elements."""
    return builder.ctpop(mask)
