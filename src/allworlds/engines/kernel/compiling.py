"""The compilation of the engines, and the reuse of earlier compilations.

numba keeps compiled code beside the sources (or in the user's cache), but checks only the source
file of the outermost function.  Here every source is checked from which something is compiled in.

No compiled function makes an array or counts references, and only those that Python calls are
wrapped for Python: that saves a third of the time of compiling.
"""

from __future__ import annotations

import gc
import hashlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cache, partial
from pathlib import Path
from typing import Any, cast

from numba import from_dtype, njit
from numba.core.ccallback import CFunc

_njit = partial(njit, nogil=True, error_model="numpy", no_cfunc_wrapper=True, _nrt=False)


def inlined(function: Callable[..., Any]) -> Any:
    """A function that is called from one place: it becomes a part of its caller."""
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
    """Switch the garbage collector off: it would take a tenth of the time of compiling."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def is_compiled(function: Any) -> bool:
    """Whether compiled code of ``function`` is kept from an earlier use, and still valid.

    The stamp of the kept code is checked, not its age: a later installation of equal sources uses
    it, too.
    """
    file = _file_of(function)
    return file is not None and bool(file._load_index())  # noqa: SLF001  # there is no public way


RECORD = from_dtype
"""The type of a C function's argument that points to a record."""

_ALIVE: list[CFunc] = []
"""The functions with addresses, which must not be freed."""


def _stamped(function: Any) -> Any:
    """The function; its kept code is valid as long as no source of this package changes."""
    file = _file_of(function)
    if file is not None:
        file._source_stamp = _stamp()  # noqa: SLF001  # there is no public way
        # It is compared before the rest is read, which may name classes that are gone.
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
