"""The verb ``optimum``."""

from __future__ import annotations

import allworlds
from allworlds.cli.events import answered
from allworlds.cli.options import LongOutputGroup
from allworlds.cli.output import emit
from allworlds.studies.optimum import OptimumRequest


def optimum(request: OptimumRequest, *, output: LongOutputGroup) -> int:
    """Example: allworlds optimum --edges 4

    The fewest traversals with which an explorer that knows the number of edges can map the
    worst world, by minimax over all worlds with every bearing, with its strategy; beside it the
    worst cost of every built-in explorer.  Exit code 0: answered, 3: the time was up, 70: the
    strategy, followed in every world, disagrees.
    """
    return emit(answered(allworlds.optimum, request, output), "optimum", output)
