"""The verb ``paper figure`` on the command line."""

from __future__ import annotations

import allworlds
from allworlds.cli.files import ensure_writable
from allworlds.cli.options import OutputGroup
from allworlds.cli.output import answered, emit
from allworlds.evidence.figures import FigureRequest


def figure(request: FigureRequest, *, output: OutputGroup) -> int:
    """Example: allworlds paper figure 2 --out pass.svg

    A figure of the paper, drawn from runs that were judged or from a proof that was checked, and
    its data as CSV; needs the extra 'figures'. Exit code 0: the checks of the figure succeed, 1:
    they do not.
    """
    for path in request.files:
        ensure_writable(str(path))
    report = answered(allworlds.figure, request, output)
    return emit(report, "paper figure", output, request.workers)
