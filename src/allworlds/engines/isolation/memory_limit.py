"""The address space of this process, and a bound on it."""

from __future__ import annotations

import mmap
import sys
from contextlib import suppress
from pathlib import Path

from allworlds.inputs import InputError


def address_space() -> int:
    """MB of address space of this process; 0 if unknown."""
    with suppress(OSError):
        pages = int(Path("/proc/self/statm").read_text().split()[0])
        return pages * mmap.PAGESIZE >> 20
    return 0


def limit_memory(megabytes: int) -> None:
    """Bound the address space of this process.

    Raises:
        InputError: if it is larger already; the limit would then act only on further growth.
    """
    import resource

    _, most = resource.getrlimit(resource.RLIMIT_AS)
    size = min(megabytes << 20, sys.maxsize if most == resource.RLIM_INFINITY else most)
    # With such a limit the process would come to its end when its stack grows.
    too_small = size < address_space() << 20
    if not too_small:
        resource.setrlimit(resource.RLIMIT_AS, (size, size))
        try:
            mmap.mmap(-1, mmap.PAGESIZE).close()
        except OSError:
            too_small = True
    if too_small:
        raise InputError(
            f"memory {megabytes} MB is probably too small: a process is larger before it begins"
        )
