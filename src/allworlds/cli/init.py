"""The verb ``init``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.output import emit
from allworlds.skeletons import LANGUAGES


def init(
    directory: Annotated[
        str, typer.Argument(metavar="DIR", help="Where to; no file in it is overwritten.")
    ],
    *,
    lang: Annotated[str, opt.option(opt.OUTPUT, "LANG", f"{opt.one_of(LANGUAGES)}.")] = "python",
    output: opt.Output,
) -> int:
    """Example: allworlds init my-explorer --lang javascript

    Write an explorer to begin with, its test, and a workflow for CI. It builds and runs, and a
    check refutes it, until it is filled in.
    """
    import allworlds

    return emit(allworlds.init(directory, lang=lang), "init", output)
