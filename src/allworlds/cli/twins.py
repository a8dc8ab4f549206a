"""The verb ``twins``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.files import PageFile
from allworlds.cli.output import emit


def twins(
    a: Annotated[str, typer.Argument(metavar="A", help=opt.WORLD)],
    b: Annotated[str, typer.Argument(metavar="B", help="Another one.")],
    *,
    lighthouse: opt.LighthouseOfWorld = "position",
    page: PageFile,
    output: opt.Output,
) -> int:
    """Example: allworlds twins fig1-left fig1-right

    Can any motion tell two worlds apart?  The answer comes with the shortest motions that do,
    or with classes of darts that prove that none does.
    """
    import allworlds
    from allworlds.world import world_named

    page.ensure_writable()

    result = allworlds.twins(world_named(a, lighthouse), world_named(b, lighthouse))
    page.write("twins", result)
    return emit(result, "twins", output)
