"""The verb ``worst``."""

from __future__ import annotations

import allworlds
from allworlds.cli.events import answered
from allworlds.cli.files import PageFile
from allworlds.cli.options import LongOutputGroup
from allworlds.cli.output import emit
from allworlds.studies.worst import WorstRequest


def worst(request: WorstRequest, *, page: PageFile, output: LongOutputGroup) -> int:
    """Example: allworlds worst --edges 5

    The exact worst and best cost of an explorer over all worlds and over every schedule; of
    Algorithm 1 every choice of edge, order of hypotheses and path.  Exit code 0: answered,
    1: a schedule breaks a law, 70: counts, replays or engines disagree.
    """
    page.ensure_writable()
    report = answered(allworlds.worst, request, output)
    page.write("worst", report)
    return emit(report, "worst", output, workers=request.workers)
