"""Embeddings as Sage prints them: a dictionary of clockwise neighbours a line.

``{0: [1, 2], 1: [2, 0], 2: [0, 1]}`` is what ``graph.get_embedding()`` returns; fat graphs stand in
a line likewise.  Keys are numbers, texts or tuples; their texts become the names.

Source: the reference manual of Sage, ``set_embedding``.
"""

import ast
import warnings
from collections.abc import Iterable, Iterator
from typing import IO, Any

from allworlds.inputs.checks import InputError, show
from allworlds.notations.entry import at, lines_of, neighbours
from allworlds.notations.objects import entry_of
from allworlds.world.world import Entry


def read_sage(file: IO[bytes]) -> Iterator[tuple[int, Entry]]:
    """The worlds of a file with one dictionary a line."""
    for offset, place, text in lines_of(file):
        with at(place):
            entry = entry_of(_literal(text.strip()))
        yield offset, entry


def _literal(text: str) -> Any:
    """The value of a literal; raise InputError if it is none, or if a key stands in it twice."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of garbled numbers
            tree = ast.parse(text, mode="eval").body
            value = ast.literal_eval(tree)
    except (ValueError, SyntaxError, TypeError, MemoryError, RecursionError):
        legal = "a dictionary in one line, such as {0: [1], 1: [0]}"
        raise InputError(f"{show(text)} is no literal; legal is {legal}") from None
    if isinstance(tree, ast.Dict) and len(tree.keys) > len(value):
        raise InputError("a key stands twice in the dictionary")
    return value


def write_sage(entries: Iterable[Entry]) -> Iterator[bytes]:
    """Simple worlds, a dictionary a line; vertices without names are numbers.

    Raises:
        InputError: naming a vertex with a loop or parallel edges.
    """
    for entry in entries:
        names: tuple[Any, ...] = entry.labels.vertices or tuple(range(entry.map.vertex_count))
        around = [[names[end] for end in ends] for ends in neighbours(entry)]
        yield f"{dict(zip(names, around, strict=True))}\n".encode()
