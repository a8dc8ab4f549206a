"""Calls of an explorer's C functions by their addresses, from compiled code.

Arguments are pointers (a record, or an address as an integer) and 32-bit integers, and nothing or
a 32-bit integer is returned: that is called alike on every platform.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from llvmlite import ir
from numba import extending, types
from numba.core.cgutils import raw_memcpy

from allworlds.engines.kernel.names import LANES

intrinsic: Any = extending.intrinsic

_POINTER = ir.IntType(8).as_pointer()


def _lowered(builder: Any, kind: Any, value: Any) -> Any:
    """The value in the form that C takes."""
    if isinstance(kind, types.Record):
        return builder.bitcast(value, _POINTER)
    if kind == types.int64:
        return builder.inttoptr(value, _POINTER)
    assert kind == types.int32, kind
    return value


def _call(context: Any, builder: Any, signature: Any, values: Sequence[Any]) -> Any:
    """The code of a call of the address that is the first value."""
    address, *values = values
    lowered = [
        _lowered(builder, kind, value)
        for kind, value in zip(signature.args[1:], values, strict=True)
    ]
    shape = ir.FunctionType(ir.VoidType(), [value.type for value in lowered])
    builder.call(builder.inttoptr(address, shape.as_pointer()), lowered)
    return context.get_dummy_value()


def _ask(context: Any, builder: Any, signature: Any, values: Sequence[Any]) -> Any:
    """The code of a call that returns a 32-bit integer."""
    address, *values = values
    lowered = [
        _lowered(builder, kind, value)
        for kind, value in zip(signature.args[1:], values, strict=True)
    ]
    shape = ir.FunctionType(ir.IntType(32), [value.type for value in lowered])
    return builder.call(builder.inttoptr(address, shape.as_pointer()), lowered)


@intrinsic
def call_with(_context, address, record):
    """Call ``function(&record)``."""
    return types.void(address, record), _call


@intrinsic
def call_start(_context, address, state, percept, told, action):
    """Call ``start(state, &percept, told, &action)``."""
    return types.void(address, state, percept, told, action), _call


@intrinsic
def call_step(_context, address, state, percept, action):
    """Call ``step(state, &percept, &action)``."""
    return types.void(address, state, percept, action), _call


@intrinsic
def call_answer(_context, address, state, answer):
    """Call ``answer(state, &answer)``."""
    return types.void(address, state, answer), _call


@intrinsic
def call_choose(_context, address, state, pick, context):
    """Call ``choose(state, pick, context)``."""
    return types.void(address, state, pick, context), _call


@intrinsic
def ask_answer(_context, address, state, capacity, sigma, alpha, here):
    """Call ``answer(state, capacity, sigma, alpha, &here)``; return the number of darts."""
    return types.int32(address, state, capacity, sigma, alpha, here), _ask


@intrinsic
def entry_of(_context, address, index):
    """The 32-bit integer number ``index`` of the array at the address."""

    def generate(_target, builder, _signature, values):
        integer = ir.IntType(32)
        start = builder.inttoptr(values[0], integer.as_pointer())
        return builder.sext(builder.load(builder.gep(start, [values[1]])), ir.IntType(64))

    return types.int64(types.int64, types.int64), generate


@intrinsic
def byte_of(_context, address, index):
    """The byte number ``index`` from the address on."""

    def generate(_target, builder, _signature, values):
        start = builder.inttoptr(values[0], _POINTER)
        return builder.zext(builder.load(builder.gep(start, [values[1]])), ir.IntType(64))

    return types.int64(types.int64, types.int64), generate


@intrinsic
def put_entry(_context, address, index, value):
    """Write the 32-bit integer number ``index`` from the address on."""

    def generate(target, builder, _signature, values):
        integer = ir.IntType(32)
        start = builder.inttoptr(values[0], integer.as_pointer())
        entry = builder.trunc(values[2], integer)
        builder.store(entry, builder.gep(start, [values[1]]), align=1)
        return target.get_dummy_value()

    return types.void(types.int64, types.int64, types.int64), generate


@intrinsic
def address_of(_context, record_array):
    """The address of an array inside a record."""

    def generate(target, builder, signature, values):
        array = target.make_array(signature.args[0])(target, builder, values[0])
        return builder.ptrtoint(array.data, ir.IntType(64))

    return types.int64(record_array), generate


@intrinsic
def word_of(_context, address, index):
    """The eight bytes from ``index`` bytes behind the address on, as one integer."""

    def generate(_target, builder, _signature, values):
        start = builder.gep(builder.inttoptr(values[0], _POINTER), [values[1]])
        word = builder.bitcast(start, ir.IntType(64).as_pointer())
        return builder.load(word, align=1)

    return types.int64(types.int64, types.int64), generate


@intrinsic
def put_word(_context, address, value):
    """Write the value to the eight bytes at the address, the lowest first."""

    def generate(target, builder, _signature, values):
        start = builder.inttoptr(values[0], ir.IntType(64).as_pointer())
        builder.store(values[1], start, align=1)
        return target.get_dummy_value()

    return types.void(types.int64, types.int64), generate


_BYTES = ir.VectorType(ir.IntType(8), LANES)
_ENTRIES = ir.VectorType(ir.IntType(32), LANES)


@intrinsic
def narrow(_context, target, source, count):
    """Copy the first ``count`` of ``LANES`` 32-bit integers to bytes, and make the others 0.

    The returned value is not 0 if one of them is no byte.
    """

    def generate(_target, builder, _signature, values):
        to, origin, count = values
        entries = builder.load(builder.inttoptr(origin, _ENTRIES.as_pointer()), align=4)
        lanes = ir.IntType(LANES)
        one = ir.Constant(ir.IntType(64), 1)
        all_ = builder.icmp_signed(">=", count, ir.Constant(ir.IntType(64), LANES))
        some = builder.sub(builder.shl(one, count), one)
        asked = builder.select(all_, ir.Constant(ir.IntType(64), -1), some)
        among = builder.bitcast(builder.trunc(asked, lanes), ir.VectorType(ir.IntType(1), LANES))
        wanted = builder.select(among, entries, ir.Constant(_ENTRIES, [0] * LANES))
        builder.store(
            builder.trunc(wanted, _BYTES), builder.inttoptr(to, _BYTES.as_pointer()), align=1
        )
        odd = builder.icmp_unsigned(">", wanted, ir.Constant(_ENTRIES, [255] * LANES))
        return builder.zext(builder.bitcast(odd, lanes), ir.IntType(64))

    return types.int64(types.int64, types.int64, types.int64), generate


@intrinsic
def widen(_context, target, source):
    """Copy ``LANES`` bytes to as many 32-bit integers."""

    def generate(context, builder, _signature, values):
        to, origin = values
        bytes_ = builder.load(builder.inttoptr(origin, _BYTES.as_pointer()), align=1)
        builder.store(
            builder.zext(bytes_, _ENTRIES), builder.inttoptr(to, _ENTRIES.as_pointer()), align=4
        )
        return context.get_dummy_value()

    return types.void(types.int64, types.int64), generate


WIDE_LANES = 32
"""The number of bytes that are compared, or copied, at a time."""

_WIDE = ir.VectorType(ir.IntType(8), WIDE_LANES)


def _wide(builder: Any, address: Any) -> Any:
    """The vector of bytes at the address."""
    return builder.load(builder.inttoptr(address, _WIDE.as_pointer()), align=1)


def _where_unlike(builder: Any, one: Any, other: Any) -> Any:
    """The places where the two vectors differ, as a set."""
    differ = builder.icmp_unsigned("!=", one, other)
    return builder.zext(builder.bitcast(differ, ir.IntType(WIDE_LANES)), ir.IntType(64))


@intrinsic
def unlike(_context, one, other):
    """The places of the bytes that differ at the two addresses, as a set."""

    def generate(_target, builder, _signature, values):
        return _where_unlike(builder, *(_wide(builder, value) for value in values))

    return types.int64(types.int64, types.int64), generate


@intrinsic
def moved(_context, address):
    """The places of the bytes at the address that differ from their own number, as a set."""

    def generate(_target, builder, _signature, values):
        places = ir.Constant(_WIDE, list(range(WIDE_LANES)))
        return _where_unlike(builder, _wide(builder, values[0]), places)

    return types.int64(types.int64), generate


@intrinsic
def copy_bytes(_context, target, source):
    """Copy ``WIDE_LANES`` bytes."""

    def generate(context, builder, _signature, values):
        to = builder.inttoptr(values[0], _WIDE.as_pointer())
        builder.store(_wide(builder, values[1]), to, align=1)
        return context.get_dummy_value()

    return types.void(types.int64, types.int64), generate


@intrinsic
def copy(_context, target, source):
    """Copy the source record to the target."""
    assert target == source, (target, source)

    def generate(context, builder, signature, values):
        size = ir.Constant(ir.IntType(64), signature.args[0].size)
        raw_memcpy(builder, values[0], values[1], size, 1)
        return context.get_dummy_value()

    return types.void(target, source), generate
