"""Request of ``figure``: which one, its numbers and its file."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from allworlds.engines import AskedListener, Limits
from allworlds.inputs import OUTPUT, SCOPE, Argument, InputError, Option, integer_of, show
from allworlds.protocol import ANSWER_TIMEOUT

SUFFIXES = (".svg", ".png", ".pdf")


class AskedFigure(AskedListener, Limits):
    """Options for making a figure."""

    answer_timeout: Annotated[float, "as for a check; built-in explorers are never silent"] = (
        ANSWER_TIMEOUT
    )
    out: Annotated[
        str | None,
        Option(
            OUTPUT,
            "FILE",
            "The picture: .svg, .png or .pdf; the data go beside it as .csv "
            "[default: figure-NAME.svg].",
        ),
    ] = None
    worlds: Annotated[
        int | None,
        Option(
            SCOPE,
            "K",
            "The number of graphs of each size, for figure 3 [default: 30].",
            parse=integer_of,
        ),
    ] = None
    seed: Annotated[
        int | None,
        Option(
            SCOPE,
            "S",
            "The seed of the first graph of a size, for figure 3 [default: 1].",
            parse=integer_of,
        ),
    ] = None
    edges: Annotated[
        int | None,
        Option(
            SCOPE, "M", "At most M edges, for the figure bounds [default: 6].", parse=integer_of
        ),
    ] = None


class FigureRequest(AskedFigure, kw_only=False):
    """Request of ``figure``: which one, its numbers and its file."""

    name: Annotated[
        str,
        Argument(
            "",
            "1|2|3|bounds",
            "Twins, one pass of Algorithm 1, the cost in graphs with holes; or the exact "
            "worst cases beside the bound.",
        ),
    ]

    @property
    def files(self) -> tuple[Path, Path]:
        """The files of the figure: the picture, and its data.

        Raises:
            InputError: for an end that is no format.
        """
        path = Path(f"figure-{self.name}.svg" if self.out is None else self.out)
        if path.suffix not in SUFFIXES:
            raise InputError(f"out {show(str(path))} ends with none of {', '.join(SUFFIXES)}")
        return path, path.with_suffix(".csv")
