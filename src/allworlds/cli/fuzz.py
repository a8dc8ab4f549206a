"""The verb ``fuzz``."""

from __future__ import annotations

import allworlds
from allworlds.cli.events import answered
from allworlds.cli.files import Files
from allworlds.cli.options import LongOutputGroup
from allworlds.cli.output import emit
from allworlds.studies.fuzz import FuzzRequest


def fuzz(request: FuzzRequest, *, files: Files, output: LongOutputGroup) -> int:
    """Example: allworlds fuzz my_explorer.py:explore --edges 20 --min-edges 6 --runs 1000

    Run an explorer in random worlds beyond the exhaustive bound, and shrink what refutes it.
    Exit code 0: not refuted by the sample, 1: refuted.
    """
    files.ensure_writable()
    report = answered(allworlds.fuzz, request, output)
    files.write(report)
    return emit(report, "fuzz", output, workers=request.workers)
