"""The verb ``native``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.output import emit


def native(
    *,
    header: Annotated[bool, opt.option(opt.OUTPUT, "", "The C header.", "--header")] = False,
    output: opt.Output,
) -> int:
    """Example: allworlds native --header > allworlds.h

    The C header of explorers in shared libraries, which is its own manual; such an explorer is
    tried with check --native PATH.
    """
    import allworlds

    return emit(allworlds.native(header=header), "native", output)
