"""The notations of embedded graphs that files are read in and written in."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import IO, Literal, TypeAlias

from msgspec import Struct

from allworlds.notations.entry import Entry

Order: TypeAlias = Literal["clockwise", "anticlockwise"]
"""In which order a file lists the edges round a vertex."""

YAxis: TypeAlias = Literal["up", "down"]
"""Where the second coordinate of a position grows."""


class Notation(Struct, frozen=True):
    """One notation.

    Attributes:
        name: as ``-o NAME:FILE`` takes it.
        suffixes: of files in it.
        begins: the first bytes of such a file, where it has some.
        read: the entries of an open binary file from its position on, each with the offset at which
            it begins; a file that holds one entry alone yields one.
        write: the bytes of these entries; None where it is not written.
        positions: whether the order follows from positions, so that the y axis matters.
        y: the usual direction of its y axis.
    """

    name: str
    suffixes: tuple[str, ...]
    read: Callable[[IO[bytes], Order, YAxis], Iterator[tuple[int, Entry]]]
    write: Callable[[Iterable[Entry]], Iterator[bytes]] | None = None
    begins: bytes = b""
    positions: bool = False
    y: YAxis = "up"


def entries(
    file: str | Path, order: Order = "clockwise", y: YAxis | None = None
) -> Iterator[tuple[int, Entry]]:
    """Every world of a file in any notation, with the offset in bytes at which it begins.

    Raises:
        InputError: naming the file, the place in it and what would be legal.

    Cost: the memory of one entry at a time, where the notation holds many.
    """
    raise NotImplementedError


def entry_at(
    file: str | Path, offset: int, order: Order = "clockwise", y: YAxis | None = None
) -> Entry:
    """The world of a file at an offset that :func:`entries` has told."""
    raise NotImplementedError


def entry_named(
    file: str | Path, name: str, order: Order = "clockwise", y: YAxis | None = None
) -> Entry:
    """The world of that name in the file, or of that number, from 1 on; the only one for ``""``."""
    raise NotImplementedError
