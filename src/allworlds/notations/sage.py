"""Embeddings as Sage prints them: a dictionary of clockwise neighbours a line.

``{0: [1, 2], 1: [2, 0], 2: [0, 1]}`` is what ``graph.get_embedding()`` returns; fat graphs stand in
a line likewise.  Keys are numbers, texts or tuples; their texts become the names.

Source: the reference manual of Sage, ``set_embedding``.
"""

import ast
import warnings
from typing import Any

from allworlds.inputs.checks import InputError, show
from allworlds.notations.entry import neighbours
from allworlds.world.world import Entry


def literal(text: str) -> Any:
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


def write_sage(entry: Entry) -> bytes:
    """A simple world, a dictionary in a line; vertices without names are numbers.

    Raises:
        InputError: naming a vertex with a loop or parallel edges.
    """
    names: tuple[Any, ...] = entry.labels.vertices or tuple(range(entry.map.vertex_count))
    around = [[names[end] for end in ends] for ends in neighbours(entry)]
    return f"{dict(zip(names, around, strict=True))}\n".encode()
