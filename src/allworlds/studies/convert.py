"""``convert``: the description of a file's worlds, and the same worlds in other notations."""

from collections.abc import Iterable
from dataclasses import KW_ONLY
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Any

from allworlds.documents.document import (
    Document,
    Edges,
    Natural,
    NotInDocument,
    Positive,
    Text,
    Vertices,
    about,
)
from allworlds.documents.report import Report
from allworlds.inputs.checks import InputError, a_path, show
from allworlds.inputs.requests import Argument, Converted, answers
from allworlds.maps.combinatorial import automorphisms
from allworlds.notations.given import FileOptions
from allworlds.notations.objects import doors_of, own_of
from allworlds.notations.table import Notation, entries, legal, to_write, written
from allworlds.world.world import Entry

DRAWN = 12
"""The number of worlds, the first ones of a file, of which pictures are shown."""


def _files(given: Any) -> tuple[str, ...]:
    """The names of files: ``given`` is None, one name, or a list of names."""
    if given is None:
        return ()
    return tuple(map(str, [given] if isinstance(given, str | Path) else given))


class ConvertRequest(FileOptions, kw_only=False):
    """Request of ``convert``: a file of worlds, and the files in which the worlds are written."""

    file: Annotated[
        str | Path, Argument("", "FILE", f"A file of worlds, by its suffix: {legal()}.")
    ]
    _: KW_ONLY
    output: Annotated[
        Converted[Any, tuple[str, ...]],
        f"the files in which the worlds are written, by their suffix: {legal(written=True)}",
    ] = Converted(_files, ())


class ConvertRow(Document):
    """The description of one world of the file."""

    number: Annotated[Positive, about("its place in the file, from 1 on")]
    name: Annotated[str, about("in the file; empty: it has none")]
    vertices: Vertices
    edges: Edges
    genus: Annotated[Natural, about("the genus of its surface")]
    faces: Annotated[Positive, about("the number of faces")]
    automorphisms: Annotated[Positive, about("those that keep the orientation")]
    names: Annotated[tuple[str, ...], about("of its vertices; empty: they have none")]
    doors: Annotated[
        tuple[tuple[str, ...], ...],
        about(
            "of each vertex, clockwise, the vertices to which its edges lead; where two edges have "
            "the same ends, with a number, which both ends of an edge have"
        ),
    ]


class Convert(Report, kw_only=True):
    """Report of 'convert'.

    The worlds of a file; ``drawn`` has the first worlds, of which pictures are shown.
    """

    written: Annotated[
        tuple[Text, ...] | None, about("the files in which the worlds were written")
    ] = None
    left_out: Annotated[
        tuple[Text, ...] | None,
        about("what of the worlds one of them has no place for; null: all is there"),
    ] = None
    rows: Annotated[tuple[ConvertRow, ...], about("one a world, in the order of the file")]
    drawn: NotInDocument[tuple[Entry, ...]] = ()


@answers(ConvertRequest)
def convert(request: ConvertRequest) -> Convert:
    """Describe the worlds of a file, and write them in other notations if ``output`` is given.

    Raises:
        InputError: naming a file that cannot be read, or a map that the notation cannot express.

    Cost: O(m^2) for a world at worst, for its automorphisms.
    """
    outputs = [(a_path("output", name), to_write(name)) for name in request.output]
    rows, has, drawn = list[ConvertRow](), set[str](), list[Entry]()
    for number, (_, entry) in enumerate(entries(request.file, request.order, request.y), 1):
        rows.append(_row(number, entry))
        has.update(own_of(entry))
        drawn += [entry] if number <= DRAWN else []
    for path, notation in outputs:
        again = entries(request.file, request.order, request.y)
        _write(path, notation, (entry for _, entry in again))
    kept = [{"sigma", "alpha", *notation.keeps} for _, notation in outputs]
    left_out = {key for keys in kept for key in has - keys}
    return Convert(
        written=tuple(str(path) for path, _ in outputs) or None,
        rows=tuple(rows),
        left_out=tuple(sorted(left_out)) or None,
        drawn=tuple(drawn),
    )


def _row(number: int, entry: Entry) -> ConvertRow:
    map_, labels = entry.map, entry.labels
    return ConvertRow(
        number=number,
        name=labels.name,
        vertices=map_.vertex_count,
        edges=map_.edge_count,
        genus=map_.genus,
        faces=len(map_.faces),
        automorphisms=automorphisms(map_),
        names=labels.vertices,
        doors=tuple(tuple(map(_room_behind, ends)) for ends in doors_of(entry)),
    )


def _room_behind(end: str | list[str | int]) -> str:
    """The text for a door: the name of the room behind it, and perhaps the number of its edge.

    ``end`` describes the door as :func:`doors_of` does.  If no other edge joins the same two rooms,
    ``end`` is the name of the room behind the door, and the text is this name.  Otherwise ``end``
    is a list: this name, and the number of the edge.  Then the text has the number in parentheses
    behind the name, so that the reader sees which two doors belong to one edge.
    """
    return end if isinstance(end, str) else f"{end[0]} ({end[1]})"


def _write(path: Path, notation: Notation, worlds: Iterable[Entry]) -> None:
    """Write worlds into a file; if the notation refuses one of them, the old file stays."""
    try:
        with TemporaryDirectory(prefix=".allworlds-", dir=path.parent) as beside:
            part = Path(beside) / path.name
            with part.open("wb") as file:
                file.writelines(written(worlds, notation))
            part.replace(path)
    except OSError as error:
        raise InputError(f"file {show(str(path))} cannot be written: {error.strerror}") from None
