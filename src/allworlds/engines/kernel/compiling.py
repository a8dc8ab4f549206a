"""The compilation of the engines, the reuse of earlier compilations, and instructions.

numba keeps compiled code beside the sources (or in the user's cache), but checks only the source
file of the outermost function.  This module checks all source files of the kernel.

No compiled function makes an array or counts references, and only functions that Python calls are
wrapped for Python, which saves a third of the time of compiling.

The instructions are calls by address, bytes in memory, and sets as bit masks.  The arguments of a C
function are pointers (to a structured array, or an address as an integer) and 32-bit integers; it
returns nothing or a 32-bit integer.  Such a function is called in the same way on every platform.
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
    """A function that is called from one place only; it is compiled into its caller."""
    return _njit(no_cpython_wrapper=True, inline="always")(function)


def inner(function: Callable[..., Any]) -> Any:
    """A function that only compiled code calls."""
    return _njit(no_cpython_wrapper=True)(function)


def entry(function: Callable[..., Any]) -> Any:
    """A function that Python calls; its compiled code is kept if that is possible."""
    try:
        return _stamped(_njit(cache=True)(function))
    except RuntimeError:  # no folder that could be written to
        return _njit()(function)


def callback(function: Callable[..., Any], signature: Any) -> int:
    """A C function with an address; its compiled code is kept if that is possible."""
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
    """Switch off the garbage collector, which would take a tenth of the time of compiling."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def is_compiled(function: Any) -> bool:
    """Whether valid compiled code of ``function`` is kept from an earlier use.

    The stamp of the kept code is checked, not its age, so that a later installation of equal
    sources uses it, too.
    """
    file = _file_of(function)
    return file is not None and bool(file._load_index())  # noqa: SLF001  # there is no public way


RECORD = from_dtype
"""The type of a C function's argument that points to a structured array."""

_ALIVE: list[CFunc] = []
"""The functions whose addresses are in use, and which must not be freed."""


def _stamped(function: Any) -> Any:
    """The function; its kept code is valid until a source file of this package changes."""
    file = _file_of(function)
    if file is not None:
        file._source_stamp = _stamp()  # noqa: SLF001  # there is no public way
        # The stamp is compared before the rest is read, which may name classes that are gone.
        file._version = f"{file._version} {_stamp()}"  # noqa: SLF001  # as above
    return function


def _file_of(function: Any) -> Any:
    """The index file of a function's kept code; None if there is none."""
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
    """The value in the form in which C takes it."""
    if isinstance(kind, types.Record):
        return builder.bitcast(value, _POINTER)
    if kind == types.int64:
        return builder.inttoptr(value, _POINTER)
    assert kind == types.int32, kind
    return value


def _call(context: Any, builder: Any, signature: Any, values: Sequence[Any]) -> Any:
    """The code of a call of the address in the first value, with the tuple in the second."""
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
    """Make a function of 64-bit integers from the function that builds its instructions."""

    @wraps(function)
    def typed(_context: Any, *arguments: Any) -> Any:
        def generate(_target, builder, _signature, values):
            return function(builder, *values)

        return types.int64(*(types.int64 for _ in arguments)), generate

    return intrinsic(typed)


def number(value: int) -> Any:
    """The value as a constant in compiled code."""
    return ir.Constant(_LONG, value)


@expression
def lowest(builder, mask):
    """The least element of a nonempty set of numbers below 63."""
    return builder.cttz(mask, _NOT_EMPTY)


@expression
def highest(builder, mask):
    """The greatest element of a nonempty set."""
    return builder.sub(number(63), builder.ctlz(mask, _NOT_EMPTY))


@expression
def size(builder, mask):
    """The number of elements."""
    return builder.ctpop(mask)


@inlined
def neighbours(graph, front):
    """The set of vertices that are joined to the set ``front`` by ``graph.adjacent``."""
    joined = 0
    while front:
        joined |= graph.adjacent[lowest(front)]
        front &= front - 1
    return joined


def _at(builder: Any, address: Any, index: Any, kind: Any) -> Any:
    """The pointer to entry ``index`` of an array of this kind at the address."""
    return builder.gep(builder.inttoptr(address, kind.as_pointer()), [index])


@expression
def entry_of(builder, address, index):
    """Entry ``index`` of the array of 32-bit integers at the address."""
    return builder.sext(builder.load(_at(builder, address, index, _INT)), _LONG)


@expression
def put_entry(builder, address, index, value):
    """Write entry ``index`` of the array of 32-bit integers at the address; return it."""
    builder.store(builder.trunc(value, _INT), _at(builder, address, index, _INT), align=1)
    return value


@expression
def byte_of(builder, address, index):
    """Byte ``index`` of the array at the address."""
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
