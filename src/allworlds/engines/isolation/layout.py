"""Layouts of memory that are drawn for each process.

The system draws the pages of an interpreter, but not the places within a page: two interpreters
that do the same have the same objects there, in the same order.  Forks of one process have all
addresses in common.  So each interpreter begins with a drawn number of objects of each size, some
of which leave their places to later ones in a drawn order.  A player does that again before it
loads the explorer, and moves its heap, its libraries and its stack by drawn distances.

As a script, this module is the start of a guardian: nothing of this package is loaded before it.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable

POOLED, POOLS = range(16, 513, 16), 1 << 15
"""The sizes of objects that Python puts into pools, and a bound on the drawn number of bytes.

Source: ``Objects/obmalloc.c`` of CPython."""

LARGE, FEW = (600, 1000, 2000, 4000, 8000), 16
"""Some sizes of objects that the C library places, and the number below which theirs is drawn."""

APART = 1 << 26
"""The bytes below which the distances of heap and libraries are drawn; bits 12 to 25 of addresses
follow."""

DEEPER = 1 << 21
"""The bytes below which the size of an argument is drawn that lies on the stack, twice."""

BLOCKS = (*(1 << n for n in range(16, 10, -1)), *range(1024, 0, -16))
"""The sizes of the blocks that fill the gaps of the heap: the C library has a list of free blocks
for each multiple of 16 bytes."""

HOLES = tuple(1 << n for n in range(25, 11, -1))
"""The sizes of the maps that fill the gaps between libraries."""

MOST = 1 << 12
"""The largest number of gaps of one size that are filled."""

_kept: list[list[object]] = []


def scatter_objects() -> None:
    """Let chance decide where later objects are within their pages, and in which order."""
    for size in POOLED:
        _leave_places([_object(size) for _ in range(_drawn(POOLS // size))])
    for size in LARGE:
        _leave_places([_object(size) for _ in range(_drawn(FEW))])


def _object(size: int) -> object:
    """A new object of that many bytes, or a few less."""
    if size < 32:
        return object()
    return 10**9 + _drawn(10**6) if size < 48 else bytes(size - sys.getsizeof(b""))


def _leave_places(objects: list[object]) -> None:
    """Keep half of these objects; drop the others, in a drawn order."""
    noise = os.urandom(4 * len(objects))
    for i in sorted(range(len(objects)), key=lambda i: noise[4 * i : 4 * i + 4])[::2]:
        objects[i] = None
    _kept.append(objects)


def _drawn(below: int) -> int:
    return int.from_bytes(os.urandom(8)) % below


def scatter_memory() -> None:
    """Move the heap, and the libraries that are loaded later, by drawn distances."""
    if sys.platform == "linux":
        import ctypes

        word, number = ctypes.c_size_t, ctypes.c_int
        _move_libraries(_of_libc("mmap", word, word, number, number, number, ctypes.c_long))
        _move_heap(_of_libc("sbrk", ctypes.c_long), _of_libc("malloc", word))


def _of_libc(name: str, *takes: type) -> Callable[..., int]:
    """A function of the C library that returns an address."""
    import ctypes

    function = getattr(ctypes.CDLL(None), name)
    function.argtypes, function.restype = takes, ctypes.c_size_t
    made: Callable[..., int] = function
    return made


def _move_libraries(mmap: Callable[..., int]) -> None:
    import mmap as flags

    def mapped(size: int) -> int:
        # No access, and no memory behind it.
        return mmap(0, size, 0, flags.MAP_PRIVATE | flags.MAP_ANONYMOUS, -1, 0)

    below = mapped(APART + _drawn(APART))
    _fill_gaps(HOLES, lambda size: mapped(size) > below)


def _move_heap(sbrk: Callable[[int], int], malloc: Callable[[int], int]) -> None:
    end = sbrk(_drawn(APART) & ~15)
    _fill_gaps(BLOCKS, lambda size: 0 < malloc(size) < end)


def _fill_gaps(sizes: Iterable[int], is_filled: Callable[[int], bool]) -> None:
    """Fill the gaps of each size, as long as there are any."""
    for size in sizes:
        for _ in range(MOST):
            if not is_filled(size):
                break


def run_deeper(run: Callable[[], None]) -> None:
    """Call a function with a stack that begins at a drawn distance, and is as large as before."""
    if sys.platform != "linux":
        run()
        return
    import ctypes
    import resource

    size = _drawn(DEEPER) + 1
    soft, hard = resource.getrlimit(resource.RLIMIT_STACK)
    if soft != resource.RLIM_INFINITY:
        wanted = soft + 2 * size
        if hard != resource.RLIM_INFINITY and wanted > hard:
            run()
            return
        resource.setrlimit(resource.RLIMIT_STACK, (wanted, hard))

    class Filling(ctypes.Structure):
        _fields_ = (("bytes", ctypes.c_byte * size),)

    raised: list[BaseException] = []

    def guarded() -> None:
        try:
            run()
        except BaseException as error:  # noqa: BLE001  # it is raised below
            raised.append(error)

    callback = ctypes.CFUNCTYPE(None)(guarded)
    address = ctypes.cast(callback, ctypes.c_void_p).value
    assert address is not None
    # An argument by value lies on the stack between the caller and the function.
    ctypes.CFUNCTYPE(None, Filling)(address)(Filling())
    for error in raised:
        raise error


def _begin() -> None:
    """Be a guardian, with the import path, the descriptor and the kind of the command line."""
    scatter_objects()
    import json

    sys.path[:] = json.loads(sys.argv[1])
    from allworlds.engines.isolation.roles import guard

    guard(int(sys.argv[2]), sys.argv[3])


if __name__ == "__main__":
    _begin()
