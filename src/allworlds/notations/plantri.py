"""The two binary codes of plantri, which list neighbours or edges clockwise round each vertex.

A file may begin with a header, such as ``>>planar_code<<``; then the worlds follow, one by one.

In ``planar_code`` a world is the number of its vertices, and then for each vertex the neighbours,
counted from 1, and a 0.  Each number is one byte.  If the first byte of a world is 0, each number
after this byte has two bytes; the header tells whether the lower byte comes first (``le``, the
default) or the higher byte (``be``).  The code cannot express loops and parallel edges.

In ``edge_code`` the *body* of a world holds for each vertex the numbers of its edges, with a byte
255 between two vertices.  The length of the body, in bytes, stands before the body.  Usually the
length is one byte, and each number of an edge is one byte.  If a world begins with a byte 0, these
numbers are longer: in the next byte the higher four bits tell how many bytes the length has, the
lower four bits how many bytes the number of an edge has.  Then the length and the body follow.  In
longer numbers the higher byte comes first.

Source: the guide of plantri, and its program; the headers are also those of CaGe.
"""

from collections.abc import Iterator
from typing import IO, Literal

from allworlds.inputs.checks import InputError
from allworlds.maps.build import from_cycles
from allworlds.notations.entry import at, neighbours
from allworlds.world.world import Entry

PLANAR, EDGE = b">>planar_code", b">>edge_code"
MOST = 255
"""The largest number of vertices, edges or bytes for which numbers have one byte.  In ``edge_code``
a byte of this value separates two vertices."""


def _begun(file: IO[bytes], code: bytes) -> bytes:
    """The word in the header of a file, ``b" le"`` or ``b" be"``; empty without a word or a header.

    The header stands at the beginning of the file, but reading may begin at a later world.  So this
    function reads the header from the beginning of the file, and then sets the file's position
    back.  If the position was before the end of the header, it is set to the end of the header.

    ``code`` is :data:`PLANAR` or :data:`EDGE`: the bytes with which the header begins.

    Raises:
        InputError: if the header has another word, or no end.
    """
    here = file.tell()
    file.seek(0)
    header = file.read(len(code) + 5)
    if not header.startswith(code):
        file.seek(here)
        return b""
    word, end, _ = header[len(code) :].partition(b"<<")
    if not end or word not in (b"", b" le", b" be"):
        raise InputError(f"the header is {header!r}; legal is {(code + b'<<')!r}")
    file.seek(max(here, len(code + word + end)))
    return word


def _number(file: IO[bytes], size: int, order: Literal["little", "big"] = "big") -> int:
    """The next number in the file, read from ``size`` bytes in the byte order ``order``."""
    read = file.read(size)
    if len(read) < size:
        raise InputError("the file ends in the middle of a world")
    return int.from_bytes(read, order)


def read_planar_code(file: IO[bytes]) -> Iterator[tuple[int, Entry]]:
    """Yield the worlds of a file in ``planar_code``, each with the offset of its first byte."""
    order: Literal["little", "big"] = "big" if _begun(file, PLANAR) == b" be" else "little"
    offset = file.tell()
    while first := file.read(1):
        with at(f"the world at byte {offset}"):
            size = 1 if first[0] else 2
            count = first[0] or _number(file, 2, order)
            edges = dict[int, dict[tuple[int, int], None]]()
            for vertex in range(1, count + 1):
                edges[vertex] = {}
                while end := _number(file, size, order):
                    edge = (min(vertex, end), max(vertex, end))
                    if edge in edges[vertex]:
                        rest = "edge_code tells loops and parallel edges"
                        raise InputError(f"vertex {vertex} lists {end} twice; {rest}")
                    edges[vertex][edge] = None
            entry = Entry(from_cycles({vertex: [*ends] for vertex, ends in edges.items()}))
        yield offset, entry
        offset = file.tell()


def write_planar_code(entry: Entry) -> bytes:
    """The bytes of a world in ``planar_code``; the names in the world are left out.

    Raises:
        InputError: if the map has loops, parallel edges or a genus above 0; the message names the
            vertex or the genus.
    """
    map_ = entry.map
    if map_.genus:
        raise InputError(f"planar_code tells maps of genus 0, not {map_.genus}; see edge_code")
    size = 1 if map_.vertex_count <= MOST else 2
    numbers = [map_.vertex_count]
    for ends in neighbours(entry):
        numbers += [*(end + 1 for end in ends), 0]
    return b"\0" * (size - 1) + b"".join(each.to_bytes(size, "little") for each in numbers)


def read_edge_code(file: IO[bytes]) -> Iterator[tuple[int, Entry]]:
    """Yield the worlds of a file in ``edge_code``, each with the offset of its first byte."""
    _begun(file, EDGE)
    offset = file.tell()
    while first := file.read(1):
        with at(f"the world at byte {offset}"):
            length, size = first[0], 1
            if not length:
                halves = _number(file, 1)
                size, length = halves & 15, _number(file, halves >> 4)
                if not size:
                    raise InputError("its numbers of edges have 0 bytes; 1 to 15 are legal")
            end = file.tell() + length
            vertices = [list[int]()]
            while file.tell() < end:
                if (byte := _number(file, 1)) == MOST:
                    vertices.append([])
                else:
                    vertices[-1].append(byte << 8 * (size - 1) | _number(file, size - 1))
            if file.tell() > end:
                raise InputError(f"{length} bytes are no list of numbers of {size} bytes")
            entry = Entry(from_cycles(vertices))
        yield offset, entry
        offset = file.tell()


def write_edge_code(entry: Entry) -> bytes:
    """The bytes of a world of any genus in ``edge_code``; the names in the world are left out."""
    map_ = entry.map
    edge = {dart: number for number, pair in enumerate(map_.edges) for dart in pair}
    size = 1 if map_.edge_count <= MOST else 2 if map_.edge_count <= MOST << 8 else 3
    lists = [b"".join(edge[d].to_bytes(size, "big") for d in ds) for ds in map_.vertices]
    body = b"\xff".join(lists)
    if len(body) <= MOST and size == 1:
        return bytes([len(body)]) + body
    digits = (len(body).bit_length() + 7) // 8
    return bytes([0, digits << 4 | size]) + len(body).to_bytes(digits, "big") + body
