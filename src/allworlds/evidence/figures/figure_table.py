"""A figure is computed, drawn and written, with its data beside it."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Unpack

from allworlds.document import Natural, Report, Some, Text, about, one_of
from allworlds.engines import EffortOptions, Limits, Listener, Silent
from allworlds.evidence.figures.augmentation import figure_2
from allworlds.evidence.figures.bounds import figure_bounds
from allworlds.evidence.figures.drawn import Drawn
from allworlds.evidence.figures.holes import figure_3
from allworlds.evidence.figures.twins import figure_1
from allworlds.inputs import InputError, an_integer, ensure_installed, show
from allworlds.outcome import Exit, Verdict
from allworlds.studies.check import refuse_others

WORLDS, SEED, EDGES = 30, 1, 6
"""What is taken where nothing is said: graphs of a size, the first seed, the largest size."""

MOST_EDGES = 7

SUFFIXES = (".svg", ".png", ".pdf")


@dataclass(frozen=True, slots=True)
class FigureRequest:
    """What a figure is made of."""

    worlds: int
    seed: int
    edges: int
    limits: Limits
    listener: Listener


@dataclass(frozen=True, slots=True)
class Kind:
    """A figure that can be asked for.

    Attributes:
        title: what is to be seen.
        make: the computation.
        options: those that it takes beside the effort.
    """

    title: str
    make: Callable[[FigureRequest], Drawn]
    options: tuple[str, ...] = ()


FIGURES: Mapping[str, Kind] = {
    "1": Kind("two worlds that no motion tells apart", lambda _: figure_1()),
    "2": Kind("one pass before and after", lambda _: figure_2()),
    "3": Kind(
        "the cost in lattices and dense graphs with holes",
        lambda asked: figure_3(asked.worlds, asked.seed, asked.limits, asked.listener),
        ("worlds", "seed"),
    ),
    "bounds": Kind(
        "exact worst cases beside the bound",
        lambda asked: figure_bounds(asked.edges, asked.limits, asked.listener),
        ("edges",),
    ),
}
"""**The** table of the figures."""


class Figure(Report):
    """Report of 'figure'.

    A figure that was written: the picture, and the CSV beside it.
    """

    verdict: Annotated[Verdict, about("whether what is drawn is so")]
    exit_code: Annotated[
        Exit,
        one_of(
            *(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERNAL),
            Exit.INTERRUPTED,
        ),
    ]
    figure: Annotated[Text, about("its name")]
    path: Annotated[Path, about("the file of the picture")]
    data: Annotated[Path, about("the file of its data, CSV")]
    caption: Annotated[Some[Text], about("what is seen, a few sentences each")]
    columns: Annotated[Some[Text], about("of the data")]
    rows: Annotated[Natural, about("how many there are")]


class FigureOptions(EffortOptions, total=False):
    """What ``figure`` takes beside the name.

    Attributes:
        out: the file; its end says the format (default ``figure-NAME.svg``).
        worlds: how many graphs of each size (``3``; default 30).
        seed: of the first of them (``3``; default 1).
        edges: the largest number of edges (``bounds``; default 6).
    """

    out: str | None
    worlds: int | None
    seed: int | None
    edges: int | None


def figure(
    name: str, *, listener: Listener | None = None, **options: Unpack[FigureOptions]
) -> Figure:
    """Compute a figure, draw it into a file, and write its data beside it as CSV.

    Args:
        name: one of :data:`FIGURES`.
        listener: is told of the progress.
        options: see :class:`FigureOptions`.

    Raises:
        InputError: naming the offending option and what would be legal, or what is missing.
        OSError: if a file cannot be written.

    Cost: ``3`` some minutes; the others seconds.
    """
    refuse_others("figure", options, FigureOptions)
    kind = FIGURES.get(name)
    if kind is None:
        raise InputError(f"figure {show(name)} is not one of {', '.join(FIGURES)}")
    asked = _asked(name, kind, options, listener or Silent())
    path, data = files_of(name, options.get("out"))
    ensure_installed("matplotlib", "figures", "figure")
    drawn = kind.make(asked)
    path.write_bytes(_picture(drawn, path.suffix))
    data.write_text(_csv(drawn), encoding="utf-8")
    header, rows = drawn.table()
    return Figure(
        verdict=drawn.verdict,
        exit_code=drawn.exit_code,
        figure=name,
        path=path,
        data=data,
        caption=tuple(drawn.caption()),
        columns=tuple(header),
        rows=len(rows),
    )


def files_of(name: str, out: str | None) -> tuple[Path, Path]:
    """The files of a figure: the picture, and its data.

    Raises:
        InputError: for an end that is no format.
    """
    path = Path(f"figure-{name}.svg" if out is None else out)
    if path.suffix not in SUFFIXES:
        raise InputError(f"out {show(str(path))} ends with none of {', '.join(SUFFIXES)}")
    return path, path.with_suffix(".csv")


def _asked(name: str, kind: Kind, options: FigureOptions, listener: Listener) -> FigureRequest:
    numbers = {}
    given: Mapping[str, Any] = options
    for option, usual, least, most in (
        ("worlds", WORLDS, 1, 10_000),
        ("seed", SEED, 0, 10**9),
        ("edges", EDGES, 1, MOST_EDGES),
    ):
        value = given.get(option)
        if value is not None and option not in kind.options:
            raise InputError(f"{option} {show(value)} has no effect on figure {name}")
        numbers[option] = usual if value is None else an_integer(option, value)
        if not least <= numbers[option] <= most:
            raise InputError(f"{option} = {show(value)} is not in {least}..{most}")
    return FigureRequest(**numbers, limits=Limits.of(options), listener=listener)


def _picture(drawn: Drawn, suffix: str) -> bytes:
    import matplotlib as mpl
    from matplotlib.figure import Figure as Sheet

    # Without a salt the names in an SVG are drawn anew each time; without a date it is the same.
    with mpl.rc_context({"svg.hashsalt": "allworlds", "svg.fonttype": "none"}):
        sheet = Sheet(layout="constrained")
        drawn.draw(sheet)
        out = io.BytesIO()
        dated = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}, ".png": {}}
        sheet.savefig(out, format=suffix[1:], dpi=150, metadata=dated[suffix])
    return out.getvalue()


def _csv(drawn: Drawn) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    header, rows = drawn.table()
    writer.writerow(header)
    writer.writerows(rows)
    return out.getvalue()
