"""Functions that the readers and writers of notations share.

They decode a file's bytes, tell in error messages where in the file the error is, and list the
neighbours of each vertex.
"""

from collections.abc import Iterator
from contextlib import contextmanager

from allworlds.inputs.checks import InputError
from allworlds.maps.combinatorial import Vertex
from allworlds.world.world import Entry


@contextmanager
def at(where: str) -> Iterator[None]:
    """A context in which the message of every :class:`InputError` begins with ``where``.

    ``where`` says where in the file the error is, such as ``line 3``.
    """
    try:
        yield
    except InputError as error:
        raise type(error)(f"{where}: {error}") from None


def text_of(content: bytes) -> str:
    """The text of the bytes ``content`` of a file.

    Raises:
        InputError: naming the first byte that is not UTF-8.
    """
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(f"byte {error.start} is no text in UTF-8") from None


def neighbours(entry: Entry) -> list[list[Vertex]]:
    """For each vertex its neighbours, clockwise, for a notation that can express only simple maps.

    Raises:
        InputError: naming the first vertex with a loop or parallel edges.
    """
    at_, alpha = entry.map.vertex_of, entry.map.alpha
    found = [[at_[alpha[dart]] for dart in darts] for darts in entry.map.vertices]
    for vertex, ends in enumerate(found):
        if vertex in ends or len({*ends}) < len(ends):
            what = "a loop" if vertex in ends else "parallel edges"
            raise InputError(f"vertex {entry.labels.vertex(vertex)} has {what}, not told so")
    return found
