"""Files of JSON: worlds, rotations and fat graphs, alone, in lists, by names, or one a line."""

import json
from collections.abc import Callable, Iterable, Iterator
from contextlib import nullcontext
from typing import IO, Any

from allworlds.inputs.checks import parse_json, show
from allworlds.notations.entry import at, lines_of, text_of
from allworlds.notations.objects import entry_of, own_of
from allworlds.world.world import Entry

Objects = Iterator[tuple[int, Entry]]


def read_json(file: IO[bytes]) -> Objects:
    """The worlds of one document: an object, a list of them, or an object of them by names."""
    worlds = _worlds(parse_json(text_of(file.read())))
    for number, (name, given) in enumerate(worlds):
        place = f"world {show(name) if name else number + 1}"
        with at(place) if len(worlds) > 1 or name else nullcontext():
            entry = entry_of(given, name)
        yield number, entry


def _worlds(document: Any) -> list[tuple[str, Any]]:
    if isinstance(document, list):
        return [("", each) for each in document]
    if isinstance(document, dict) and all(isinstance(each, dict) for each in document.values()):
        return [*document.items()]
    return [("", document)]


def read_lines(file: IO[bytes]) -> Objects:
    """The worlds of a file that has one a line."""
    for offset, place, text in lines_of(file):
        with at(place):
            entry = entry_of(parse_json(text))
        yield offset, entry


def write_json(of: Callable[[Entry], Any]) -> Callable[[Iterable[Entry]], Iterator[bytes]]:
    """A writer of one object, or of a list, of what each entry becomes."""

    def write(entries: Iterable[Entry]) -> Iterator[bytes]:
        objects = [_text(of(entry)) for entry in entries]
        rest = ",\n".join(objects)
        yield f"{rest if len(objects) == 1 else f'[{rest}]'}\n".encode()

    return write


def _text(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)


def write_lines(entries: Iterable[Entry]) -> Iterator[bytes]:
    """Worlds, one a line."""
    for entry in entries:
        yield f"{_text(own_of(entry))}\n".encode()
