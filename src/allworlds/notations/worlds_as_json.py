"""JSON files of worlds, rotations and fat graphs.

A file holds one object, a list of objects, an object whose keys are the names of such objects, or
one object in each line.
"""

import json
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from typing import IO, Any

from allworlds.inputs.checks import parse_json, show
from allworlds.notations.entry import at, text_of
from allworlds.notations.objects import entry_of
from allworlds.world.world import Entry

Objects = Iterator[tuple[int, Entry]]


def read_json(file: IO[bytes]) -> Objects:
    """Yield the worlds of a JSON file, each with its number from 0 on.

    The file holds an object, a list of objects, or an object with names as keys, objects as values.
    """
    worlds = _worlds(parse_json(text_of(file.read())))
    for number, (name, given) in enumerate(worlds):
        where = f"world {show(name) if name else number + 1}"
        with at(where) if len(worlds) > 1 or name else nullcontext():
            entry = entry_of(given, name)
        yield number, entry


def _worlds(document: Any) -> list[tuple[str, Any]]:
    if isinstance(document, list):
        return [("", each) for each in document]
    if isinstance(document, dict) and all(isinstance(each, dict) for each in document.values()):
        return [*document.items()]
    return [("", document)]


def read_lines(
    parse: Callable[[str], Any], opens: Callable[[str], int] = lambda _line: 0
) -> Callable[[IO[bytes]], Objects]:
    """The function that yields the worlds of a file of lines, each with its offset in the file.

    ``parse`` makes from the text of a world the object that :func:`entry_of` takes.  ``opens``
    takes a line, and returns the number of its opening brackets minus that of its closing brackets.
    A world has one line; while brackets are open, it goes on in the next line.
    """

    def read(file: IO[bytes]) -> Objects:
        start = offset = begin = file.tell()
        text, first, depth = "", 1, 0
        for number, line in enumerate(file, 1):
            if not text.strip():
                text, first, begin = "", number, offset
            offset += len(line)
            with at(f"line {number}" + (f" from byte {start} on" if start else "")):
                more = text_of(line)
            text, depth = text + more, depth + opens(more)
            if depth <= 0 and text.strip():
                yield begin, _entry(parse, text, first, start)
                text, depth = "", 0
        if text.strip():
            yield begin, _entry(parse, text, first, start)

    return read


def _entry(parse: Callable[[str], Any], text: str, line: int, start: int) -> Entry:
    """The world of a text; ``parse`` makes from the text the object that :func:`entry_of` takes.

    ``line`` and ``start`` only tell the user in messages where the text stands in the file.
    ``start`` is the offset of the byte at which the reading of the file began.  ``line`` is the
    number of the first line of the text; the line with the byte ``start`` has the number 1.  A
    message begins like ``line 3``, or like ``line 3 from byte 120 on`` if ``start`` is not 0.
    """
    with at(f"line {line}" + (f" from byte {start} on" if start else "")):
        return entry_of(parse(text.strip()))


def write_json(of: Callable[[Entry], Any]) -> Callable[[Entry], bytes]:
    """The function from a world to a line of JSON; ``of`` makes a JSON value from the world."""
    return lambda entry: f"{json.dumps(of(entry), ensure_ascii=False)}\n".encode()
