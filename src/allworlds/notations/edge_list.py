"""Tables of edges in CSV: the two ends of each edge, and the edge's rank at each end.

The header ``from,to,from_rank,to_rank`` is required; each further line is an edge.  A rank is a
number: clockwise round a vertex the edges are in the order of their ranks, all of which are
different.
"""

import csv
import io
from collections.abc import Iterator
from math import isfinite
from typing import IO

from allworlds.inputs.checks import InputError, show
from allworlds.maps.build import from_cycles
from allworlds.notations.entry import at, text_of
from allworlds.world.labels import Labelling
from allworlds.world.world import Entry

COLUMNS = ["from", "to", "from_rank", "to_rank"]


def read_edge_list(file: IO[bytes]) -> Iterator[tuple[int, Entry]]:
    """Yield one pair: the number 0, and the only world of a table of edges.

    Raises:
        InputError: naming the line, and what is illegal there.
    """
    rows = csv.reader(io.StringIO(text_of(file.read()), newline=""), strict=True)
    ranks = dict[str, dict[float, int]]()
    try:
        header = next(rows, [])
        if header != COLUMNS:
            legal = ",".join(COLUMNS)
            raise InputError(f"the header is {show(','.join(header))}; legal is {legal}")
        for row in filter(None, rows):
            with at(f"line {rows.line_num}"):
                if len(row) != len(header):
                    raise InputError(f"{len(row)} cells; the header has {len(header)}")
                for vertex, rank in zip(row[:2], row[2:4], strict=True):
                    taken, number = ranks.setdefault(vertex, {}), _rank(rank)
                    if number in taken:
                        raise InputError(f"two edges at vertex {show(vertex)} have rank {rank}")
                    taken[number] = rows.line_num
    except csv.Error as error:
        raise InputError(f"line {rows.line_num}: {error}") from None
    cycles = {v: [edges[rank] for rank in sorted(edges)] for v, edges in ranks.items()}
    yield 0, Entry(from_cycles(cycles), Labelling(vertices=tuple(ranks)))


def _rank(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = float("nan")
    if not isfinite(number):
        raise InputError(f"rank {show(text)} is not a number")
    return number


def write_edge_list(entry: Entry) -> bytes:
    """The table of the edges of a world, in UTF-8."""
    out, map_ = io.StringIO(), entry.map
    rank = {dart: i for darts in map_.vertices for i, dart in enumerate(darts)}
    name = [entry.labels.vertex(vertex) for vertex in map_.vertex_of]
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(COLUMNS)
    writer.writerows([name[d], name[e], rank[d], rank[e]] for d, e in map_.edges)
    return out.getvalue().encode()
