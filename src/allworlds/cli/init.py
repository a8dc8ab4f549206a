"""The verb ``init``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.output import emit
from allworlds.explorers import LANGUAGES


def init(
    directory: Annotated[
        str | None,
        typer.Argument(
            metavar="[DIR]",
            help="The directory of the skeleton; no file in it is overwritten.",
            show_default=False,
        ),
    ] = None,
    *,
    lang: Annotated[
        str | None,
        opt.option(
            opt.OUTPUT,
            "LANG",
            f"{opt.one_of(LANGUAGES)} [default: python].",
            show_default=False,
        ),
    ] = None,
    header: Annotated[
        bool,
        opt.flag(
            opt.OUTPUT,
            "Print the C header of native explorers instead, which is its own manual.",
            "--header",
        ),
    ] = False,
    output: opt.OutputGroup,
) -> int:
    """Example: allworlds init my-explorer --lang javascript

    Write an explorer to begin with, its test, and a workflow for CI. It builds and runs, and a
    check refutes it, until it is filled in.  With --header print allworlds.h, for explorers in
    shared libraries: check --native PATH tries one.
    """
    import allworlds

    return emit(allworlds.init(directory, lang=lang, header=header), "init", output)
