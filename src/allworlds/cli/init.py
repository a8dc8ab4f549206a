"""The verb ``init`` on the command line."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.options import OutputGroup
from allworlds.cli.output import emit
from allworlds.explorers import LANGUAGES
from allworlds.inputs import OUTPUT, Argument, Option, one_of


def init(
    directory: Annotated[
        str | None,
        Argument(
            "",
            "[DIR]",
            "The directory of the skeleton; no file in it is overwritten.",
        ),
    ] = None,
    *,
    lang: Annotated[
        str | None,
        Option(
            OUTPUT,
            "LANG",
            f"{one_of(LANGUAGES)} [default: python].",
        ),
    ] = None,
    header: Annotated[
        bool,
        Option(
            OUTPUT,
            "",
            "Print instead the C header of native explorers, which includes their manual.",
            "header",
        ),
    ] = False,
    output: OutputGroup,
) -> int:
    """Example: allworlds init my-explorer --lang javascript

    Write an explorer to begin with, its test, and a workflow for CI. It builds and runs, and a
    check refutes it, until it is filled in.  With --header print allworlds.h, for explorers in
    shared libraries: check --native PATH tries one.
    """
    return emit(allworlds.init(directory, lang=lang, header=header), "init", output)
