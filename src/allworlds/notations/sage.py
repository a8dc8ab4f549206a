"""Embeddings in the form in which Sage prints them: dictionaries of clockwise neighbours.

A dictionary stands in one line or in several.

``graph.get_embedding()`` returns, for example, ``{0: [1, 2], 1: [2, 0], 2: [0, 1]}``.  Keys are
numbers, texts or tuples; the texts of the keys become the names.  A file may also hold fat graphs,
as dictionaries or as Sage prints them: ``FatGraph('(0,2,1,3)', '(0,1)(2,3)', '(0,2,1,3)')`` with
vertices, edges and faces, or with vertices and faces alone.

Source: the reference manual of Sage, ``set_embedding``; ``FatGraph`` of surface_dynamics.
"""

import ast
import re
import warnings
from typing import Any

from allworlds.inputs.checks import InputError, show
from allworlds.notations.entry import neighbours
from allworlds.world.world import Entry


def opens(line: str) -> int:
    """The number of opening minus that of closing brackets in a line; quoted texts do not count."""
    plain = re.sub(r"'[^']*'|\"[^\"]*\"", "", line)
    return sum((sign in "([{") - (sign in ")]}") for sign in plain)


CYCLES = r"'((?:\([0-9]{1,9}(?:, ?[0-9]{1,9})*\))*)'"
"""The pattern of a permutation in a text, such as ``'(0,1)(2)'``."""

FAT_GRAPH = re.compile(
    rf"FatGraph\((?:vp=)?{CYCLES}(?:,\s*(?:ep=)?{CYCLES})?,\s*(?:fp=)?{CYCLES}\)"
)


def _fat_graph(text: str) -> dict[str, list[list[int]]] | None:
    """The cycles of darts in a text such as ``FatGraph('(0)(1)', '(0,1)')``; None for other texts.

    The keys of the result are ``vertices``, ``edges`` and ``faces``; a text with only two
    permutations has those of the vertices and of the faces.
    """
    found = FAT_GRAPH.fullmatch(text)
    if not found:
        return None
    parts = zip(("vertices", "edges", "faces"), found.groups(), strict=True)
    texts = {key: re.findall(r"\(([^)]+)\)", cycles) for key, cycles in parts if cycles is not None}
    return {key: [[*map(int, one.split(","))] for one in cycles] for key, cycles in texts.items()}


def literal(text: str) -> Any:
    """The value of a Python literal, or for a fat graph the result of :func:`_fat_graph`.

    InputError is raised for any other text, and for a dictionary in which a key stands twice.
    """
    if fat := _fat_graph(text):
        return fat
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of garbled numbers
            tree = ast.parse(text, mode="eval").body
            value = ast.literal_eval(tree)
    except (ValueError, SyntaxError, TypeError, MemoryError, RecursionError):
        legal = "a dictionary such as {0: [1], 1: [0]}, or FatGraph('(0)(1)', '(0,1)')"
        raise InputError(f"{show(text)} is no literal; legal is {legal}") from None
    if isinstance(tree, ast.Dict) and len(tree.keys) > len(value):
        raise InputError("a key stands twice in the dictionary")
    return value


def write_sage(entry: Entry) -> bytes:
    """A line with a world as a dictionary; if the vertices have no names, the keys are numbers.

    Raises:
        InputError: if the map has loops or parallel edges; the message names a vertex with them.
    """
    names: tuple[Any, ...] = entry.labels.vertices or tuple(range(entry.map.vertex_count))
    around = [[names[end] for end in ends] for ends in neighbours(entry)]
    return f"{dict(zip(names, around, strict=True))}\n".encode()
