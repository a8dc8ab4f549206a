"""Instructions for compiled code: calls by address, bytes in memory, sets as bit masks.

The arguments of a C function are pointers (a record, or an address as an integer) and 32-bit
integers, and nothing or a 32-bit integer is returned: that is called alike on every platform.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import wraps
from typing import Any

from llvmlite import ir
from numba import extending, types
from numba.core.cgutils import raw_memcpy, unpack_tuple

from allworlds.engines.kernel.compiling import inlined

intrinsic: Any = extending.intrinsic

_BYTE, _INT, _LONG = (ir.IntType(bits) for bits in (8, 32, 64))
_POINTER = _BYTE.as_pointer()
_NOT_EMPTY = ir.Constant(ir.IntType(1), 0)


def _lowered(builder: Any, kind: Any, value: Any) -> Any:
    """The value in the form that C takes."""
    if isinstance(kind, types.Record):
        return builder.bitcast(value, _POINTER)
    if kind == types.int64:
        return builder.inttoptr(value, _POINTER)
    assert kind == types.int32, kind
    return value


def _call(context: Any, builder: Any, signature: Any, values: Sequence[Any]) -> Any:
    """The code of a call of the address that is the first value, with the tuple behind it."""
    address, arguments = values
    lowered = [
        _lowered(builder, kind, value)
        for kind, value in zip(signature.args[1], unpack_tuple(builder, arguments), strict=True)
    ]
    answers = signature.return_type == types.int32
    shape = ir.FunctionType(_INT if answers else ir.VoidType(), [value.type for value in lowered])
    answer = builder.call(builder.inttoptr(address, shape.as_pointer()), lowered)
    return answer if answers else context.get_dummy_value()


@intrinsic
def call(_context, address, arguments):
    """Call the function at the address with a tuple of arguments; it returns nothing."""
    return types.void(address, arguments), _call


@intrinsic
def ask(_context, address, arguments):
    """Call the function at the address with a tuple of arguments; return its 32-bit integer."""
    return types.int32(address, arguments), _call


def expression(function: Callable[..., Any]) -> Any:
    """Make a function of 64-bit integers of the builder of its instructions."""

    @wraps(function)
    def typed(_context: Any, *arguments: Any) -> Any:
        def generate(_target, builder, _signature, values):
            return function(builder, *values)

        return types.int64(*(types.int64 for _ in arguments)), generate

    return intrinsic(typed)


def number(value: int) -> Any:
    """The constant."""
    return ir.Constant(_LONG, value)


@expression
def lowest(builder, mask):
    """The least element of a set of numbers below 63 that is not empty."""
    return builder.cttz(mask, _NOT_EMPTY)


@expression
def highest(builder, mask):
    """The greatest element of a set that is not empty."""
    return builder.sub(number(63), builder.ctlz(mask, _NOT_EMPTY))


@expression
def size(builder, mask):
    """The number of elements."""
    return builder.ctpop(mask)


@inlined
def neighbours(graph, front):
    """The vertices that are joined in ``graph.adjacent`` to one of the front, as a set."""
    joined = 0
    while front:
        joined |= graph.adjacent[lowest(front)]
        front &= front - 1
    return joined


def _at(builder: Any, address: Any, index: Any, kind: Any) -> Any:
    """The pointer to the number of that kind with this index, from the address on."""
    return builder.gep(builder.inttoptr(address, kind.as_pointer()), [index])


@expression
def entry_of(builder, address, index):
    """The 32-bit integer number ``index`` of the array at the address."""
    return builder.sext(builder.load(_at(builder, address, index, _INT)), _LONG)


@expression
def put_entry(builder, address, index, value):
    """Write the 32-bit integer number ``index`` from the address on; return it."""
    builder.store(builder.trunc(value, _INT), _at(builder, address, index, _INT), align=1)
    return value


@expression
def byte_of(builder, address, index):
    """The byte number ``index`` from the address on."""
    return builder.zext(builder.load(_at(builder, address, index, _BYTE)), _LONG)


@intrinsic
def address_of(_context, array):
    """The address of an array."""

    def generate(target, builder, signature, values):
        made = target.make_array(signature.args[0])(target, builder, values[0])
        return builder.ptrtoint(made.data, _LONG)

    return types.int64(array), generate


@intrinsic
def copy(_context, target, source):
    """Copy the source record to the target."""
    assert target == source, (target, source)

    def generate(context, builder, signature, values):
        to, origin = values
        raw_memcpy(builder, to, origin, number(signature.args[0].size), 1)
        return context.get_dummy_value()

    return types.void(target, source), generate
