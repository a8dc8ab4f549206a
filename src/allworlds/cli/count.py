"""The verb ``count``."""

from __future__ import annotations

import allworlds
from allworlds.cli.events import answered
from allworlds.cli.options import LongOutputGroup
from allworlds.cli.output import emit
from allworlds.studies.count import CountRequest


def count(request: CountRequest, *, output: LongOutputGroup) -> int:
    """Example: allworlds count --edges 6

    Enumerate every rooted map of a class, count, and compare the counts with an independent
    source.
    """
    return emit(answered(allworlds.count, request, output), "count", output)
