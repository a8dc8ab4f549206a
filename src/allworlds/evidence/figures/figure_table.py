"""A figure is computed, drawn and written, with its data beside it."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Annotated

from msgspec import Struct

from allworlds.document import (
    EXIT_CODE,
    Aside,
    ExitCode,
    Natural,
    Report,
    Some,
    Text,
    about,
    computed,
    one_of,
)
from allworlds.evidence.figures.augmentation import figure_2
from allworlds.evidence.figures.bounds import figure_bounds
from allworlds.evidence.figures.drawn import Drawn
from allworlds.evidence.figures.figure_request import FigureRequest
from allworlds.evidence.figures.holes import figure_3
from allworlds.evidence.figures.twins import figure_1
from allworlds.inputs import InputError, an_integer, answers, ensure_installed, show
from allworlds.outcome import Exit, Facts, Verdict

WORLDS, SEED, EDGES = 30, 1, 6
"""Defaults: graphs of a size, the first seed, the largest size."""

MOST_EDGES = 7


class FigureNumbers(Struct, frozen=True):
    """Numbers that determine a figure: graphs of a size, first seed, largest size."""

    worlds: int = WORLDS
    seed: int = SEED
    edges: int = EDGES

    @classmethod
    def of(cls, request: FigureRequest, kind: Kind) -> FigureNumbers:
        """Return the numbers of a request.

        Raises:
            InputError: for one that is out of range, or of no effect.
        """
        numbers = {}
        for option, least, most in (
            ("worlds", 1, 10_000),
            ("seed", 0, 10**9),
            ("edges", 1, MOST_EDGES),
        ):
            value = getattr(request, option)
            if value is None:
                continue
            if option not in kind.options:
                raise InputError(f"{option} {show(value)} has no effect on figure {request.name}")
            numbers[option] = an_integer(option, value)
            if not least <= numbers[option] <= most:
                raise InputError(f"{option} = {show(value)} is not in {least}..{most}")
        return cls(**numbers)


class Kind(Struct, frozen=True):
    """A figure that can be asked for.

    Attributes:
        title: what is to be seen.
        make: the computation.
        options: those that it takes beside the effort.
    """

    title: str
    make: Callable[[FigureRequest, FigureNumbers], Drawn]
    options: tuple[str, ...] = ()


FIGURES: Mapping[str, Kind] = {
    "1": Kind("two worlds that no motion tells apart", lambda *_: figure_1()),
    "2": Kind("one pass before and after", lambda *_: figure_2()),
    "3": Kind(
        "the cost in lattices and dense graphs with holes",
        lambda asked, of: figure_3(of.worlds, of.seed, asked.limits, asked.listener),
        ("worlds", "seed"),
    ),
    "bounds": Kind(
        "exact worst cases beside the bound",
        lambda asked, of: figure_bounds(of.edges, asked.limits, asked.listener),
        ("edges",),
    ),
}
"""**The** table of the figures."""


def _verdict(drawn: Drawn) -> Verdict:
    """Whether what is drawn is so."""
    return drawn.facts.sample_verdict if drawn.is_sample else drawn.facts.verdict


class Figure(Report):
    """Report of 'figure'.

    A figure that was written: the picture, and the CSV beside it.
    """

    verdict: Annotated[Verdict, about("whether the figure's claims were found true")] = computed(
        lambda figure: _verdict(figure.drawn)
    )
    exit_code: Annotated[
        ExitCode,
        one_of(
            *(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERNAL),
            Exit.INTERRUPTED,
        ),
    ] = EXIT_CODE
    figure: Annotated[Text, about("its name")]
    path: Annotated[Path, about("the file of the picture")]
    data: Annotated[Path, about("the file of its data, CSV")]
    caption: Annotated[Some[Text], about("the caption, a few sentences each")]
    columns: Annotated[Some[Text], about("of the data")]
    rows: Annotated[Natural, about("how many there are")]
    drawn: Aside[Drawn]

    @property
    def facts(self) -> Facts:
        """The facts of the figure's content."""
        return self.drawn.facts


@answers(FigureRequest)
def figure(request: FigureRequest) -> Figure:
    """Compute a figure, draw it into a file, and write its data beside it as CSV.

    Raises:
        InputError: naming the offending option and what would be legal, or what is missing.
        OSError: if a file cannot be written.

    Cost: ``3`` some minutes; the others seconds.
    """
    name = request.name
    kind = FIGURES.get(name)
    if kind is None:
        raise InputError(f"figure {show(name)} is not one of {', '.join(FIGURES)}")
    asked = FigureNumbers.of(request, kind)
    path, data = request.files
    ensure_installed("matplotlib", "figures", "figure")
    drawn = kind.make(request, asked)
    path.write_bytes(_picture(drawn, path.suffix))
    data.write_text(_csv(drawn), encoding="utf-8")
    header, rows = drawn.table()
    return Figure(
        drawn=drawn,
        figure=name,
        path=path,
        data=data,
        caption=tuple(drawn.caption()),
        columns=tuple(header),
        rows=len(rows),
    )


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
