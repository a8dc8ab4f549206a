"""The notations in which files of embedded graphs are read and written."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import IO, Any, Literal, TypeAlias, get_args

from msgspec import Struct

from allworlds.inputs.checks import (
    InputError,
    a_path,
    in_file,
    not_one_of,
    one_of,
    parse_json,
    show,
)
from allworlds.maps.networks import to_networkx, undirected
from allworlds.notations.edge_list import read_edge_list, write_edge_list
from allworlds.notations.entry import at
from allworlds.notations.graphs import (
    named_graph,
    of_gml,
    of_graph6,
    of_graphml,
    of_yed,
    read_graph,
)
from allworlds.notations.objects import fat_of, own_of, rotation_of
from allworlds.notations.plantri import (
    EDGE,
    PLANAR,
    read_edge_code,
    read_planar_code,
    write_edge_code,
    write_planar_code,
)
from allworlds.notations.sage import literal, opens, write_sage
from allworlds.notations.worlds_as_json import read_json, read_lines, write_json
from allworlds.world.labels import Labelling
from allworlds.world.world import Entry

Order: TypeAlias = Literal["clockwise", "anticlockwise"]
"""The order in which a file lists the edges round a vertex."""

YAxis: TypeAlias = Literal["up", "down"]
"""The direction in which the second coordinate of a position grows."""

EVERY = ("name", "names", "positions", "start", "lighthouse")
"""The parts that a world in a file can have besides its map, named by the keys of its JSON."""


class Notation(Struct, frozen=True):
    """A notation of embedded graphs in files.

    Attributes:
        name: the usual name.
        suffixes: the suffixes of files in this notation.
        read: the function that yields the worlds of an open binary file, from the file's current
            position on.  The function takes every order of edges as clockwise, and every y axis as
            upward.  Each world comes with its offset in the file, or with its number if ``streams``
            is false.
        write: the function from a world to bytes; None if the notation is not written.
        keeps: the parts of a world besides its map that the notation can express, such as
            ``names``; :data:`EVERY` lists all parts.
        mark: bytes near the beginning of files in this notation, which other files lack; or empty.
        streams: whether worlds are read one by one, with a single world in memory.
        y: the usual direction of the y axis if the order of edges follows from positions, else
            None.
        graph: the function from a file's content to its graph, for callers that need only the
            edges; None for most notations.
    """

    name: str
    suffixes: tuple[str, ...]
    read: Callable[[IO[bytes]], Iterator[tuple[int, Entry]]]
    write: Callable[[Entry], bytes] | None = None
    keeps: tuple[str, ...] = ()
    mark: bytes = b""
    streams: bool = False
    y: YAxis | None = None
    graph: Callable[[bytes], Any] | None = None


def _graph(
    name: str, suffixes: tuple[str, ...], graph: Callable[[bytes], Any], y: YAxis, mark: bytes = b""
) -> Notation:
    """The notation of files with a graph; ``graph`` makes the graph from the content of a file.

    The order of the edges round a node follows from the positions of the nodes.
    """
    return Notation(name, suffixes, read_graph(graph), mark=mark, y=y, graph=graph)


NOTATIONS = (
    Notation("worlds", (".json",), read_json, write_json(own_of), EVERY),
    Notation(
        "lines",
        (".jsonl", ".ndjson"),
        read_lines(parse_json),
        write_json(own_of),
        EVERY,
        streams=True,
    ),
    Notation("rotation", (".rot.json",), read_json, write_json(rotation_of), ("names",)),
    Notation("fat", (".fat.json",), read_json, write_json(fat_of)),
    _graph("graphml", (".graphml",), of_graphml, "up"),
    _graph("yed", (), of_yed, "down", b"http://www.yworks.com/xml/graphml"),
    _graph("gml", (".gml",), of_gml, "down"),
    _graph("graph6", (".g6",), of_graph6, "up"),
    Notation(
        "planar_code",
        (".pl", ".plc"),
        read_planar_code,
        write_planar_code,
        mark=PLANAR,
        streams=True,
    ),
    Notation("edge_code", (".ec",), read_edge_code, write_edge_code, mark=EDGE, streams=True),
    Notation("sage", (".sage",), read_lines(literal, opens), write_sage, ("names",), streams=True),
    Notation("edges", (".csv",), read_edge_list, write_edge_list, ("names",)),
)
"""All notations; a file that begins like JSON, and has no known suffix, is in the first one."""

HEAD = 2000
"""The number of bytes at the beginning of a file in which the mark of a notation is searched."""


def by_suffix(file: str) -> Notation | None:
    """The notation of a file's name: of the suffixes at its end, the longest decides.

    The result is None if the name ends with no suffix of a notation.
    """
    ends = ((end, each) for each in NOTATIONS for end in each.suffixes if file.endswith(end))
    return max(ends, key=lambda found: len(found[0]), default=("", None))[1]


def notation_in(stream: IO[bytes], file: str) -> Notation:
    """The notation of an open file: its mark decides, else its suffix, else its first character."""
    head = stream.read(HEAD)
    stream.seek(0)
    for each in NOTATIONS:
        if each.mark and each.mark in head:
            return each
    if found := by_suffix(file):
        return found
    if head.lstrip()[:1] in (b"{", b"["):
        return NOTATIONS[0]
    raise InputError(f"this is no file of worlds by its name or beginning; legal are {legal()}")


def legal(*, written: bool = False) -> str:
    """The suffixes of all notations, in words.

    If ``written`` is True, notations that can only be read are left out.
    """
    notations = (each for each in NOTATIONS if each.write or not written)
    return one_of(end for each in notations for end in each.suffixes)


@contextmanager
def _opened(file: str | Path) -> Iterator[tuple[IO[bytes], Notation]]:
    """A context with the opened file and its notation, in which errors name the file."""
    try:
        stream = a_path("file", file).open("rb")
    except OSError as error:
        raise InputError(f"file {show(str(file))} cannot be read: {error.strerror}") from None
    with stream, in_file(str(file)):
        yield stream, notation_in(stream, str(file))


def entries(
    file: str | Path, order: Order | None = None, y: YAxis | None = None
) -> Iterator[tuple[int, Entry]]:
    """Yield all worlds of a file in any notation, each with its offset in bytes.

    If the notation does not stream (see :class:`Notation`), the number of the world, from 0 on,
    replaces the offset.

    Args:
        file: the name of the file.
        order: the order in which the file lists the edges round a vertex; None means clockwise.
        y: the direction of the y axis in the file; None means the usual one of the notation.

    Raises:
        InputError: if the file cannot be read, or an option does not fit its notation; the message
            names the file, the place in the file, and what would be legal.

    Cost: the memory of one entry at a time, if the notation streams.
    """
    with _opened(file) as (stream, notation):
        _check(notation, order, y)
        found = False
        for offset, entry in notation.read(stream):
            found = True
            yield offset, _turned(entry, notation, order, y)
        if not found:
            raise InputError("there is no world in it")


def _check(notation: Notation, order: str | None, y: str | None) -> None:
    for name, given, known in (("order", order, Order), ("y", y, YAxis)):
        if given is not None and given not in get_args(known):
            raise not_one_of(name, given, get_args(known))
    if y and not notation.y:
        raise InputError(f"y {y} has no effect on {notation.name}, where positions decide nothing")


def _turned(entry: Entry, notation: Notation, order: Order | None, y: YAxis | None) -> Entry:
    """The world that a file means; ``entry`` is this world or its mirror image.

    ``entry`` comes from ``notation.read``, which takes every order of edges as clockwise and every
    y axis as upward.  ``order`` and ``y`` are the options of :func:`entries`, which tell the true
    order and the true axis.  In a notation with a y axis, the result is the mirror image of
    ``entry`` if the true axis points down.  In any other notation, it is the mirror image if the
    true order is anticlockwise.

    Raises:
        InputError: if ``order`` is anticlockwise in a notation with a y axis.
    """
    labels = entry.labels.checked(entry.map)
    if notation.y:
        if order == "anticlockwise":
            raise InputError(f"order {order} has no effect on positions; y up or y down has")
        turn = (y or notation.y) == "down"
        upward = tuple((right, 0.0 - up) for right, up in labels.positions)
        mirror = Labelling(labels.name, labels.vertices, upward)
    else:
        turn, mirror = order == "anticlockwise", labels.mirrored()
    if not turn:
        return Entry(entry.map, labels, entry.start, entry.lighthouse)
    return Entry(entry.map.mirrored(), mirror, entry.start, entry.lighthouse)


def entry_at(
    file: str | Path, offset: int, order: Order | None = None, y: YAxis | None = None
) -> Entry:
    """The world of a file at an offset that :func:`entries` has yielded.

    ``order`` and ``y`` are those of :func:`entries`.

    Cost: the reading of this world.  If the notation does not stream, the whole file is read once,
    and all its worlds are kept.
    """
    with _opened(file) as (stream, notation):
        if notation.streams:
            stream.seek(offset)
            for _, entry in notation.read(stream):
                return _turned(entry, notation, order, y)
        changed = a_path("file", file).stat().st_mtime_ns
        found = _whole(str(file), changed, order, y)[offset : offset + 1]
        if not found:
            raise InputError(f"there is no world at {offset} any more: the file has changed")
        return found[0]


@lru_cache(maxsize=4)
def _whole(file: str, _changed: int, order: Order | None, y: YAxis | None) -> tuple[Entry, ...]:
    """All worlds of a file; the result is kept, and a later call returns it again.

    ``_changed`` is the time of the file's last change, so that a changed file is read anew.
    """
    return tuple(entry for _, entry in entries(file, order, y))


SHOWN = 5
"""The largest number of names of worlds that an error lists."""


def entry_named(
    file: str | Path, name: str, order: Order | None = None, y: YAxis | None = None
) -> Entry:
    """The world of this name or number (from 1 on) in the file; for ``""`` the file's only world.

    ``order`` and ``y`` are those of :func:`entries`.

    Raises:
        InputError: if there is no such world, or if there are several worlds for ``""``; the
            message names the first worlds of the file.
    """
    known, numbered = list[str](), None
    for number, (_, entry) in enumerate(entries(file, order, y), 1):
        if entry.labels.name == name and name:
            return entry
        if name == str(number) or (not name and number == 1):
            numbered = entry
        if number <= SHOWN:
            known.append(entry.labels.name or str(number))
        elif not name:
            break
    if numbered and (name or len(known) == 1):
        return numbered
    first = ", ".join(map(show, known)) + (", ..." if number > SHOWN else "")
    what = f"no world {show(name)}" if name else "more than one world"
    raise InputError(f"file {show(str(file))} has {what}; @FILE:NAME names one of {first}")


def graph_in(
    file: str | Path, order: Order | None = None, y: YAxis | None = None
) -> tuple[Any, Labelling]:
    """The graph in a file, as networkx has it, and the labels of the graph.

    The labels hold the graph's name, and the names of the nodes in the order of the graph's nodes.
    In GraphML, GML and graph6 the nodes are texts, and are their own names; in other notations the
    nodes are numbers, and the names may be missing.

    ``order`` and ``y`` are the options of :func:`entries`.  An option that is illegal for the file
    is refused, as in that function; a legal one changes nothing, since the result has no order of
    the edges.

    Raises:
        InputError: if the file does not hold one graph or one world, or if an option is illegal;
            the message names the part that cannot be read.
    """
    with _opened(file) as (stream, notation):
        if notation.graph:
            _check(notation, order, y)
            graph = undirected(named_graph(notation.graph, stream.read()))
            return graph, Labelling("", tuple(graph))
    entry = entry_named(file, "", order, y)
    return to_networkx(entry.map), Labelling(entry.labels.name, entry.labels.vertices)


def to_write(file: str) -> Notation:
    """The notation in which a file with the name ``file`` is written.

    Raises:
        InputError: if no written notation has the suffix of this name.
    """
    if (found := by_suffix(file)) and found.write:
        return found
    raise InputError(f"worlds cannot be written as {show(file)}; legal are {legal(written=True)}")


def written(worlds: Iterable[Entry], notation: Notation) -> Iterator[bytes]:
    """Yield the bytes of a file in a notation, without parts that the notation cannot express.

    Raises:
        InputError: if the notation cannot express the map of a world; the message has the number of
            this world.  Also if a file in the notation holds one world, and several are given.
    """

    def parts() -> Iterator[bytes]:
        assert notation.write
        for number, entry in enumerate(worlds, 1):
            with at(f"world {number} is not written"):
                yield notation.write(entry)

    if notation.streams:
        yield notation.mark and notation.mark + b"<<"
        yield from parts()
        return
    first, *more = parts()
    if more and not notation.suffixes[0].endswith(".json"):
        raise InputError(f"a file of {notation.name} holds one world; name one of another notation")
    texts = (part.rstrip() for part in (first, *more))
    yield b"[%s]\n" % b",\n".join(texts) if more else first
