"""Worlds of a file: told of, and written in another notation."""

from collections.abc import Iterable, Iterator
from dataclasses import KW_ONLY
from pathlib import Path
from typing import Annotated

from allworlds.document import Document, Edges, Natural, Positive, Report, Vertices, about
from allworlds.inputs.checks import InputError, a_path, show
from allworlds.inputs.requests import OUTPUT, Argument, Option, answers
from allworlds.maps.combinatorial import automorphisms
from allworlds.notations.given import FileOptions
from allworlds.notations.table import (
    PARTS,
    entries,
    legal,
    to_write,
    written,
)
from allworlds.world.world import Entry


class ConvertRequest(FileOptions, kw_only=False):
    """Request of ``convert``: a file of worlds, and where they are written."""

    file: Annotated[
        str | Path, Argument("", "FILE", f"A file of worlds, by its suffix: {legal()}; or - .")
    ]
    _: KW_ONLY
    output: Annotated[
        str | Path | None,
        f"where the worlds are written, by its suffix: {legal(written=True)}, or NOTATION:FILE",
    ] = None
    without: Annotated[
        str | None,
        Option(
            OUTPUT,
            "WHAT",
            f"Leave out of the worlds that are written any of {', '.join(PARTS)}, with commas.",
        ),
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
    rows: Annotated[tuple[ConvertRow, ...], about("one a world, in the order of the file")]


@answers(ConvertRequest)
def convert(request: ConvertRequest) -> Convert:
    """Tell of the worlds of a file, and write them in another notation if ``output`` is given.

    Raises:
        InputError: naming what cannot be read, or what the other notation cannot tell.

    Cost: of a world O(m^2) at worst, for its automorphisms.
    """
    rows = list[ConvertRow]()

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
            yield entry

    if request.output is None:
        if request.without is not None:
            raise InputError(f"without {request.without} has no effect where nothing is written")
        path = None
        for _ in told():
            pass
    else:
        notation, path = to_write(str(request.output))
        without = () if request.without is None else request.without.split(",")
        _write(a_path("output", path), written(told(), notation, without))
    return Convert(written=path, rows=tuple(rows))


def _write(path: Path, content: Iterable[bytes]) -> None:
    """Write a file as a whole, or not at all."""
    part = path.with_name(f"{path.name}.part")
    try:
        with part.open("wb") as file:
            file.writelines(content)
        part.replace(path)
    except OSError as error:
        raise InputError(f"file {show(str(path))} cannot be written: {error.strerror}") from None
    finally:
        part.unlink(missing_ok=True)
