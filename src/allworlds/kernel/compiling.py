"""How the engines are compiled, and when what was compiled once is used again.

numba keeps what it has compiled beside the sources (or in the user's cache), but asks only the
source file of the outermost function whether it is still good.  Here every source of this
package is asked: what a function has taken in from other files must not be older than they are.

No compiled function makes an array or counts references, and only those that Python calls are
wrapped for Python: that saves a third of the time of compiling.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from numba import from_dtype, njit
from numba.core.ccallback import CFunc

_OPTIONS: dict[str, Any] = {
    "nogil": True,
    "error_model": "numpy",
    "no_cfunc_wrapper": True,
    "_nrt": False,
}


def inlined(function: Callable[..., Any]) -> Any:
    """As inner, for one that is called from one place: it becomes a part of its caller."""
    return njit(**_OPTIONS, no_cpython_wrapper=True, inline="always")(function)


def inner(function: Callable[..., Any]) -> Any:
    """A function that only compiled code calls."""
    return njit(**_OPTIONS, no_cpython_wrapper=True)(function)


def entry(function: Callable[..., Any]) -> Any:
    """A function that Python calls; what it compiles to is kept, where there is room for it."""
    try:
        return _stamped(njit(**_OPTIONS, cache=True)(function))
    except RuntimeError:  # no folder that could be written to
        return njit(**_OPTIONS)(function)


def callback(function: Callable[..., Any], signature: Any) -> int:
    """The address of a C function; what it compiles to is kept, where there is room for it."""
    options = {"error_model": "numpy", "_nrt": False}
    compiled = CFunc(function, (signature.args, signature.return_type), {}, options)
    try:
        compiled.enable_caching()
        _stamped(compiled)
    except RuntimeError:  # as above
        pass
    compiled.compile()
    _ALIVE.append(compiled)
    return int(compiled.address)


RECORD = from_dtype
"""The type of a C function's argument that points to a record."""

_ALIVE: list[CFunc] = []
"""What has an address must stay."""


def _stamped(function: Any) -> Any:
    """The function; what is kept of it is good as long as this package is as it is now."""
    file = getattr(getattr(function, "_cache", None), "_cache_file", None)
    if file is not None:
        file._source_stamp = _stamp()  # noqa: SLF001  # there is no public way
    return function


@cache
def _stamp() -> str:
    digest = hashlib.sha256()
    for source in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(source.read_bytes())
    return digest.hexdigest()
