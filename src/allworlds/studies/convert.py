"""Worlds of a file: told of, and written in another notation."""

from collections import deque
from collections.abc import Iterator
from dataclasses import KW_ONLY
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated

from allworlds.documents.document import Document, Edges, Natural, Positive, Text, Vertices, about
from allworlds.documents.report import Report
from allworlds.inputs.checks import InputError, a_path, show
from allworlds.inputs.requests import Argument, answers
from allworlds.maps.combinatorial import automorphisms
from allworlds.notations.given import FileOptions
from allworlds.notations.objects import own_of
from allworlds.notations.table import entries, legal, to_write, written
from allworlds.world.world import Entry


class ConvertRequest(FileOptions, kw_only=False):
    """Request of ``convert``: a file of worlds, and where they are written."""

    file: Annotated[
        str | Path, Argument("", "FILE", f"A file of worlds, by its suffix: {legal()}.")
    ]
    _: KW_ONLY
    output: Annotated[
        str | Path | None,
        f"where the worlds are written, by its suffix: {legal(written=True)}",
    ] = None


class ConvertRow(Document):
    """A world of the file."""

    number: Annotated[Positive, about("its place in the file, from 1 on")]
    name: Annotated[str, about("in the file; empty: it has none")]
    vertices: Vertices
    edges: Edges
    genus: Annotated[Natural, about("the genus of its surface")]
    faces: Annotated[Positive, about("the number of faces")]
    automorphisms: Annotated[Positive, about("those that keep the orientation")]


class Convert(Report, kw_only=True):
    """Report of 'convert'.

    The worlds of a file.
    """

    written: Annotated[str | None, about("the file in which the worlds were written")] = None
    left_out: Annotated[
        tuple[Text, ...] | None, about("what of the worlds it has no place for; null: all is there")
    ] = None
    rows: Annotated[tuple[ConvertRow, ...], about("one a world, in the order of the file")]


@answers(ConvertRequest)
def convert(request: ConvertRequest) -> Convert:
    """Tell of the worlds of a file, and write them in another notation if ``output`` is given.

    Raises:
        InputError: naming what cannot be read, or which map the other notation cannot tell.

    Cost: of a world O(m^2) at worst, for its automorphisms.
    """
    rows, has = list[ConvertRow](), set[str]()

    def told() -> Iterator[Entry]:
        for number, (_, entry) in enumerate(entries(request.file, request.order, request.y), 1):
            map_ = entry.map
            rows.append(
                ConvertRow(
                    number=number,
                    name=entry.labels.name,
                    vertices=map_.vertex_count,
                    edges=map_.edge_count,
                    genus=map_.genus,
                    faces=len(map_.faces),
                    automorphisms=automorphisms(map_),
                )
            )
            has.update(own_of(entry))
            yield entry

    if request.output is None:
        deque(told(), 0)
        return Convert(rows=tuple(rows))
    path = a_path("output", request.output)
    notation = to_write(str(path))
    try:
        with TemporaryDirectory(prefix=".allworlds-", dir=path.parent) as beside:
            part = Path(beside) / path.name  # what is refused midway leaves the old file
            with part.open("wb") as file:
                file.writelines(written(told(), notation))
            part.replace(path)
    except OSError as error:
        raise InputError(f"file {show(str(path))} cannot be written: {error.strerror}") from None
    left_out = tuple(sorted(has - {"sigma", "alpha", *notation.keeps}))
    return Convert(written=str(path), rows=tuple(rows), left_out=left_out or None)
