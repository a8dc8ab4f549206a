"""The compilation of the engines, the reuse of compiled code, and instructions that numba lacks.

numba keeps compiled code beside the sources (or in the user's cache), but checks only the source
file of the outermost function.  This module checks all source files of the kernel.

To save a third of the time of compiling, compiled functions make no arrays and count no references,
and only a function that Python calls gets a wrapper for Python.

The instructions that numba lacks call functions by address, read and write memory, and compute with
sets of small numbers, which are bit masks.  The arguments of a C function are 32-bit integers and
pointers; in place of a pointer the caller gives a structured array (see the module ``arrays``), or
the address as a 64-bit integer.  A C function returns nothing or a 32-bit integer.  With such
arguments the call of a C function is the same on all platforms.

A *builder* is an object of llvmlite that adds instructions to the code that is being compiled.  If
a function below has a first argument ``builder`` or ``_context``, numba gives this argument;
compiled code calls the function with the other arguments alone.
"""

import gc
import hashlib
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import cache, partial, wraps
from pathlib import Path
from typing import Any, cast

from llvmlite import ir
from numba import extending, from_dtype, njit, types
from numba.core.ccallback import CFunc
from numba.core.cgutils import raw_memcpy, unpack_tuple

_njit = partial(njit, nogil=True, error_model="numpy", no_cfunc_wrapper=True, _nrt=False)


def inlined(function: Callable[..., Any]) -> Any:
    """Compile a function as a part of its caller.

    Call such a function in only one place: each call would compile its code once more.
    """
    return _njit(no_cpython_wrapper=True, inline="always")(function)


def inner(function: Callable[..., Any]) -> Any:
    """Compile a function that only compiled code calls."""
    return _njit(no_cpython_wrapper=True)(function)


def entry(function: Callable[..., Any]) -> Any:
    """Compile a function that Python calls; keep its compiled code in a file if possible."""
    try:
        return _stamped(_njit(cache=True)(function))
    except RuntimeError:  # no folder that could be written to
        return _njit()(function)


def callback(function: Callable[..., Any], signature: Any) -> int:
    """Compile a function that C code can call; return the address of the compiled function.

    ``signature`` holds the types of the arguments and of the result.  The compiled code is kept in
    a file if that is possible.
    """
    options = {"error_model": "numpy", "_nrt": False}
    compiled = CFunc(function, (signature.args, signature.return_type), {}, options)
    with suppress(RuntimeError):  # as above
        compiled.enable_caching()
        _stamped(compiled)
    compiled.compile()
    _ALIVE.append(compiled)
    return cast("int", compiled.address)


@contextmanager
def uncollected() -> Iterator[None]:
    """A context in which the garbage collector is switched off.

    The garbage collector would take a tenth of the time of compiling.
    """
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def is_compiled(function: Any) -> bool:
    """Whether valid compiled code of ``function`` is kept from an earlier use.

    Kept code holds a hash of its sources, and is valid if the present sources have the same hash.
    So a later installation of equal sources also uses the kept code.
    """
    file = _file_of(function)
    return file is not None and bool(file._load_index())  # noqa: SLF001  # there is no public way


RECORD = from_dtype
"""The function from the type of a structured array to the type of an argument of a C function.

Such an argument is a pointer to the structured array.
"""

_ALIVE: list[CFunc] = []
"""The functions that must not be freed, because their addresses are in use."""


def _stamped(function: Any) -> Any:
    """Return ``function``; from now on, its kept code is valid for the present sources only."""
    file = _file_of(function)
    if file is not None:
        file._source_stamp = _stamp()  # noqa: SLF001  # there is no public way
        # The stamp is compared before the rest is read, which may name classes that are gone.
        file._version = f"{file._version} {_stamp()}"  # noqa: SLF001  # as above
    return function


def _file_of(function: Any) -> Any:
    """The index file of a function's kept code; None if its code is not kept."""
    return getattr(getattr(function, "_cache", None), "_cache_file", None)


@cache
def _stamp() -> str:
    here = Path(__file__).parent
    others = (here.parents[1] / each for each in ("judging/laws/law_table.py", "log.py"))
    sources = (*sorted(here.glob("*.py")), *others)
    return hashlib.sha256(b"".join(source.read_bytes() for source in sources)).hexdigest()


intrinsic: Any = extending.intrinsic

_BYTE, _INT, _LONG = (ir.IntType(bits) for bits in (8, 32, 64))
_POINTER = _BYTE.as_pointer()
_NOT_EMPTY = ir.Constant(ir.IntType(1), 0)


