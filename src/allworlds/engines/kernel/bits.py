"""Sets of numbers below 63 as bit masks."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic, overload


def lowest(mask: int) -> int:
    """The least element of a set that is not empty."""
    return int(mask & -mask).bit_length() - 1


def highest(mask: int) -> int:
    """The greatest element of a set that is not empty."""
    return int(mask).bit_length() - 1


def size(mask: int) -> int:
    """The number of elements."""
    return int(mask).bit_count()


def _unary(instruction: str) -> Any:
    """One machine instruction on an integer of 64 bits."""

    @intrinsic
    def single(_context, _mask):
        def generate(_context, builder, _signature, arguments):
            (value,) = arguments
            if instruction == "ctpop":
                return builder.ctpop(value)
            return getattr(builder, instruction)(value, ir.Constant(ir.IntType(1), 0))

        return types.int64(types.int64), generate

    return single


_trailing = _unary("cttz")
_leading = _unary("ctlz")
_population = _unary("ctpop")


@overload(lowest, inline="always")
def _lowest(mask):
    return lambda mask: _trailing(mask)  # noqa: PLW0108  # numba compiles its source


@overload(highest, inline="always")
def _highest(mask):
    return lambda mask: 63 - _leading(mask)


@overload(size, inline="always")
def _size(mask):
    return lambda mask: _population(mask)  # noqa: PLW0108  # as above