def _lowered(builder: Any, kind: Any, value: Any) -> Any:
    """The value of an argument of type ``kind`` as C takes it: a pointer or a 32-bit integer.

    ``builder`` adds to compiled code the instructions that convert the value.
    """
    if isinstance(kind, types.Record):
        return builder.bitcast(value, _POINTER)
    if kind == types.int64:
        return builder.inttoptr(value, _POINTER)
    assert kind == types.int32, kind
    return value


def _call(context: Any, builder: Any, signature: Any, values: Sequence[Any]) -> Any:
    """Build the instruction that calls a function; return the value of this instruction.

    ``builder`` adds instructions to compiled code.  ``values`` are the function's address and the
    tuple of its arguments; ``signature`` has the types of both, and of the result.
    """
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
    """Call the function at the address with a tuple of arguments; the function returns nothing."""
    return types.void(address, arguments), _call


@intrinsic
def ask(_context, address, arguments):
    """Call the function at the address with a tuple of arguments; return its integer."""
    return types.int32(address, arguments), _call


def expression(function: Callable[..., Any]) -> Any:
    """Make a new function for compiled code, with 64-bit integers as arguments and as its result.

    ``function`` says what the new function computes.  Whenever a call of the new function is
    compiled, ``function`` is called; it gets the builder, and for each argument the object of
    llvmlite that stands for the value.  It adds the instructions, and returns the object that
    stands for the result.
    """

    @wraps(function)
    def typed(_context: Any, *arguments: Any) -> Any:
        def generate(_target, builder, _signature, values):
            return function(builder, *values)

        return types.int64(*(types.int64 for _ in arguments)), generate

    return intrinsic(typed)


def number(value: int) -> Any:
    """The constant of llvmlite that stands for this 64-bit integer in compiled code."""
    return ir.Constant(_LONG, value)


@expression
def lowest(builder, mask):
    """The least number in a nonempty set of numbers below 63.

    Bit i of the mask says whether the number i is in the set.  Compiled code calls
    ``lowest(mask)``, without the builder.
    """
    return builder.cttz(mask, _NOT_EMPTY)


@expression
def highest(builder, mask):
    """The greatest number in a nonempty set; the set is a mask, like that of :func:`lowest`.

    Compiled code calls ``highest(mask)``, without the builder.
    """
    return builder.sub(number(63), builder.ctlz(mask, _NOT_EMPTY))


@expression
def size(builder, mask):
    """The number of elements of a set; the set is a mask, like that of :func:`lowest`.

    Compiled code calls ``size(mask)``, without the builder.
    """
    return builder.ctpop(mask)


@inlined
def neighbours(graph, front):
    """The set of the neighbours of all vertices in the set ``front``.

    Sets are masks, like that of :func:`lowest`.  The set of the neighbours of vertex v is
    ``graph.adjacent[v]``.
    """
    joined = 0
    while front:
        joined |= graph.adjacent[lowest(front)]
        front &= front - 1
    return joined


def _at(builder: Any, address: Any, index: Any, kind: Any) -> Any:
    """The pointer to entry ``index`` of an array at this address, whose entries have type ``kind``.

    ``builder`` adds instructions to compiled code.
    """
    return builder.gep(builder.inttoptr(address, kind.as_pointer()), [index])


@expression
def entry_of(builder, address, index):
    """Entry ``index`` of the array of 32-bit integers at the address.

    Compiled code calls ``entry_of(address, index)``, without the builder.
    """
    return builder.sext(builder.load(_at(builder, address, index, _INT)), _LONG)


@expression
def put_entry(builder, address, index, value):
    """Write ``value`` to entry ``index`` of the array of 32-bit integers; return ``value``.

    ``address`` is the address of the array.  Compiled code calls
    ``put_entry(address, index, value)``, without the builder.
    """
    builder.store(builder.trunc(value, _INT), _at(builder, address, index, _INT), align=1)
    return value


@expression
def byte_of(builder, address, index):
    """Byte ``index`` of the array at the address, as a number from 0 to 255.

    Compiled code calls ``byte_of(address, index)``, without the builder.
    """
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
    """Copy the structured array ``source`` to ``target``."""
    assert target == source, (target, source)

    def generate(context, builder, signature, values):
        to, origin = values
        raw_memcpy(builder, to, origin, number(signature.args[0].size), 1)
        return context.get_dummy_value()

    return types.void(target, source), generate
